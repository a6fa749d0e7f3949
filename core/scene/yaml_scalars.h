/// @file
/// From YAML nodes to values: numbers, vectors, names. Each function notes an
/// error in the context and returns a neutral value when the node is not what
/// it should be.
#pragma once

#include <string>
#include <string_view>

#include "core/math/vec.h"
#include "core/scene/range.h"
#include "core/scene/yaml_reader.h"

namespace rtb {

/// Notes "`label` is FOUND, expected WORDS".
void FailExpected(YamlNode node, std::string_view label,
                  const std::string& expected, ReadContext& context,
                  std::string hint = "");

double ToNumber(YamlNode node, std::string_view label, const Range& range,
                ReadContext& context);
int ToInteger(YamlNode node, std::string_view label, int low, int high,
              ReadContext& context);
bool ToBool(YamlNode node, std::string_view label, ReadContext& context);
/// A list of three numbers, each within `range`.
V3d ToVector(YamlNode node, std::string_view label, const Range& range,
             ReadContext& context);
std::string ToText(YamlNode node, std::string_view label, ReadContext& context);
/// A text of [A-Za-z0-9_-]+.
std::string ToName(YamlNode node, std::string_view label, ReadContext& context);

}  // namespace rtb
