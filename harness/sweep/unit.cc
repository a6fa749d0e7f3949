#include "harness/sweep/unit.h"

#include <array>
#include <utility>

#include "harness/results/unit_json.h"
#include "harness/sweep/suite.h"

namespace rtb {
namespace {

constexpr std::array<std::pair<UnitKind, const char*>, 4> kNames = {{
    {UnitKind::kQuality, "quality"},
    {UnitKind::kTemporal, "temporal"},
    {UnitKind::kTiming, "timing"},
    {UnitKind::kLive, "live"},
}};

}  // namespace

std::string NameOf(UnitKind kind) {
  return kNames[static_cast<std::size_t>(kind)].second;
}

std::optional<UnitKind> FindUnitKind(std::string_view name) {
  for (const auto& [kind, text] : kNames) {
    if (name == text) return kind;
  }
  return std::nullopt;
}

std::string GridText(GridSize grid) {
  return std::to_string(grid.columns) + "x" + std::to_string(grid.rows);
}

std::string ConfigurationKey(UnitKind kind,
                             const UnitConfiguration& configuration) {
  return ToJson(Unit{NameOf(kind), "", "", configuration})
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string Describe(const SweepUnit& unit) {
  const UnitConfiguration& c = unit.configuration;
  std::string text = NameOf(unit.kind) + " " + c.scene;
  if (c.time != 0) text += " t=" + NumberText(c.time);
  text += " " + GridText(c.grid);
  if (c.spp != 1) text += " spp=" + std::to_string(c.spp);
  if (c.backend != "embree") text += " " + c.backend;
  if (c.integrator != "whitted") text += " " + c.integrator;
  if (c.color != NameOf(ColorDepth::kTruecolor)) text += " color=" + c.color;
  if (!c.reference.empty()) text += " against " + c.reference;
  if (c.seed != 0) text += " seed=" + std::to_string(c.seed);
  if (c.encoders.size() == 1) return text + " " + c.encoders.front();
  return text + " " + std::to_string(c.encoders.size()) + " encoders";
}

}  // namespace rtb
