#include "harness/sweep/outcome.h"

#include <exception>

namespace rtb {
namespace {

/// What is known of the settings before the scene is.
RunSettings SettingsOf(const SweepUnit& unit) {
  const UnitConfiguration& c = unit.configuration;
  RunSettings settings;
  settings.backend = c.backend;
  settings.integrator = c.integrator;
  settings.spp = c.spp;
  settings.seed = c.seed;
  settings.time = c.time;
  settings.reference = c.reference;
  settings.color = c.color;
  return settings;
}

Status RunKind(const SweepUnit& unit, Workbench& bench,
               const UnitProgress& progress, UnitOutcome& outcome) try {
  switch (unit.kind) {
    case UnitKind::kQuality:
      return RunQuality(unit, bench, outcome);
    case UnitKind::kTiming:
      return RunTiming(unit, bench, progress, outcome);
    case UnitKind::kTemporal:
      return RunTemporal(unit, bench, progress, outcome);
    case UnitKind::kLive:
      return RunLive(unit, bench, outcome);
  }
  RTB_CHECK(false);
} catch (const std::exception& error) {
  // Of the standard library: no memory, above all.
  return Fail(Failure(unit.configuration.scene, error.what()));
}

}  // namespace

RunFailure ToFailure(const Error& error, const std::string& encoder) {
  const bool missing = error.kind == ErrorKind::kMissing;
  return {missing ? "skipped" : "failed", encoder, error.place, error.what,
          error.hint};
}

UnitOutcome RunUnit(const SweepUnit& unit, const std::string& suite,
                    Workbench& bench, const UnitProgress& progress) {
  UnitOutcome outcome;
  RunRecord& record = outcome.record;
  record.manifest.build = GetBuildInfo();
  record.manifest.settings = SettingsOf(unit);
  record.unit = {NameOf(unit.kind), suite, unit.hash, unit.configuration};
  const Status status = RunKind(unit, bench, progress, outcome);
  if (status) return outcome;
  record.runs.clear();
  outcome.files.clear();
  const auto& encoders = unit.configuration.encoders;
  record.failure =
      ToFailure(status.error(), encoders.size() == 1 ? encoders.front() : "");
  return outcome;
}

}  // namespace rtb
