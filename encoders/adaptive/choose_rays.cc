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

/// A turn ends with the cell that would be the last one if so many 16ths of the
/// rays went to a cell each.
constexpr std::array<int, kTurns> kTurnEnds = {3, 5, 9, 16};

/// The choice of one round.
class Chooser {
 public:
  Chooser(const VoronoiMap& map, const SeenSamples& samples,
          const RayRequest& request)
      : map_(map), samples_(samples), request_(request) {
    const int cells = samples.grid().cells();
    for (int cell = 0; cell < cells; ++cell) {
      threshold_.Add(Gain(cell), samples.count(cell) < kMostPerCell);
    }
    parts_.resize(static_cast<std::size_t>((cells + kGrain - 1) / kGrain));
  }

  std::vector<RayChoice> Choose() {
    std::array<float, kTurns> ends;
    std::ranges::transform(kTurnEnds, ends.begin(), [this](int part) {
      const std::int64_t rays = std::int64_t{request_.rays} * part / 16;
      return threshold_.Of(static_cast<int>(rays)).from;
    });
    FindCells(ends);
    // That many cells have a ray that gains this much: none below is wanted.
    least_ = ends.back();
    float below = std::numeric_limits<float>::infinity();
    for (std::size_t turn = 0; turn < kTurns && below > least_; ++turn) {
      FindRays(turn);
      RaiseLeast();
      below = ends[turn];
    }
    return TakeBest(parts_, request_.rays, threshold_);
  }

 private:
  float Gain(int cell) const {
    return map_.best_gains()[static_cast<std::size_t>(cell)];
  }

  /// Which cells' turn it is when.
  /// @param ends the least gains of the turns, which fall.
  void FindCells(const std::array<float, kTurns>& ends) {
    const int cells = samples_.grid().cells();
    for (int begin = 0; begin < cells; begin += kGrain) {
      FoundRays& part = parts_[static_cast<std::size_t>(begin / kGrain)];
      part.begin = begin;
      part.end = std::min(begin + kGrain, cells);
      // One turn more, of which nothing comes.
      std::array<std::array<int, kGrain>, kTurns + 1> found;
      std::array<std::size_t, kTurns + 1> counts{};
      const std::array<int, kGrain> turns = TurnsOf(part, ends);
      for (int cell = begin; cell < part.end; ++cell) {
        const auto turn = static_cast<std::size_t>(
            turns[static_cast<std::size_t>(cell - begin)]);
        found[turn][counts[turn]++] = cell;
      }
      for (std::size_t turn = 0; turn < kTurns; ++turn) {
        const auto first = found[turn].begin();
        part.cells[turn].assign(
            first, first + static_cast<std::ptrdiff_t>(counts[turn]));
      }
    }
  }

  /// The turn of each cell. A loop of its own, which compilers turn into
  /// vectors.
  std::array<int, kGrain> TurnsOf(const FoundRays& part,
                                  const std::array<float, kTurns>& ends) const {
    std::array<int, kGrain> turns;
    const float* const gains = map_.best_gains().data() + part.begin;
    const int* const counts = samples_.counts().data() + part.begin;
    for (int i = 0; i < part.end - part.begin; ++i) {
      int turn = 0;
      for (const float end : ends) turn += gains[i] < end ? 1 : 0;
      turns[static_cast<std::size_t>(i)] =
          counts[i] < kMostPerCell ? turn : static_cast<int>(kTurns);
    }
    return turns;
  }

  void FindRays(std::size_t turn) {
    ParallelFor(static_cast<int>(parts_.size()), 1, request_.threads,
                [&](int begin, int end) {
                  for (int i = begin; i < end; ++i) {
                    FindIn(parts_[static_cast<std::size_t>(i)], turn);
                  }
                });
  }

  void FindIn(FoundRays& part, std::size_t turn) const {
    std::array<int, kCellsAtOnce> cells;
    std::size_t count = 0;
    for (const int cell : part.cells[turn]) {
      cells[count] = cell;
      // Without a branch, which would be a guess.
      count += static_cast<std::size_t>(Gain(cell) >= least_);
      if (count < kCellsAtOnce) continue;
      FindIn(cells, part);
      count = 0;
    }
    if (count > 0) FindIn(std::span(cells).first(count), part);
  }

  /// @param cells kCellsAtOnce at most.
  void FindIn(std::span<const int> cells, FoundRays& part) const {
    std::array<CellChoice, kCellsAtOnce> choices;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const int seen = samples_.count(cells[i]);
      choices[i] = {&map_.Slots(cells[i]), cells[i], seen,
                    std::min(request_.most_per_cell, kMostPerCell - seen)};
    }
    const auto room = static_cast<std::size_t>(request_.most_per_cell);
    part.room.resize(room * kCellsAtOnce);
    std::array<int, kCellsAtOnce> counts;
    ChooseInCells(std::span(choices).first(cells.size()),
                  {map_.cell_width(), least_, request_.seed}, room,
                  part.room.data(), counts.data());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto first =
          part.room.begin() + static_cast<std::ptrdiff_t>(i * room);
      part.rays.insert(part.rays.end(), first, first + counts[i]);
    }
  }

  /// A cell's best gain has been counted already.
  void RaiseLeast() {
    for (FoundRays& part : parts_) {
      int before = -1;
      for (; part.known < part.rays.size(); ++part.known) {
        const RayChoice& ray = part.rays[part.known];
        threshold_.Add(ray.gain, ray.cell == before);
        before = ray.cell;
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
