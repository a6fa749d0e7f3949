#include "reference/pov_passes.h"

#include <cmath>

#include "reference/work_folder.h"

namespace rtb {

std::vector<PovPass> PassesOf(int side) {
  std::vector<PovPass> passes;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      passes.push_back({row, column});
    }
  }
  return passes;
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

std::string PovPassRenderer::NameOf(const PovPass& pass) {
  return "pass_" + std::to_string(pass.row) + "_" + std::to_string(pass.column);
}

std::vector<std::string> PovPassRenderer::Command(const PovPass& pass,
                                                  std::string output) const {
  if (output.empty()) output = NameOf(pass) + ".exr";
  return {"povray",
          "+Iscene.pov",
          "+O" + output,
          "+FE",  // EXR, half
          "+W" + std::to_string(request_.width),
          "+H" + std::to_string(request_.height),
          "Declare=PassSide=" + std::to_string(side_),
          "Declare=PassRow=" + std::to_string(pass.row),
          "Declare=PassColumn=" + std::to_string(pass.column),
          "Declare=Emitters=" + std::to_string(request_.emitters),
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

Result<double> PovPassRenderer::Render(const PovPass& pass) const {
  // POV-Ray's own restrictions let it write only below its folder and /tmp.
  return MakePiece(folder_, NameOf(pass), [&](const std::string& output) {
    return RunRenderer(Command(pass, output), folder_,
                       (folder_ / "scene.pov").string());
  });
}

Result<Image> PovPassRenderer::Read(const PovPass& pass) const {
  return ReadPiece(folder_, NameOf(pass), request_.width, request_.height);
}

}  // namespace rtb
