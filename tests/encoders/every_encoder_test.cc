// The conformance suite that every encoder gets for free: each entry of the
// registry, and the example of the documentation, with its defaults and with
// every value of every parameter that has a list of values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "core/base/check.h"
#include "encoders/decode.h"
#include "encoders/emit/emit.h"
#include "encoders/parameters.h"
#include "encoders/parse/parse.h"
#include "tests/encoders/example_encoder.h"
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

std::vector<Variant> AllVariants() {
  const auto entries = EncoderEntries();
  std::vector<EncoderEntry> all(entries.begin(), entries.end());
  all.push_back(example_entry());
  std::vector<Variant> variants;
  for (const EncoderEntry& entry : all) {
    variants.push_back({entry, {}, entry.info.name});
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

class EveryEncoder : public testing::TestWithParam<Variant> {
 protected:
  void SetUp() override {
    auto made = GetParam().entry.make(GetParam().parameters);
    ASSERT_TRUE(made) << made.error().ToString();
    encoder_ = std::move(*made);
  }

  CellGrid EncodeRandom(GridSize size, int threads = 0) const {
    EncodeContext context;
    context.threads = threads;
    return encoder_->Encode(RandomFragments(PlanFor(size), 7), context);
  }

  SamplePlan PlanFor(GridSize size) const {
    return encoder_->Plan(size, 0.5, 0);
  }

  std::unique_ptr<Encoder> encoder_;
};

TEST_P(EveryEncoder, PlansAsManyPositionsAsItSaysInsideTheCell) {
  const SamplePlan plan = encoder_->Plan({3, 2}, 0.5, 1);
  EXPECT_EQ(plan.grid, (GridSize{3, 2}));
  EXPECT_EQ(plan.cell_aspect, 0.5);
  if (GetParam().parameters.empty()) {
    EXPECT_EQ(plan.samples_per_cell, GetParam().entry.info.samples_per_cell);
  }
  const auto samples = static_cast<std::size_t>(plan.samples_per_cell);
  EXPECT_TRUE(plan.positions.size() == samples ||
              plan.positions.size() == 6 * samples);
  for (const V2f& position : plan.positions) {
    EXPECT_GE(std::min(position.x, position.y), 0.0f);
    EXPECT_LT(std::max(position.x, position.y), 1.0f);
  }
  EXPECT_GT(std::min(plan.footprint.x, plan.footprint.y), 0.0f);
  EXPECT_LE(std::max(plan.footprint.x, plan.footprint.y), 1.0f);
}

TEST_P(EveryEncoder, IsPure) {
  EXPECT_EQ(EncodeRandom({7, 5}), EncodeRandom({7, 5}));
}

TEST_P(EveryEncoder, CoversGridsOfAnySize) {
  for (const GridSize size : {GridSize{1, 1}, GridSize{3, 5}, GridSize{17, 1},
                              GridSize{1, 9}, GridSize{80, 24}}) {
    const CellGrid grid = EncodeRandom(size);
    EXPECT_EQ(grid.size, size);
    EXPECT_EQ(grid.cells.size(), static_cast<std::size_t>(size.cells()));
    EXPECT_TRUE(std::ranges::none_of(
        grid.cells, [](const Cell& cell) { return cell.glyph == 0; }));
  }
}

// Cells are encoded one by one: the last cell of a grid is what a grid of that
// cell alone would hold.
TEST_P(EveryEncoder, DoesNotDependOnTheNumberOfThreads) {
  const CellGrid one = EncodeRandom({37, 23}, 1);
  EXPECT_EQ(EncodeRandom({37, 23}, 2), one);
  EXPECT_EQ(EncodeRandom({37, 23}, 3), one);
}

// A picture of one color shows that color everywhere, whatever the glyphs.
TEST_P(EveryEncoder, KeepsAUniformColor) {
  const Rgb8 color{200, 90, 17};
  Fragments fragments(PlanFor({3, 2}));
  std::ranges::fill(fragments.values, Decode8(color));
  const auto image = Decode(encoder_->Encode(fragments, {}), {});
  ASSERT_TRUE(image) << image.error().ToString();
  const Rgb expected = EncodedValues(color);
  for (const Rgb& pixel : image->pixels()) {
    ASSERT_TRUE(pixel.equalWithAbsError(expected, 1e-6f)) << pixel;
  }
}

// NaN counts as 0, everything else is clipped to [0, 1].
TEST_P(EveryEncoder, ClipsWhatCannotBeShown) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float wild[] = {std::nanf(""), kInfinity, -kInfinity, -3, 1e30f, 0.25f};
  const float clipped[] = {0, 1, 0, 0, 1, 0.25f};
  Fragments raw(PlanFor({5, 3}));
  Fragments tame = raw;
  for (std::size_t i = 0; i < raw.values.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      // 7 and 5 spread the values over samples and channels.
      const std::size_t which =
          (7 * i / 3 + 5 * static_cast<std::size_t>(channel)) % 6;
      raw.values[i][channel] = wild[which];
      tame.values[i][channel] = clipped[which];
    }
  }
  EXPECT_EQ(encoder_->Encode(raw, {}), encoder_->Encode(tame, {}));
}

TEST_P(EveryEncoder, SurvivesTheWayThroughATerminal) {
  const CellGrid grid = EncodeRandom({21, 13});
  const auto parsed = ParseAnsi(EmitAnsi(grid), grid.size);
  ASSERT_TRUE(parsed) << parsed.error().ToString();
  EXPECT_EQ(Canonical(*parsed), Canonical(grid));
}

TEST_P(EveryEncoder, SurvivesTheWayThroughJson) {
  const CellGrid grid = EncodeRandom({21, 13});
  const auto parsed = ParseCellsJson(EmitJson(grid), "test");
  ASSERT_TRUE(parsed) << parsed.error().ToString();
  EXPECT_EQ(*parsed, grid);
}

TEST_P(EveryEncoder, UsesGlyphsThatCanBeDecoded) {
  for (const MaskSource masks : {MaskSource::kGeometric, MaskSource::kFont}) {
    DecodeOptions options;
    options.masks = masks;
    const auto image = Decode(EncodeRandom({40, 20}), options);
    ASSERT_TRUE(image) << image.error().ToString();
    EXPECT_EQ(image->width(), 320);
    EXPECT_EQ(image->height(), 320);
  }
}

/// Answers any plan with random fragments.
class RandomSource : public FragmentSource {
 public:
  Result<Fragments> Query(const SamplePlan& plan) override {
    samples_ += static_cast<double>(plan.samples_per_cell);
    return RandomFragments(plan, 7);
  }
  double samples_ = 0;
};

TEST_P(EveryEncoder, ReportsTheRaysItAskedFor) {
  RandomSource source;
  const auto encoding = encoder_->Run(source, {7, 5}, 0.5, {});
  ASSERT_TRUE(encoding);
  EXPECT_EQ(encoding->grid.size, (GridSize{7, 5}));
  EXPECT_GT(encoding->rays_per_cell, 0);
  EXPECT_LE(encoding->rays_per_cell, source.samples_);
}

INSTANTIATE_TEST_SUITE_P(, EveryEncoder, testing::ValuesIn(AllVariants()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace rtb
