/// @file
/// A POV-Ray rendering cut into passes, each a program run of its own, so that
/// an interrupted reference can be continued and that area lights are sampled
/// elsewhere in each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "reference/reference.h"

namespace rtb {

/// One ray through every pixel, at the center of a cell of the n x n grid that
/// divides each.
struct PovPass {
  int row = 0;
  int column = 0;
};

/// The passes of a request whose grid has `side` x `side` cells.
std::vector<PovPass> PassesOf(int side);

/// The side n of the n x n grid of rays in a pixel; kBadInput when `spp` is
/// not a square number or the size is not positive.
Result<int> GridSide(const ReferenceRequest& request);

/// Renders passes of `scene.pov` in a work folder, where finished ones stay.
class PovPassRenderer {
 public:
  /// @param side n of the n x n rays per pixel.
  PovPassRenderer(std::filesystem::path folder, const ReferenceRequest& request,
                  int side)
      : folder_(std::move(folder)), request_(request), side_(side) {}

  /// Renders a pass unless it lies finished in the folder.
  /// @return the seconds that the rendering took, now or then.
  Result<double> Render(const PovPass& pass) const;

  /// A finished pass, in linear light.
  Result<Image> Read(const PovPass& pass) const;

  /// The command line for a pass, as run inside the folder.
  /// @param output the file it writes; empty = the finished pass.
  std::vector<std::string> Command(const PovPass& pass,
                                   std::string output = "") const;

 private:
  static std::string NameOf(const PovPass& pass);

  std::filesystem::path folder_;
  ReferenceRequest request_;
  int side_;
};

}  // namespace rtb
