#include "core/scene/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "core/scene/yaml_tree.h"

namespace rtb {
namespace {

using Words = std::vector<std::string_view>;

/// Splits at blanks, without empty parts.
Words SplitWords(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  Words words;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end =
        std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

/// Parses a float, also `nan`, `inf` and what overflows (as infinity).
bool ParseFloat(std::string_view word, float* value) {
  if (word.size() > 1 && word[0] == '+') word.remove_prefix(1);
  double exact = 0;
  const auto [end, code] =
      std::from_chars(word.data(), word.data() + word.size(), exact);
  if (end != word.data() + word.size()) return false;
  if (code == std::errc::invalid_argument) return false;
  const bool overflow = code == std::errc::result_out_of_range ||
                        std::abs(exact) > std::numeric_limits<float>::max();
  *value = overflow ? std::numeric_limits<float>::infinity()
                    : static_cast<float>(exact);
  return true;
}

/// One of the three lists that faces refer to.
struct List {
  const char* name;
  int count = 0;
  int largest = 0;       ///< Index used, from 1.
  int largest_line = 0;  ///< Where.
};

/// Reads line by line and writes the kept ones.
class ObjChecker {
 public:
  explicit ObjChecker(const std::string& file) : file_(file) {}

  Status Line(std::string_view line) {
    ++line_;
    const Words words = SplitWords(line.substr(0, line.find('#')));
    if (words.empty()) return {};
    if (words[0] == "v") return Numbers(words, 3, 3, 7, &lists_[0]);
    if (words[0] == "vt") return Numbers(words, 2, 1, 3, &lists_[1]);
    if (words[0] == "vn") return Numbers(words, 3, 3, 3, &lists_[2]);
    if (words[0] == "f") return Face(words);
    return {};
  }

  /// Checks what only the end of the file can tell.
  Status End() const {
    for (const List& list : lists_) {
      if (list.largest <= list.count) continue;
      return FailAt(list.largest_line,
                    "a face refers to " + std::string(list.name) + " " +
                        std::to_string(list.largest) + ", the file has " +
                        std::to_string(list.count));
    }
    return {};
  }

  ObjText Take() { return std::move(result_); }

 private:
  tl::unexpected<Error> FailAt(int line, std::string what) const {
    return Fail(BadInput(file_ + ":" + std::to_string(line), std::move(what)));
  }

  /// A line of `low` to `high` numbers, of which `kept` are of use.
  Status Numbers(const Words& words, std::size_t kept, std::size_t low,
                 std::size_t high, List* list) {
    if (words.size() - 1 < low || words.size() - 1 > high) {
      return FailAt(line_, "a `" + std::string(words[0]) + "` line has " +
                               std::to_string(words.size() - 1) +
                               " numbers, expected " + std::to_string(low) +
                               ".." + std::to_string(high));
    }
    std::array<float, 3> values{};
    for (std::size_t i = 1; i < words.size(); ++i) {
      float value = 0;
      if (!ParseFloat(words[i], &value)) {
        return FailAt(line_, "found `" + std::string(words[i].substr(0, 40)) +
                                 "`, expected a number");
      }
      if (i <= kept) values[i - 1] = value;
    }
    Keep(words[0], {values.data(), kept}, *list);
    ++list->count;
    return {};
  }

  void Keep(std::string_view word, std::span<float> values, const List& list) {
    const bool finite = std::all_of(values.begin(), values.end(),
                                    [](float x) { return std::isfinite(x); });
    if (!finite && list.count < INT32_MAX) {
      if (word == "v") result_.non_finite.insert(list.count);
      if (word == "vt") ++result_.non_finite_uvs;
      std::fill(values.begin(), values.end(), 0.0f);
    }
    result_.text += word;
    for (const float value : values) {
      char digits[32];
      const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
      result_.text += ' ';
      result_.text.append(digits, end);
    }
    result_.text += '\n';
  }

  Status Face(const Words& words) {
    if (words.size() - 1 > kMaxFaceVertices) {
      return FailAt(line_, "a face has more than " +
                               std::to_string(kMaxFaceVertices) + " vertices");
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      RTB_RETURN_IF_ERROR(Corner(words[i]));
    }
    if (words.size() - 1 < 3) {
      ++result_.skipped_faces;
      return {};
    }
    KeepFace(words);
    return {};
  }

  void KeepFace(const Words& words) {
    const unsigned int group = words.size() - 1 == 4 ? kQuads : 0;
    if (group != group_) {
      result_.text += "s " + std::to_string(group) + '\n';
      group_ = group;
    }
    for (const std::string_view word : words) {
      result_.text += word;
      result_.text += ' ';
    }
    result_.text += '\n';
  }

  /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
  Status Corner(std::string_view word) {
    std::string_view rest = word;
    for (std::size_t i = 0; i < lists_.size(); ++i) {
      const std::size_t end = std::min(rest.find('/'), rest.size());
      const std::string_view part = rest.substr(0, end);
      const bool last = end == rest.size();
      const bool optional = i == 1 && !last;
      if (!part.empty() || !optional) {
        RTB_RETURN_IF_ERROR(Refer(part, word, &lists_[i]));
      }
      if (last) return {};
      rest.remove_prefix(end + 1);
    }
    return FailAt(line_, "a face's corner is `" +
                             std::string(word.substr(0, 40)) +
                             "`, expected v/vt/vn");
  }

  Status Refer(std::string_view part, std::string_view word, List* list) {
    int index = 0;
    const auto [end, code] =
        std::from_chars(part.data(), part.data() + part.size(), index);
    const bool number = code == std::errc() && end == part.data() + part.size();
    if (!number || index == 0) {
      return FailAt(line_, "a face's corner is `" +
                               std::string(word.substr(0, 40)) +
                               "`, expected indices from 1 (or from -1 back)");
    }
    if (index < 0 && index < -list->count) {
      return FailAt(line_, "a face refers to " + std::string(list->name) + " " +
                               std::to_string(index) + ", only " +
                               std::to_string(list->count) +
                               " stand before it");
    }
    if (index > list->largest) {
      list->largest = index;
      list->largest_line = line_;
    }
    return {};
  }

  const std::string& file_;
  ObjText result_;
  unsigned int group_ = 0;  ///< Smoothing group of the last face.
  int line_ = 0;
  std::array<List, 3> lists_ = {
      {{"vertex"}, {"texture coordinate"}, {"normal"}}};
};

}  // namespace

Result<ObjText> CheckObjText(const std::string& text, const std::string& file) {
  ObjChecker checker(file);
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    RTB_RETURN_IF_ERROR(checker.Line(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  RTB_RETURN_IF_ERROR(checker.End());
  return checker.Take();
}

}  // namespace rtb
