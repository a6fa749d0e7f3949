#include "harness/sweep/expand.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "encoders/parameters.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

/// The name in a SPEC.
std::string NameIn(const std::string& spec) {
  return spec.substr(0, spec.find(':'));
}

/// Whether a rule leaves out `encoder` in a unit of that configuration.
bool Holds(const ExcludeRule& rule, UnitKind kind, const UnitConfiguration& c,
           const std::string& encoder) {
  const std::map<std::string, std::string> texts = {
      {"kind", NameOf(kind)},
      {"scene", c.scene},
      {"time", NumberText(c.time)},
      {"grid", GridText(c.grid)},
      {"spp", std::to_string(c.spp)},
      {"backend", c.backend},
      {"integrator", c.integrator},
      {"color", c.color},
      {"reference", c.reference.empty() ? "auto" : c.reference}};
  return std::ranges::all_of(rule, [&](const auto& entry) {
    const auto& [key, values] = entry;
    const auto has = [&values](const std::string& text) {
      return std::ranges::find(values, text) != values.end();
    };
    if (key == "encoder") return has(encoder) || has(NameIn(encoder));
    return has(texts.at(key));
  });
}

/// Gathers units, each configuration once.
class UnitList {
 public:
  void Add(SweepUnit unit) {
    if (unit.configuration.encoders.empty()) return;
    const auto key = ConfigurationKey(unit.kind, unit.configuration);
    if (known_.insert(key).second) units_.push_back(std::move(unit));
  }
  std::vector<SweepUnit> Take() { return std::move(units_); }

 private:
  std::set<std::string> known_;
  std::vector<SweepUnit> units_;
};

/// The units of one matrix.
class Product {
 public:
  Product(const Suite& suite, const SuiteMatrix& matrix, UnitList& units)
      : suite_(suite), matrix_(matrix), units_(units) {}

  void Add() {
    for (const SuiteScene& scene : matrix_.scenes) {
      unit_.configuration.scene = scene.name;
      unit_.scene_file = scene.file;
      for (const std::string& backend : matrix_.backends) {
        unit_.configuration.backend = backend;
        for (const std::string& integrator : matrix_.integrators) {
          unit_.configuration.integrator = integrator;
          AddTimes();
        }
      }
    }
  }

 private:
  void AddTimes() {
    for (const double time : matrix_.times) {
      unit_.configuration.time = time;
      for (const GridSize grid : matrix_.grids) {
        unit_.configuration.grid = grid;
        for (const int spp : matrix_.spp) {
          unit_.configuration.spp = spp;
          for (const ColorDepth depth : matrix_.colors) {
            unit_.depth = depth;
            unit_.configuration.color = NameOf(depth);
            AddKinds();
          }
        }
      }
    }
  }

  void AddKinds() {
    for (const UnitKind kind : matrix_.kinds) {
      unit_.kind = kind;
      kind == UnitKind::kTiming ? AddTiming() : AddQuality();
    }
  }

  bool Excluded(const std::string& encoder) const {
    return std::ranges::any_of(matrix_.exclude, [&](const ExcludeRule& rule) {
      return Holds(rule, unit_.kind, unit_.configuration, encoder);
    });
  }

  void AddTiming() {
    SweepUnit unit = unit_;
    unit.repeat = suite_.repeat;
    unit.configuration.seed = matrix_.seeds.front();
    for (const std::string& encoder : matrix_.encoders) {
      if (!Excluded(encoder)) unit.configuration.encoders.push_back(encoder);
    }
    units_.Add(std::move(unit));
  }

  void AddQuality() {
    for (const std::string& reference : matrix_.references) {
      const bool choose = reference == "auto";
      unit_.configuration.reference = choose ? "" : reference;
      unit_.reference = matrix_.reference_files.contains(reference)
                            ? matrix_.reference_files.at(reference).string()
                            : unit_.configuration.reference;
      for (const std::string& encoder : matrix_.encoders) {
        if (!Excluded(encoder)) AddSeeds(encoder);
      }
    }
    unit_.configuration.reference.clear();
  }

  void AddSeeds(const std::string& encoder) {
    SweepUnit unit = unit_;
    unit.configuration.encoders = {encoder};
    const bool random = DependsOnSeed(encoder, unit.configuration.spp,
                                      unit.configuration.integrator);
    const std::size_t count = random ? matrix_.seeds.size() : 1;
    for (std::size_t i = 0; i < count; ++i) {
      unit.configuration.seed = matrix_.seeds[i];
      // One picture shows what an encoder does as well as five.
      unit.pictures = matrix_.pictures && i == 0;
      units_.Add(unit);
    }
  }

  const Suite& suite_;
  const SuiteMatrix& matrix_;
  UnitList& units_;
  SweepUnit unit_;  ///< What the loops have chosen so far.
};

/// One unit for each scene and encoder of `temporal` or `live`.
/// @param rest of the unit, where these two differ.
template <class Part>
void AddMoving(const Part& part, const SweepUnit& rest, UnitList& units) {
  for (const SuiteScene& scene : part.scenes) {
    for (const std::string& encoder : part.encoders) {
      SweepUnit unit = rest;
      unit.configuration.scene = scene.name;
      unit.configuration.grid = part.grid;
      unit.configuration.backend = "embree";
      unit.configuration.integrator = "whitted";
      unit.configuration.color = NameOf(unit.depth);
      unit.configuration.encoders = {encoder};
      unit.scene_file = scene.file;
      unit.frames = part.frames;
      units.Add(std::move(unit));
    }
  }
}

/// Puts timed units last and the units of a scene together.
void Sort(std::vector<SweepUnit>& units) {
  std::map<std::string, std::size_t> scenes;  // Position of first appearance.
  for (const SweepUnit& unit : units) {
    scenes.emplace(unit.configuration.scene, scenes.size());
  }
  const auto rank = [&scenes](const SweepUnit& unit) {
    return std::tuple(
        IsTimed(unit.kind) ? 1 : 0, unit.kind == UnitKind::kLive ? 1 : 0,
        scenes.at(unit.configuration.scene), unit.configuration.backend);
  };
  std::ranges::stable_sort(units, {}, rank);
}

}  // namespace

bool DependsOnSeed(const std::string& encoder, int spp,
                   const std::string& integrator) {
  if (spp > 1 || integrator == "path") return true;
  const auto spec = ParseEncoderSpec(encoder);
  if (!spec) return false;
  const auto given = [&spec](const std::string& key) {
    const auto found = spec->parameters.find(key);
    return found == spec->parameters.end() ? std::string() : found->second;
  };
  if (given("dither") == "noise") return true;
  const std::string& key = SeedParameter().name;
  const auto entry = std::ranges::find(
      EncoderEntries(), spec->name,
      [](const EncoderEntry& candidate) { return candidate.info.name; });
  const bool takes_seed =
      std::ranges::find(entry->info.parameters, key, &EncoderParameter::name) !=
      entry->info.parameters.end();
  return takes_seed && given(key).empty();
}

std::vector<SweepUnit> Expand(const Suite& suite) {
  UnitList units;
  for (const SuiteMatrix& matrix : suite.matrices) {
    Product(suite, matrix, units).Add();
  }
  if (suite.temporal) {
    SweepUnit unit;
    unit.kind = UnitKind::kTemporal;
    unit.configuration.spp = suite.temporal->spp;
    unit.fps = suite.temporal->fps;
    AddMoving(*suite.temporal, unit, units);
  }
  if (suite.live) {
    SweepUnit unit;
    unit.kind = UnitKind::kLive;
    AddMoving(*suite.live, unit, units);
  }
  std::vector<SweepUnit> list = units.Take();
  Sort(list);
  return list;
}

}  // namespace rtb
