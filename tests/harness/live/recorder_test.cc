#include "harness/live/recorder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/file.h"
#include "tests/temp_folder.h"

namespace rtb {
namespace {

using nlohmann::json;

TEST(Recorder, WritesAsciicastV2) {
  const TempFolder folder;
  const std::string file = folder / "a.cast";
  {
    auto recorder = Recorder::Start(file, {80, 24}, 10);
    ASSERT_TRUE(recorder.has_value());
    ASSERT_TRUE(recorder->Output("\x1b[1;1H\"▀", 10.25));
    ASSERT_TRUE(recorder->Resize({100, 30}, 11));
  }
  std::istringstream lines(*ReadFile(file));
  std::string line;
  std::getline(lines, line);
  const json header = json::parse(line);
  EXPECT_EQ(header["version"], 2);
  EXPECT_EQ(header["width"], 80);
  EXPECT_EQ(header["height"], 24);
  std::getline(lines, line);
  EXPECT_EQ(json::parse(line), json::array({0.25, "o", "\x1b[1;1H\"▀"}));
  std::getline(lines, line);
  EXPECT_EQ(json::parse(line), json::array({1.0, "r", "100x30"}));
}

TEST(Recorder, SaysWhereItCannotWrite) {
  const auto recorder = Recorder::Start("no/such/folder/a.cast", {80, 24}, 0);
  ASSERT_FALSE(recorder.has_value());
  EXPECT_EQ(recorder.error().place, "no/such/folder/a.cast");
}

}  // namespace
}  // namespace rtb
