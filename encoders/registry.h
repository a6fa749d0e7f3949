/// @file
/// The registry: every encoder that encoders.inc lists, and SPECs.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "encoders/encoder.h"

namespace rtb {

/// Parameters of a SPEC: key -> value.
using EncoderParameters = std::map<std::string, std::string>;

/// How the registry makes an encoder. The parameters have been checked
/// against info.parameters by name; the factory checks their values.
struct EncoderEntry {
  EncoderInfo info;
  Result<std::unique_ptr<Encoder>> (*make)(const EncoderParameters&);
};

/// All encoders, in the order of encoders.inc.
std::span<const EncoderEntry> EncoderEntries();

/// `name[:key=value...]`, a value may stand in '...'.
struct EncoderSpec {
  std::string name;
  EncoderParameters parameters;
  std::string text;  ///< As given.
};

/// Splits one SPEC. Unknown names and keys are errors that list what is
/// possible.
Result<EncoderSpec> ParseEncoderSpec(std::string_view text);

/// Splits `SPEC[,SPEC...]` or `all` (quotes protect commas): every encoder that
/// can run here and whose name alone is a SPEC. In `external:COMMAND` the
/// command is the rest of the text, commas and colons included; its other
/// parameters stand before it: `external:timeout=60:COMMAND`.
Result<std::vector<EncoderSpec>> ParseEncoderSpecs(std::string_view text);

/// The modifiers that an entry takes: all but those among its parameters.
std::vector<EncoderParameter> ModifiersOf(const EncoderEntry& entry);

/// Makes an entry's encoder, with the modifiers that any takes
/// (modifiers/modifiers.h) around it.
/// @param given the entry's parameters and modifiers, checked by name.
Result<std::unique_ptr<Encoder>> MakeEncoder(const EncoderEntry& entry,
                                             const EncoderParameters& given);

/// Makes the encoder that a SPEC names.
Result<std::unique_ptr<Encoder>> MakeEncoder(const EncoderSpec& spec);

/// Shorthand: parses and makes.
Result<std::unique_ptr<Encoder>> MakeEncoder(std::string_view spec);

}  // namespace rtb
