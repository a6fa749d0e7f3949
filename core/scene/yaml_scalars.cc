#include "core/scene/yaml_scalars.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace rtb {
namespace {

bool IsDigit(char c) { return '0' <= c && c <= '9'; }

/// Drops a leading +, which std::from_chars does not take.
std::string_view WithoutPlus(std::string_view text) {
  const bool signed_number =
      text.size() > 1 && text[0] == '+' && (IsDigit(text[1]) || text[1] == '.');
  return signed_number ? text.substr(1) : text;
}

/// Parses all of `text`; false when it is not a T in decimal notation.
template <class T>
bool ParseAll(std::string_view text, T* value) {
  const std::string_view digits = WithoutPlus(text);
  const auto [end, code] =
      std::from_chars(digits.data(), digits.data() + digits.size(), *value);
  return code == std::errc() && end == digits.data() + digits.size();
}

bool IsNameCharacter(char c) {
  return IsDigit(c) || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') ||
         c == '_' || c == '-';
}

std::string NumberHint(YamlNode node) {
  if (!node.is_scalar()) return "";
  if (node.quoted()) return "write numbers without quotes";
  return "numbers are finite and decimal, such as 0.5, -3 or 1e-4";
}

}  // namespace

void FailExpected(YamlNode node, std::string_view label,
                  const std::string& expected, ReadContext& context,
                  std::string hint) {
  context.Fail(node.mark(),
               "`" + std::string(label) + "` is " + node.Describe() +
                   ", expected " + expected,
               std::move(hint));
}

double ToNumber(YamlNode node, std::string_view label, const Range& range,
                ReadContext& context) {
  double value = 0;
  const bool parsed = node.is_scalar() && !node.quoted() &&
                      ParseAll(node.text(), &value) && std::isfinite(value);
  if (!parsed) {
    FailExpected(node, label, range.words, context, NumberHint(node));
    return 0;
  }
  if (!range.Holds(value)) FailExpected(node, label, range.words, context);
  return value;
}

int ToInteger(YamlNode node, std::string_view label, int low, int high,
              ReadContext& context) {
  int value = 0;
  const bool parsed =
      node.is_scalar() && !node.quoted() && ParseAll(node.text(), &value);
  if (!parsed || value < low || value > high) {
    FailExpected(node, label,
                 "a whole number within " + std::to_string(low) + ".." +
                     std::to_string(high),
                 context);
  }
  return value;
}

bool ToBool(YamlNode node, std::string_view label, ReadContext& context) {
  const bool plain = node.is_scalar() && !node.quoted();
  if (plain && node.text() == "true") return true;
  if (!plain || node.text() != "false") {
    FailExpected(node, label, "true or false", context);
  }
  return false;
}

V3d ToVector(YamlNode node, std::string_view label, const Range& range,
             ReadContext& context) {
  V3d vector(0, 0, 0);
  if (!node.is_list()) {
    FailExpected(node, label, "a list of three numbers", context);
    return vector;
  }
  const std::vector<YamlNode> items = ItemsOf(node, label, 3, 3, context);
  for (std::size_t i = 0; i < items.size(); ++i) {
    vector[static_cast<int>(i)] = ToNumber(items[i], label, range, context);
  }
  return vector;
}

std::string ToText(YamlNode node, std::string_view label,
                   ReadContext& context) {
  if (!node.is_scalar()) {
    FailExpected(node, label, "a text", context);
    return "";
  }
  std::string text(node.text());
  if (text.empty() || text != Printable(text)) {
    FailExpected(node, label, "one line of text without control characters",
                 context);
  }
  return text;
}

std::string ToName(YamlNode node, std::string_view label,
                   ReadContext& context) {
  if (!node.is_scalar()) {
    FailExpected(node, label, "a name", context);
    return "";
  }
  std::string text(node.text());
  if (text.empty() || !std::all_of(text.begin(), text.end(), IsNameCharacter)) {
    FailExpected(node, label, "a name of the characters A-Z a-z 0-9 _ -",
                 context);
  }
  return text;
}

}  // namespace rtb
