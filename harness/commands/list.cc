#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/render/backend.h"
#include "core/scene/load.h"
#include "encoders/registry.h"
#include "harness/commands/command.h"
#include "harness/commands/console.h"
#include "harness/lookup.h"
#include "harness/metrics/metric.h"
#include "harness/results/run_record_json.h"

namespace rtb {
namespace {

struct ListOptions {
  std::string what;
  bool json = false;
};

Json Encoders() {
  Json list = Json::array();
  for (const EncoderEntry& entry : EncoderEntries()) {
    Json parameters = Json::array();
    for (const EncoderParameter& parameter : entry.info.parameters) {
      parameters.push_back({{"name", parameter.name},
                            {"default", parameter.default_value},
                            {"values", parameter.values},
                            {"description", parameter.description}});
    }
    list.push_back({{"name", entry.info.name},
                    {"samples_per_cell", entry.info.samples_per_cell},
                    {"glyphs", entry.info.glyphs},
                    {"description", entry.info.description},
                    {"parameters", parameters}});
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
    Json entry = {{"name", backend.name},
                  {"available", backend.available},
                  {"description", backend.description}};
    if (!backend.available) entry["why_not"] = backend.why_not;
    list.push_back(entry);
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
    list.push_back(
        {{"encoder", entry.info.name}, {"description", entry.info.glyphs}});
  }
  return list;
}

/// A value of an entry as a word of text.
std::string Word(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "available" : "missing";
  return value.is_string() ? Printable(value.get<std::string>()) : value.dump();
}

/// One entry a line, its description last; an encoder's parameters below it.
std::string Lines(const Json& list) {
  std::string text;
  for (const Json& entry : list) {
    std::string name = Word(entry.front());
    name.resize(std::max<std::size_t>(name.size(), 13), ' ');
    text += name;
    for (const auto& [key, value] : entry.items()) {
      if (key == "samples_per_cell") text += Word(value) + " samples  ";
      if (key == "available") text += Word(value) + "  ";
      if (key == "better") text += Word(value) + " is better  ";
    }
    text += Word(entry["description"]);
    if (entry.contains("glyphs")) text += "; " + Word(entry["glyphs"]);
    if (entry.contains("why_not")) text += " (" + Word(entry["why_not"]) + ")";
    text += "\n";
    for (const Json& parameter : entry.value("parameters", Json::array())) {
      text += "    " + Word(parameter["name"]) + "=" +
              Word(parameter["default"]) + "  [" + Word(parameter["values"]) +
              "]  " + Word(parameter["description"]) + "\n";
    }
  }
  return text;
}

Status List(const ListOptions& options) {
  Json list;
  if (options.what == "encoders") list = Encoders();
  if (options.what == "scenes") list = Scenes();
  if (options.what == "backends") list = BackendList();
  if (options.what == "metrics") list = MetricList();
  if (options.what == "glyphs") list = Glyphs();
  return options.json ? WriteJson("-", list) : WriteOutput("-", Lines(list));
}

void AddOptions(CLI::App& app, ListOptions& options) {
  app.add_option("WHAT", options.what,
                 "encoders, scenes, backends, metrics or glyphs")
      ->required()
      ->check([](const std::string& given) -> std::string {
        for (const char* known :
             {"encoders", "scenes", "backends", "metrics", "glyphs"}) {
          if (given == known) return "";
        }
        return "found '" + given +
               "', expected encoders, scenes, backends, metrics or glyphs";
      });
  app.add_flag("--json", options.json, "As JSON");
}

}  // namespace

void AddList(CLI::App& program, Action& selected) {
  AddCommand<ListOptions>(program, selected, "list",
                          "Lists encoders, scenes, backends, metrics or glyphs",
                          AddOptions, List);
}

}  // namespace rtb
