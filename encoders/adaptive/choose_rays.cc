#include "encoders/adaptive/choose_rays.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/base/parallel.h"
#include "encoders/adaptive/found_rays.h"

namespace rtb {
namespace {

/// Cells that a thread takes at once.
constexpr int kGrain = 480;

/// Cells so much later are fetched from memory already.
constexpr std::size_t kAhead = 4;

/// Cells take turns, those of the largest gains first: these want many rays,
/// and from what they gain follows how little is too little for others. A turn
/// ends with the cell that would be the last one if so many 16ths of the rays
/// went to a cell each.
constexpr std::array<int, 7> kTurns = {2, 3, 4, 5, 7, 10, 16};

/// The choice of one round.
class Chooser {
 public:
  Chooser(const VoronoiMap& map, const SeenSamples& samples,
          const RayRequest& request)
      : map_(map), samples_(samples), request_(request) {
    const int cells = samples.grid().cells();
    parts_.resize(static_cast<std::size_t>((cells + kGrain - 1) / kGrain));
    for (int cell = 0; cell < cells; ++cell) {
      if (samples.count(cell) == kMostPerCell) continue;
      threshold_.Add(map.best_gains()[static_cast<std::size_t>(cell)]);
    }
  }

  std::vector<RayChoice> Choose() {
    std::array<float, kTurns.size()> ends;
    std::ranges::transform(kTurns, ends.begin(), [this](int part) {
      const std::int64_t rays = std::int64_t{request_.rays} * part / 16;
      return threshold_.Of(static_cast<int>(rays)).from;
    });
    // That many cells have a ray that gains this much: none below is wanted.
    least_ = ends.back();
    float below = std::numeric_limits<float>::infinity();
    for (const float end : ends) {
      const float from = std::min(below, std::max(end, least_));
      if (from == below) continue;
      FindRays(from, below);
      below = from;
      RaiseLeast();
    }
    return TakeBest(parts_, request_.rays, threshold_);
  }

 private:
  /// In all cells whose best gain is in [from, below).
  void FindRays(float from, float below) {
    ParallelFor(samples_.grid().cells(), kGrain, request_.threads,
                [&](int begin, int end) {
                  FindIn(CellsOf(begin, end, from, below), begin,
                         parts_[static_cast<std::size_t>(begin / kGrain)]);
                });
  }

  /// Some cells, by rising numbers.
  struct Cells {
    std::array<int, kGrain> cells;
    std::size_t count = 0;
  };
  Cells CellsOf(int begin, int end, float from, float below) const {
    Cells found;
    for (int cell = begin; cell < end; ++cell) {
      const float gain = map_.best_gains()[static_cast<std::size_t>(cell)];
      found.cells[found.count] = cell;
      // Without a branch, which would be a guess.
      found.count += static_cast<std::size_t>((gain >= from) & (gain < below));
    }
    return found;
  }

  void FindIn(const Cells& cells, int begin, FoundRays& part) const {
    part.at.resize(kGrain);
    part.counts.resize(kGrain);
    std::array<RayChoice, kMostPerCell> found;
    for (std::size_t i = 0; i < cells.count; ++i) {
      map_.Prefetch(cells.cells[std::min(i + kAhead, cells.count - 1)]);
      const int cell = cells.cells[i];
      CellChoice choice = map_.ChoiceIn(cell);
      choice.seen = samples_.count(cell);
      choice.most =
          std::min(request_.most_per_cell, kMostPerCell - choice.seen);
      choice.least = least_;
      choice.seed = request_.seed;
      const int count = ChooseInCell(choice, found.data());
      const auto place = static_cast<std::size_t>(cell - begin);
      part.at[place] = static_cast<std::uint32_t>(part.rays.size());
      part.counts[place] = static_cast<std::uint8_t>(count);
      part.rays.insert(part.rays.end(), found.begin(), found.begin() + count);
    }
  }

  /// A cell's best gain has been counted already.
  void RaiseLeast() {
    for (FoundRays& part : parts_) {
      for (; part.known < part.rays.size(); ++part.known) {
        if (part.IsLater(part.known, 1)) {
          threshold_.Add(part.rays[part.known].gain);
        }
      }
    }
    least_ = threshold_.Of(request_.rays).from;
  }

  const VoronoiMap& map_;
  const SeenSamples& samples_;
  const RayRequest& request_;
  GainThreshold threshold_;
  float least_ = 0;
  std::vector<FoundRays> parts_;
};

}  // namespace

std::vector<RayChoice> ChooseRays(const VoronoiMap& map,
                                  const SeenSamples& samples,
                                  const RayRequest& request) {
  if (request.rays <= 0) return {};
  return Chooser(map, samples, request).Choose();
}

}  // namespace rtb
