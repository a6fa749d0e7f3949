#include "encoders/parse/command_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rtb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> Words(std::string_view command) {
  const auto words = CommandWords(command);
  EXPECT_TRUE(words) << command;
  return words.value_or(std::vector<std::string>());
}

TEST(CommandWordsTest, SplitsAtBlanks) {
  EXPECT_THAT(Words("  a b\t\nc "), ElementsAre("a", "b", "c"));
  EXPECT_THAT(Words(" "), IsEmpty());
  EXPECT_THAT(Words(""), IsEmpty());
}

TEST(CommandWordsTest, KeepsQuotedBlanksAndEmptyWords) {
  EXPECT_THAT(Words(R"(a' b'c "d e" '' "")"),
              ElementsAre("a bc", "d e", "", ""));
  EXPECT_THAT(Words(R"('a"b' "c'd")"), ElementsAre("a\"b", "c'd"));
}

TEST(CommandWordsTest, BackslashesQuote) {
  EXPECT_THAT(Words(R"(a\ b '\n' "\"\\\n" \')"),
              ElementsAre("a b", "\\n", "\"\\\\n", "'"));
  EXPECT_THAT(Words("a\\"), ElementsAre("a\\"));
}

TEST(CommandWordsTest, ExpandsNothing) {
  EXPECT_THAT(Words("$HOME * a;b `c` ~"),
              ElementsAre("$HOME", "*", "a;b", "`c`", "~"));
}

TEST(CommandWordsTest, QuotesMustBeClosed) {
  for (const char* command : {"'", "a 'b", "\"a", "\"a\\\""}) {
    const auto words = CommandWords(command);
    ASSERT_FALSE(words) << command;
    EXPECT_EQ(words.error().kind, ErrorKind::kBadInput);
  }
}

}  // namespace
}  // namespace rtb
