#include "harness/encoder_version.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "core/base/check.h"
#include "core/base/file.h"
#include "core/base/process.h"
#include "encoders/parse/command_words.h"

namespace rtb {
namespace {

bool IsDigit(char letter) { return letter >= '0' && letter <= '9'; }

/// What looks like a version in what a program says of itself: digits, a dot,
/// a digit, and what follows without a break.
std::string FindVersion(const std::string& text) {
  // No program says so much before it comes to its version.
  constexpr std::size_t kLongest = 4000;
  const std::string head = text.substr(0, kLongest);
  for (std::size_t begin = 0; begin < head.size(); ++begin) {
    if (!IsDigit(head[begin])) continue;
    std::size_t dot = begin;
    while (dot < head.size() && IsDigit(head[dot])) ++dot;
    if (dot + 1 < head.size() && head[dot] == '.' && IsDigit(head[dot + 1])) {
      const std::size_t end = head.find_first_of(" \t\r\n\f\v,;()", dot);
      return head.substr(begin, end - begin);
    }
    begin = dot;
  }
  return "unknown";
}

std::string ProgramVersion(const std::string& program) {
  constexpr double kPatience = 5;  // Seconds.
  constexpr std::size_t kShown = 16;
  const auto file = FindProgram(program);
  if (!file) return "";
  const auto answer = RunProcess({{program, "--version"}, {}, kPatience});
  const auto sha256 = Sha256File(*file);
  return file->filename().string() + " " +
         (answer ? FindVersion(answer->out + "\n" + answer->err) : "unknown") +
         (sha256 ? " (" + sha256->substr(0, kShown) + ")" : "");
}

/// Remembers the answers: programs are not exchanged while we run.
std::string KnownProgramVersion(const std::string& program) {
  static std::mutex mutex;
  static std::map<std::string, std::string> versions;
  const std::lock_guard lock(mutex);
  const auto found = versions.find(program);
  if (found != versions.end()) return found->second;
  std::string version = ProgramVersion(program);
  if (!version.empty()) versions[program] = version;
  return version;
}

}  // namespace

std::string EncoderVersion(const EncoderSpec& spec) {
  const auto name = [](const EncoderEntry& entry) { return entry.info.name; };
  const auto entry = std::ranges::find(EncoderEntries(), spec.name, name);
  RTB_CHECK(entry != EncoderEntries().end());
  const auto command = spec.parameters.find("command");
  if (spec.name != "external" || command == spec.parameters.end()) {
    return entry->info.version;
  }
  const auto words = CommandWords(command->second);
  if (!words || words->empty()) return "";
  return KnownProgramVersion(words->front());
}

}  // namespace rtb
