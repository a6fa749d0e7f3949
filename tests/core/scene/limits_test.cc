// The limits of the format, from both sides.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/scene/load.h"
#include "core/scene/yaml_text.h"
#include "core/scene/yaml_tree.h"
#include "tests/core/scene/scene_text.h"

namespace rtb {
namespace {

using testing::HasSubstr;

const char* const kSphere = "{type: sphere, center: [0, 0, 0], radius: 1}";

Result<Scene> Parse(const std::string& sections) {
  return ParseScene(kPreamble + sections, "f");
}

std::string Repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

/// A sphere within `levels` - 1 groups.
std::string Nested(int levels) {
  return "objects: [" + Repeated("{type: group, children: [", levels - 1) +
         kSphere + Repeated("]}", levels - 1) + "]\n";
}

/// Group g0 of ten spheres; each further group has ten instances of the one
/// before: g_k holds 10^(k+1) spheres.
std::string PowersOfTen(int groups) {
  std::string text = "objects:\n";
  for (int k = 0; k < groups; ++k) {
    const std::string child =
        k == 0 ? kSphere
               : "{type: instance, of: g" + std::to_string(k - 1) + "}";
    text += "  - {type: group, id: g" + std::to_string(k) + ", children: [" +
            Repeated(child + ", ", 10) + "]}\n";
  }
  return text;
}

TEST(SceneLimitsTest, SixtyFourLevelsOfObjects) {
  EXPECT_TRUE(Parse(Nested(64)));
  const auto deeper = Parse(Nested(65));
  ASSERT_FALSE(deeper);
  EXPECT_THAT(deeper.error().ToString(), HasSubstr("more than 64 levels"));
}

TEST(SceneLimitsTest, InstancesCountTowardsTheLevels) {
  // Each group stands one level deeper than the instance that names it: a
  // chain of n groups and a sphere has n + 1 levels.
  const auto chain = [](int groups) {
    std::string text = "objects:\n";
    for (int k = 0; k < groups; ++k) {
      const std::string child =
          k == 0 ? kSphere
                 : "{type: instance, of: g" + std::to_string(k - 1) + "}";
      text += "  - {type: group, id: g" + std::to_string(k) + ", children: [" +
              child + "]}\n";
    }
    return text;
  };
  EXPECT_TRUE(Parse(chain(63)));
  const auto deeper = Parse(chain(64));
  ASSERT_FALSE(deeper);
  EXPECT_THAT(deeper.error().ToString(), HasSubstr("more than 64 levels"));
  // The last group's instance takes it past the limit: line 4 is `objects:`.
  EXPECT_THAT(deeper.error().place, HasSubstr("f:68:"));
  // Long chains, in either order, end as soon.
  EXPECT_FALSE(Parse(chain(20000)));
}

TEST(SceneLimitsTest, ObjectsAreCountedAtEveryUse) {
  // A group of 999 spheres has 1000 objects, itself included; with 999
  // instances of it, a million.
  const std::string full = "objects:\n  - {type: group, id: g, children: [" +
                           Repeated(std::string(kSphere) + ", ", 999) + "]}\n" +
                           Repeated("  - {type: instance, of: g}\n", 999);
  EXPECT_TRUE(Parse(full));
  const auto more = Parse(full + "  - " + kSphere + "\n");
  ASSERT_FALSE(more);
  EXPECT_THAT(more.error().ToString(), HasSubstr("more than 1000000 objects"));
  EXPECT_THAT(more.error().place, HasSubstr("f:1005:5"));  // 4 + 1000 + 1
}

TEST(SceneLimitsTest, ExponentialNestsOfInstancesAreFoundAtOnce) {
  EXPECT_FALSE(Parse(PowersOfTen(60)));  // 10^60 objects
}

TEST(SceneLimitsTest, AliasesCannotMultiplyTheText) {
  std::string bomb = "a: &a0 [0]\n";
  for (int k = 1; k < 60; ++k) {
    const std::string alias = "*a" + std::to_string(k - 1);
    bomb += "b" + std::to_string(k) + ": &a" + std::to_string(k) + " [" +
            alias + ", " + alias + "]\n";
  }
  EXPECT_FALSE(Parse(bomb));
}

TEST(SceneLimitsTest, AnObjectThatContainsItselfByAliases) {
  const auto self =
      Parse("objects: [&o {type: group, children: [*o, *o, *o]}]\n");
  ASSERT_FALSE(self);
  EXPECT_THAT(self.error().ToString(), HasSubstr("more than 64 levels"));
}

TEST(SceneLimitsTest, AliasesOfObjectsCountAtEveryUse) {
  // Each level holds the one before ten times: 10^7 spheres.
  std::string text = "objects:\n  - &o0 " + std::string(kSphere) + "\n";
  for (int k = 1; k <= 7; ++k) {
    text += "  - &o" + std::to_string(k) + " {type: group, children: [" +
            Repeated("*o" + std::to_string(k - 1) + " , ", 10) + "]}\n";
  }
  const auto scene = Parse(text);
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().ToString(), HasSubstr("more than 1000000 objects"));
}

TEST(SceneLimitsTest, DeepNestingOfYamlDoesNotOverflowTheStack) {
  for (const std::string open : {"[", "{", "- ", "? ", "{a: ", "[[{a: "}) {
    const auto scene = Parse("objects: \n  " + Repeated(open, 100000));
    EXPECT_FALSE(scene) << open;
  }
  const auto lists =
      Parse("objects: " + Repeated("[", 300) + Repeated("]", 300) + "\n");
  ASSERT_FALSE(lists);
  EXPECT_THAT(lists.error().ToString(), HasSubstr("levels deep"));
}

TEST(SceneLimitsTest, SixtyFourMebibytesOfText) {
  std::string text(kMaxYamlBytes, 'x');
  EXPECT_TRUE(CheckYamlText(text, "f"));
  text += 'x';
  const auto longer = ParseScene(text, "f");
  ASSERT_FALSE(longer);
  EXPECT_THAT(longer.error().ToString(), HasSubstr("67108865 bytes"));
}

}  // namespace
}  // namespace rtb
