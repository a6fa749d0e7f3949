#include "harness/live/sample_store.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"

namespace rtb {
namespace {

constexpr int kCellsPerTask = 256;

/// Squared distance in the cell's unit square, its borders joined.
float Distance(const V2f& a, const V2f& b) {
  float dx = std::abs(a.x - b.x);
  float dy = std::abs(a.y - b.y);
  dx = std::min(dx, 1 - dx);
  dy = std::min(dy, 1 - dy);
  return dx * dx + dy * dy;
}

/// For each position its turn: every next one is as far as can be from those
/// before it, so that any first few of them cover the cell. Gonzalez,
/// "Clustering to minimize the maximum intercluster distance", 1985.
std::vector<int> FarthestFirst(const std::vector<V2f>& positions) {
  const std::size_t count = positions.size();
  std::vector<int> order(count, 0);
  std::vector<float> nearest(count, std::numeric_limits<float>::max());
  std::size_t next = 0;
  for (std::size_t turn = 0; turn < count; ++turn) {
    order[next] = static_cast<int>(turn);
    nearest[next] = -1;  // Taken.
    for (std::size_t i = 0; i < count; ++i) {
      const float distance = Distance(positions[i], positions[next]);
      nearest[i] = std::min(nearest[i], distance);
    }
    next = static_cast<std::size_t>(
        std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  }
  return order;
}

/// Point `index` of the R2 sequence around (0, 0), within half a unit.
/// Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
V2f Spread(int index) {
  constexpr double kX = 0.7548776662466927;
  constexpr double kY = 0.5698402909980532;
  const auto centered = [index](double step) {
    const double value = 0.5 + step * index;
    return static_cast<float>(value - std::floor(value) - 0.5);
  };
  return {centered(kX), centered(kY)};
}

}  // namespace

void SampleStore::BeginFrame(Tracer tracer, int epoch, double share,
                             int threads) {
  tracer_ = std::move(tracer);
  threads_ = threads;
  epoch_ = epoch;
  share_ = share;
  asked_ = false;
  traced_ = 0;
}

Result<Fragments> SampleStore::Query(const SamplePlan& plan) {
  if (asked_ || !plan.cells.empty()) {
    traced_ += plan.samples();
    return tracer_(plan, 0);
  }
  asked_ = true;
  if (kept_epoch_ != epoch_ || !Fits(plan)) Reset(plan);
  if (least_rays() >= kMostRays) return Means();
  const bool whole = share_ >= 1;
  const SamplePlan pass = whole ? WholePass() : PartialPass();
  traced_ += pass.samples();
  RTB_ASSIGN_OR_RETURN(const Fragments fragments, tracer_(pass, pass_));
  ++pass_;
  Add(fragments, whole);
  return Means();
}

int SampleStore::least_rays() const {
  if (kept_epoch_ != epoch_ || rays_.empty()) return 0;
  return *std::min_element(rays_.begin(), rays_.end());
}

bool SampleStore::Fits(const SamplePlan& plan) const {
  return plan.grid == plan_.grid && plan.cell_aspect == plan_.cell_aspect &&
         plan.samples_per_cell == plan_.samples_per_cell &&
         plan.footprint == plan_.footprint && plan.positions == plan_.positions;
}

void SampleStore::Reset(const SamplePlan& plan) {
  if (!Fits(plan)) {
    plan_ = plan;
    order_.resize(static_cast<std::size_t>(plan.samples_per_cell));
    std::iota(order_.begin(), order_.end(), 0);
    if (plan.uniform()) order_ = FarthestFirst(plan.positions);
  }
  turn_ = 0;  // The same positions in each frame of a moving view: no flicker.
  kept_epoch_ = epoch_;
  pass_ = 0;
  sums_.assign(plan.samples(), Rgb(0));
  rays_.assign(plan.samples(), 0);
  variances_.clear();
}

V2f SampleStore::JitteredPosition(int entry, int sample, int rays) const {
  const V2f position = plan_.position(entry, sample);
  return rays == 0 ? position : position + Spread(rays) * plan_.footprint;
}

SamplePlan SampleStore::WholePass() const {
  SamplePlan pass = plan_;
  if (pass_ > 0) {
    const V2f offset = Spread(pass_) * plan_.footprint;
    for (V2f& position : pass.positions) position += offset;
  }
  return pass;
}

int SampleStore::TurnOf(int cell, int sample) const {
  const int column = cell % plan_.grid.columns;
  const int row = cell / plan_.grid.columns;
  constexpr int kBlock[] = {0, 2, 3, 1};  // Neighbors are far apart in time.
  const int place = (column & 1) + 2 * (row & 1);
  return 4 * order_[static_cast<std::size_t>(sample)] + kBlock[place];
}

SamplePlan SampleStore::PartialPass() {
  // Any four turns in a row reach every cell; a single row or column lacks
  // half of them.
  const int least = plan_.grid.columns > 1 && plan_.grid.rows > 1 ? 1 : 4;
  const int count = std::clamp(static_cast<int>(std::lround(share_ * turns())),
                               least, turns());
  SamplePlan pass;
  pass.grid = plan_.grid;
  pass.cell_aspect = plan_.cell_aspect;
  pass.samples_per_cell = 1;
  pass.footprint = plan_.footprint;
  picked_.clear();
  for (int cell = 0; cell < plan_.grid.cells(); ++cell) {
    for (int s = 0; s < plan_.samples_per_cell; ++s) {
      const int since = (TurnOf(cell, s) - turn_ + turns()) % turns();
      if (since >= count) continue;
      const auto at =
          static_cast<std::size_t>(cell * plan_.samples_per_cell + s);
      picked_.push_back(at);
      pass.cells.push_back(cell);
      pass.samples_before.push_back(s);
      pass.positions.push_back(JitteredPosition(cell, s, rays_[at]));
    }
  }
  turn_ = (turn_ + count) % turns();
  return pass;
}

void SampleStore::Add(const Fragments& fragments, bool whole) {
  const bool noisy = !fragments.variances.empty();
  if (noisy && variances_.empty()) variances_.assign(sums_.size(), 0);
  for (std::size_t i = 0; i < fragments.values.size(); ++i) {
    const std::size_t at = whole ? i : picked_[i];
    sums_[at] += fragments.values[i];
    ++rays_[at];
    if (noisy) variances_[at] += fragments.variances[i];
  }
}

Rgb SampleStore::Mean(std::size_t sample) const {
  return sums_[sample] / static_cast<float>(rays_[sample]);
}

Fragments SampleStore::Means() const {
  Fragments means(plan_);
  if (!variances_.empty()) means.variances.resize(variances_.size());
  ParallelFor(plan_.grid.cells(), kCellsPerTask, threads_,
              [&](int begin, int end) {
                for (int cell = begin; cell < end; ++cell)
                  FillCell(cell, &means);
              });
  return means;
}

void SampleStore::FillCell(int cell, Fragments* fragments) const {
  const int count = plan_.samples_per_cell;
  for (int s = 0; s < count; ++s) {
    const auto at = static_cast<std::size_t>(cell * count + s);
    const std::size_t from = rays_[at] > 0 ? at : Nearest(cell, s);
    fragments->values[at] = Mean(from);
    if (!variances_.empty()) {
      const auto rays = static_cast<float>(rays_[from]);
      fragments->variances[at] = variances_[from] / (rays * rays);
    }
  }
}

std::size_t SampleStore::Nearest(int cell, int wanted) const {
  const int count = plan_.samples_per_cell;
  float least = std::numeric_limits<float>::max();
  std::ptrdiff_t best = -1;
  for (int s = 0; s < count; ++s) {
    const std::ptrdiff_t at = cell * count + s;
    if (rays_[static_cast<std::size_t>(at)] == 0) continue;
    const V2f offset = plan_.position(cell, s) - plan_.position(cell, wanted);
    const float distance = offset.length2();
    if (distance < least) {
      least = distance;
      best = at;
    }
  }
  if (best >= 0) return static_cast<std::size_t>(best);
  // No ray in this cell: one of its block of 2 x 2 has one, unless the grid's
  // border cuts the block; then the row before the block's has.
  const int column = cell % plan_.grid.columns;
  const int row = cell / plan_.grid.columns;
  for (const int y : {row, row ^ 1, row - 1, row - 2}) {
    for (const int x : {column, column ^ 1, column - 1, column - 2}) {
      best = AnyOf(x, y);
      if (best >= 0) return static_cast<std::size_t>(best);
    }
  }
  const auto any =
      std::ranges::find_if(rays_, [](int rays) { return rays > 0; });
  return static_cast<std::size_t>(any - rays_.begin());
}

std::ptrdiff_t SampleStore::AnyOf(int column, int row) const {
  if (column < 0 || column >= plan_.grid.columns || row < 0 ||
      row >= plan_.grid.rows) {
    return -1;
  }
  const int count = plan_.samples_per_cell;
  const std::ptrdiff_t first = (row * plan_.grid.columns + column) * count;
  for (std::ptrdiff_t at = first; at < first + count; ++at) {
    if (rays_[static_cast<std::size_t>(at)] > 0) return at;
  }
  return -1;
}

}  // namespace rtb
