#include "encoders/adaptive/edge_metric.h"

#include <algorithm>
#include <cmath>

namespace rtb {
namespace {

/// Pairs of samples nearer to each other than this, in sub-pixels, tell how
/// colors change.
constexpr float kPairReach = 8;

/// Squared distance at which a pair counts half as much as one side by side.
constexpr float kHalfCounted = 16;

/// Keeps directions finite where samples coincide.
constexpr float kWithinPixel = 0.25f;

/// A squared difference that is no edge yet: one of 0.07.
constexpr double kNoEdge = 0.005;

/// So many samples tell enough; their pairs cost time.
constexpr std::size_t kMostSamples = 96;

/// How many times as far things are across an edge as along it, at most.
constexpr double kMostStretch = 3;

/// The quadratic form g in D = g.x ux^2 + 2 g.y ux uy + g.z uy^2 that fits the
/// squared differences D of pairs of samples in directions (ux, uy) best. How
/// far a pair lies apart is left out of it: a step is as high however far from
/// it one stands.
class DirectionFit {
 public:
  void Add(float dx, float dy, float difference2) {
    const float distance2 = dx * dx + dy * dy + kWithinPixel;
    if (distance2 > kPairReach * kPairReach) return;
    const V3f row = V3f(dx * dx, 2 * dx * dy, dy * dy) / distance2;
    const V3f counted = row / (distance2 + kHalfCounted);
    x_ += counted * row.x;
    xy_ += counted * row.y;
    y_ += counted * row.z;
    sum_ += counted * difference2;
  }

  V3d Solve() const {
    // Cramer's rule; without pairs in some direction, little is made of it.
    const double ridge = 1e-3 * double{x_.x + y_.z} + 1e-9;
    const V3d a = V3d(x_) + V3d(ridge, 0, 0);
    const V3d b = V3d(xy_) + V3d(0, ridge, 0);
    const V3d c = V3d(y_) + V3d(0, 0, ridge);
    const V3d sum(sum_);
    return V3d(sum.dot(b.cross(c)), a.dot(sum.cross(c)), a.dot(b.cross(sum))) /
           a.dot(b.cross(c));
  }

 private:
  V3f x_{0}, xy_{0}, y_{0};  ///< Rows of the normal equations.
  V3f sum_{0};
};

/// The map that stretches what lies across, where differences are larger, and
/// shrinks what lies along.
EdgeMetric Stretched(const V3d& form) {
  const double mean = (form.x + form.z) / 2;
  const double half = (form.x - form.z) / 2;
  const double root = std::hypot(half, form.y);
  if (!(root > 0)) return {};
  const double across = std::max(0.0, mean + root) + kNoEdge;
  const double along = std::max(0.0, mean - root) + kNoEdge;
  const double ratio = across / along;
  const double stretch = std::min(kMostStretch, ratio * std::sqrt(ratio));
  const double longer = std::sqrt(stretch);
  const double middle = (longer + 1 / longer) / 2;
  const double turn = (longer - 1 / longer) / 2 / root;
  return {static_cast<float>(middle + turn * half),
          static_cast<float>(turn * form.y),
          static_cast<float>(middle - turn * half)};
}

}  // namespace

void EdgeMetric::Turn(std::span<float> x, std::span<float> y) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const float before = x[i];
    x[i] = xx * before + xy * y[i];
    y[i] = xy * before + yy * y[i];
  }
}

EdgeMetric MetricOf(const NearSamples& near) {
  DirectionFit fit;
  const std::size_t step = (near.size() + kMostSamples - 1) / kMostSamples;
  for (std::size_t i = 0; i < near.size(); i += step) {
    for (std::size_t j = 0; j < i; j += step) {
      fit.Add(near.x[i] - near.x[j], near.y[i] - near.y[j],
              (near.encoded[i] - near.encoded[j]).length2());
    }
  }
  return Stretched(fit.Solve());
}

}  // namespace rtb
