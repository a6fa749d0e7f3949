#include "encoders/parse/sgr.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <vector>

namespace rtb {
namespace {

/// A parameter and what follows it behind colons; nothing reads as 0.
using Parameter = std::vector<int>;

template <class Take>
void Split(std::string_view text, char separator, const Take& take) {
  for (;;) {
    const std::size_t end = std::min(text.find(separator), text.size());
    take(text.substr(0, end));
    if (end == text.size()) return;
    text.remove_prefix(end + 1);
  }
}

/// A number; -1 for what is none or too large.
int Number(std::string_view text) {
  if (text.empty()) return 0;
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end ? number : -1;
}

std::vector<Parameter> SplitParameters(std::string_view text) {
  std::vector<Parameter> parameters;
  Split(text, ';', [&](std::string_view part) {
    Parameter& parameter = parameters.emplace_back();
    Split(part, ':',
          [&](std::string_view sub) { parameter.push_back(Number(sub)); });
  });
  return parameters;
}

std::string Sequence(const std::string& parameters) {
  return "\x1b[" + parameters + "m";
}

/// `which;5;index` or `which;2;r;g;b` from a color model and its values;
/// nothing when they do not name a color.
std::string Color(int which, int model, const std::vector<int>& values) {
  const std::size_t expected = model == 5 ? 1 : model == 2 ? 3 : 0;
  const bool sound =
      expected > 0 && values.size() == expected &&
      std::ranges::all_of(values, [](int v) { return v >= 0 && v <= 255; });
  if (!sound || (which != 38 && which != 48)) return "";
  std::string text = std::to_string(which) + ";" + std::to_string(model);
  for (const int value : values) text += ";" + std::to_string(value);
  return Sequence(text);
}

/// A color behind colons: 38:5:n, 38:2:r:g:b or 38:2:space:r:g:b, after which
/// tolerances may stand.
std::string ColonColor(const Parameter& parameter) {
  const int model = parameter[1];
  std::size_t first = 2;
  if (model == 2 && parameter.size() > 5) ++first;
  const std::size_t count = model == 2 ? 3 : 1;
  if (parameter.size() < first + count) return "";
  const auto begin = parameter.begin() + static_cast<std::ptrdiff_t>(first);
  return Color(parameter[0], model,
               {begin, begin + static_cast<std::ptrdiff_t>(count)});
}

/// A color in the parameters that follow the one at `i`, which becomes the
/// last of them.
std::string SemicolonColor(const std::vector<Parameter>& parameters,
                           std::size_t& i) {
  const int which = parameters[i][0];
  if (++i == parameters.size()) return "";
  const int model = parameters[i][0];
  const int count = model == 2 ? 3 : model == 5 ? 1 : 0;
  std::vector<int> values;
  for (int k = 0; k < count && i + 1 < parameters.size(); ++k) {
    values.push_back(parameters[++i][0]);
  }
  return Color(which, model, values);
}

bool Between(int value, int low, int high) {
  return value >= low && value <= high;
}

/// Any other attribute.
std::string Attribute(int code) {
  const auto as = [](int other) { return Sequence(std::to_string(other)); };
  if (code == 2) return as(kFaintAsBlink);
  if (code == 22) return as(kFaintAsBlink + 20);
  if (code == 8) return as(10 + kConcealFont);
  if (code == 28) return as(10);
  const bool shows = code == 0 || code == 7 || code == 27 ||
                     Between(code, 30, 37) || code == 39 ||
                     Between(code, 40, 47) || code == 49 ||
                     Between(code, 90, 97) || Between(code, 100, 107);
  return shows ? as(code) : "";
}

bool IsColor(int code) { return code == 38 || code == 48 || code == 58; }

}  // namespace

std::string PortableSgr(std::string_view text) {
  const std::vector<Parameter> parameters = SplitParameters(text);
  std::string portable;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    if (!IsColor(parameter[0])) {
      portable += Attribute(parameter[0]);
    } else if (parameter.size() > 1) {
      portable += ColonColor(parameter);
    } else {
      portable += SemicolonColor(parameters, i);
    }
  }
  return portable;
}

}  // namespace rtb
