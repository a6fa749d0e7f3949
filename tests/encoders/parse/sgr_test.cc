#include "encoders/parse/sgr.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

TEST(PortableSgrTest, NothingIsAReset) {
  EXPECT_EQ(PortableSgr(""), "\x1b[0m");
  EXPECT_EQ(PortableSgr(";31"), "\x1b[0m\x1b[31m");
}

TEST(PortableSgrTest, WritesColorsWithSemicolons) {
  EXPECT_EQ(PortableSgr("38;2;1;2;3;48;5;67"), "\x1b[38;2;1;2;3m\x1b[48;5;67m");
  EXPECT_EQ(PortableSgr("38:2:1:2:3"), "\x1b[38;2;1;2;3m");
  EXPECT_EQ(PortableSgr("38:2:5:1:2:3"), "\x1b[38;2;1;2;3m");
  EXPECT_EQ(PortableSgr("48:2::1::3;48:5:9"), "\x1b[48;2;1;0;3m\x1b[48;5;9m");
  EXPECT_EQ(PortableSgr("38;2;;5;"), "\x1b[38;2;0;5;0m");
}

// An underline's color must not be taken for attributes: 7 would reverse.
TEST(PortableSgrTest, LeavesOutTheColorOfLines) {
  EXPECT_EQ(PortableSgr("58;5;7;32"), "\x1b[32m");
  EXPECT_EQ(PortableSgr("58;2;7;7;7;32"), "\x1b[32m");
  EXPECT_EQ(PortableSgr("58:2::7:7:7;32;59"), "\x1b[32m");
}

TEST(PortableSgrTest, LeavesOutWhatCellsDoNotShow) {
  EXPECT_EQ(PortableSgr("1;3;4;4:3;5;6;9;11;19;21;23;24;25;29;53;73"), "");
}

TEST(PortableSgrTest, HandsOnHiddenAndFaint) {
  EXPECT_EQ(PortableSgr("8;28;2;22"), "\x1b[19m\x1b[10m\x1b[5m\x1b[25m");
}

TEST(PortableSgrTest, LeavesOutWhatIsNoColor) {
  EXPECT_EQ(PortableSgr("38;2;256;2;3;38;5;256"), "");
  EXPECT_EQ(PortableSgr("38:2:1:2"), "");
  EXPECT_EQ(PortableSgr("38:5"), "");
  EXPECT_EQ(PortableSgr("38:7:1;38"), "");
  EXPECT_EQ(PortableSgr("38;5"), "");
  EXPECT_EQ(PortableSgr("38;2;1;2"), "");
  EXPECT_EQ(PortableSgr("99999999999;<"), "");
}

}  // namespace
}  // namespace rtb
