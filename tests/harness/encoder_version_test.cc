#include "harness/encoder_version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using ::testing::MatchesRegex;

std::string VersionOf(const std::string& spec) {
  return EncoderVersion(ParseEncoderSpec(spec).value());
}

/// A program that says `text` and goes.
std::string Program(const TemporaryFolder& folder, const std::string& name,
                    const std::string& text) {
  const auto file = folder.Write(name, "#!/bin/sh\necho '" + text + "' >&2\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return "external:" + file.string() + " {input}";
}

TEST(EncoderVersionTest, OurEncodersHaveNone) {
  EXPECT_EQ(VersionOf("half"), "");
  EXPECT_EQ(VersionOf("adaptive:rays=4"), "");
}

TEST(EncoderVersionTest, AnotherProgramIsAsked) {
  const TemporaryFolder folder;
  EXPECT_THAT(VersionOf(Program(folder, "draw", "Draw (c) 2006, v1.2.3-b; x")),
              MatchesRegex("draw 1\\.2\\.3-b \\([0-9a-f]{16}\\)"));
  EXPECT_THAT(VersionOf(Program(folder, "mute", "usage: mute FILE")),
              MatchesRegex("mute unknown \\([0-9a-f]{16}\\)"));
}

TEST(EncoderVersionTest, WhatIsNotThereHasNone) {
  EXPECT_EQ(VersionOf("external:no-such-program {input}"), "");
}

}  // namespace
}  // namespace rtb
