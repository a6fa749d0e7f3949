#include "encoders/chafa.h"

#include <gtest/gtest.h>

#include <ostream>
#include <vector>

#include "core/image/io.h"
#include "encoders/parse/parse.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr int kSide = 8;

bool Missing() { return ChafaVersion().empty(); }

/// Answers a plan of 8 x 8 samples a cell with a picture's pixels.
class PixelSource : public FragmentSource {
 public:
  explicit PixelSource(Image image) : image_(std::move(image)) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    Fragments fragments(plan);
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        const int cell = y / kSide * plan.grid.columns + x / kSide;
        const int sample = y % kSide * kSide + x % kSide;
        fragments.cell(cell)[static_cast<std::size_t>(sample)] =
            image_.at(x, y);
      }
    }
    return fragments;
  }

 private:
  Image image_;
};

struct Mode {
  ColorDepth depth;
  const char* name;  ///< chafa's.
};

void PrintTo(const Mode& mode, std::ostream* out) { *out << mode.name; }

class ChafaModeTest : public testing::TestWithParam<Mode> {};

// The library is given the very pixels that its program was.
TEST_P(ChafaModeTest, ChoosesWhatItsProgramPrints) {
  if (Missing()) GTEST_SKIP() << "built without libchafa";
  const auto image = ReadLinear(std::string(RTB_TEST_SOURCE_DIR) +
                                "/tests/data/tiv/synthetic.png");
  ASSERT_TRUE(image) << image.error().ToString();
  const GridSize grid{image->width() / kSide, image->height() / kSide};
  PixelSource source(*image);
  EncodeContext context;
  context.depth = GetParam().depth;
  const auto encoding = Make("chafa")->Run(source, grid, 0.5, context);
  ASSERT_TRUE(encoding) << encoding.error().ToString();
  const auto printed =
      ParseAnsi(ReadTestFile(std::string("data/ansi/chafa_synthetic_") +
                             GetParam().name + ".ansi"),
                grid);
  ASSERT_TRUE(printed) << printed.error().ToString();
  const CellGrid ours = Canonical(encoding->grid);
  const CellGrid theirs = Canonical(*printed);
  std::vector<std::size_t> different;
  for (std::size_t i = 0; i < ours.cells.size(); ++i) {
    if (ours.cells[i] != theirs.cells[i]) different.push_back(i);
  }
  EXPECT_EQ(different, std::vector<std::size_t>());
}

INSTANTIATE_TEST_SUITE_P(, ChafaModeTest,
                         testing::Values(Mode{ColorDepth::kTruecolor, "full"},
                                         Mode{ColorDepth::k256, "240"},
                                         Mode{ColorDepth::k16, "16"}),
                         [](const auto& test) {
                           return std::string(test.param.name);
                         });

// Left half black, right half white: one of the two half blocks.
std::vector<Rgb8> Halves() {
  std::vector<Rgb8> pixels;
  for (int i = 0; i < kSide * kSide; ++i) {
    const auto gray = static_cast<std::uint8_t>(i % kSide < 4 ? 0 : 255);
    pixels.push_back({gray, gray, gray});
  }
  return pixels;
}

TEST(ChafaTest, SymbolsBoundTheGlyphs) {
  if (Missing()) GTEST_SKIP() << "built without libchafa";
  const Cell half = EncodeOne("chafa:symbols=half", Halves());
  EXPECT_TRUE(half == (Cell{U'▌', {0, 0, 0}, {255, 255, 255}}) ||
              half == (Cell{U'▐', {255, 255, 255}, {0, 0, 0}}))
      << testing::PrintToString(half);
  EXPECT_EQ(Canonical(EncodeOne("chafa:symbols=space", Halves())).glyph, U' ');
}

// Wide characters would push the rest of their row aside.
TEST(ChafaTest, NeverUsesWideCharacters) {
  if (Missing()) GTEST_SKIP() << "built without libchafa";
  EXPECT_EQ(EncodeOne("chafa:symbols=wide", Halves()).glyph, U' ');
}

TEST(ChafaTest, RefusesUnknownSymbols) {
  if (Missing()) GTEST_SKIP() << "built without libchafa";
  const auto encoder = MakeEncoder("chafa:symbols=hieroglyphs");
  ASSERT_FALSE(encoder);
  EXPECT_EQ(encoder.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(encoder.error().ToString().find("hieroglyphs"), std::string::npos);
}

TEST(ChafaTest, SaysWhenItIsMissing) {
  if (!Missing()) GTEST_SKIP() << "built with libchafa";
  const auto encoder = MakeEncoder("chafa");
  ASSERT_FALSE(encoder);
  EXPECT_EQ(encoder.error().kind, ErrorKind::kMissing);
  const auto all = ParseEncoderSpecs("all");
  ASSERT_TRUE(all);
  for (const EncoderSpec& spec : *all) EXPECT_NE(spec.name, "chafa");
}

}  // namespace
}  // namespace rtb
