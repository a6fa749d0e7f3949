#include "encoders/parameters.h"

#include <algorithm>
#include <sstream>

#include "core/base/numbers.h"
#include "core/base/suggest.h"

namespace rtb {

const std::string& ValueOf(const EncoderParameter& parameter,
                           const EncoderParameters& given) {
  const auto found = given.find(parameter.name);
  return found == given.end() ? parameter.default_value : found->second;
}

std::vector<std::string> ChoiceNames(const EncoderParameter& parameter) {
  std::vector<std::string> names;
  std::istringstream values(parameter.values);
  for (std::string name; std::getline(values, name, '|');) {
    names.push_back(name);
  }
  return names;
}

Result<int> ReadChoice(const EncoderParameter& parameter,
                       const EncoderParameters& given) {
  const std::vector<std::string> names = ChoiceNames(parameter);
  const std::string& value = ValueOf(parameter, given);
  const auto found = std::find(names.begin(), names.end(), value);
  if (found == names.end()) {
    return Fail(
        BadInput(parameter.name,
                 "unknown value `" + value + "`; expected " + parameter.values,
                 DidYouMean(value, names)));
  }
  return static_cast<int>(found - names.begin());
}

Result<double> ReadNumber(const EncoderParameter& parameter,
                          const EncoderParameters& given, double low,
                          double high) {
  return ParseNumber(parameter.name, ValueOf(parameter, given), low, high);
}

const EncoderParameter& SeedParameter() {
  static const EncoderParameter parameter{"seed", "the run's", "integer >= 0",
                                          "of the random positions"};
  return parameter;
}

Result<std::optional<std::uint64_t>> ReadSeed(const EncoderParameters& given) {
  const auto found = given.find(SeedParameter().name);
  if (found == given.end()) return std::nullopt;
  RTB_ASSIGN_OR_RETURN(const std::uint64_t seed,
                       ParseSeed(found->first, found->second));
  return seed;
}

}  // namespace rtb
