// Every row of the table must fail at its marked place with its message.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "core/scene/load.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

struct BadScene {
  std::string name;
  std::string text;  ///< With `@` before the place of the error.
  std::string message;
};

void PrintTo(const BadScene& scene, std::ostream* out) { *out << scene.name; }

std::vector<BadScene> BadScenes() {
  return {
#define BAD_FILE(name, text, message) {#name, text, message},
#define BAD_SECTION(name, text, message) {#name, kPreamble + text, message},
#include "tests/core/scene/bad_scenes_table.inc"
#undef BAD_FILE
#undef BAD_SECTION
  };
}

/// `line:column` of a position, counted from 1.
std::string PlaceAt(const std::string& text, std::size_t position) {
  const auto begin = text.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(position);
  const std::size_t line_start = text.rfind('\n', position) + 1;
  return std::to_string(std::count(begin, end, '\n') + 1) + ":" +
         std::to_string(position - line_start + 1);
}

class BadSceneTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneTest, FailsAtItsPlace) {
  std::string text = GetParam().text;
  const std::size_t mark = text.find('@');
  ASSERT_NE(mark, std::string::npos);
  text.erase(mark, 1);
  const std::string place = "test.yaml:" + PlaceAt(text, mark);

  const Result<Scene> scene = ParseScene(text, "test.yaml");

  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(scene.error().place, place) << scene.error().ToString();
  EXPECT_THAT(scene.error().ToString(), testing::HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(Table, BadSceneTest, testing::ValuesIn(BadScenes()),
                         [](const auto& row) { return row.param.name; });

TEST(BadSceneTableTest, HasAtLeastEightyRows) {
  EXPECT_GE(BadScenes().size(), 80u);
}

}  // namespace
}  // namespace rtb
