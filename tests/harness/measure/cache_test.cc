#include "harness/measure/cache.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

TEST(CacheTest, ItsFolderIsTheFirstThatTheEnvironmentNames) {
  EXPECT_EQ(CacheFolder("/own", "/xdg", "/there"), "/own");
  EXPECT_EQ(CacheFolder("", "/xdg", "/there"), "/xdg/rtbench");
  EXPECT_EQ(CacheFolder("", "", "/there"), "/there/.cache/rtbench");
  EXPECT_EQ(CacheFolder("", "", ""), "");
}

// SHA-256 of "abc" (FIPS 180-4, first example) begins so.
TEST(CacheTest, NamesHashTheirInputs) {
  EXPECT_EQ(CacheName("bound", "abc", ".txt"),
            "bound-ba7816bf8f01cfea414140de5dae2223.txt");
  EXPECT_NE(CacheName("bound", "abd", ".txt"),
            CacheName("bound", "abc", ".txt"));
}

TEST(CacheTest, NumbersAreSpelledExactly) {
  EXPECT_EQ(ExactText(0.5), "0.5");
  EXPECT_NE(ExactText(0.1 + 0.2), ExactText(0.3));
}

}  // namespace
}  // namespace rtb
