/// @file
/// SweepUnit: the smallest piece of a sweep's work, and what names it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "encoders/color_depth.h"
#include "harness/results/unit.h"

namespace rtb {

enum class UnitKind {
  kQuality,   ///< One encoder drawn once and scored; no times.
  kTemporal,  ///< One encoder on the frames of a moving scene.
  kTiming,    ///< All encoders of a scene and grid in turns; no scores.
  kLive,      ///< One encoder in the live mode without a terminal.
};

/// `quality`, `temporal`, `timing` or `live`.
std::string NameOf(UnitKind kind);

/// The kind of that name.
std::optional<UnitKind> FindUnitKind(std::string_view name);

/// Whether its times count: such units run alone, after all others.
constexpr bool IsTimed(UnitKind kind) {
  return kind == UnitKind::kTiming || kind == UnitKind::kLive;
}

/// One unit. Its configuration is in the words of the suite: no machine and no
/// file's content has a part in it.
struct SweepUnit {
  UnitKind kind = UnitKind::kQuality;
  UnitConfiguration configuration;
  ColorDepth depth = ColorDepth::kTruecolor;  ///< The configuration's color.
  int repeat = 0;                             ///< Timed rounds (kTiming).
  int frames = 0;                             ///< kTemporal and kLive.
  double fps = 0;                             ///< kTemporal.
  std::filesystem::path scene_file;
  std::string reference;  ///< As ChooseReference takes it.
  bool pictures = false;  ///< Whether its grid and maps are kept.
  std::string hash = {};  ///< Of all that it depends on; see identity.h.

  /// `quality-0123456789abcdef`: its name in the sweep's folder.
  std::string Name() const { return NameOf(kind) + "-" + hash; }
};

/// Text that two units share when suites call them the same work.
std::string ConfigurationKey(UnitKind kind,
                             const UnitConfiguration& configuration);

/// What a unit is, as one short line for people.
std::string Describe(const SweepUnit& unit);

/// `120x40`.
std::string GridText(GridSize grid);

}  // namespace rtb
