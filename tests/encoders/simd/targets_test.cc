// Every vector instruction set gives the cells of the scalar encoders, cell for
// cell, whatever the samples and however many cells there are.
#include <gtest/gtest.h>

#include <limits>
#include <ostream>

#include "core/math/random.h"
#include "encoders/encode_cells.h"
#include "tests/encoders/given_source.h"
#include "tests/encoders/testing.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

struct Kind {
  std::string spec;
  int samples;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.spec; }

using Values = std::vector<Rgb>;

/// Where a component of a sample stands.
struct Place {
  int cell, sample, channel;
};

using Value = float (*)(std::uint32_t bits, const Place& place);

/// `value(random bits, place)` for each component.
Values Made(int cells, int samples, std::uint64_t seed, Value value) {
  Values values;
  for (int cell = 0; cell < cells; ++cell) {
    for (int sample = 0; sample < samples; ++sample) {
      Rgb color(0);
      for (int channel = 0; channel < 3; ++channel) {
        const std::uint32_t bits =
            RandomBits(static_cast<std::uint32_t>(cell),
                       static_cast<std::uint32_t>(sample),
                       static_cast<std::uint32_t>(channel), seed);
        color[channel] = value(bits, {cell, sample, channel});
      }
      values.push_back(color);
    }
  }
  return values;
}

float OfCode(std::uint32_t code) {
  return SrgbDecode8(static_cast<std::uint8_t>(code));
}

float AnyFloat(std::uint32_t bits, const Place&) {
  return std::bit_cast<float>(bits);
}

/// What cannot be shown, between what can.
float Wild(std::uint32_t bits, const Place&) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kValues[] = {kNan, kInfinity, -kInfinity, -1,    1e30f,
                               0,    1e-38f,    1e-45f,     0.25f, 0.5f};
  return kValues[bits % std::size(kValues)];
}

float AnyCode(std::uint32_t bits, const Place&) { return OfCode(bits % 256); }

/// A few neighboring codes, which have many equal partitions.
float FewCodes(std::uint32_t bits, const Place& place) {
  const auto base = static_cast<std::uint32_t>(place.cell % 250);
  return OfCode(base + bits % (2 + base % 4));
}

/// Two to five equal steps apart.
float EvenSteps(std::uint32_t bits, const Place& place) {
  const auto step = static_cast<std::uint32_t>(1 + place.cell % 50);
  return OfCode(step * (bits % (2 + step % 4)));
}

/// One code, and noise far below it.
float Noise(std::uint32_t bits, const Place& place) {
  const float scale = place.cell % 3 == 0   ? 1e-7f
                      : place.cell % 3 == 1 ? 1e-6f
                                            : 1e-4f;
  return OfCode(static_cast<std::uint32_t>(place.cell % 256)) *
         (1 + scale * UnitFloat(bits));
}

/// A color, and differences of a few steps (steps.h) from it, about kNoise.
float FewSteps(std::uint32_t bits, const Place& place) {
  const int code = 50 + (place.cell * 37 + place.channel * 71) % 200;
  return OfCode(static_cast<std::uint32_t>(code)) *
         (1 + 4e-6f * UnitFloat(bits));
}

/// A gradient down the cell.
float Gradient(std::uint32_t, const Place& place) {
  return 0.3f + 0.0001f * static_cast<float>(place.cell * place.sample);
}

float Flat(std::uint32_t, const Place& place) {
  return 0.001f * static_cast<float>(place.cell);
}

/// Each kind of samples there is, after one another.
Values Zoo(int cells, int samples) {
  Values all;
  for (const Value value : {AnyFloat, Wild, AnyCode, FewCodes, EvenSteps, Noise,
                            FewSteps, Gradient, Flat}) {
    const Values some = Made(cells, samples, all.size(), value);
    all.insert(all.end(), some.begin(), some.end());
  }
  const Values random = RandomValues(cells * samples, 5);
  all.insert(all.end(), random.begin(), random.end());
  return all;
}

CellGrid EncodeWith(const Encoder& encoder, int samples, const Values& values,
                    bool scalar) {
  GivenSource source(values);
  EncodeContext context;
  context.threads = 1;
  context.scalar = scalar;
  const GridSize size{static_cast<int>(values.size()) / samples, 1};
  auto encoding = encoder.Run(source, size, 0.5, context);
  if (!encoding) CheckFailed(__FILE__, __LINE__, encoding.error().ToString());
  return std::move(encoding->grid);
}

int Differences(const CellGrid& a, const CellGrid& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    if (a.cells[i] == b.cells[i]) continue;
    if (count == 0) {
      EXPECT_EQ(a.cells[i], b.cells[i]) << "cell " << i;
    }
    ++count;
  }
  return count;
}

class SimdTargetsTest : public testing::TestWithParam<Kind> {
 protected:
  const std::unique_ptr<Encoder> encoder_ = Make(GetParam().spec);
  const int samples_ = GetParam().samples;
};

TEST_P(SimdTargetsTest, GiveTheCellsOfTheScalarEncoder) {
  const Values values = Zoo(1501, samples_);
  const CellGrid expected = EncodeWith(*encoder_, samples_, values, true);
  ForEachSimdTarget([&] {
    const CellGrid grid = EncodeWith(*encoder_, samples_, values, false);
    EXPECT_EQ(Differences(grid, expected), 0);
  });
}

// Grids up to beyond twice the lanes of any target: every remainder.
TEST_P(SimdTargetsTest, TakeAnyNumberOfCells) {
  const Values values = RandomValues(40 * samples_, 9);
  ForEachSimdTarget([&] {
    for (int cells = 1; cells <= 40; ++cells) {
      const Values some(values.begin(), values.begin() + cells * samples_);
      EXPECT_EQ(EncodeWith(*encoder_, samples_, some, false),
                EncodeWith(*encoder_, samples_, some, true))
          << cells;
    }
  });
}

std::vector<Kind> Kinds() {
  return {{"half", 2},    {"quadrant", 4}, {"quadrant:split=best", 4},
          {"sextant", 6}, {"octant", 8},   {"braille", 8},
          {"tiv", 32},
          {"optimal:mask=8x8", 64},
          {"optimal:glyphs=blocks+quadrants+octants:mask=2x4", 8},
          {"optimal:glyphs=sextants+octants+wedges+eighths", 128},
          {"optimal:glyphs=shades+ascii:mask=4x8", 32},
          {"optimal:glyphs=braille+box+eighths:mask=5x7", 35},
          {"optimal:blend=linear:mask=2x2", 4}};
}

std::string NameOf(const Kind& kind) {
  std::string name = kind.spec;
  for (char& c : name) {
    if (c == ':' || c == '=' || c == '+') c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(, SimdTargetsTest, testing::ValuesIn(Kinds()),
                         [](const auto& test) { return NameOf(test.param); });

}  // namespace
}  // namespace rtb
