#include <algorithm>
#include <utility>

#include "core/base/suggest.h"
#include "encoders/blend.h"
#include "encoders/modifiers/modifiers.h"
#include "encoders/parameters.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

constexpr char kForm[] = "name[:key=value...]";
constexpr char kAll[] = "all";
/// This one's last parameter is a command: the rest of the text, as it stands.
constexpr std::string_view kRestOfText = "external:";
constexpr char kCommand[] = "command";

std::string Place(std::string_view spec) {
  return "encoder `" + std::string(spec) + "`";
}

/// What stands before the first `separator` outside quotes (or everything),
/// taken off `text` together with the separator.
Result<std::string_view> TakeUntil(char separator, std::string_view& text) {
  bool quoted = false;
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    if (text[end] == '\'') quoted = !quoted;
    if (text[end] == separator && !quoted) break;
  }
  if (quoted) {
    return Fail(BadInput(Place(text), "a quote (') is not closed"));
  }
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

std::string Unquoted(std::string_view value) {
  std::string text(value);
  std::erase(text, '\'');
  return text;
}

const EncoderEntry* FindEntry(const std::string& name) {
  for (const EncoderEntry& entry : EncoderEntries()) {
    if (entry.info.name == name) return &entry;
  }
  return nullptr;
}

Error UnknownEncoder(const EncoderSpec& spec) {
  std::vector<std::string> names;
  for (const EncoderEntry& entry : EncoderEntries()) {
    names.push_back(entry.info.name);
  }
  return BadInput(Place(spec.text),
                  "unknown encoder `" + spec.name +
                      "`; expected all or one of " + JoinNames(names),
                  DidYouMean(spec.name, names));
}

Error UnknownParameter(const EncoderSpec& spec, const EncoderInfo& info,
                       const std::string& key) {
  std::vector<std::string> names;
  for (const auto parameters :
       {std::span(info.parameters), ModifierParameters()}) {
    for (const EncoderParameter& parameter : parameters) {
      if (std::ranges::find(names, parameter.name) == names.end()) {
        names.push_back(parameter.name);
      }
    }
  }
  return BadInput(Place(spec.text),
                  "unknown parameter `" + key + "`; " + info.name + " takes " +
                      JoinNames(names),
                  DidYouMean(key, names));
}

bool Lists(std::span<const EncoderParameter> parameters,
           const std::string& key) {
  return std::ranges::find(parameters, key, &EncoderParameter::name) !=
         parameters.end();
}

/// Checks name and keys against the registry.
Result<const EncoderEntry*> EntryOf(const EncoderSpec& spec) {
  const EncoderEntry* entry = FindEntry(spec.name);
  if (entry == nullptr) return Fail(UnknownEncoder(spec));
  for (const auto& [key, value] : spec.parameters) {
    if (!Lists(entry->info.parameters, key) &&
        !Lists(ModifierParameters(), key)) {
      return Fail(UnknownParameter(spec, entry->info, key));
    }
  }
  return entry;
}

/// Adds one `key=value` to the spec.
Status AddParameter(std::string_view text, EncoderSpec& spec) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos) {
    return Fail(BadInput(Place(spec.text), "expected key=value, found `" +
                                               std::string(text) + "`"));
  }
  const std::string key(text.substr(0, equals));
  const auto [at, added] =
      spec.parameters.emplace(key, Unquoted(text.substr(equals + 1)));
  if (!added) {
    return Fail(BadInput(Place(spec.text),
                         "parameter `" + key + "` is given more than once"));
  }
  return {};
}

/// Whether a text begins with `key=value:`, where the value holds no blank.
bool BeginsWithParameter(std::string_view text) {
  const std::size_t key = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  const std::size_t end = text.find_first_of(": \t");
  return key != text.npos && key > 0 && text[key] == '=' && end != text.npos &&
         text[end] == ':';
}

/// Splits `external:key=value:...:COMMAND`.
Result<EncoderSpec> SplitExternal(std::string_view text) {
  EncoderSpec spec;
  spec.text = text;
  spec.name = text.substr(0, kRestOfText.size() - 1);
  text.remove_prefix(kRestOfText.size());
  while (BeginsWithParameter(text)) {
    RTB_ASSIGN_OR_RETURN(const std::string_view part, TakeUntil(':', text));
    RTB_RETURN_IF_ERROR(AddParameter(part, spec));
  }
  RTB_RETURN_IF_ERROR(AddParameter(std::string(kCommand) + "=", spec));
  spec.parameters[kCommand] = text;
  return spec;
}

/// Splits `name:key=value:...` without looking anything up.
Result<EncoderSpec> SplitSpec(std::string_view text) {
  if (text.starts_with(kRestOfText)) return SplitExternal(text);
  EncoderSpec spec;
  spec.text = text;
  std::string_view rest = text;
  RTB_ASSIGN_OR_RETURN(spec.name, TakeUntil(':', rest));
  bool more = spec.name.size() < text.size();
  while (more) {
    const std::size_t before = rest.size();
    RTB_ASSIGN_OR_RETURN(const std::string_view part, TakeUntil(':', rest));
    RTB_RETURN_IF_ERROR(AddParameter(part, spec));
    more = part.size() < before;
  }
  return spec;
}

std::vector<EncoderSpec> AllSpecs() {
  std::vector<EncoderSpec> specs;
  for (const EncoderEntry& entry : EncoderEntries()) {
    if (entry.info.needs_parameters || !entry.info.why_not.empty()) continue;
    specs.push_back({entry.info.name, {}, entry.info.name});
  }
  return specs;
}

}  // namespace

Result<EncoderSpec> ParseEncoderSpec(std::string_view text) {
  if (text.empty()) {
    return Fail(BadInput(Place(text), std::string("an encoder's SPEC is "
                                                  "empty; expected ") +
                                          kForm));
  }
  RTB_ASSIGN_OR_RETURN(EncoderSpec spec, SplitSpec(text));
  RTB_RETURN_IF_ERROR(EntryOf(spec));
  return spec;
}

Result<std::vector<EncoderSpec>> ParseEncoderSpecs(std::string_view text) {
  if (text == kAll) return AllSpecs();
  std::vector<EncoderSpec> specs;
  bool more = true;
  while (more) {
    const std::size_t before = text.size();
    std::string_view part = text;
    if (text.starts_with(kRestOfText)) {
      text = {};
    } else {
      RTB_ASSIGN_OR_RETURN(part, TakeUntil(',', text));
    }
    RTB_ASSIGN_OR_RETURN(EncoderSpec spec, ParseEncoderSpec(part));
    specs.push_back(std::move(spec));
    more = part.size() < before;
  }
  return specs;
}

std::vector<EncoderParameter> ModifiersOf(const EncoderEntry& entry) {
  std::vector<EncoderParameter> modifiers;
  for (const EncoderParameter& modifier : ModifierParameters()) {
    if (!Lists(entry.info.parameters, modifier.name)) {
      modifiers.push_back(modifier);
    }
  }
  return modifiers;
}

Result<std::unique_ptr<Encoder>> MakeEncoder(const EncoderEntry& entry,
                                             const EncoderParameters& given) {
  EncoderParameters own;
  EncoderParameters shared;
  for (const auto& [key, value] : given) {
    (Lists(entry.info.parameters, key) ? own : shared).emplace(key, value);
  }
  RTB_ASSIGN_OR_RETURN(Modifiers modifiers, ReadModifiers(shared));
  if (Lists(entry.info.parameters, BlendParameter().name)) {
    RTB_ASSIGN_OR_RETURN(modifiers.blend, ReadBlend(own));
  }
  RTB_ASSIGN_OR_RETURN(auto encoder, entry.make(own));
  return MakeModified(std::move(encoder), modifiers);
}

Result<std::unique_ptr<Encoder>> MakeEncoder(const EncoderSpec& spec) {
  RTB_ASSIGN_OR_RETURN(const EncoderEntry* const entry, EntryOf(spec));
  auto encoder = MakeEncoder(*entry, spec.parameters);
  if (!encoder) {
    Error& error = encoder.error();
    error.place = Place(spec.text) + ": " + error.place;
  }
  return encoder;
}

Result<std::unique_ptr<Encoder>> MakeEncoder(std::string_view spec) {
  RTB_ASSIGN_OR_RETURN(const EncoderSpec parsed, ParseEncoderSpec(spec));
  return MakeEncoder(parsed);
}

}  // namespace rtb
