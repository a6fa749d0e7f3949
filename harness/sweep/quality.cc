/// @file
/// A quality unit: one encoder, drawn once and scored.
#include <algorithm>

#include "core/base/file.h"
#include "core/base/gzip.h"
#include "core/image/io.h"
#include "core/image/resample.h"
#include "encoders/emit/emit.h"
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
  RTB_ASSIGN_OR_RETURN(Contestant contestant, MakeContestant(spec));
  RTB_ASSIGN_OR_RETURN(const ReferencePicture* const reference,
                       bench.Reference(unit));
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, bench.Scene(unit));
  outcome.notes = reference->notes;
  const BenchRequest request = RequestOf(unit, bench.threads());
  RTB_RETURN_IF_ERROR(RunContestant(TaskOf(request), *scene,
                                    /*warm_up=*/true, contestant));
  BenchResult result;
  result.reference = reference->display;
  RTB_RETURN_IF_ERROR(ScoreContestant(request, *scene, contestant, result));
  RunRecord& record = outcome.record;
  RTB_ASSIGN_OR_RETURN(
      record.manifest,
      MakeManifest(request, *scene, *reference, result.pictures));
  record.runs = std::move(result.record.runs);
  if (!unit.pictures) return {};
  return AddPictures(unit, result, outcome);
}

}  // namespace rtb
