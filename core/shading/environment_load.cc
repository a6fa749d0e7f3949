#include "core/shading/environment_load.h"

#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/check.h"
#include "core/color/luminance.h"
#include "core/image/io.h"
#include "core/math/discrete.h"
#include "core/shading/texture_load.h"

namespace rtb {
namespace {

/// The luminance of a row at `position`: a mean over texel `position` of what
/// lies between the centers. Straight lines between a, b and c have the mean
/// (a + 6 b + c) / 8 over b's texel.
double Mean(double a, double b, double c) { return (a + 6 * b + c) / 8; }

/// The mean of the interpolated luminance over texel (x, y).
double MeanLuminance(const Image& image, int x, int y) {
  const int left = TexelIndex(x - 1, image.width(), EdgeRule::kWrap);
  const int right = TexelIndex(x + 1, image.width(), EdgeRule::kWrap);
  const auto row_mean = [&](int row) {
    const int j = TexelIndex(row, image.height(), EdgeRule::kClamp);
    return Mean(Luminance(V3d(image.at(left, j))),
                Luminance(V3d(image.at(x, j))),
                Luminance(V3d(image.at(right, j))));
  };
  return Mean(row_mean(y - 1), row_mean(y), row_mean(y + 1));
}

}  // namespace

Environment MakeEnvironment(Image image) {
  RTB_CHECK(!image.empty());
  const auto width = static_cast<std::size_t>(image.width());
  const auto height = static_cast<std::size_t>(image.height());
  Environment environment;
  environment.column_cdfs.resize((width + 1) * height);
  std::vector<double> rows(height);
  std::vector<double> columns(width);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      columns[static_cast<std::size_t>(x)] = MeanLuminance(image, x, y);
    }
    const auto row = static_cast<std::size_t>(y);
    const std::span cdf(environment.column_cdfs);
    rows[row] = FillCdf(columns, cdf.subspan(row * (width + 1), width + 1)) *
                TexelSolidAngle(image.width(), image.height(), y);
  }
  environment.row_cdf = MakeCdf(rows);
  environment.mean_luminance =
      std::accumulate(rows.begin(), rows.end(), 0.0) / (4 * std::numbers::pi);
  environment.image = std::move(image);
  return environment;
}

Result<Environment> LoadEnvironment(const std::filesystem::path& file) {
  RTB_ASSIGN_OR_RETURN(Image image, ReadLinear(file));
  RTB_RETURN_IF_ERROR(CheckTexels(
      image, file, {0, std::numeric_limits<float>::max(), "a radiance"}));
  return MakeEnvironment(std::move(image));
}

EnvironmentData ViewOf(const Environment& environment) {
  return {{environment.image.width(), environment.image.height(),
           environment.image.pixels().data()},
          environment.row_cdf.data(),
          environment.column_cdfs.data()};
}

}  // namespace rtb
