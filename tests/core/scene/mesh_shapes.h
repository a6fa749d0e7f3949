/// @file
/// Small meshes, and measures of meshes, for the tests of mesh code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/scene/scene.h"

namespace rtb {

inline V3f PositionOf(const TriangleMesh& mesh, int vertex) {
  return mesh.positions[static_cast<std::size_t>(vertex)];
}

/// The cross product of a triangle's edges: its normal, as long as twice its
/// area.
inline V3d CrossOf(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  const V3d a(PositionOf(mesh, t[0]));
  return (V3d(PositionOf(mesh, t[1])) - a)
      .cross(V3d(PositionOf(mesh, t[2])) - a);
}

inline double AreaOf(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += CrossOf(mesh, t).length() / 2;
  return sum;
}

/// The volume inside a closed mesh, positive when it is wound outwards.
inline double VolumeOf(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += CrossOf(mesh, t).dot(V3d(PositionOf(mesh, t[0]))) / 6;
  }
  return sum;
}

/// How many triangles run along each edge, in each direction.
inline std::map<std::pair<int, int>, int> EdgesOf(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  return edges;
}

/// Whether each edge has two triangles, which run along it in both ways.
inline bool IsClosed(const TriangleMesh& mesh) {
  const auto edges = EdgesOf(mesh);
  return std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
    const auto back = edges.find({entry.first.second, entry.first.first});
    return entry.second == 1 && back != edges.end() && back->second == 1;
  });
}

/// A regular tetrahedron in the cube [-1, 1]^3.
inline TriangleMesh Tetrahedron() {
  return {.positions = {V3f(1, 1, 1), V3f(1, -1, -1), V3f(-1, 1, -1),
                        V3f(-1, -1, 1)},
          .normals = {},
          .uvs = {},
          .triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

/// An icosahedron in the unit sphere: a pole, two rings of five at latitudes
/// of +-atan(1/2), and the other pole (along z).
inline TriangleMesh Icosahedron() {
  TriangleMesh mesh;
  const float h = 1 / std::sqrt(5.0f);
  mesh.positions.emplace_back(0.0f, 0.0f, 1.0f);
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < 5; ++i) {
      const float angle =
          (static_cast<float>(i) + 0.5f * static_cast<float>(ring)) *
          1.25663706f;  // 2 pi / 5
      mesh.positions.emplace_back(2 * h * std::cos(angle),
                                  2 * h * std::sin(angle), ring == 0 ? h : -h);
    }
  }
  mesh.positions.emplace_back(0.0f, 0.0f, -1.0f);
  for (int i = 0; i < 5; ++i) {
    const int j = (i + 1) % 5;
    mesh.triangles.push_back({0, 1 + i, 1 + j});
    mesh.triangles.push_back({1 + i, 6 + i, 1 + j});
    mesh.triangles.push_back({6 + i, 6 + j, 1 + j});
    mesh.triangles.push_back({11, 6 + j, 6 + i});
  }
  return mesh;
}

/// The icosahedron with each triangle parted in four `levels` times, all
/// vertices on the unit sphere and shared.
inline TriangleMesh Icosphere(int levels) {
  TriangleMesh mesh = Icosahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto next = static_cast<int>(mesh.positions.size());
      const auto [at, added] = middles.emplace(std::minmax(a, b), next);
      if (added) {
        mesh.positions.push_back(
            (PositionOf(mesh, a) + PositionOf(mesh, b)).normalized());
      }
      return at->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(),
                   {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// The same, shaded as the unit sphere.
inline TriangleMesh SmoothIcosphere(int levels) {
  TriangleMesh mesh = Icosphere(levels);
  mesh.normals = mesh.positions;
  return mesh;
}

/// A disk in z = 0: `n` vertices on the unit circle around a center.
inline TriangleMesh Fan(int n) {
  TriangleMesh mesh;
  mesh.positions.emplace_back(0.0f, 0.0f, 0.0f);
  for (int i = 0; i < n; ++i) {
    const double angle = i * 6.283185307179586 / n;
    mesh.positions.emplace_back(static_cast<float>(std::cos(angle)),
                                static_cast<float>(std::sin(angle)), 0.0f);
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return mesh;
}

}  // namespace rtb
