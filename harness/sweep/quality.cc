/// @file
/// A quality unit: one encoder, drawn once and scored.
#include <algorithm>

#include "core/base/file.h"
#include "core/base/gzip.h"
#include "core/image/io.h"
#include "core/image/resample.h"
#include "encoders/emit/emit.h"
#include "harness/bench_rounds.h"
#include "harness/sweep/outcome.h"

namespace rtb {
namespace {

constexpr int kReferenceQuality = 90;  ///< JPEG's 1..100.
constexpr int kMapQuality = 50;
constexpr std::size_t kHashDigits = 16;

/// The reference as displayed, under a name that hashes what it shows.
Result<UnitFile> ReferenceFile(const Image& displayed) {
  RTB_ASSIGN_OR_RETURN(std::string bytes,
                       EncodeJpeg(displayed, kReferenceQuality));
  const std::string hash = Sha256(bytes).substr(0, kHashDigits);
  return UnitFile{"reference-" + hash + ".jpg", std::move(bytes)};
}

/// The FLIP map at half its size: the eye is not to find pixels in it.
Result<UnitFile> MapFile(const std::string& stem, const Image& map) {
  const Image half = ResizeArea(map, std::max(map.width() / 2, 1),
                                std::max(map.height() / 2, 1));
  RTB_ASSIGN_OR_RETURN(std::string bytes, EncodeJpeg(half, kMapQuality));
  return UnitFile{stem + ".flip.jpg", std::move(bytes)};
}

/// The grid, the map and the reference of the unit's one run.
Status AddPictures(const SweepUnit& unit, const BenchResult& result,
                   UnitOutcome& outcome) {
  const std::string stem = unit.Name() + ".0";
  const BenchPicture& picture = result.pictures.front();
  UnitFile cells{stem + ".cells.json.gz", Gzip(EmitJson(picture.grid))};
  RTB_ASSIGN_OR_RETURN(UnitFile map, MapFile(stem, picture.flip));
  RTB_ASSIGN_OR_RETURN(UnitFile reference, ReferenceFile(result.reference));
  outcome.record.runs.front().pictures = {cells.name, map.name, reference.name};
  outcome.files = {std::move(reference), std::move(map), std::move(cells)};
  return {};
}

}  // namespace

Status RunQuality(const SweepUnit& unit, Workbench& bench,
                  UnitOutcome& outcome) {
  RTB_ASSIGN_OR_RETURN(const EncoderSpec spec,
                       ParseEncoderSpec(unit.configuration.encoders.front()));
  std::vector<Configuration> one(1);
  RTB_ASSIGN_OR_RETURN(one.front(), MakeConfiguration(spec));
  RTB_ASSIGN_OR_RETURN(const BenchStage stage, bench.Stage(unit));
  outcome.notes = stage.reference.notes;
  BenchRequest request = RequestOf(unit, bench.threads());
  request.decompose = true;
  request.flip_maps = unit.pictures;
  RTB_ASSIGN_OR_RETURN(
      BenchResult result,
      Bench(
          request, stage, [](double, const std::string&) {}, one));
  RunRecord& record = outcome.record;
  record.manifest = std::move(result.record.manifest);
  record.runs = std::move(result.record.runs);
  if (!unit.pictures) return {};
  return AddPictures(unit, result, outcome);
}

}  // namespace rtb
