#include "core/color/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "core/color/srgb_tables.h"
#include "core/math/random.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// IEC 61966-2-1, from the standard's own constants.
double DecodeByTheFormula(double encoded) {
  if (encoded <= 0.04045) return encoded / 12.92;
  return std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Clipped, encoded as IEC 61966-2-1 says and rounded half up.
int CodeByTheFormula(float linear) {
  if (!(linear > 0)) return 0;
  const double l = std::fmin(linear, 1.0);
  const double encoded =
      l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
  return static_cast<int>(encoded * 255 + 0.5);
}

std::uint8_t Code(int i) { return static_cast<std::uint8_t>(i); }

TEST(Srgb, EveryCodeSurvivesTheRoundTrip) {
  for (int i = 0; i < 256; ++i) {
    EXPECT_EQ(SrgbEncode8(SrgbDecode8(Code(i))), i);
    EXPECT_EQ(QuantizeEncoded(EncodedValues({Code(i), 0, 0}).x), i);
    const Rgb8 color{Code(i), Code(255 - i), Code(i / 2)};
    EXPECT_EQ(Encode8(Decode8(color)), color);
    EXPECT_EQ(QuantizeEncoded(EncodedValues(color)), color);
  }
}

TEST(Srgb, CodesDecodeByTheFormula) {
  for (int i = 0; i < 256; ++i) {
    const double expected = DecodeByTheFormula(i / 255.0);
    EXPECT_FLOAT_EQ(SrgbDecode8(Code(i)), static_cast<float>(expected)) << i;
  }
  EXPECT_EQ(SrgbDecode8(0), 0);
  EXPECT_EQ(SrgbDecode8(255), 1);
}

// A code's interval in linear light ends where the encoded value is half way
// to the next code.
TEST(Srgb, EncodingRoundsAtTheHalfWayPoints) {
  for (int i = 0; i < 255; ++i) {
    const double border = DecodeByTheFormula((i + 0.5) / 255);
    EXPECT_EQ(SrgbEncode8(static_cast<float>(border * (1 - 1e-5))), i);
    EXPECT_EQ(SrgbEncode8(static_cast<float>(border * (1 + 1e-5))), i + 1);
  }
}

// Every float within 64 of each border between two codes.
TEST(Srgb, EncodingIsTheFormulaAroundEveryBorder) {
  for (int i = 0; i < 255; ++i) {
    const auto border = static_cast<float>(DecodeByTheFormula((i + 0.5) / 255));
    const auto middle = std::bit_cast<std::uint32_t>(border);
    for (std::uint32_t bits = middle - 64; bits <= middle + 64; ++bits) {
      const float linear = std::bit_cast<float>(bits);
      ASSERT_EQ(SrgbEncode8(linear), CodeByTheFormula(linear)) << linear;
    }
  }
}

// Any bit pattern - negative numbers, denormals, infinities and NaN are among
// them - and as many from 2^-16 to 1, where codes differ.
TEST(Srgb, EncodingIsTheFormulaForFloatsOfAnyKind) {
  for (std::uint32_t i = 0; i < 5'000'000; ++i) {
    const std::uint32_t bits = RandomBits(i, 0, 0, 0);
    const float any = std::bit_cast<float>(bits);
    ASSERT_EQ(SrgbEncode8(any), CodeByTheFormula(any)) << any;
    const float shown =
        std::bit_cast<float>(0x37800000u + (bits & 0x07ffffffu));
    ASSERT_EQ(SrgbEncode8(shown), CodeByTheFormula(shown)) << shown;
  }
}

double EncodeByTheFormula(float linear) {
  if (!(linear > 0)) return 0;
  const double l = std::fmin(linear, 1.0);
  return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

// The float above the knee lies on the power's side of the formula.
TEST(Srgb, TheKneeIsTheLastFloatOfTheLinearPiece) {
  EXPECT_LE(static_cast<double>(SrgbCurveTable::kKnee), 0.0031308);
  EXPECT_GT(static_cast<double>(std::nextafter(SrgbCurveTable::kKnee, 1.0f)),
            0.0031308);
}

TEST(Srgb, UnroundedEncodingIsTheFormulaToOneInTenMillion) {
  for (std::uint32_t i = 0; i < 3'000'000; ++i) {
    const std::uint32_t bits = RandomBits(i, 1, 0, 0);
    const float any = std::bit_cast<float>(bits);
    ASSERT_NEAR(SrgbEncode(any), EncodeByTheFormula(any), 1e-7) << any;
    const float shown =
        std::bit_cast<float>(0x37800000u + (bits & 0x07ffffffu));
    ASSERT_NEAR(SrgbEncode(shown), EncodeByTheFormula(shown), 1e-7) << shown;
  }
}

/// Random bits, and floats where codes differ.
std::vector<float> FloatsOfAnyKind(std::uint32_t count) {
  std::vector<float> values = {
      kNan, -kNan, kInf, -kInf, 0.0f, -0.0f, 1, 2, SrgbCurveTable::kKnee};
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t bits = RandomBits(i, 2, 0, 0);
    values.push_back(std::bit_cast<float>(bits));
    values.push_back(std::bit_cast<float>(0x37800000u + (bits & 0x07ffffffu)));
  }
  return values;
}

bool HaveEqualBits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

// Lengths up to beyond twice the lanes of any target: every remainder.
TEST(Srgb, VectorsEncodeAsSingleValuesDo) {
  const std::vector<float> values = FloatsOfAnyKind(100'000);
  const std::span<const float> all(values);
  ForEachSimdTarget([&] {
    for (std::size_t count = 0; count < 40; ++count) {
      std::vector<float> encoded(count + 1, -7);
      SrgbEncode(all.first(count), std::span(encoded).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_PRED2(HaveEqualBits, encoded[i], SrgbEncode(values[i]));
      }
      EXPECT_EQ(encoded[count], -7);
    }
    std::vector<float> encoded(values.size());
    SrgbEncode(all, encoded);
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_PRED2(HaveEqualBits, encoded[i], SrgbEncode(values[i]))
          << values[i];
    }
  });
}

TEST(Srgb, VectorsOfColorsEncodeAsSingleColorsDo) {
  const std::vector<float> values = FloatsOfAnyKind(100'000);
  std::vector<Rgb> colors;
  for (std::size_t i = 0; i + 3 <= values.size(); i += 3) {
    colors.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
  const std::span<const Rgb> all(colors);
  ForEachSimdTarget([&] {
    for (const std::size_t count : {0, 1, 2, 3, 5, 6, 7, 20, 50'000}) {
      std::vector<Rgb8> codes(count);
      std::vector<Rgb> encoded(count, Rgb(0));
      Encode8(all.first(count), codes);
      SrgbEncode(all.first(count), encoded);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(codes[i], Encode8(colors[i])) << colors[i];
        ASSERT_EQ(encoded[i].y, SrgbEncode(colors[i].y)) << colors[i];
      }
    }
  });
}

TEST(Srgb, FloatTransferIsItsOwnInverse) {
  for (int i = 0; i <= 1000; ++i) {
    const float value = static_cast<float>(i) / 1000;
    EXPECT_NEAR(SrgbDecode(value), DecodeByTheFormula(value), 1e-7);
    EXPECT_NEAR(SrgbEncode(SrgbDecode(value)), value, 2e-7);
  }
  // 18 % gray: 1.055 * 0.18^(1/2.4) - 0.055 = 0.4613561...
  EXPECT_NEAR(SrgbEncode(0.18f), 0.461356, 1e-6);
  EXPECT_EQ(SrgbEncode8(0.18f), 118);  // 0.4613561 * 255 = 117.6
}

TEST(Srgb, ClipsAndTakesNanForZero) {
  for (const float low : {-0.0f, -1e-30f, -0.5f, -kInf, kNan, -kNan}) {
    EXPECT_EQ(SrgbEncode(low), 0);
    EXPECT_EQ(SrgbDecode(low), 0);
    EXPECT_EQ(SrgbEncode8(low), 0);
    EXPECT_EQ(QuantizeEncoded(low), 0);
  }
  for (const float high : {1.0f, 1.0001f, 1e30f, kInf}) {
    EXPECT_FLOAT_EQ(SrgbEncode(high), 1);
    EXPECT_FLOAT_EQ(SrgbDecode(high), 1);
    EXPECT_LE(SrgbEncode(high), 1);
    EXPECT_EQ(SrgbEncode8(high), 255);
    EXPECT_EQ(QuantizeEncoded(high), 255);
  }
  // The smallest denormal is black, not trouble.
  EXPECT_EQ(SrgbEncode8(std::numeric_limits<float>::denorm_min()), 0);
}

TEST(Srgb, QuantizingRoundsHalfUp) {
  EXPECT_EQ(QuantizeEncoded(0.5f), 128);  // 127.5
  EXPECT_EQ(QuantizeEncoded(0.499f), 127);
  EXPECT_EQ(QuantizeEncoded(Rgb(0, 0.5f, 1)), (Rgb8{0, 128, 255}));
}

}  // namespace
}  // namespace rtb
