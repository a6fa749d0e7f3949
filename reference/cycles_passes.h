/// @file
/// A Cycles rendering cut into passes of some samples per pixel, each a
/// program run of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "reference/reference.h"

namespace rtb {

/// One program run.
struct CyclesPass {
  int index = 0;
  int spp = 0;
  int first = 0;  ///< The first of its samples in Cycles' sequence.
};

/// The passes of a request: kCyclesPassSpp samples each, the last one fewer
/// where they do not add up. Together they are the samples of a single run:
/// one sequence converges faster than many short ones.
std::vector<CyclesPass> PassesOf(const ReferenceRequest& request);

/// Renders passes of `scene.json` in a work folder, where finished ones stay.
class CyclesPassRenderer {
 public:
  CyclesPassRenderer(std::filesystem::path folder,
                     const ReferenceRequest& request)
      : folder_(std::move(folder)), request_(request) {}

  /// Renders a pass unless it lies finished in the folder.
  /// @return the seconds that the rendering took, now or then.
  Result<double> Render(const CyclesPass& pass) const;

  /// The finished pass' pixels.
  Result<Image> Read(const CyclesPass& pass) const;

  /// The command line for a pass, as run inside the folder.
  /// @param output the file it writes; empty = the finished pass.
  std::vector<std::string> Command(const CyclesPass& pass,
                                   std::string output = "") const;

 private:
  static std::string NameOf(const CyclesPass& pass);

  std::filesystem::path folder_;
  ReferenceRequest request_;
};

/// The mean of images, weighted, in double precision.
class ImageMean {
 public:
  ImageMean(int width, int height);
  void Add(const Image& image, double weight);
  Image Take() const;

 private:
  int width_, height_;
  double weight_ = 0;
  std::vector<V3d> sums_;
};

}  // namespace rtb
