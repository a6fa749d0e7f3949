/// @file
/// ImageSource: a FragmentSource that samples an image instead of a scene.
#pragma once

#include <string>

#include "core/image/image.h"
#include "core/render/fragment_source.h"

namespace rtb {

/// How an image is fitted to the picture that a plan covers.
enum class Fit {
  kContain,  ///< Whole image, centered, black beside it.
  kStretch,  ///< Whole image, its aspect changed to the picture's.
  kCover,    ///< Whole picture, what stands over of the image is cut.
};

/// `contain`, `stretch` or `cover`.
Result<Fit> ParseFit(const std::string& place, const std::string& text);

/// Where a plan's picture lies on an image: pixel x = left + column * pitch_x
/// for a column in cells from the picture's left edge, y likewise.
struct ImageMapping {
  double left = 0;
  double top = 0;
  double pitch_x = 1;  ///< Image pixels per cell.
  double pitch_y = 1;
};

/// The mapping of a fit. An image of exactly the plan's size (its footprints
/// side by side, one pixel each) is mapped pixel by pixel whatever the fit.
ImageMapping MapImage(const SamplePlan& plan, int width, int height, Fit fit);

/// Answers plans with the image's exact area average over each sample's
/// footprint, in linear light.
class ImageSource : public FragmentSource {
 public:
  /// @param linear scene-linear pixels, exposure applied; must outlive this.
  /// @param threads upper bound; 0 = all cores.
  ImageSource(const Image& linear, Fit fit, int threads);

  /// @return kBadInput for a plan of more than kMaxSamples samples.
  Result<Fragments> Query(const SamplePlan& plan) override;

 private:
  const Image& linear_;
  Fit fit_;
  int threads_;
};

}  // namespace rtb
