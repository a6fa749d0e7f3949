#include "harness/sweep/suite.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/sweep/suites.h"

namespace rtb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SuiteTest : public ::testing::Test {
 protected:
  /// The error of a suite, as people see it.
  std::string ErrorOf(const std::string& rest) {
    const auto suite = suites_.Parse(rest);
    return suite ? "" : suite.error().ToString();
  }

  SuiteFolder suites_;
};

TEST_F(SuiteTest, WithoutMatrixTheTopLevelIsTheOnlyOne) {
  const Suite suite =
      suites_
          .Parse(
              "repeat: 7\nscenes: [sky, sun]\nencoders: [half, tiv]\n"
              "grids: [12x4]\ntimes: [0, 2.5]\ncolors: [256, mono]\n"
              "seeds: [3, 18446744073709551615]\nspp: [1, 4]\n"
              "integrators: [path]\nreferences: [self]\npictures: false\n"
              "kinds: [quality]\n")
          .value();
  EXPECT_EQ(suite.name, "test");
  EXPECT_EQ(suite.repeat, 7);
  ASSERT_EQ(suite.matrices.size(), 1u);
  const SuiteMatrix& matrix = suite.matrices[0];
  ASSERT_EQ(matrix.scenes.size(), 2u);
  EXPECT_EQ(matrix.scenes[1].name, "sun");
  EXPECT_EQ(matrix.scenes[1].file.filename(), "sun.yaml");
  EXPECT_THAT(matrix.encoders, ElementsAre("half", "tiv"));
  EXPECT_THAT(matrix.grids, ElementsAre(GridSize{12, 4}));
  EXPECT_THAT(matrix.times, ElementsAre(0, 2.5));
  EXPECT_THAT(matrix.colors, ElementsAre(ColorDepth::k256, ColorDepth::kMono));
  EXPECT_THAT(matrix.seeds, ElementsAre(3u, 18446744073709551615u));
  EXPECT_THAT(matrix.spp, ElementsAre(1, 4));
  EXPECT_THAT(matrix.integrators, ElementsAre("path"));
  EXPECT_THAT(matrix.references, ElementsAre("self"));
  EXPECT_FALSE(matrix.pictures);
  EXPECT_THAT(matrix.kinds, ElementsAre(UnitKind::kQuality));
}

TEST_F(SuiteTest, AnEntryOfMatrixTakesWhatItLacksFromTheTopLevel) {
  const Suite suite = suites_
                          .Parse(
                              "scenes: [sky]\nencoders: [half]\n"
                              "matrix:\n  - {}\n  - {encoders: [tiv]}\n")
                          .value();
  ASSERT_EQ(suite.matrices.size(), 2u);
  EXPECT_THAT(suite.matrices[0].encoders, ElementsAre("half"));
  EXPECT_THAT(suite.matrices[1].encoders, ElementsAre("tiv"));
  EXPECT_EQ(suite.matrices[1].scenes[0].name, "sky");
}

TEST_F(SuiteTest, ScenesMayBeFilesBesideTheSuite) {
  suites_.folder().Write("mine.yaml", SuiteFolder::SceneText("mine"));
  const Suite suite =
      suites_.Parse("scenes: [mine.yaml]\nencoders: [half]\n").value();
  EXPECT_EQ(suite.matrices[0].scenes[0].name, "mine.yaml");
  EXPECT_EQ(suite.matrices[0].scenes[0].file,
            suites_.file().parent_path() / "mine.yaml");
}

TEST_F(SuiteTest, AnEncoderMayBeMissingHere) {
  EXPECT_EQ(ErrorOf("scenes: [sky]\n"
                    "encoders: ['external:no-such-program {input}']\n"),
            "");
}

TEST_F(SuiteTest, MovingScenesAloneAreASuite) {
  const Suite suite =
      suites_.Parse("temporal: {scenes: [sky], encoders: [half], frames: 30}\n")
          .value();
  EXPECT_TRUE(suite.matrices.empty());
  EXPECT_EQ(suite.temporal->frames, 30);
  EXPECT_EQ(suite.temporal->fps, 24);
}

/// A mistake, and what must be said of it. The suite's first two lines are
/// those of SuiteFolder::Parse.
struct Mistake {
  const char* text;
  const char* place;  ///< `line:column` after the file's name.
  const char* says;
};

TEST_F(SuiteTest, EveryMistakeIsNamedWithItsPlace) {
  constexpr Mistake kMistakes[] = {
      {"scenes: [sky]\nencodres: [half]\n", ":4:1:", "did you mean `encoders`"},
      {"scenes: [sky]\nencoders: [half]\ngrids: [12]\n", ":5:9:", "COLSxROWS"},
      {"scenes: [sky]\nencoders: [hlaf]\n", ":4:12:", "did you mean `half`"},
      {"scenes: [sky]\nencoders: ['search:rays=5']\n", ":4:12:", "16|12|8"},
      {"scenes: [skyy]\nencoders: [half]\n", ":3:10:", "did you mean `sky`"},
      {"scenes: []\nencoders: [half]\n", ":3:9:", "0 items"},
      {"encoders: [half]\n", ":1:1:", "`scenes` is nowhere"},
      {"scenes: [sky]\nencoders: [half]\ntimes: [-1]\n", ":5:9:", "seconds"},
      {"scenes: [sky]\nencoders: [half]\nspp: [0]\n", ":5:7:", "1..65536"},
      {"scenes: [sky]\nencoders: [half]\nbackends: [embre]\n",
       ":5:12:", "did you mean `embree`"},
      {"scenes: [sky]\nencoders: [half]\nreferences: [povry]\n",
       ":5:14:", "did you mean `povray`"},
      {"scenes: [sky]\nencoders: [half]\nseeds: [-1]\n", ":5:9:", "2^64"},
      {"scenes: [sky]\nencoders: [half]\nexclude: [{scen: sky}]\n",
       ":5:12:", "did you mean `scene`"},
      {"scenes: [sky]\nencoders: [half]\nexclude: [{}]\n",
       ":5:11:", "everything"},
      {"temporal: {scenes: [sky]}\n", ":3:11:", "lacks the required key"},
      {"scenes: [sky]\nencoders: [half]\nkinds: [live]\n",
       ":5:9:", "quality, timing"},
  };
  for (const Mistake& mistake : kMistakes) {
    const std::string error = ErrorOf(mistake.text);
    EXPECT_THAT(error, HasSubstr(std::string("suite.yaml") + mistake.place))
        << mistake.text;
    EXPECT_THAT(error, HasSubstr(mistake.says)) << mistake.text;
  }
}

}  // namespace
}  // namespace rtb
