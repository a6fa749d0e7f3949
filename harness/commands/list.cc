#include <string>
#include <vector>

#include "core/render/backend.h"
#include "core/scene/load.h"
#include "encoders/registry.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/commands/options.h"
#include "harness/lookup.h"
#include "harness/metrics/metric.h"
#include "harness/results/run_record_json.h"
#include "harness/results/table.h"

namespace rtb {
namespace {

constexpr char kParameters[] = "parameters";
/// Parameters that an encoder takes because all do.
constexpr char kModifiers[] = "modifiers";

struct ListOptions {
  std::string what;
  bool json = false;
};

Json ParameterList(std::span<const EncoderParameter> parameters) {
  Json list = Json::array();
  for (const EncoderParameter& parameter : parameters) {
    list.push_back({{"name", parameter.name},
                    {"default", parameter.default_value},
                    {"values", parameter.values},
                    {"description", parameter.description}});
  }
  return list;
}

Json Encoders() {
  Json list = Json::array();
  for (const EncoderEntry& entry : EncoderEntries()) {
    list.push_back({{"name", entry.info.name},
                    {"samples_per_cell", entry.info.samples_per_cell},
                    {"glyphs", entry.info.glyphs},
                    {"needs_parameters", entry.info.needs_parameters},
                    {"version", entry.info.version},
                    {"available", entry.info.why_not.empty()},
                    {"why_not", entry.info.why_not},
                    {"description", entry.info.description},
                    {kParameters, ParameterList(entry.info.parameters)},
                    {kModifiers, ParameterList(ModifiersOf(entry))}});
  }
  return list;
}

Json Scenes() {
  Json list = Json::array();
  for (const NamedScene& named : ListScenes(FindDataFolders())) {
    const auto scene = LoadScene(named.file);
    list.push_back({{"name", named.name},
                    {"file", named.file.string()},
                    {"description",
                     scene ? scene->description : scene.error().ToString()}});
  }
  return list;
}

Json BackendList() {
  Json list = Json::array();
  for (const BackendInfo& backend : Backends()) {
    const Status runs = backend.check();
    list.push_back({{"name", backend.name},
                    {"compiled", backend.compiled},
                    {"available", runs.has_value()},
                    {"why_not", runs ? "" : runs.error().what},
                    {"description", backend.description}});
  }
  return list;
}

Json MetricList() {
  Json list = Json::array();
  for (const Metric& metric : Metrics()) {
    list.push_back({{"name", metric.name},
                    {"better", metric.lower_is_better ? "lower" : "higher"},
                    {"description", metric.description}});
  }
  return list;
}

Json Glyphs() {
  Json list = Json::array();
  for (const EncoderEntry& entry : EncoderEntries()) {
    list.push_back({{"name", entry.info.name}, {"glyphs", entry.info.glyphs}});
  }
  return list;
}

/// A value as a cell of a table.
std::string Word(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Entries as a table whose columns are their keys, lists left out.
std::string TableOf(const Json& entries) {
  Table table;
  for (const auto& [key, value] : entries.front().items()) {
    if (!value.is_array()) {
      table.columns.push_back({key, value.is_number()});
    }
  }
  for (const Json& entry : entries) {
    std::vector<std::string>& row = table.rows.emplace_back();
    for (const TableColumn& column : table.columns) {
      row.push_back(Word(entry[column.heading]));
    }
  }
  return FormatTable(table);
}

/// A table, and where entries have parameters one of these, ending with those
/// that all entries take.
std::string Text(const Json& list) {
  if (list.empty()) return "";
  Json all = Json::array();
  for (const Json& entry : list) {
    for (const Json& parameter : entry.value(kParameters, Json::array())) {
      Json row = {{"parameter of", entry["name"]}};
      row.update(parameter);
      all.push_back(row);
    }
  }
  for (const Json& modifier : list.front().value(kModifiers, Json::array())) {
    Json row = {{"parameter of", "any encoder"}};
    row.update(modifier);
    all.push_back(row);
  }
  return TableOf(list) + (all.empty() ? "" : "\n" + TableOf(all));
}

Status List(const ListOptions& options) {
  Json list;
  if (options.what == "encoders") list = Encoders();
  if (options.what == "scenes") list = Scenes();
  if (options.what == "backends") list = BackendList();
  if (options.what == "metrics") list = MetricList();
  if (options.what == "glyphs") list = Glyphs();
  return options.json ? WriteJson("-", list) : WriteOutput("-", Text(list));
}

void AddOptions(CLI::App& app, ListOptions& options) {
  AddWord(app,
          {"WHAT", "", "", "encoders, scenes, backends, metrics or glyphs"},
          options.what, {"encoders", "scenes", "backends", "metrics", "glyphs"})
      ->required();
  app.add_flag("--json", options.json, "As JSON");
}

}  // namespace

void AddList(CLI::App& program, Action& selected) {
  AddCommand<ListOptions>(program, selected, "list",
                          "Lists encoders, scenes, backends, metrics or glyphs",
                          AddOptions, List);
}

}  // namespace rtb
