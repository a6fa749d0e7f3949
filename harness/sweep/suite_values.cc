/// @file
/// The values of a suite's lists.
#include <algorithm>

#include "core/base/suggest.h"
#include "core/render/backend.h"
#include "encoders/registry.h"
#include "harness/arguments.h"
#include "harness/sweep/suite_reader.h"

namespace rtb {
namespace {

constexpr ColorDepth kDepths[] = {ColorDepth::kTruecolor, ColorDepth::k256,
                                  ColorDepth::k16, ColorDepth::kMono};

/// Success also where the encoder cannot run here but could elsewhere.
Status CheckEncoder(const std::string& text) {
  RTB_ASSIGN_OR_RETURN(const EncoderSpec spec, ParseEncoderSpec(text));
  const auto encoder = MakeEncoder(spec);
  if (encoder || encoder.error().kind == ErrorKind::kMissing) return {};
  return Fail(encoder.error());
}

}  // namespace

void SuiteReader::Scenes(MapReader& map, std::vector<SuiteScene>& scenes) {
  List(map, "scenes", scenes, [&](YamlNode n) { return ToScene(n); });
}

void SuiteReader::Encoders(MapReader& map, std::vector<std::string>& encoders) {
  List(map, "encoders", encoders, [&](YamlNode n) { return ToEncoder(n); });
}

void SuiteReader::Grid(MapReader& map, GridSize& grid) {
  const auto node = map.Find("grid");
  if (node) grid = ToGrid(*node);
}

SuiteScene SuiteReader::ToScene(YamlNode node) {
  SuiteScene scene{ToText(node, "scenes", context_), {}};
  if (!context_.ok()) return scene;
  const std::filesystem::path beside = file_.parent_path() / scene.name;
  auto found = FindScene(folders_, scene.name);
  std::error_code ignored;
  const bool named = std::ranges::any_of(
      ListScenes(folders_),
      [&](const NamedScene& known) { return known.name == scene.name; });
  if (!named && std::filesystem::is_regular_file(beside, ignored)) {
    scene.file = beside;
  } else if (found && named) {
    scene.file = *found;
  } else {
    context_.Fail(node.mark(),
                  "`scenes` names " + scene.name +
                      ", which is neither a scene nor a file beside the suite",
                  found ? "file names are relative to the suite's file"
                        : found.error().hint);
  }
  return scene;
}

std::string SuiteReader::ToEncoder(YamlNode node) {
  const std::string text = ToText(node, "encoders", context_);
  if (!context_.ok()) return text;
  const Status status = CheckEncoder(text);
  if (!status) {
    const Error& error = status.error();
    context_.Fail(node.mark(), error.place + ": " + error.what, error.hint);
  }
  return text;
}

std::string SuiteReader::ToBackend(YamlNode node) {
  std::vector<std::string> names;
  for (const BackendInfo& backend : Backends()) names.push_back(backend.name);
  return ToWord(node, "backends", names);
}

std::string SuiteReader::ToReference(YamlNode node, SuiteMatrix& matrix) {
  static const std::vector<std::string> kWords = {"auto", "self", "povray",
                                                  "cycles"};
  std::string text = ToText(node, "references", context_);
  if (!context_.ok() || std::ranges::find(kWords, text) != kWords.end()) {
    return text;
  }
  const std::filesystem::path file = file_.parent_path() / text;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored)) {
    matrix.reference_files[text] = file;
  } else {
    FailExpected(node, "references",
                 JoinNames(kWords) + " or an image file beside the suite",
                 context_, DidYouMean(text, kWords));
  }
  return text;
}

std::uint64_t SuiteReader::ToSeed(YamlNode node) {
  const auto seed = node.is_scalar() && !node.quoted()
                        ? ParseSeed("", std::string(node.text()))
                        : Fail(BadInput("", ""));
  if (!seed) {
    FailExpected(node, "seeds", "a whole number from 0 to 2^64 - 1", context_);
  }
  return seed.value_or(0);
}

ColorDepth SuiteReader::ToColor(YamlNode node) {
  std::vector<std::string> names;
  for (const ColorDepth depth : kDepths) names.push_back(NameOf(depth));
  const std::string word = ToWord(node, "colors", names);
  for (const ColorDepth depth : kDepths) {
    if (word == NameOf(depth)) return depth;
  }
  return ColorDepth::kTruecolor;
}

GridSize SuiteReader::ToGrid(YamlNode node) {
  const std::string text = ToText(node, "grids", context_);
  const auto grid = ParseGrid("", text);
  if (!grid) {
    FailExpected(
        node, "grids",
        "COLSxROWS such as 120x40, each 1 to " + std::to_string(kMaxGridSide),
        context_);
  }
  return grid.value_or(GridSize{1, 1});
}

UnitKind SuiteReader::ToKind(YamlNode node) {
  const std::string word = ToWord(node, "kinds", {"quality", "timing"});
  return FindUnitKind(word).value_or(UnitKind::kQuality);
}

std::string SuiteReader::ToWord(YamlNode node, std::string_view label,
                                const std::vector<std::string>& words) {
  const std::string text(node.is_scalar() ? node.text() : "");
  if (std::ranges::find(words, text) != words.end()) return text;
  FailExpected(node, label, "one of " + JoinNames(words), context_,
               DidYouMean(text, words));
  return words.front();
}

std::string SuiteReader::ToExcluded(YamlNode node, const std::string& key) {
  if (key == "time")
    return NumberText(ToNumber(node, key, kAnyNumber, context_));
  return ToText(node, key, context_);
}

}  // namespace rtb
