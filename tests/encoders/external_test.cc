#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/encoders/picture_source.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

using testing::HasSubstr;

/// Red rises to the right, one code a sample where there are `width` in each
/// cell.
Picture Ramp(int width) {
  return [width](double x, double, int channel) {
    const auto code = static_cast<std::uint8_t>(x * width);
    return channel == 0 ? SrgbDecode8(code) : 0;
  };
}

Result<Encoding> RunSpec(const std::string& spec, GridSize grid,
                         ColorDepth depth = ColorDepth::kTruecolor) {
  const auto encoder = MakeEncoder(spec);
  if (!encoder) return Fail(encoder.error());
  PictureSource source(Ramp(2));
  EncodeContext context;
  context.depth = depth;
  return (*encoder)->Run(source, grid, 0.5, context);
}

/// What a shell's script prints in the cells; {input} is its $0.
std::string Shown(const std::string& script, GridSize grid,
                  ColorDepth depth = ColorDepth::kTruecolor) {
  const auto encoding = RunSpec(
      "external:samples=2x1:sh -c '" + script + "' {input} {cols} {rows}", grid,
      depth);
  return encoding ? GlyphText(encoding->grid) : encoding.error().ToString();
}

TEST(ExternalTest, ShowsWhatTheProgramPrints) {
  const auto encoding = RunSpec(
      R"(external:printf '\033[38;2;1;2;3ma\033[0m\nb%s' {input} {cols})",
      {40, 3});
  ASSERT_TRUE(encoding) << encoding.error().ToString();
  EXPECT_EQ(encoding->grid.at(0, 0), (Cell{U'a', {1, 2, 3}, {}}));
  EXPECT_EQ(encoding->grid.at(0, 1).glyph, U'b');
  EXPECT_EQ(encoding->rays_per_cell, 8 * 16);
}

TEST(ExternalTest, FillsInTheGrid) {
  EXPECT_EQ(Shown("echo $1,$2,x$1y", {9, 1}), "9,1,x9y  \n");
}

TEST(ExternalTest, TellsProgramsOfTheTerminal) {
  const std::string script = "echo $TERM,$COLORTERM,$COLUMNS,$LINES";
  EXPECT_EQ(Shown(script, {30, 1}), "xterm-256color,truecolor,30,1 \n");
  EXPECT_EQ(Shown(script, {20, 1}, ColorDepth::k16), "xterm-16color,,20,1 \n");
}

// A PNG of 3 x 2 cells of 2 x 1 samples; its header holds both sides in bytes
// 16 to 23. The folder is the user's alone.
TEST(ExternalTest, GivesThePictureInAPrivateFolder) {
  EXPECT_EQ(Shown("od -An -tu1 -j19 -N5 \"$0\" | tr -s \" \" ,", {11, 2}),
            ",22,0,0,0,2\n           \n");
  EXPECT_EQ(Shown("ls -ld \"${0%/*}\" | cut -c1-10", {11, 1}), "drwx------ \n");
}

TEST(ExternalTest, RemovesTheFolder) {
  const std::string path = Shown("echo \"${0%/*}\"", {120, 1});
  const std::string folder = path.substr(0, path.find_first_of(" \n"));
  ASSERT_THAT(folder, HasSubstr("/rtbench_"));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(ExternalTest, CellsNeverWrittenAreSpaces) {
  EXPECT_EQ(Shown("echo ab", {3, 2}), "ab \n   \n");
}

TEST(ExternalTest, SaysWhyAProgramFailed) {
  EXPECT_THAT(Shown("echo no light >&2; exit 7", {3, 2}),
              testing::AllOf(HasSubstr("sh: ended with status 7"),
                             HasSubstr("no light")));
  EXPECT_THAT(Shown("echo hm >&2", {3, 2}), HasSubstr("printed nothing: hm"));
  EXPECT_THAT(Shown("echo abcd; echo; echo; echo e", {4, 2}),
              HasSubstr("scrolled"));
}

TEST(ExternalTest, EndsProgramsThatTakeTooLong) {
  const auto encoding = RunSpec(
      "external:timeout=1:samples=1x1:sh -c 'sleep 60' {input}", {2, 1});
  ASSERT_FALSE(encoding);
  EXPECT_EQ(encoding.error().kind, ErrorKind::kFailure);
  EXPECT_THAT(encoding.error().what, HasSubstr("within 1 s"));
}

TEST(ExternalTest, MissingProgramsAreFoundOutAtOnce) {
  const auto encoder = MakeEncoder("external:no-such-program-here {input}");
  ASSERT_FALSE(encoder);
  EXPECT_EQ(encoder.error().kind, ErrorKind::kMissing);
  EXPECT_FALSE(encoder.error().hint.empty());
}

TEST(ExternalTest, RefusesWhatCannotBeRun) {
  for (const auto& [spec, says] :
       {std::pair{"external", "is missing"}, std::pair{"external:", "missing"},
        std::pair{"external:cat", "names no {input}"},
        std::pair{"external:cat '{input}", "not closed"},
        std::pair{"external:samples=0x4:cat {input}", "from 1 to 64"},
        std::pair{"external:samples=8:cat {input}", "WxH"},
        std::pair{"external:timeout=0:cat {input}", "seconds"},
        std::pair{"external:speed=9:cat {input}", "unknown parameter"}}) {
    const auto encoder = MakeEncoder(spec);
    ASSERT_FALSE(encoder) << spec;
    EXPECT_EQ(encoder.error().kind, ErrorKind::kBadInput) << spec;
    EXPECT_THAT(encoder.error().ToString(), HasSubstr(says)) << spec;
  }
}

}  // namespace
}  // namespace rtb
