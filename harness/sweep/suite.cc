#include "harness/sweep/suite.h"

#include <charconv>

#include "harness/measure/temporal.h"
#include "harness/sweep/suite_reader.h"

namespace rtb {
namespace {

constexpr int kMaxSpp = 65536;

}  // namespace

const std::vector<std::string>& ExcludeKeys() {
  static const std::vector<std::string> keys = {
      "kind", "scene",   "time",       "encoder", "grid",
      "spp",  "backend", "integrator", "color",   "reference"};
  return keys;
}

std::string NumberText(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number).ptr;
  return {text, end};
}

Result<Suite> ParseSuite(const std::string& text,
                         const std::filesystem::path& file,
                         const DataFolders& folders) {
  RTB_ASSIGN_OR_RETURN(const YamlTree tree, ParseYaml(text, file.string()));
  ReadContext context(file);
  Suite suite = SuiteReader(file, folders, context).Read(YamlNode(tree, 0));
  if (!context.ok()) return Fail(context.error());
  return suite;
}

Suite SuiteReader::Read(YamlNode node) {
  constexpr int kMostRounds = 100000;
  MapReader root(node, "a suite", context_);
  Suite suite;
  root.Integer("rtbench_suite", 1, 1);
  suite.name = root.Name("name");
  suite.description = root.Text("description", "");
  suite.repeat = root.Integer("repeat", 1, kMostRounds, suite.repeat);
  ReadMatrices(root, suite);
  ReadTemporal(root, suite);
  ReadLive(root, suite);
  root.Finish();
  CheckTopLevel(root, suite);
  return suite;
}

void SuiteReader::ReadMatrices(MapReader& root, Suite& suite) {
  SuiteMatrix shared;
  ReadMatrix(root, shared);
  const auto list = root.Find("matrix");
  if (!list) {
    suite.matrices.push_back(shared);
    return;
  }
  for (const YamlNode& item :
       ItemsOf(*list, "matrix", 1, kMostItems, context_)) {
    MapReader map(item, "an entry of `matrix`", context_);
    SuiteMatrix matrix = shared;
    ReadMatrix(map, matrix);
    RequireLists(map, matrix);
    map.Finish();
    suite.matrices.push_back(std::move(matrix));
  }
}

void SuiteReader::CheckTopLevel(MapReader& root, Suite& suite) {
  if (!context_.ok() || root.Has("matrix")) return;
  const SuiteMatrix& only = suite.matrices.front();
  // A suite of moving scenes or of the live mode alone has no lists.
  const bool other = suite.temporal || suite.live;
  if (other && only.scenes.empty() && only.encoders.empty()) {
    suite.matrices.clear();
  } else {
    RequireLists(root, only);
  }
}

void SuiteReader::ReadMatrix(MapReader& map, SuiteMatrix& matrix) {
  constexpr Range kTimes{0, 1e9, "seconds within 0..1e9"};
  List(map, "kinds", matrix.kinds, [&](YamlNode n) { return ToKind(n); });
  Scenes(map, matrix.scenes);
  List(map, "times", matrix.times,
       [&](YamlNode n) { return ToNumber(n, "times", kTimes, context_); });
  Encoders(map, matrix.encoders);
  List(map, "grids", matrix.grids, [&](YamlNode n) { return ToGrid(n); });
  List(map, "spp", matrix.spp,
       [&](YamlNode n) { return ToInteger(n, "spp", 1, kMaxSpp, context_); });
  List(map, "backends", matrix.backends,
       [&](YamlNode n) { return ToBackend(n); });
  List(map, "integrators", matrix.integrators, [&](YamlNode n) {
    return ToWord(n, "integrators", {"whitted", "path"});
  });
  List(map, "colors", matrix.colors, [&](YamlNode n) { return ToColor(n); });
  List(map, "references", matrix.references,
       [&](YamlNode n) { return ToReference(n, matrix); });
  List(map, "seeds", matrix.seeds, [&](YamlNode n) { return ToSeed(n); });
  matrix.pictures = map.Bool("pictures", matrix.pictures);
  ReadExclude(map, matrix);
}

void SuiteReader::RequireLists(const MapReader& map,
                               const SuiteMatrix& matrix) {
  if (matrix.scenes.empty()) {
    context_.Fail(map.mark(), "`scenes` is nowhere, expected a list");
  }
  if (matrix.encoders.empty()) {
    context_.Fail(map.mark(), "`encoders` is nowhere, expected a list");
  }
}

void SuiteReader::ReadExclude(MapReader& map, SuiteMatrix& matrix) {
  const auto list = map.Find("exclude");
  if (!list) return;
  matrix.exclude.clear();
  for (const YamlNode& item :
       ItemsOf(*list, "exclude", 0, kMostItems, context_)) {
    MapReader rule_map(item, "a rule of `exclude`", context_);
    ExcludeRule rule;
    for (const std::string& key : ExcludeKeys()) {
      const auto value = rule_map.Find(key);
      if (!value) continue;
      if (!value->is_list()) {
        rule[key] = {ToExcluded(*value, key)};
        continue;
      }
      List(rule_map, key, rule[key],
           [&](YamlNode n) { return ToExcluded(n, key); });
    }
    rule_map.Finish();
    if (rule.empty()) {
      context_.Fail(item.mark(),
                    "a rule of `exclude` without keys would leave "
                    "out everything");
    }
    matrix.exclude.push_back(std::move(rule));
  }
}

void SuiteReader::ReadTemporal(MapReader& root, Suite& suite) {
  constexpr Range kRates{0.001, 1000, "frames per second within 0.001..1000"};
  auto map = root.FindMap("temporal", "`temporal`");
  if (!map) return;
  TemporalSuite temporal;
  map->Require("scenes");
  Scenes(*map, temporal.scenes);
  map->Require("encoders");
  Encoders(*map, temporal.encoders);
  Grid(*map, temporal.grid);
  temporal.spp = map->Integer("spp", 1, kMaxSpp, temporal.spp);
  temporal.frames =
      map->Integer("frames", kLeastFrames, 100000, temporal.frames);
  temporal.fps = map->Number("fps", kRates, temporal.fps);
  map->Finish();
  suite.temporal = std::move(temporal);
}

void SuiteReader::ReadLive(MapReader& root, Suite& suite) {
  auto map = root.FindMap("live", "`live`");
  if (!map) return;
  LiveSuite live;
  map->Require("scenes");
  Scenes(*map, live.scenes);
  map->Require("encoders");
  Encoders(*map, live.encoders);
  Grid(*map, live.grid);
  live.frames = map->Integer("frames", 1, 1000000, live.frames);
  map->Finish();
  suite.live = std::move(live);
}

}  // namespace rtb
