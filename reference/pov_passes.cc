#include "reference/pov_bands.h"

#include <algorithm>
#include <cmath>

#include "reference/work_folder.h"

namespace rtb {
namespace {

constexpr double kRaysPerBand = 2e6;

/// The mean of the n x n rays of pixel (x, y).
Rgb PixelMean(const Image& rays, int x, int y, int n) {
  V3d sum(0);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) sum += V3d(rays.at(x * n + i, y * n + j));
  }
  return Rgb(sum / (static_cast<double>(n) * n));
}

}  // namespace

std::vector<RowBand> BandsOf(const ReferenceRequest& request) {
  const double rays_per_row = static_cast<double>(request.width) * request.spp;
  const int rows = std::clamp(static_cast<int>(kRaysPerBand / rays_per_row), 1,
                              request.height);
  std::vector<RowBand> bands;
  for (int begin = 0; begin < request.height; begin += rows) {
    bands.push_back({begin, std::min(begin + rows, request.height)});
  }
  return bands;
}

Result<int> GridSide(const ReferenceRequest& request) {
  if (request.width < 1 || request.height < 1) {
    return Fail(BadInput("--size",
                         std::to_string(request.width) + "x" +
                             std::to_string(request.height) + " is no size",
                         "both numbers must be positive"));
  }
  const int side = static_cast<int>(std::lround(std::sqrt(request.spp)));
  if (request.spp < 1 || side * side != request.spp) {
    return Fail(BadInput("--spp",
                         std::to_string(request.spp) +
                             " rays per pixel; a reference takes a square "
                             "number of them",
                         "e.g. 16, 64 or 256"));
  }
  return side;
}

std::string BandRenderer::NameOf(const RowBand& band) const {
  return "rows_" + std::to_string(band.begin) + "_" + std::to_string(band.end);
}

std::vector<std::string> BandRenderer::Command(const RowBand& band,
                                               std::string output) const {
  if (output.empty()) output = NameOf(band) + ".exr";
  return {"povray",
          "+Iscene.pov",
          "+O" + output,
          "+FE",  // EXR, half
          "+W" + std::to_string(request_.width * side_),
          "+H" + std::to_string((band.end - band.begin) * side_),
          "Declare=BandRows=" + std::to_string(request_.height),
          "Declare=BandBegin=" + std::to_string(band.begin),
          "Declare=BandEnd=" + std::to_string(band.end),
          "+Q9",  // every feature
          "-A",   // no antialiasing: one ray through each center
          "-UA",  // no alpha
          "-D",   // no window
          "-P",   // no pause
          "-V",   // no progress lines
          "-GD",
          "-GR",
          "-GS"};
}

Result<double> BandRenderer::Render(const RowBand& band) const {
  // POV-Ray's own restrictions let it write only below its folder and /tmp.
  return MakePiece(folder_, NameOf(band), [&](const std::string& output) {
    return RunRenderer(Command(band, output), folder_,
                       (folder_ / "scene.pov").string());
  });
}

Result<Image> BandRenderer::Averaged(const RowBand& band) const {
  Image mean(request_.width, band.end - band.begin);
  RTB_ASSIGN_OR_RETURN(const Image rays,
                       ReadPiece(folder_, NameOf(band), mean.width() * side_,
                                 mean.height() * side_));
  for (int y = 0; y < mean.height(); ++y) {
    for (int x = 0; x < mean.width(); ++x) {
      mean.at(x, y) = PixelMean(rays, x, y, side_);
    }
  }
  return mean;
}

}  // namespace rtb
