#include "core/scene/mesh_area.h"

namespace rtb {

bool HasArea(const V3f& a, const V3f& b, const V3f& c) {
  // The differences and products of floats fill doubles: each step is off by
  // up to 2^-53 of its result, and so is the sine that their quotient is.
  constexpr double kRounding = 0x1p-50;
  const V3d e1 = V3d(b) - V3d(a);
  const V3d e2 = V3d(c) - V3d(a);
  // Squares cannot leave double's range: edges lie within 1e-45..1e39.
  return e1.cross(e2).length2() >
         kRounding * kRounding * e1.length2() * e2.length2();
}

int DropTrianglesWithoutArea(TriangleMesh* mesh) {
  const auto at = [mesh](int i) {
    return mesh->positions[static_cast<std::size_t>(i)];
  };
  const auto dropped = std::erase_if(mesh->triangles, [&](const auto& t) {
    return !HasArea(at(t[0]), at(t[1]), at(t[2]));
  });
  return static_cast<int>(dropped);
}

}  // namespace rtb
