#include "core/shading/bump.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/shading/texture_load.h"

namespace rtb {
namespace {

/// 16 x 8 texels of height a * column + b * (rows from the bottom).
MipChain<float> Ramp(float a, float b) {
  HeightMap map{16, 8, {}};
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      map.values.push_back(a * static_cast<float>(x) +
                           b * static_cast<float>(map.height - 1 - y));
    }
  }
  return MakeMipChain(map);
}

const V2f kMiddle(0.47f, 0.53f);
const V3f kX(1, 0, 0);
const V3f kY(0, 1, 0);
const V3f kZ(0, 0, 1);

void ExpectNear(const V3f& a, const V3f& b) {
  EXPECT_LT((a - b).length(), 1e-5f) << a << " " << b;
}

TEST(BumpTest, FlatHeightsKeepTheNormal) {
  const MipChain<float> flat =
      MakeMipChain(HeightMap{2, 2, {0.7f, 0.7f, 0.7f, 0.7f}});
  const V3f normal = V3f(0.1f, -0.2f, 1).normalized();
  for (const V2f& uv : {V2f(0), V2f(0.3f, 0.9f), V2f(-5.2f, 7.7f)}) {
    EXPECT_LT((BumpNormal(BumpOf(flat, V2f(3), 5), uv, kX, kY, normal) - normal)
                  .length(),
              1e-6f);
  }
}

// A height that rises along u tilts the normal towards -dp/du, one along v,
// which runs up the image, towards -dp/dv.
TEST(BumpTest, NormalsTiltAgainstTheRise) {
  const MipChain<float> along_u = Ramp(1, 0);
  const V3f a = BumpNormal(BumpOf(along_u, V2f(1), 0.01f), kMiddle, kX, kY, kZ);
  EXPECT_LT(a.x, -0.1f);
  EXPECT_NEAR(a.y, 0, 1e-6);
  const MipChain<float> along_v = Ramp(0, 1);
  const V3f b = BumpNormal(BumpOf(along_v, V2f(1), 0.01f), kMiddle, kX, kY, kZ);
  EXPECT_NEAR(b.x, 0, 1e-6);
  EXPECT_LT(b.y, -0.05f);
}

// One texel is 1/16 of u, which is 2/16 of a unit long, and rises by
// a * amount: slope dz/dx = a amount 16 / 2, and dz/dy = b amount 8 / 3.
// The normal of z = s x + t y is (-s, -t, 1).
TEST(BumpTest, TiltedPlaneHasTheClosedFormNormal) {
  const MipChain<float> map = Ramp(0.25f, -0.5f);
  const float amount = 0.3f;
  const V3f expected(-0.25f * amount * 8, 0.5f * amount * 8 / 3, 1);
  ExpectNear(
      BumpNormal(BumpOf(map, V2f(1), amount), kMiddle, kX * 2, kY * 3, kZ),
      expected.normalized());
  // Four repetitions in u: as steep again by four.
  ExpectNear(BumpNormal(BumpOf(map, V2f(4, 1), amount), kMiddle / V2f(4, 1),
                        kX * 2, kY * 3, kZ),
             V3f(expected.x * 4, expected.y, 1).normalized());
}

// Displaced along the normal, the tangents are dp/du + n dh/du and
// dp/dv + n dh/dv; their cross product is the normal, up to the handedness.
// The map is linear here, so the terms that Blinn leaves out are zero.
TEST(BumpTest, RotatedSlantedAndMirroredTangents) {
  const MipChain<float> map = Ramp(0.25f, -0.5f);
  const float amount = 0.3f;
  const float du = 0.25f * amount * 16;
  const float dv = -0.5f * amount * 8;
  for (const float angle : {0.0f, 0.7f, 2.0f, 4.0f}) {
    const V3f dpdu(std::cos(angle), std::sin(angle), 0);
    const V3f turned(-std::sin(angle), std::cos(angle), 0);
    for (const float hand : {1.0f, -1.0f}) {
      const V3f dpdv = turned * (hand * 2) + dpdu * 0.6f;
      const V3f expected =
          (dpdu + kZ * du).cross(dpdv + kZ * dv).normalized() * hand;
      ExpectNear(
          BumpNormal(BumpOf(map, V2f(1), amount), kMiddle, dpdu, dpdv, kZ),
          expected);
    }
  }
}

TEST(BumpTest, NegativeAmountsAndScalesTurnTheTiltAround) {
  const MipChain<float> map = Ramp(1, 0);
  const V3f rise = BumpNormal(BumpOf(map, V2f(1), 0.01f), kMiddle, kX, kY, kZ);
  const V3f fall = BumpNormal(BumpOf(map, V2f(1), -0.01f), kMiddle, kX, kY, kZ);
  ExpectNear(fall, V3f(-rise.x, rise.y, rise.z));
  ExpectNear(BumpNormal(BumpOf(map, V2f(-1, 1), 0.01f), kMiddle, kX, kY, kZ),
             fall);
}

// Heights 0 1 0 1 ...: the slope goes from one sign to the other in straight
// lines, without jumps: by at most 4 per texel, here 256 steps a texel.
TEST(BumpTest, SlopesAreContinuous) {
  const MipChain<float> map = MakeMipChain(HeightMap{4, 1, {0, 1, 0, 1}});
  const BumpData bump = BumpOf(map, V2f(1), 0.25f);  // slope per texel
  float least = 0, most = 0;
  float before = HeightSlope(bump, V2f(0)).x;
  for (int i = 1; i <= 1024; ++i) {
    const float slope =
        HeightSlope(bump, V2f(static_cast<float>(i) / 1024, 0.5f)).x;
    EXPECT_LE(std::abs(slope - before), 4.0f / 256 + 1e-5f) << i;
    least = std::min(least, slope);
    most = std::max(most, slope);
    before = slope;
  }
  EXPECT_EQ(most, 1);
  EXPECT_EQ(least, -1);
}

TEST(BumpTest, WithoutTangentsTheNormalStays) {
  const MipChain<float> map = Ramp(1, 1);
  const BumpData bump = BumpOf(map, V2f(1), 1);
  EXPECT_EQ(BumpNormal(bump, kMiddle, V3f(0), kY, kZ), kZ);
  EXPECT_EQ(BumpNormal(bump, kMiddle, kY, kY * 2, kZ), kZ);
}

}  // namespace
}  // namespace rtb
