#include "core/scene/geometry_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rtb {
namespace {

constexpr double kParallelSine = 1e-7;

const V3d& At(std::span<const V3d> vertices, std::size_t i) {
  return vertices[i % vertices.size()];
}

V3d Centroid(std::span<const V3d> vertices) {
  V3d sum(0, 0, 0);
  for (const V3d& v : vertices) sum += v;
  return sum / static_cast<double>(vertices.size());
}

/// Largest distance between two vertices.
double Diameter(std::span<const V3d> vertices) {
  double largest = 0;
  for (const V3d& a : vertices) {
    for (const V3d& b : vertices) largest = std::max(largest, (a - b).length());
  }
  return largest;
}

/// Newell's normal, of twice the polygon's area in length: Sutherland,
/// Sproull and Schumacker, "A Characterization of Ten Hidden-Surface
/// Algorithms", 1974. Taken around the centroid, for precision.
V3d NewellNormal(std::span<const V3d> vertices, const V3d& center) {
  V3d normal(0, 0, 0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    normal += (At(vertices, i) - center).cross(At(vertices, i + 1) - center);
  }
  return normal;
}

/// Whether all corners turn to the left around `n`, once around in all.
bool TurnsLeftOnce(std::span<const V3d> vertices, const V3d& n) {
  constexpr double kStraight = 1e-6;  // radians
  double turned = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const V3d in = At(vertices, i + 1) - At(vertices, i);
    const V3d out = At(vertices, i + 2) - At(vertices, i + 1);
    const V3d flat_in = in - n * n.dot(in);
    const V3d flat_out = out - n * n.dot(out);
    const double angle =
        std::atan2(n.dot(flat_in.cross(flat_out)), flat_in.dot(flat_out));
    if (angle < -kStraight) return false;
    turned += angle;
  }
  return std::abs(turned - 2 * std::numbers::pi) < 0.1;
}

}  // namespace

bool AreParallel(const V3d& a, const V3d& b) {
  return a.cross(b).length() <= kParallelSine * a.length() * b.length();
}

std::string PolygonFault(std::span<const V3d> vertices) {
  constexpr double kPlanarShare = 0.01;
  const double diameter = Diameter(vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (At(vertices, i) == At(vertices, i + 1)) {
      return "has the same vertex twice in a row";
    }
  }
  const V3d center = Centroid(vertices);
  const V3d newell = NewellNormal(vertices, center);
  if (newell.length() <= kParallelSine * diameter * diameter) {
    return "has no area";
  }
  const V3d n = newell.normalized();
  for (const V3d& v : vertices) {
    if (std::abs(n.dot(v - center)) > kPlanarShare * diameter) {
      return "is not planar within 1 % of its diameter";
    }
  }
  return TurnsLeftOnce(vertices, n) ? "" : "is not convex";
}

}  // namespace rtb
