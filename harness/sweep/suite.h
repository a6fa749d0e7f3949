/// @file
/// Suite: what a sweep runs, as plain data, and its YAML form
/// (results/suites/suite.schema.json describes it).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "encoders/color_depth.h"
#include "harness/lookup.h"
#include "harness/sweep/unit.h"

namespace rtb {

/// A scene as the suite names it, and its file.
struct SuiteScene {
  std::string name;
  std::filesystem::path file;
};

/// Leaves out the units that have, for each key, one of its values. The keys
/// are those of ExcludeKeys(); values are compared as text, an encoder's also
/// by its name alone (`search` holds for `search:rays=4`).
using ExcludeRule = std::map<std::string, std::vector<std::string>>;

/// Lists whose product is run. Encoders are SPECs.
struct SuiteMatrix {
  std::vector<UnitKind> kinds{UnitKind::kQuality, UnitKind::kTiming};
  std::vector<SuiteScene> scenes;
  std::vector<double> times{0};  ///< Seconds.
  std::vector<std::string> encoders;
  std::vector<GridSize> grids{{120, 40}};
  std::vector<int> spp{1};
  std::vector<std::string> backends{"embree"};
  std::vector<std::string> integrators{"whitted"};
  std::vector<ColorDepth> colors{ColorDepth::kTruecolor};
  std::vector<std::string> references{"auto"};
  /// Where those of the references that are files lie.
  std::map<std::string, std::filesystem::path> reference_files;
  /// Used where something is random; elsewhere the first alone.
  std::vector<std::uint64_t> seeds{0};
  bool pictures = true;  ///< Whether grids and maps are kept.
  std::vector<ExcludeRule> exclude;
};

/// Moving scenes, frame by frame.
struct TemporalSuite {
  std::vector<SuiteScene> scenes;
  std::vector<std::string> encoders;
  GridSize grid{120, 40};
  int spp = 1;
  int frames = 24;
  double fps = 24;
};

/// The live mode without a terminal.
struct LiveSuite {
  std::vector<SuiteScene> scenes;
  std::vector<std::string> encoders;
  GridSize grid{120, 40};
  int frames = 120;
};

struct Suite {
  std::string name;
  std::string description;
  int repeat = 10;  ///< Timed rounds.
  std::vector<SuiteMatrix> matrices;
  std::optional<TemporalSuite> temporal;
  std::optional<LiveSuite> live;
};

/// What `exclude` may name.
const std::vector<std::string>& ExcludeKeys();

/// A number as exclude rules compare it: the shortest text that reads back.
std::string NumberText(double number);

/// Reads a suite. Scenes are names of `folders`, or files relative to the
/// suite's; encoders are checked, and may be missing here.
/// @param file names the text in errors.
/// @return an Error whose place is `file:line:column`.
Result<Suite> ParseSuite(const std::string& text,
                         const std::filesystem::path& file,
                         const DataFolders& folders);

}  // namespace rtb
