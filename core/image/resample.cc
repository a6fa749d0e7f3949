#include "core/image/resample.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace rtb {
namespace {

/// Positions computed in single precision still hit pixel borders.
constexpr double kBorderTolerance = 1e-5;

double Snap(double position) {
  const double border = std::round(position);
  return std::abs(position - border) < kBorderTolerance ? border : position;
}

/// One side of the box, and the pixels [first, last) of the image that it
/// touches, each over a length greater than 0.
struct Span {
  double begin, end;
  int first, last;

  Span(double from, double to, int size) : begin(Snap(from)), end(Snap(to)) {
    if (!(end > begin)) {
      begin = from;
      end = to;
    }
    first = static_cast<int>(std::clamp(std::floor(begin), 0.0, size * 1.0));
    last = static_cast<int>(std::clamp(std::ceil(end), 0.0, size * 1.0));
  }

  double Length() const { return end - begin; }
  double Covered(int pixel) const {
    return std::min(end, pixel + 1.0) - std::max(begin, pixel * 1.0);
  }
};

}  // namespace

Rgb BoxMean(const Image& image, double x0, double y0, double x1, double y1) {
  RTB_CHECK_LT(x0, x1);
  RTB_CHECK_LT(y0, y1);
  const Span columns(x0, x1, image.width());
  const Span rows(y0, y1, image.height());
  V3d sum(0);
  for (int y = rows.first; y < rows.last; ++y) {
    V3d row_sum(0);
    for (int x = columns.first; x < columns.last; ++x) {
      row_sum += V3d(image.at(x, y)) * columns.Covered(x);
    }
    sum += row_sum * rows.Covered(y);
  }
  return Rgb(sum / (columns.Length() * rows.Length()));
}

Image ResizeArea(const Image& image, int width, int height) {
  RTB_CHECK(!image.empty());
  RTB_CHECK_GT(width, 0);
  RTB_CHECK_GT(height, 0);
  const auto column = [&](int x) {
    return static_cast<double>(x) * image.width() / width;
  };
  const auto row = [&](int y) {
    return static_cast<double>(y) * image.height() / height;
  };
  Image resized(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      resized.at(x, y) =
          BoxMean(image, column(x), row(y), column(x + 1), row(y + 1));
    }
  }
  return resized;
}

}  // namespace rtb
