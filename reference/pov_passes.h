/// @file
/// A POV-Ray rendering cut into bands of rows, each a program run of its own,
/// so that an interrupted reference can be continued.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "reference/reference.h"

namespace rtb {

/// Rows [begin, end) of the finished picture.
struct RowBand {
  int begin = 0;
  int end = 0;
};

/// The bands of a request, from the top: as many rows each as hold about two
/// million rays, at least one.
std::vector<RowBand> BandsOf(const ReferenceRequest& request);

/// The side n of the n x n grid of rays in a pixel; kBadInput when `spp` is
/// not a square number or the size is not positive.
Result<int> GridSide(const ReferenceRequest& request);

/// Renders bands of `scene.pov` in a work folder, where finished ones stay.
class BandRenderer {
 public:
  /// @param side n of the n x n rays per pixel.
  BandRenderer(std::filesystem::path folder, const ReferenceRequest& request,
               int side)
      : folder_(std::move(folder)), request_(request), side_(side) {}

  /// Renders a band unless it lies finished in the folder.
  /// @return the seconds that the rendering took, now or then.
  Result<double> Render(const RowBand& band) const;

  /// The finished band's pixels, each the mean of its rays in linear light.
  Result<Image> Averaged(const RowBand& band) const;

  /// The command line for a band, as run inside the folder.
  /// @param output the file it writes; empty = the finished band.
  std::vector<std::string> Command(const RowBand& band,
                                   std::string output = "") const;

 private:
  std::string NameOf(const RowBand& band) const;

  std::filesystem::path folder_;
  ReferenceRequest request_;
  int side_;
};

}  // namespace rtb
