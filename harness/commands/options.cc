#include "harness/commands/options.h"

#include "core/render/backend.h"

namespace rtb {
namespace {

constexpr int kMaxSpp = 65536;
constexpr int kMaxThreads = 1024;
constexpr int kMaxDepth = 64;  // The scene format's limit.
constexpr double kMaxTime = 1e9;

Result<std::string> NotEmpty(const std::string&, const std::string& text) {
  if (text.empty())
    return Fail(BadInput("", "found nothing, expected a value"));
  return text;
}

/// A parser for one of a few words, which become values.
template <class T>
auto OneOf(std::vector<std::pair<std::string, T>> words) {
  return [words](const std::string& place,
                 const std::string& text) -> Result<T> {
    std::string expected;
    for (const auto& [word, value] : words) {
      if (word == text) return value;
      expected += (expected.empty() ? "" : " or ") + word;
    }
    return Fail(BadInput(place, "found '" + text + "', expected " + expected));
  };
}

std::string CompiledBackends() {
  std::string names;
  for (const BackendInfo& backend : Backends()) {
    if (!backend.compiled) continue;
    names += (names.empty() ? "" : "|") + std::string(backend.name);
  }
  return names;
}

}  // namespace

CLI::Option* AddText(CLI::App& app, const OptionText& text,
                     std::string& value) {
  return AddParsed(app, text, value, NotEmpty);
}

CLI::Option* AddInteger(CLI::App& app, const OptionText& text, int& value,
                        int low, int high) {
  return AddParsed(app, text, value,
                   [low, high](const std::string& place,
                               const std::string& given) -> Result<int> {
                     RTB_ASSIGN_OR_RETURN(
                         const std::int64_t number,
                         ParseInteger(place, given, low, high));
                     return static_cast<int>(number);
                   });
}

CLI::Option* AddWord(CLI::App& app, const OptionText& text, std::string& value,
                     const std::vector<std::string>& words) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& word : words) pairs.emplace_back(word, word);
  return AddParsed(app, text, value, OneOf(pairs));
}

void AddSceneName(CLI::App& app, std::string& scene) {
  AddText(app,
          {"--scene", "NAME|FILE", "",
           "Scene: a name that `list scenes` shows, or a file"},
          scene);
}

void AddTime(CLI::App& app, double& time) {
  AddParsed(app, {"--time", "SECONDS", "0", "Moment along the movement paths"},
            time, [](const std::string& place, const std::string& given) {
              return ParseNumber(place, given, 0, kMaxTime);
            });
}

void AddSpp(CLI::App& app, int& spp) {
  AddInteger(app,
             {"--spp", "N", std::to_string(spp),
              "Rays per sample; 1 is its center, more are stratified"},
             spp, 1, kMaxSpp);
}

void AddSeed(CLI::App& app, std::uint64_t& seed) {
  AddParsed(app, {"--seed", "N", "0", "Seed of all random numbers"}, seed,
            ParseSeed);
}

void AddThreads(CLI::App& app, int& threads) {
  AddInteger(app, {"--threads", "N", "0", "Threads at most; 0 = all cores"},
             threads, 0, kMaxThreads);
}

void AddSceneOptions(CLI::App& app, SceneRequest& request) {
  AddSceneName(app, request.scene);
  AddText(app,
          {"--backend", CompiledBackends(), request.backend,
           "What traces the rays (see `list backends`)"},
          request.backend);
  AddWord(app,
          {"--integrator", "whitted|path", request.options.integrator,
           "How light is transported"},
          request.options.integrator, {"whitted", "path"});
  AddSpp(app, request.options.spp);
  AddTime(app, request.options.time);
  AddSeed(app, request.options.seed);
  AddThreads(app, request.options.threads);
  AddExposure(app, request.exposure, "the scene's");
  AddInteger(app,
             {"--max-depth", "N", "the scene's", "Bounces after the eye ray"},
             request.options.max_depth, 0, kMaxDepth);
}

void AddGrid(CLI::App& app, GridSize& grid, const std::string& default_value) {
  AddParsed(app,
            {"--grid", "COLSxROWS", default_value, "Size of the grid of cells"},
            grid, ParseGrid);
}

void AddDecodeOptions(CLI::App& app, DecodeOptions& options) {
  AddParsedWith(app,
                {"--cell", "WxH", "8x16", "Pixels of one cell when decoded"},
                ParseCellSize, [&options](PixelSize cell) {
                  options.cell_width = cell.width;
                  options.cell_height = cell.height;
                });
  AddParsed(app,
            {"--decode", "geometric|font", "geometric",
             "Shapes of the glyphs: Unicode's exact areas where defined, or "
             "the font's for all"},
            options.masks,
            OneOf<MaskSource>({{"geometric", MaskSource::kGeometric},
                               {"font", MaskSource::kFont}}));
  AddParsed(app,
            {"--font", "FILE", "DejaVu Sans Mono",
             "Font of glyphs without a geometric shape"},
            options.font, NotEmpty);
}

void AddColorDepth(CLI::App& app, ColorDepth& depth) {
  std::vector<std::pair<std::string, ColorDepth>> depths;
  for (const ColorDepth one : {ColorDepth::kTruecolor, ColorDepth::k256,
                               ColorDepth::k16, ColorDepth::kMono}) {
    depths.emplace_back(NameOf(one), one);
  }
  AddParsed(app,
            {"--color", "truecolor|256|16|mono", "truecolor",
             "Colors of the terminal: glyph and colors are chosen for them"},
            depth, OneOf(depths));
}

void AddJson(CLI::App& app, std::string& json) {
  AddText(app,
          {"--json", "FILE|-", "",
           "Write the record; with - standard output is JSON alone"},
          json);
}

void AddQuiet(CLI::App& app, bool& quiet) {
  app.add_flag("--quiet", quiet, "No notes and no progress");
}

}  // namespace rtb
