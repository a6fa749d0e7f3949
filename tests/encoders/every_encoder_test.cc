// The conformance suite that every encoder gets for free: each entry of the
// registry, and the examples of the documentation, with its defaults and with
// every value of every parameter that has a list of values. Encoders are run on
// pictures that are functions of the position, whatever they ask for and in
// however many rounds.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <ostream>

#include "core/math/random.h"
#include "encoders/adaptive/samples.h"
#include "encoders/decode.h"
#include "encoders/emit/emit.h"
#include "encoders/parameters.h"
#include "encoders/parse/parse.h"
#include "encoders/plan_encoder.h"
#include "tests/encoders/example_encoder.h"
#include "tests/encoders/picture_source.h"
#include "tests/encoders/rounds_encoder.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

struct Variant {
  EncoderEntry entry;
  EncoderParameters parameters;
  std::string name;  ///< Of the test: letters, digits and underscores.
};

void PrintTo(const Variant& variant, std::ostream* out) {
  *out << variant.name;
}

/// What encoders that need parameters are given here.
EncoderParameters RequiredParameters(const std::string& name) {
  if (name != "external") return {};
  const std::string program =
      std::string(RTB_TEST_SOURCE_DIR) + "/tests/data/programs/half_blocks.py";
  return {{"command",
           "/usr/bin/python3 -B '" + program + "' {input} {cols} {rows}"},
          {"samples", "1x2"}};
}

std::vector<Variant> AllVariants() {
  const auto entries = EncoderEntries();
  std::vector<EncoderEntry> all(entries.begin(), entries.end());
  all.push_back(example_entry());
  all.push_back(rounds_entry());
  std::vector<Variant> variants;
  for (const EncoderEntry& entry : all) {
    variants.push_back(
        {entry, RequiredParameters(entry.info.name), entry.info.name});
    for (const EncoderParameter& parameter : entry.info.parameters) {
      if (parameter.values.find('|') == std::string::npos) continue;
      for (const std::string& value : ChoiceNames(parameter)) {
        variants.push_back(
            {entry,
             {{parameter.name, value}},
             entry.info.name + "_" + parameter.name + "_" + value});
      }
    }
  }
  return variants;
}

constexpr double kCellAspect = 0.5;

/// Waves in each channel, some of them beyond [0, 1].
float Waves(double x, double y, int channel) {
  return static_cast<float>(
      0.5 + 0.7 * std::sin((2.1 + channel) * x + 3.7 * y + 0.3 * x * y));
}

class EveryEncoder : public testing::TestWithParam<Variant> {
 protected:
  void SetUp() override {
    const std::string& why_not = GetParam().entry.info.why_not;
    if (!why_not.empty()) GTEST_SKIP() << why_not;
    auto made = GetParam().entry.make(GetParam().parameters);
    ASSERT_TRUE(made) << made.error().ToString();
    encoder_ = std::move(*made);
  }

  /// Runs the encoder, and checks its plans and what it says of them.
  CellGrid Encode(GridSize size, const Picture& picture,
                  const EncodeContext& context = {}) const {
    PictureSource source(picture);
    auto encoding = encoder_->Run(source, size, kCellAspect, context);
    if (!encoding) {
      ADD_FAILURE() << encoding.error().ToString();
      return CellGrid(size);
    }
    for (const SamplePlan& plan : source.plans()) {
      ExpectSound(plan, size, kCellAspect);
    }
    EXPECT_GT(source.samples(), 0);
    EXPECT_DOUBLE_EQ(encoding->rays_per_cell, source.samples() / size.cells());
    return std::move(encoding->grid);
  }

  CellGrid EncodeWaves(GridSize size, int threads = 0) const {
    EncodeContext context;
    context.threads = threads;
    return Encode(size, Waves, context);
  }

  std::unique_ptr<Encoder> encoder_;
};

TEST_P(EveryEncoder, AsksForNoMoreThanItsEntrySays) {
  // The entry speaks of the defaults.
  if (!GetParam().parameters.empty()) return;
  PictureSource source(Waves);
  const auto encoding = encoder_->Run(source, {7, 5}, kCellAspect, {});
  ASSERT_TRUE(encoding) << encoding.error().ToString();
  const int promised = GetParam().entry.info.samples_per_cell;
  EXPECT_LE(encoding->rays_per_cell, promised);
  if (dynamic_cast<const PlanEncoder*>(encoder_.get()) != nullptr) {
    EXPECT_EQ(encoding->rays_per_cell, promised);
  }
}

TEST_P(EveryEncoder, IsPure) {
  EXPECT_EQ(EncodeWaves({7, 5}), EncodeWaves({7, 5}));
}

TEST_P(EveryEncoder, CoversGridsOfAnySize) {
  for (const GridSize size : {GridSize{1, 1}, GridSize{3, 5}, GridSize{17, 1},
                              GridSize{1, 9}, GridSize{80, 24}}) {
    const CellGrid grid = EncodeWaves(size);
    EXPECT_EQ(grid.size, size);
    EXPECT_EQ(grid.cells.size(), static_cast<std::size_t>(size.cells()));
    EXPECT_TRUE(std::ranges::none_of(
        grid.cells, [](const Cell& cell) { return cell.glyph == 0; }));
  }
}

// One thread and more give the same cells. The grid holds some 13 times as many
// as one task takes on (64), so that all threads have work.
TEST_P(EveryEncoder, DoesNotDependOnTheNumberOfThreads) {
  const CellGrid one = EncodeWaves({37, 23}, 1);
  EXPECT_EQ(EncodeWaves({37, 23}, 2), one);
  EXPECT_EQ(EncodeWaves({37, 23}, 3), one);
}

// A picture of one color shows that color everywhere, whatever the glyphs.
TEST_P(EveryEncoder, KeepsAUniformColor) {
  const Rgb8 color{200, 90, 17};
  const CellGrid grid = Encode({3, 2}, [&](double, double, int channel) {
    return Decode8(color)[channel];
  });
  const auto image = Decode(grid, {});
  ASSERT_TRUE(image) << image.error().ToString();
  const Rgb expected = EncodedValues(color);
  for (const Rgb& pixel : image->pixels()) {
    ASSERT_TRUE(pixel.equalWithAbsError(expected, 1e-6f)) << pixel;
  }
}

/// A choice of 0..5 that differs from place to place.
std::size_t Choice(double x, double y, int channel) {
  return RandomBits(std::bit_cast<std::uint32_t>(static_cast<float>(x)),
                    std::bit_cast<std::uint32_t>(static_cast<float>(y)),
                    static_cast<std::uint32_t>(channel), 0) %
         6;
}

// NaN counts as 0, everything else is clipped to [0, 1]; but adaptive averages
// light that is brighter than white, up to a bound.
TEST_P(EveryEncoder, ClipsWhatCannotBeShown) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const bool adaptive = GetParam().entry.info.name == "adaptive";
  const float most = adaptive ? kBrightest : 1;
  const float wild[] = {std::nanf(""), kInfinity, -kInfinity, -3, 1e30f, 0.25f};
  const float clipped[] = {0, most, 0, 0, most, 0.25f};
  const auto picture = [](const float* values) {
    return [values](double x, double y, int channel) {
      return values[Choice(x, y, channel)];
    };
  };
  EXPECT_EQ(Encode({5, 3}, picture(wild)), Encode({5, 3}, picture(clipped)));
}

TEST_P(EveryEncoder, SurvivesTheWayThroughATerminal) {
  const CellGrid grid = EncodeWaves({21, 13});
  const auto parsed = ParseAnsi(EmitAnsi(grid), grid.size);
  ASSERT_TRUE(parsed) << parsed.error().ToString();
  EXPECT_EQ(Canonical(*parsed), Canonical(grid));
}

TEST_P(EveryEncoder, SurvivesTheWayThroughJson) {
  const CellGrid grid = EncodeWaves({21, 13});
  const auto parsed = ParseCellsJson(EmitJson(grid), "test");
  ASSERT_TRUE(parsed) << parsed.error().ToString();
  EXPECT_EQ(*parsed, grid);
}

TEST_P(EveryEncoder, UsesGlyphsThatCanBeDecoded) {
  for (const MaskSource masks : {MaskSource::kGeometric, MaskSource::kFont}) {
    DecodeOptions options;
    options.masks = masks;
    const auto image = Decode(EncodeWaves({40, 20}), options);
    ASSERT_TRUE(image) << image.error().ToString();
    EXPECT_EQ(image->width(), 320);
    EXPECT_EQ(image->height(), 320);
  }
}

/// Shows waves, but fails at one query.
class FailingSource : public FragmentSource {
 public:
  explicit FailingSource(std::size_t failing) : failing_(failing) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    if (waves_.plans().size() == failing_) {
      return Fail(Failure("source", "out of light"));
    }
    return waves_.Query(plan);
  }

 private:
  PictureSource waves_{Waves};
  std::size_t failing_;
};

TEST_P(EveryEncoder, PassesOnTheErrorOfAnyQuery) {
  PictureSource sound(Waves);
  ASSERT_TRUE(encoder_->Run(sound, {4, 3}, kCellAspect, {}));
  for (std::size_t failing = 0; failing < sound.plans().size(); ++failing) {
    FailingSource source(failing);
    const auto encoding = encoder_->Run(source, {4, 3}, kCellAspect, {});
    ASSERT_FALSE(encoding) << failing;
    EXPECT_EQ(encoding.error().place, "source");
    EXPECT_EQ(encoding.error().what, "out of light");
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryEncoder, testing::ValuesIn(AllVariants()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace rtb
