// Damaged scenes: whatever happens to the text, the loader answers with a
// Scene or an Error whose place is in the file, and does so quickly.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/scene/load.h"

namespace rtb {
namespace {

const std::string kFile =
    RTB_TEST_SOURCE_DIR "/tests/data/scenes/every_key.yaml";

/// Deterministic choices. (The standard's distributions are not the same
/// everywhere; a remainder is.)
class Chooser {
 public:
  explicit Chooser(unsigned seed) : engine_(seed) {}
  std::size_t Below(std::size_t count) { return engine_() % count; }

 private:
  std::mt19937 engine_;
};

/// What is put in place of something else: edge cases of YAML and of numbers.
const std::vector<std::string> kTokens = {
    "-1",   "0",    "1e999", ".nan", "-.inf", "null", "~",    "true",
    "[",    "]",    "{",     "}",    "&a ",   "*a",   "!!x ", "? ",
    ": ",   "- ",   "#",     "\"",   "'",     "|",    ">",    "%",
    "---",  "...",  "\t",    "\n",   "\r",    "\xff", "\x01", "\\",
    "1e18", "1e-9", "[[[[",  "<<: ", "*pale", ",",    "@",    "`",
};

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Changes bytes: one is removed, replaced or doubled, or a token put in.
void MutateBytes(Chooser& choose, std::string* text) {
  if (text->empty()) return;
  const std::size_t at = choose.Below(text->size());
  const std::string& token = kTokens[choose.Below(kTokens.size())];
  switch (choose.Below(5)) {
    case 0:
      text->erase(at, 1 + choose.Below(8));
      break;
    case 1:
      (*text)[at] = static_cast<char>(choose.Below(256));
      break;
    case 2:
      text->insert(at, token);
      break;
    case 3:
      text->replace(at, 1 + choose.Below(4), token);
      break;
    default:
      text->resize(at + 1);
  }
}

/// Changes lines: one is removed, doubled, moved or indented.
void MutateLines(Chooser& choose, std::string* text) {
  std::vector<std::string> lines = Lines(*text);
  const std::size_t from = choose.Below(lines.size());
  const std::size_t to = choose.Below(lines.size());
  switch (choose.Below(4)) {
    case 0:
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(from));
      break;
    case 1:
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(to),
                   std::string(lines[from]));
      break;
    case 2:
      std::swap(lines[from], lines[to]);
      break;
    default:
      lines[from].insert(0, 1 + choose.Below(4), ' ');
  }
  *text = Joined(lines);
}

/// Whether the outcome is one that the loader may have.
void ExpectSound(const std::string& text, int round) {
  const Result<Scene> scene = ParseScene(text, kFile);
  if (scene) {
    EXPECT_EQ(scene->sha256, Sha256(text));
    return;
  }
  EXPECT_EQ(scene.error().kind, ErrorKind::kBadInput) << "round " << round;
  EXPECT_EQ(scene.error().place.rfind(kFile + ":", 0), 0u)
      << "round " << round << ": " << scene.error().ToString();
  EXPECT_FALSE(scene.error().what.empty()) << "round " << round;
}

TEST(SceneMutationTest, TheUndamagedSceneLoads) {
  const Result<Scene> scene = LoadScene(kFile);
  ASSERT_TRUE(scene) << scene.error().ToString();
  EXPECT_EQ(scene->materials.size(), 9u);
  EXPECT_EQ(scene->lights.size(), 5u);
  EXPECT_EQ(scene->objects.size(), 11u);
}

TEST(SceneMutationTest, DamagedBytes) {
  const std::string original = *ReadFile(kFile);
  for (int round = 0; round < 3000; ++round) {
    Chooser choose(static_cast<unsigned>(round));
    std::string text = original;
    for (std::size_t i = 0; i <= choose.Below(3); ++i) {
      MutateBytes(choose, &text);
    }
    ExpectSound(text, round);
  }
}

TEST(SceneMutationTest, DamagedLines) {
  const std::string original = *ReadFile(kFile);
  for (int round = 0; round < 1500; ++round) {
    Chooser choose(static_cast<unsigned>(round));
    std::string text = original;
    for (std::size_t i = 0; i <= choose.Below(4); ++i) {
      MutateLines(choose, &text);
    }
    ExpectSound(text, round);
  }
}

TEST(SceneMutationTest, EveryPrefix) {
  const std::string original = *ReadFile(kFile);
  for (std::size_t size = 0; size < original.size(); size += 7) {
    ExpectSound(original.substr(0, size), static_cast<int>(size));
  }
}

}  // namespace
}  // namespace rtb
