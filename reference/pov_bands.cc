#include "reference/pov_bands.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <system_error>

#include "core/base/file.h"
#include "core/base/process.h"
#include "core/image/io.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

constexpr double kRaysPerBand = 2e6;

/// The last lines of what a program said, as one line.
std::string LastLines(const std::string& text, std::size_t limit = 400) {
  std::string tail =
      text.size() > limit ? text.substr(text.size() - limit) : text;
  std::replace(tail.begin(), tail.end(), '\n', ' ');
  return tail;
}

/// The mean of the n x n rays of pixel (x, y).
Rgb PixelMean(const Image& rays, int x, int y, int n) {
  V3d sum(0);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) sum += V3d(rays.at(x * n + i, y * n + j));
  }
  return Rgb(sum / (static_cast<double>(n) * n));
}

Result<double> ReadSeconds(const std::filesystem::path& file) {
  RTB_ASSIGN_OR_RETURN(const std::string text, ReadFile(file, 100));
  double seconds = 0;
  std::from_chars(text.data(), text.data() + text.size(), seconds);
  return seconds;
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

Status BandRenderer::Run(const RowBand& band, const std::string& output) const {
  ProcessOptions options;
  options.argv = Command(band, output);
  // POV-Ray's own restrictions let it write only below here and /tmp.
  options.directory = folder_;
  RTB_ASSIGN_OR_RETURN(const ProcessResult result, RunProcess(options));
  if (result.exit_status == 0) return {};
  return Fail(Failure((folder_ / "scene.pov").string(),
                      "povray ended with status " +
                          std::to_string(result.exit_status) + ": ..." +
                          LastLines(result.err)));
}

Result<double> BandRenderer::Render(const RowBand& band) const {
  const auto file = [&](const char* extension) {
    return folder_ / (NameOf(band) + extension);
  };
  std::error_code error;
  if (std::filesystem::exists(file(".exr"), error)) {
    return ReadSeconds(file(".seconds"));
  }
  // A povray that outlived an interrupted run may still be writing its own.
  const std::string part =
      NameOf(band) + "." + std::to_string(::getpid()) + ".part.exr";
  const auto start = std::chrono::steady_clock::now();
  RTB_RETURN_IF_ERROR(Run(band, part));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
          .count();
  RTB_RETURN_IF_ERROR(
      WriteFileAtomically(file(".seconds"), PovNumber(seconds)));
  std::filesystem::rename(folder_ / part, file(".exr"), error);
  if (error) {
    return Fail(Failure((folder_ / part).string(), error.message()));
  }
  return seconds;
}

Result<Image> BandRenderer::Averaged(const RowBand& band) const {
  const auto file = folder_ / (NameOf(band) + ".exr");
  const Result<Image> rays = ReadLinear(file);
  Image mean(request_.width, band.end - band.begin);
  if (!rays || rays->width() != mean.width() * side_ ||
      rays->height() != mean.height() * side_) {
    std::error_code ignored;  // Else every later run would stumble over it.
    std::filesystem::remove(file, ignored);
    return Fail(Failure(file.string(),
                        rays ? "an image of another size than asked of povray"
                             : rays.error().what,
                        "it was removed; run the same again"));
  }
  for (int y = 0; y < mean.height(); ++y) {
    for (int x = 0; x < mean.width(); ++x) {
      mean.at(x, y) = PixelMean(*rays, x, y, side_);
    }
  }
  return mean;
}

}  // namespace rtb
