#include "core/scene/subdivide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TriangleMesh Subdivided(const TriangleMesh& mesh, int levels,
                        bool smooth = true) {
  auto result = Subdivide(mesh, levels, smooth, "f.obj");
  EXPECT_TRUE(result) << result.error().ToString();
  return result ? *result : TriangleMesh{};
}

/// The distance of a point from the nearest of a mesh's vertices.
double Distance(const TriangleMesh& mesh, const V3f& point) {
  double least = 1e30;
  for (const V3f& p : mesh.positions) {
    least = std::min(least, V3d(p - point).length());
  }
  return least;
}

void ExpectUnitNormals(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const V3f& n : mesh.normals) EXPECT_NEAR(n.length(), 1, 1e-6);
}

TEST(SubdivideTest, EachLevelQuartersTheTriangles) {
  // A level makes a vertex of each edge, two edges of each and three more in
  // each face: F 4^n, E 4^n, and V by Euler's formula V - E + F = 2.
  for (const TriangleMesh& base : {Tetrahedron(), Icosahedron()}) {
    std::size_t faces = base.triangles.size();
    for (int level = 1; level <= 4; ++level) {
      faces *= 4;
      const TriangleMesh mesh = Subdivided(base, level);
      EXPECT_THAT(mesh.triangles, SizeIs(faces));
      EXPECT_THAT(mesh.positions, SizeIs(2 + faces / 2));
      EXPECT_THAT(EdgesOf(mesh), SizeIs(3 * faces));  // in both ways
      EXPECT_TRUE(IsClosed(mesh));
    }
  }
}

TEST(SubdivideTest, SixLevels) {
  const TriangleMesh mesh = Subdivided(Icosahedron(), 6);
  EXPECT_THAT(mesh.triangles, SizeIs(81920));  // 20 * 4^6
  EXPECT_THAT(mesh.positions, SizeIs(40962));
}

TEST(SubdivideTest, VerticesOfTheBaseGoToLoopsLimit) {
  // Loop 1987: beta = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n; the limit is
  // (1 - n chi) p + chi sum(q), chi = 1 / (n + 3 / (8 beta)) (Hoppe et al.
  // 1994, section 3.2). The five neighbors of a pole have z = 1 / sqrt(5).
  const double a = 3.0 / 8 + std::cos(1.2566370614359172) / 4;
  const double beta = (5.0 / 8 - a * a) / 5;
  const double chi = 1 / (5 + 3 / (8 * beta));
  const double z = 1 - 5 * chi + 5 * chi / std::sqrt(5.0);
  for (int level = 1; level <= 3; ++level) {
    const TriangleMesh mesh = Subdivided(Icosahedron(), level);
    EXPECT_LT(Distance(mesh, V3f(0, 0, static_cast<float>(z))), 1e-6);
    EXPECT_LT(Distance(mesh, V3f(0, 0, static_cast<float>(-z))), 1e-6);
  }
}

TEST(SubdivideTest, FurtherLevelsMoveNoVertex) {
  const TriangleMesh coarse = Subdivided(Tetrahedron(), 2);
  const TriangleMesh fine = Subdivided(Tetrahedron(), 3);
  for (const V3f& p : coarse.positions) EXPECT_LT(Distance(fine, p), 1e-6);
}

TEST(SubdivideTest, MeasuresConverge) {
  // Chords of a smooth surface are off by the square of their length, which
  // each level halves: what a level adds falls to a quarter.
  double area[5], volume[5];
  for (int level = 2; level <= 4; ++level) {
    const TriangleMesh mesh = Subdivided(Icosahedron(), level);
    area[level] = AreaOf(mesh);
    volume[level] = VolumeOf(mesh);
  }
  EXPECT_GT(volume[2], 0);
  EXPECT_NEAR((area[4] - area[3]) / (area[3] - area[2]), 0.25, 0.03);
  EXPECT_NEAR((volume[4] - volume[3]) / (volume[3] - volume[2]), 0.25, 0.03);
}

TEST(SubdivideTest, NormalsAreThoseOfTheLimitSurface) {
  const TriangleMesh mesh = Subdivided(Icosahedron(), 4);
  ExpectUnitNormals(mesh);
  // Edges span some 4 degrees: a vertex is as far from a facet's normal.
  for (const auto& t : mesh.triangles) {
    const V3d facet = CrossOf(mesh, t).normalized();
    for (const int i : t) {
      const V3d n(mesh.normals[static_cast<std::size_t>(i)]);
      EXPECT_GT(n.dot(facet), std::cos(6 * 0.017453292519943295));
    }
  }
  // By symmetry the normal of a pole is the axis.
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const V3f& p = mesh.positions[i];
    if (std::hypot(p.x, p.y) > 1e-6f) continue;
    EXPECT_NEAR(mesh.normals[i].z, p.z > 0 ? 1 : -1, 1e-6);
  }
  EXPECT_THAT(Subdivided(Icosahedron(), 1, false).normals, IsEmpty());
}

TEST(SubdivideTest, VerticesOfEqualPositionAreOne) {
  // The same tetrahedron with three vertices of its own for each face, one of
  // them with a negative zero.
  const TriangleMesh whole = Tetrahedron();
  TriangleMesh split;
  for (const auto& t : whole.triangles) {
    const int first = static_cast<int>(split.positions.size());
    for (const int i : t) {
      split.positions.push_back(PositionOf(whole, i) - V3f(1, 0, 0));
    }
    split.triangles.push_back({first, first + 1, first + 2});
  }
  split.positions[0].x = -0.0f;  // 1 - 1
  const TriangleMesh mesh = Subdivided(split, 2);
  EXPECT_THAT(mesh.positions, SizeIs(34));  // 2 * 4^2 + 2
  EXPECT_TRUE(IsClosed(mesh));
}

TEST(SubdivideTest, TextureCoordinatesStayAffine) {
  // A fan with a center off the middle: Loop's rules move points within the
  // plane, and (u, v) = (x - 2 y, 3 + x / 2 + y) with them.
  TriangleMesh fan = Fan(7);
  fan.positions[0] = V3f(0.3f, 0.1f, 0);
  const auto uv = [](const V3f& p) {
    return V2f(p.x - 2 * p.y, 3 + p.x / 2 + p.y);
  };
  for (const V3f& p : fan.positions) fan.uvs.push_back(uv(p));
  const TriangleMesh mesh = Subdivided(fan, 3);
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  EXPECT_THAT(mesh.triangles, SizeIs(7 * 64));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_EQ(mesh.positions[i].z, 0);
    EXPECT_NEAR(mesh.normals[i].z, 1, 1e-6);
    EXPECT_LT((mesh.uvs[i] - uv(mesh.positions[i])).length(), 1e-6);
  }
}

TEST(SubdivideTest, SquaresStaySquaresHoweverTheyAreCut) {
  const std::vector<V3f> corners = {V3f(0, 0, 0), V3f(1, 0, 0), V3f(1, 1, 0),
                                    V3f(0, 1, 0)};
  using Cut = std::vector<std::array<int, 3>>;
  for (const Cut& cut :
       {Cut{{0, 1, 2}, {0, 2, 3}}, Cut{{0, 1, 3}, {1, 2, 3}}}) {
    const TriangleMesh mesh = Subdivided(
        {.positions = corners, .normals = {}, .uvs = {}, .triangles = cut}, 3);
    EXPECT_NEAR(AreaOf(mesh), 1, 1e-6);
    for (const V3f& corner : corners) EXPECT_EQ(Distance(mesh, corner), 0);
    for (const V3f& n : mesh.normals) EXPECT_NEAR(n.z, 1, 1e-6);
  }
}

TEST(SubdivideTest, BoundariesBecomeCubicSplines) {
  // A hexagon turns by 60 degrees, too little for corners: its vertices go to
  // (1, 4, 1) / 6 of themselves and their neighbors, 4/6 + 2/6 cos 60 deg.
  const TriangleMesh mesh = Subdivided(Fan(6), 2);
  EXPECT_LT(Distance(mesh, V3f(5.0f / 6, 0, 0)), 1e-6);
  EXPECT_GT(Distance(mesh, V3f(1, 0, 0)), 0.1);
  // A pentagon turns by 72.
  EXPECT_EQ(Distance(Subdivided(Fan(5), 2), V3f(1, 0, 0)), 0);
}

TEST(SubdivideTest, BoundaryVerticesOfOneTriangleStay) {
  // A hexagon cut from its vertex at (1, 0): the two beside that have one
  // triangle each, all others more.
  TriangleMesh hexagon = Fan(6);
  hexagon.triangles = {{1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}};
  const TriangleMesh mesh = Subdivided(hexagon, 2);
  for (const int i : {2, 6}) {
    EXPECT_EQ(Distance(mesh, PositionOf(hexagon, i)), 0);
  }
  for (const int i : {1, 3, 4, 5}) {
    EXPECT_GT(Distance(mesh, PositionOf(hexagon, i)), 0.05);
  }
}

TEST(SubdivideTest, SeamsStaySeams) {
  // A square cut along the diagonal 0-2 into two charts, u < 5 and u > 5.
  const TriangleMesh mesh =
      Subdivided({.positions = {V3f(0, 0, 0), V3f(1, 0, 0), V3f(1, 1, 0),
                                V3f(0, 0, 0), V3f(1, 1, 0), V3f(0, 1, 0)},
                  .normals = {},
                  .uvs = {V2f(0, 0), V2f(1, 0), V2f(1, 1), V2f(10, 0),
                          V2f(11, 1), V2f(10, 1)},
                  .triangles = {{0, 1, 2}, {3, 4, 5}}},
                 2);
  // 25 points, of which the 5 on the diagonal have a value of each chart.
  EXPECT_THAT(mesh.positions, SizeIs(30));
  EXPECT_NEAR(AreaOf(mesh), 1, 1e-6);
  int left = 0;
  for (const auto& t : mesh.triangles) {
    const auto u = [&](std::size_t k) {
      return mesh.uvs[static_cast<std::size_t>(t[k])].x;
    };
    left += u(0) < 5 ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(u(k) < 5, u(0) < 5);
      EXPECT_TRUE((u(k) >= 0 && u(k) <= 1) || (u(k) >= 10 && u(k) <= 11));
    }
  }
  EXPECT_EQ(left, 16);
  ExpectUnitNormals(mesh);
}

TEST(SubdivideTest, WhatIsNoManifoldIsSubdividedTooWithUnitNormals) {
  const std::vector<V3f> points = {V3f(0, 0, 0), V3f(1, 0, 0),   V3f(0, 1, 0),
                                   V3f(0, 0, 1), V3f(0, -1, -1), V3f(1, 1, 1)};
  using Faces = std::vector<std::array<int, 3>>;
  const Faces cases[] = {{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}},  // three at an edge
                         {{0, 1, 2}, {0, 1, 3}},  // of opposite winding
                         {{0, 1, 2}, {0, 3, 4}},  // touching in a point
                         {{0, 1, 2}, {0, 1, 2}},  // the same twice
                         {{0, 1, 2}, {0, 2, 1}},  // and back to back
                         {{0, 1, 2}, {1, 2, 0}, {2, 1, 5}, {2, 1, 0}}};
  for (const Faces& faces : cases) {
    for (const bool with_uvs : {false, true}) {
      const TriangleMesh mesh =
          Subdivided({.positions = points,
                      .normals = {},
                      .uvs = with_uvs ? std::vector<V2f>(6, V2f(0.5f, 2))
                                      : std::vector<V2f>(),
                      .triangles = faces},
                     2);
      EXPECT_THAT(mesh.triangles, SizeIs(16 * faces.size()));
      ExpectUnitNormals(mesh);
      for (const V3f& p : mesh.positions) EXPECT_LT(p.length(), 2);
      for (const V2f& uv : mesh.uvs) {
        EXPECT_LT((uv - V2f(0.5f, 2)).length(), 1e-6);
      }
    }
  }
}

TEST(SubdivideTest, LargeAndTinyCoordinatesKeepTheirShape) {
  const TriangleMesh unit = Subdivided(Icosahedron(), 2);
  for (const float scale : {0x1p100f, 0x1p-100f}) {
    TriangleMesh scaled = Icosahedron();
    for (V3f& p : scaled.positions) p *= scale;
    const TriangleMesh mesh = Subdivided(scaled, 2);
    for (std::size_t i = 0; i < unit.positions.size(); ++i) {
      const V3d off =
          V3d(mesh.positions[i]) / double{scale} - V3d(unit.positions[i]);
      EXPECT_LT(off.length(), 1e-6);
      EXPECT_LT((mesh.normals[i] - unit.normals[i]).length(), 1e-6);
    }
  }
}

TEST(SubdivideTest, TooManyTrianglesAreRefusedBeforehand) {
  EXPECT_TRUE(CheckSubdivision(16384, 6, "f.obj"));  // 2^14 * 4^6 = 2^26
  EXPECT_FALSE(CheckSubdivision(16385, 6, "f.obj"));
  EXPECT_TRUE(CheckSubdivision(std::size_t{1} << 26, 0, "f.obj"));
  EXPECT_FALSE(CheckSubdivision((std::size_t{1} << 26) + 1, 0, "f.obj"));
  const auto result = Subdivide(Fan(16385), 6, true, "f.obj");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(result.error().place, "f.obj");
  EXPECT_THAT(result.error().what, HasSubstr("`subdivide: 6`"));
  EXPECT_THAT(result.error().what, HasSubstr("16385 x 4096 triangles"));
  EXPECT_THAT(result.error().what, HasSubstr("at most 67108864"));
}

TEST(SubdivideTest, WhatOpenSubdivRefusesIsAnError) {
  // It numbers the edges around a vertex in 16 bits.
  const auto result = Subdivide(Fan(70000), 1, true, "f.obj");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(result.error().what, HasSubstr("cannot be subdivided: "));
  EXPECT_THAT(result.error().what, HasSubstr("65535"));
}

}  // namespace
}  // namespace rtb
