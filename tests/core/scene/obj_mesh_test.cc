#include "core/scene/obj_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <string>

#include "core/base/file.h"
#include "core/scene/load.h"
#include "tests/core/scene/mesh_shapes.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The mesh of an OBJ text, through a file of the running test's own.
Result<ObjMesh> FromText(const std::string& text) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->name()) + ".obj";
  for (char& c : name) c = c == '/' ? '_' : c;
  const auto file = std::filesystem::path(testing::TempDir()) / name;
  EXPECT_TRUE(WriteFileAtomically(file, text));
  auto mesh = ReadObjMesh(file);
  std::filesystem::remove(file);
  return mesh;
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjMeshTest, TriangleAsWritten) {
  const auto obj = FromText("o name\n" + kSquare + "usemtl m\nf 1 2 3\n");
  ASSERT_TRUE(obj) << obj.error().ToString();
  EXPECT_THAT(obj->mesh.positions,
              ElementsAre(V3f(0, 0, 0), V3f(1, 0, 0), V3f(1, 1, 0)));
  EXPECT_THAT(obj->mesh.triangles, ElementsAre(std::array<int, 3>{0, 1, 2}));
  EXPECT_THAT(obj->mesh.normals, IsEmpty());
  EXPECT_THAT(obj->mesh.uvs, IsEmpty());
  EXPECT_THAT(obj->warnings, IsEmpty());
}

TEST(ObjMeshTest, PolygonsAreTriangulated) {
  const auto quad = FromText(kSquare + "f 1 2 3 4\n");
  ASSERT_TRUE(quad);
  EXPECT_THAT(quad->mesh.triangles, SizeIs(2));
  EXPECT_THAT(quad->mesh.positions, SizeIs(4));
  EXPECT_DOUBLE_EQ(AreaOf(quad->mesh), 1);
  // An L of three unit squares: not convex, four triangles, area 3.
  const auto ell = FromText(
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
      "f 1 2 3 4 5 6\n");
  ASSERT_TRUE(ell);
  EXPECT_THAT(ell->mesh.triangles, SizeIs(4));
  EXPECT_DOUBLE_EQ(AreaOf(ell->mesh), 3);
}

TEST(ObjMeshTest, QuadsThatAreNotConvexAreCutInside) {
  // An arrowhead of height 10 with a notch of height 1: 10 - 1, though the
  // diagonal across the notch is the shorter one. Started at each corner, in
  // both windings.
  const std::string arrow = "v 0 10 0\nv -1 0 0\nv 0 1 0\nv 1 0 0\n";
  for (const char* face : {"f 1 2 3 4", "f 2 3 4 1", "f 3 4 1 2", "f 4 1 2 3",
                           "f 4 3 2 1", "f 3 2 1 4"}) {
    const auto obj = FromText(arrow + face + "\n");
    ASSERT_TRUE(obj);
    EXPECT_THAT(obj->mesh.triangles, SizeIs(2));
    EXPECT_DOUBLE_EQ(AreaOf(obj->mesh), 9) << face;
  }
}

TEST(ObjMeshTest, TrianglesThatFoldAreNotTakenForQuads) {
  // A flap that folds back over its neighbor, written as triangles: both of
  // area 1/2, and kept as they are.
  const auto obj =
      FromText("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.9 0.1 0.1\nf 1 2 3\nf 1 3 4\n");
  ASSERT_TRUE(obj);
  EXPECT_THAT(obj->mesh.triangles, ElementsAre(std::array<int, 3>{0, 1, 2},
                                               std::array<int, 3>{0, 2, 3}));
}

TEST(ObjMeshTest, NegativeIndicesCountBack) {
  const auto obj = FromText(kSquare + "f -4 -3 -2\n");
  ASSERT_TRUE(obj);
  EXPECT_THAT(obj->mesh.positions,
              ElementsAre(V3f(0, 0, 0), V3f(1, 0, 0), V3f(1, 1, 0)));
}

TEST(ObjMeshTest, FacesMayComeBeforeTheirVertices) {
  EXPECT_TRUE(FromText("f 1 2 3\n" + kSquare));
}

TEST(ObjMeshTest, CornersMergeIntoOneIndex) {
  const auto obj =
      ReadObjMesh(RTB_TEST_SOURCE_DIR "/tests/data/scenes/smooth.obj");
  ASSERT_TRUE(obj) << obj.error().ToString();
  // Corners (v/vt/vn): 1/1/1 2/2/1 3/3/1, then 3/3/1 2/1/1 4/2/2: five.
  const TriangleMesh& mesh = obj->mesh;
  EXPECT_THAT(mesh.triangles, ElementsAre(std::array<int, 3>{0, 1, 2},
                                          std::array<int, 3>{2, 3, 4}));
  EXPECT_EQ(mesh.positions[1], mesh.positions[3]);
  EXPECT_THAT(mesh.uvs, ElementsAre(V2f(0, 0), V2f(1, 0), V2f(0, 1), V2f(0, 0),
                                    V2f(1, 0)));
  // `vn 0 0 2` is brought to length 1.
  EXPECT_THAT(mesh.normals,
              ElementsAre(V3f(0, 0, 1), V3f(0, 0, 1), V3f(0, 0, 1),
                          V3f(0, 0, 1), V3f(0, 1, 0)));
}

TEST(ObjMeshTest, NormalsOfSomeCornersAreNoNormals) {
  const auto obj = FromText(kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n");
  ASSERT_TRUE(obj);
  EXPECT_THAT(obj->mesh.triangles, SizeIs(2));
  EXPECT_THAT(obj->mesh.normals, IsEmpty());
  EXPECT_THAT(obj->warnings, ElementsAre(HasSubstr("normals were left out")));
}

TEST(ObjMeshTest, TextureCoordinatesOfSomeCornersAreNone) {
  const auto obj = FromText(kSquare + "vt 0 inf\nf 1/1 2/1 3/1\nf 1 3 4\n");
  ASSERT_TRUE(obj);
  EXPECT_THAT(obj->mesh.uvs, IsEmpty());
  EXPECT_THAT(obj->warnings,
              ElementsAre(HasSubstr(": 1 texture coordinates"),
                          HasSubstr("texture coordinates were left out")));
}

TEST(ObjMeshTest, NormalsWithoutALengthAreReplaced) {
  const auto obj = FromText(kSquare +
                            "vn 0 0 0\nvn nan 0 0\nvn 0 1e30 0\n"
                            "vn 1e-30 0 0\n"
                            "f 1//1 2//2 3//3\nf 1//4 3//3 4//4\n");
  ASSERT_TRUE(obj);
  // The first two become the face's; the others are directions like any.
  EXPECT_THAT(obj->mesh.normals,
              ElementsAre(V3f(0, 0, 1), V3f(0, 0, 1), V3f(0, 1, 0),
                          V3f(1, 0, 0), V3f(1, 0, 0)));
  EXPECT_THAT(obj->warnings, ElementsAre(HasSubstr(": 2 normals")));
}

TEST(ObjMeshTest, AreasAreJudgedAfterRoundingToFloat) {
  const auto obj = FromText(
      "v 0 0 0\nv 1 0 0\nv 1.00000001 0 0\nv 0 1 0\n"
      "v 0.7 0.7 0.7\nv 100.1 100.1 100.1\nv 1e-30 1e-30 1e-30\n"
      "f 1 2 4\n"    // stays
      "f 2 3 4\n"    // the same place after rounding
      "f 5 6 7\n"    // on one line
      "f 5 6 1\n"    // likewise
      "f 1 2 3\n");  // likewise
  ASSERT_TRUE(obj);
  EXPECT_THAT(obj->mesh.triangles, SizeIs(1));
  EXPECT_THAT(obj->warnings, ElementsAre(HasSubstr(": 4 triangles")));
}

TEST(ObjMeshTest, HugeAndTinyTrianglesHaveAnArea) {
  const auto obj = FromText(
      "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nv 1e-30 0 0\nv 0 1e-30 0\n"
      "v 3e38 3e38 -3e38\nv 1e-44 0 0\nv 0 1e-44 0\n"
      "f 1 2 3\nf 1 4 5\nf 1 2 6\nf 1 7 8\n"
      "f 1 2 4\nf 1 7 2\n");  // on the x axis: none
  ASSERT_TRUE(obj);
  EXPECT_THAT(obj->mesh.triangles, SizeIs(4));
  EXPECT_THAT(obj->warnings, ElementsAre(HasSubstr(": 2 triangles")));
}

TEST(ObjMeshTest, DegenerateAndNonFiniteTrianglesAreDropped) {
  const auto obj = FromText(kSquare +
                            "v nan 0 0\nv 2 0 0\nv 0 0 1e99\n"
                            "f 1 2 3\n"  // stays
                            "f 1 1 2\n"  // a vertex twice
                            "f 1 2 6\n"  // on one line
                            "f 1 2 5\n"  // nan
                            "f 1 2 7\n"  // overflow
                            "f 1 2\n");  // no face
  ASSERT_TRUE(obj) << obj.error().ToString();
  EXPECT_THAT(obj->mesh.triangles, SizeIs(1));
  EXPECT_THAT(obj->warnings,
              ElementsAre(HasSubstr(": 1 faces"), HasSubstr(": 4 triangles")));
}

struct BadObj {
  std::string name;
  std::string text;
  std::string message;
};
void PrintTo(const BadObj& row, std::ostream* out) { *out << row.name; }

class BadObjTest : public testing::TestWithParam<BadObj> {};

TEST_P(BadObjTest, IsAnErrorThatNamesFileAndLine) {
  const auto obj = FromText(GetParam().text);
  ASSERT_FALSE(obj);
  EXPECT_EQ(obj.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(obj.error().ToString(), HasSubstr(GetParam().message));
  EXPECT_THAT(obj.error().place, HasSubstr(".obj"));
}

const BadObj kBadObjs[] = {
    {"Empty", "", "no triangle"},
    {"NoFaces", kSquare, "no triangle"},
    {"OnlyDegenerate", kSquare + "f 1 1 2\n", "no triangle"},
    {"IndexTooLarge", kSquare + "f 1 2 5\n",
     ".obj:5: a face refers to vertex 5, the file has 4"},
    {"QuadIndexTooLarge", kSquare + "f 1 2 3 99\n", "refers to vertex 99"},
    {"PolygonIndexTooLarge", kSquare + "f 1 2 3 4 99\n", "refers to vertex 99"},
    {"IndexTooFarBack", kSquare + "f 1 2 -5\n", "only 4 stand before it"},
    {"IndexZero", kSquare + "f 0 1 2\n", "indices from 1"},
    {"IndexMissing", kSquare + "f 1 2 /3\n", "indices from 1"},
    {"IndexEmptyNormal", kSquare + "f 1// 2// 3//\n", "indices from 1"},
    {"IndexFraction", kSquare + "f 1 2 3.5\n", "`3.5`"},
    {"IndexHuge", kSquare + "f 1 2 99999999999\n", "indices from 1"},
    {"IndexOfFour", kSquare + "f 1/1/1/1 2 3\n", "expected v/vt/vn"},
    {"NoTextureCoordinate", kSquare + "f 1/1 2/1 3/1\n",
     "refers to texture coordinate 1, the file has 0"},
    {"NoNormal", kSquare + "f 1//2 2//2 3//2\n",
     "refers to normal 2, the file has 0"},
    {"VertexWord", "v 0 x 0\n", ".obj:1: found `x`, expected a number"},
    {"VertexShort", "v 0 0\n", "has 2 numbers, expected 3..7"},
    {"Continued", kSquare + "f 1 2 \\\n3\n", "`\\`"},
    {"Binary", std::string("v \0\x01\x02 1 2\n", 11), "expected a number"},
};

INSTANTIATE_TEST_SUITE_P(Table, BadObjTest, testing::ValuesIn(kBadObjs),
                         [](const auto& row) { return row.param.name; });

TEST(ObjMeshTest, FacesOfTooManyVerticesAreRefused) {
  std::string face = "f";
  for (int i = 0; i <= 1024; ++i) face += " 1";
  const auto obj = FromText(kSquare + face + "\n");
  ASSERT_FALSE(obj);
  EXPECT_THAT(obj.error().ToString(), HasSubstr("more than 1024 vertices"));
}

TEST(ObjMeshTest, TheSceneNamesItsBadMesh) {
  const auto scene = ParseScene(
      kPreamble + "objects:\n  - {type: mesh, file: bad_index.obj}\n",
      RTB_TEST_SOURCE_DIR "/tests/data/scenes/bad/s.yaml");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().place, HasSubstr("s.yaml:5:24"));
  EXPECT_THAT(scene.error().ToString(),
              HasSubstr("bad_index.obj:4: a face refers to vertex 4"));
}

}  // namespace
}  // namespace rtb
