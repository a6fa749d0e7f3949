#include "reference/cycles_passes.h"

#include <algorithm>
#include <system_error>

#include "core/base/check.h"
#include "reference/cycles.h"
#include "reference/work_folder.h"

namespace rtb {
namespace {

constexpr char kScript[] = "render.py";

}  // namespace

std::vector<CyclesPass> PassesOf(const ReferenceRequest& request) {
  std::vector<CyclesPass> passes;
  for (int done = 0, i = 0; done < request.spp; ++i) {
    const int spp = std::min(kCyclesPassSpp, request.spp - done);
    passes.push_back({i, spp, done});
    done += spp;
  }
  return passes;
}

std::string CyclesPassRenderer::NameOf(const CyclesPass& pass) {
  return "pass_" + std::to_string(pass.index) + "_" + std::to_string(pass.spp);
}

std::vector<std::string> CyclesPassRenderer::Command(const CyclesPass& pass,
                                                     std::string output) const {
  if (output.empty()) output = NameOf(pass) + ".exr";
  std::vector<std::string> argv;
  if (request_.nice) argv = {"nice", "-n", "19"};
  for (const std::string& word :
       {std::string("blender"), std::string("-b"), std::string("-noaudio"),
        std::string("--factory-startup"), std::string("--python-exit-code"),
        std::string("1"), std::string("--python"), std::string(kScript),
        std::string("--"), std::string("scene.json"), "--output=" + output,
        "--width=" + std::to_string(request_.width),
        "--height=" + std::to_string(request_.height),
        "--spp=" + std::to_string(pass.spp),
        "--first=" + std::to_string(pass.first),
        "--seed=" + std::to_string(request_.seed)}) {
    argv.push_back(word);
  }
  if (request_.pixel_centers) argv.push_back("--pixel-centers");
  return argv;
}

Result<double> CyclesPassRenderer::Render(const CyclesPass& pass) const {
  return MakePiece(
      folder_, NameOf(pass), [&](const std::string& output) -> Status {
        std::vector<std::string> argv = Command(pass, output);
        // Blender looks for relative files where $PWD says, which is not here.
        std::error_code error;
        const auto script = std::filesystem::absolute(folder_, error) / kScript;
        std::replace(argv.begin(), argv.end(), std::string(kScript),
                     script.string());
        return RunRenderer(argv, folder_, (folder_ / "scene.json").string());
      });
}

Result<Image> CyclesPassRenderer::Read(const CyclesPass& pass) const {
  return ReadPiece(folder_, NameOf(pass), request_.width, request_.height);
}

ImageMean::ImageMean(int width, int height)
    : width_(width),
      height_(height),
      sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
            V3d(0)) {}

void ImageMean::Add(const Image& image, double weight) {
  RTB_CHECK_EQ(image.width(), width_);
  RTB_CHECK_EQ(image.height(), height_);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    sums_[i] += V3d(image.pixels()[i]) * weight;
  }
  weight_ += weight;
}

Image ImageMean::Take() const {
  Image image(width_, height_);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    image.pixels()[i] = Rgb(sums_[i] / weight_);
  }
  return image;
}

}  // namespace rtb
