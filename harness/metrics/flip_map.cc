#include "harness/metrics/flip_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/metrics/derived.h"
#include "harness/metrics/flip_color.h"
#include "harness/metrics/flip_kernels.h"
#include "harness/metrics/rows.h"

namespace rtb {
namespace {

// Sections are those of Andersson et al. 2020.

V3d ColorAt(const ColorPlanes& planes, int x, int y) {
  return {planes[0].row(y)[x], planes[1].row(y)[x], planes[2].row(y)[x]};
}

/// Replaces each pixel's three values by convert() of them.
template <class Convert>
void ConvertPixels(ColorPlanes& planes, int threads, const Convert& convert) {
  ForRows(planes[0].height(), threads, [&](int y) {
    for (int x = 0; x < planes[0].width(); ++x) {
      const V3d color = convert(ColorAt(planes, x, y));
      planes[0].row(y)[x] = color.x;
      planes[1].row(y)[x] = color.y;
      planes[2].row(y)[x] = color.z;
    }
  });
}

OfBoth<ColorPlanes> ToYcxcz(OfBoth<ColorPlanes> planes, int threads) {
  ConvertPixels(planes.reference, threads, LinearToYcxcz);
  ConvertPixels(planes.test, threads, LinearToYcxcz);
  return planes;
}

const OfBoth<ColorPlanes>& YcxczPlanes(const MetricInput& input) {
  return input.Once<OfBoth<ColorPlanes>>(
      "ycxcz", [&] { return ToYcxcz(LinearPlanes(input), input.threads()); });
}

/// What an observer sees of an image: filtered by contrast sensitivity, in
/// Hunt-adjusted CIELAB. Section 4.1.
ColorPlanes Perceived(const ColorPlanes& ycxcz, const FlipSensitivity& filters,
                      int threads) {
  ColorPlanes out = {
      Filter(ycxcz[0], filters.achromatic, threads),
      Filter(ycxcz[1], filters.red_green, threads),
      CombinePlanes(Filter(ycxcz[2], filters.blue_yellow[0], threads),
                    Filter(ycxcz[2], filters.blue_yellow[1], threads), threads,
                    [&](double wide, double narrow) {
                      return filters.share[0] * wide +
                             filters.share[1] * narrow;
                    })};
  ConvertPixels(out, threads, [](const V3d& color) {
    const V3d linear = YcxczToLinear(color);
    return HuntLab({std::clamp(linear.x, 0.0, 1.0),
                    std::clamp(linear.y, 0.0, 1.0),
                    std::clamp(linear.z, 0.0, 1.0)});
  });
  return out;
}

/// Strength of edges and points at each pixel. Section 4.2.
struct Features {
  ChannelPlane edge, point;
};

Features DetectFeatures(const ChannelPlane& achromatic,
                        const FlipFeatures& filters, int threads) {
  const auto magnitude = [&](const ChannelPlane& along_x,
                             const ChannelPlane& along_y) {
    return CombinePlanes(along_x, along_y, threads, [](double gx, double gy) {
      return std::sqrt(gx * gx + gy * gy);
    });
  };
  const ChannelPlane smooth = FilterRows(achromatic, filters.gaussian, threads);
  const ChannelPlane edge = FilterRows(achromatic, filters.edge, threads);
  const ChannelPlane point = FilterRows(achromatic, filters.point, threads);
  return {magnitude(FilterColumns(edge, filters.gaussian, threads),
                    FilterColumns(smooth, filters.edge, threads)),
          magnitude(FilterColumns(point, filters.gaussian, threads),
                    FilterColumns(smooth, filters.point, threads))};
}

/// The feature difference of section 4.2, q_f = 0.5. The detectors ran on Y_y,
/// whose range is 116 times that of the luminance which the paper means.
double FeatureError(double edge, double point) {
  return std::sqrt(std::max(edge, point) / (116 * std::numbers::sqrt2));
}

ChannelPlane MakeFlipMap(const OfBoth<ColorPlanes>& ycxcz, double ppd,
                         int threads) {
  const FlipFeatures detectors = MakeFlipFeatures(ppd);
  const Features features_a =
      DetectFeatures(ycxcz.reference[0], detectors, threads);
  const Features features_b = DetectFeatures(ycxcz.test[0], detectors, threads);
  const FlipSensitivity filters = MakeFlipSensitivity(ppd);
  const ColorPlanes color_a = Perceived(ycxcz.reference, filters, threads);
  const ColorPlanes color_b = Perceived(ycxcz.test, filters, threads);
  const FlipErrorRange color_error;

  ChannelPlane map(ycxcz.test[0].width(), ycxcz.test[0].height());
  ForRows(map.height(), threads, [&](int y) {
    for (int x = 0; x < map.width(); ++x) {
      const double color =
          color_error(HyAb(ColorAt(color_a, x, y), ColorAt(color_b, x, y)));
      const double feature = FeatureError(
          std::abs(features_a.edge.row(y)[x] - features_b.edge.row(y)[x]),
          std::abs(features_a.point.row(y)[x] - features_b.point.row(y)[x]));
      map.row(y)[x] = std::pow(color, 1 - feature);  // Section 4.3.
    }
  });
  return map;
}

}  // namespace

const ChannelPlane& FlipMap(const MetricInput& input, double ppd) {
  return input.Once<ChannelPlane>("flip:" + std::to_string(ppd), [&] {
    return MakeFlipMap(YcxczPlanes(input), ppd, input.threads());
  });
}

ChannelPlane FlipMapOfLinear(const ColorPlanes& reference,
                             const ColorPlanes& test, double ppd, int threads) {
  return MakeFlipMap(ToYcxcz({reference, test}, threads), ppd, threads);
}

}  // namespace rtb
