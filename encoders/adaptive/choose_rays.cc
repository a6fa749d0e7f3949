#include "encoders/adaptive/choose_rays.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"

namespace rtb {
namespace {

/// Cells that a thread takes at once.
constexpr int kGrain = 480;

/// A turn ends with the cell that would be the last one if so many 16ths of the
/// rays went to a cell each.
constexpr std::array<int, kTurns> kTurnEnds = {3, 5, 9, 16};

}  // namespace

RayChooser::RayChooser(const VoronoiMap& map, const SeenSamples& samples)
    : map_(map), samples_(samples) {
  const int cells = samples.grid().cells();
  for (int begin = 0; begin < cells; begin += kGrain) {
    FoundRays& part = parts_.emplace_back();
    part.begin = begin;
    part.end = std::min(begin + kGrain, cells);
  }
}

std::vector<RayChoice> RayChooser::Choose(const RayRequest& request) {
  if (request.rays <= 0) return {};
  CountGains();
  const TurnEnds ends = EndsOf(request.rays);
  FindCells(ends);
  // That many cells have a ray that gains this much: none below is wanted.
  least_ = ends.back();
  float below = std::numeric_limits<float>::infinity();
  for (std::size_t turn = 0; turn < kTurns && below > least_; ++turn) {
    FindRays(turn, request);
    RaiseLeast(request.rays);
    below = ends[turn];
  }
  return TakeBest(parts_, request.rays, threshold_);
}

/// Of each cell's first ray.
void RayChooser::CountGains() {
  threshold_ = {};
  for (int cell = 0; cell < samples_.grid().cells(); ++cell) {
    threshold_.Add(Gain(cell), samples_.count(cell) < kMostPerCell);
  }
}

RayChooser::TurnEnds RayChooser::EndsOf(int rays) const {
  TurnEnds ends;
  std::ranges::transform(kTurnEnds, ends.begin(), [&](int part) {
    return threshold_.Of(static_cast<int>(std::int64_t{rays} * part / 16)).from;
  });
  return ends;
}

void RayChooser::FindCells(const TurnEnds& ends) {
  for (FoundRays& part : parts_) {
    part.count = part.known = 0;
    FindCells(ends, part);
  }
}

/// Which cells' turn it is when.
void RayChooser::FindCells(const TurnEnds& ends, FoundRays& part) const {
  std::array<int, kGrain + 1> cells;  // One to write past them.
  std::size_t count = 0;
  for (int cell = part.begin; cell < part.end; ++cell) {
    cells[count] = cell;
    // Without a branch, which would be a guess.
    count += static_cast<std::size_t>((Gain(cell) >= ends.back()) &
                                      (samples_.count(cell) < kMostPerCell));
  }
  for (std::vector<int>& turn : part.cells) turn.clear();
  for (const int cell : std::span(cells).first(count)) {
    std::size_t turn = 0;
    for (const float end : ends) turn += Gain(cell) < end ? 1 : 0;
    part.cells[turn].push_back(cell);
  }
}

void RayChooser::FindRays(std::size_t turn, const RayRequest& request) {
  ParallelFor(static_cast<int>(parts_.size()), 1, request.threads,
              [&](int begin, int end) {
                for (int i = begin; i < end; ++i) {
                  FindIn(turn, request, parts_[static_cast<std::size_t>(i)]);
                }
              });
}

void RayChooser::FindIn(std::size_t turn, const RayRequest& request,
                        FoundRays& part) const {
  std::array<int, kCellsAtOnce> cells;
  std::size_t count = 0;
  for (const int cell : part.cells[turn]) {
    cells[count] = cell;
    // Without a branch, which would be a guess.
    count += static_cast<std::size_t>(Gain(cell) >= least_);
    if (count < kCellsAtOnce) continue;
    FindIn(cells, request, part);
    count = 0;
  }
  if (count > 0) FindIn(std::span(cells).first(count), request, part);
}

/// @param cells kCellsAtOnce at most.
void RayChooser::FindIn(std::span<const int> cells, const RayRequest& request,
                        FoundRays& part) const {
  std::array<CellChoice, kCellsAtOnce> choices;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int seen = samples_.count(cells[i]);
    choices[i] = {&map_.Slots(cells[i]), cells[i], seen,
                  std::min(request.most_per_cell, kMostPerCell - seen)};
  }
  const auto room = static_cast<std::size_t>(request.most_per_cell);
  part.scratch.resize(room * kCellsAtOnce);
  std::array<int, kCellsAtOnce> counts;
  ChooseInCells(std::span(choices).first(cells.size()),
                {map_.cell_width(), least_, request.seed}, room,
                part.scratch.data(), counts.data());
  part.Add(room, std::span(counts).first(cells.size()));
}

/// A cell's best gain has been counted already.
void RayChooser::RaiseLeast(int rays) {
  for (FoundRays& part : parts_) {
    int before = -1;
    for (; part.known < part.count; ++part.known) {
      const RayChoice& ray = part.rays[part.known];
      threshold_.Add(ray.gain, ray.cell == before);
      before = ray.cell;
    }
  }
  least_ = threshold_.Of(rays).from;
}

}  // namespace rtb
