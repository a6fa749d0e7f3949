#include "reference/pov_glass.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "reference/bounds.h"
#include "reference/pov_geometry.h"
#include "reference/pov_material.h"

namespace rtb {
namespace {

/// One dielectric object's region of space.
struct Region {
  Index object = kNone;
  Bounds bounds;
  std::optional<double> round_radius;  ///< Of a sphere that is one.
};

/// The sum over a surface that tells whether it is closed and outward.
class ClosedSurface {
 public:
  void Add(const FlatTriangle& triangle) {
    const auto& v = triangle.vertices;
    for (int i = 0; i < 3; ++i) {
      AddEdge(v[static_cast<std::size_t>(i)],
              v[static_cast<std::size_t>((i + 1) % 3)]);
    }
    volume_ += V3d(v[0]).dot(V3d(v[1]).cross(V3d(v[2])));
  }
  /// Each edge runs as often one way as the other, and normals point out.
  bool IsOutward() const {
    return volume_ > 0 &&
           std::all_of(edges_.begin(), edges_.end(),
                       [](const auto& edge) { return edge.second == 0; });
  }

 private:
  using Key = std::array<float, 3>;

  void AddEdge(const V3f& a, const V3f& b) {
    const Key from = {a.x, a.y, a.z};
    const Key to = {b.x, b.y, b.z};
    if (from < to) {
      ++edges_[{from, to}];
    } else {
      --edges_[{to, from}];
    }
  }

  std::map<std::pair<Key, Key>, int> edges_;
  double volume_ = 0;
};

Error Refusal(const Scene& scene, const FlatScene& flat, Index object,
              const std::string& what) {
  const Material* material = MaterialOf(scene, flat, object);
  return BadInput(
      PlaceOf(scene, material->mark),
      "POV-Ray cannot express dielectric `" + material->id + "` on " + what,
      "use another reference, e.g. --reference=self");
}

bool Meet(const Region& a, const Region& b) {
  if (a.round_radius && b.round_radius) {
    const V3d between =
        (a.bounds.min + a.bounds.max - b.bounds.min - b.bounds.max) / 2.0;
    return between.length() < *a.round_radius + *b.round_radius;
  }
  return Overlap(a.bounds, b.bounds);
}

/// The radius of a sphere whose map is a similarity.
std::optional<double> RoundRadius(const Affined& m) {
  const double r = m.x.length();
  const double skew =
      std::max({std::abs(m.y.length() - r), std::abs(m.z.length() - r),
                std::abs(m.x.dot(m.y)) / r, std::abs(m.y.dot(m.z)) / r,
                std::abs(m.z.dot(m.x)) / r});
  if (skew > 1e-9 * r) return std::nullopt;
  return r;
}

/// Finds the dielectric regions of a scene.
class GlassFinder {
 public:
  GlassFinder(const Scene& scene, const FlatScene& flat)
      : scene_(scene), flat_(flat) {}

  Result<std::vector<Region>> Find() {
    for (const FlatDisk& disk : flat_.disks) {
      if (IsGlass(disk.object)) return Refuse(disk.object, "an open disk");
    }
    for (const FlatSphere& sphere : flat_.spheres) {
      if (!IsGlass(sphere.object)) continue;
      regions_.push_back(
          {sphere.object, BoundsOf(sphere), RoundRadius(sphere.unit_to_world)});
    }
    for (const FlatPlane& plane : flat_.planes) {
      if (IsGlass(plane.object)) regions_.push_back({plane.object, All(), {}});
    }
    RTB_RETURN_IF_ERROR(FindMeshes());
    return std::move(regions_);
  }

 private:
  bool IsGlass(Index object) const {
    const Material* material = MaterialOf(scene_, flat_, object);
    return material && std::holds_alternative<Dielectric>(material->bsdf);
  }
  tl::unexpected<Error> Refuse(Index object, const std::string& what) const {
    return Fail(Refusal(scene_, flat_, object, what));
  }
  /// A plane's half-space: everything, to be on the safe side.
  static Bounds All() {
    Bounds all;
    std::swap(all.min, all.max);
    return all;
  }

  Status FindMeshes() {
    std::map<Index, std::pair<ClosedSurface, Bounds>> meshes;
    for (const FlatTriangle& triangle : flat_.triangles) {
      if (!IsGlass(triangle.object)) continue;
      auto& [surface, bounds] = meshes[triangle.object];
      surface.Add(triangle);
      bounds.Add(BoundsOf(triangle));
    }
    for (const auto& [object, mesh] : meshes) {
      if (!mesh.first.IsOutward()) {
        return Refuse(object, "a surface that is not closed and outward");
      }
      regions_.push_back({object, mesh.second, {}});
    }
    return {};
  }

  const Scene& scene_;
  const FlatScene& flat_;
  std::vector<Region> regions_;
};

}  // namespace

Status CheckPovGlass(const Scene& scene, const FlatScene& flat) {
  RTB_ASSIGN_OR_RETURN(const std::vector<Region> regions,
                       GlassFinder(scene, flat).Find());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (Meet(regions[i], regions[j])) {
        return Fail(Refusal(scene, flat, regions[i].object,
                            "objects that overlap another dielectric"));
      }
    }
  }
  return {};
}

}  // namespace rtb
