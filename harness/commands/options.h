/// @file
/// Options that several subcommands share.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "encoders/color_depth.h"
#include "encoders/decode.h"
#include "harness/arguments.h"
#include "harness/prepared_scene.h"

namespace rtb {

/// How an option looks in --help.
struct OptionText {
  std::string name;           ///< `--grid`
  std::string type;           ///< `COLSxROWS`
  std::string default_value;  ///< Empty: none is shown.
  std::string description;
};

/// Adds an option whose text `parse(place, text)` turns into a Result, and
/// whose value `set` takes. Errors of `parse` become the parser's.
template <class Parse, class Set>
CLI::Option* AddParsedWith(CLI::App& app, const OptionText& text, Parse parse,
                           Set set) {
  const std::string name = text.name;
  const auto check = [name, parse](const std::string& given) {
    const auto result = parse(name, given);
    return result ? std::string() : result.error().what;
  };
  const auto take = [name, parse, set](const std::string& given) {
    set(*parse(name, given));
  };
  const std::string shown_default =
      text.default_value.empty() ? ""
                                 : " (default: " + text.default_value + ")";
  return app
      .add_option_function<std::string>(name, take,
                                        text.description + shown_default)
      ->check(check, "")
      ->type_name(text.type);
}

/// The same into a variable.
template <class Parse, class T>
CLI::Option* AddParsed(CLI::App& app, const OptionText& text, T& value,
                       Parse parse) {
  return AddParsedWith(app, text, parse,
                       [&value](const auto& parsed) { value = parsed; });
}

/// A text option that may not be empty.
CLI::Option* AddText(CLI::App& app, const OptionText& text, std::string& value);

/// A whole number in [low, high].
CLI::Option* AddInteger(CLI::App& app, const OptionText& text, int& value,
                        int low, int high);

/// One of a few words.
CLI::Option* AddWord(CLI::App& app, const OptionText& text, std::string& value,
                     const std::vector<std::string>& words);

/// --scene alone.
void AddSceneName(CLI::App& app, std::string& scene);
/// --time alone.
void AddTime(CLI::App& app, double& time);
/// --spp alone.
void AddSpp(CLI::App& app, int& spp);
/// --exposure, into a double or an optional one.
template <class T>
void AddExposure(CLI::App& app, T& exposure, const std::string& default_value) {
  AddParsed(app,
            {"--exposure", "STOPS", default_value,
             "Linear light is multiplied by 2^STOPS before display"},
            exposure, [](const std::string& place, const std::string& given) {
              return ParseNumber(place, given, -64, 64);
            });
}
/// --seed alone.
void AddSeed(CLI::App& app, std::uint64_t& seed);
/// --threads alone.
void AddThreads(CLI::App& app, int& threads);

/// --scene --integrator --backend --spp --time --seed --threads --exposure
/// --max-depth.
void AddSceneOptions(CLI::App& app, SceneRequest& request);

/// --grid. @param default_value empty: none is shown.
void AddGrid(CLI::App& app, GridSize& grid, const std::string& default_value);
/// --cell --decode --font.
void AddDecodeOptions(CLI::App& app, DecodeOptions& options);
/// --color.
void AddColorDepth(CLI::App& app, ColorDepth& depth);
/// --json=FILE|-.
void AddJson(CLI::App& app, std::string& json);
/// --quiet.
void AddQuiet(CLI::App& app, bool& quiet);

}  // namespace rtb
