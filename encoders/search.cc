// Encoder `search`: rays in each of 8 rows and 8 columns look for the straight
// edge that splits the cell best. Origin: RAYTERM's "Search Algorithm".
#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "encoders/parameters.h"
#include "encoders/registry.h"
#include "encoders/search/tracer.h"

namespace rtb {
namespace {

constexpr int kGrain = 64;

/// In the order of the parameters' values.
enum class Order { kParallel, kSequential };
enum class FitTo { kWinner, kAll };

const EncoderParameter& RaysParameter() {
  static const EncoderParameter parameter{"rays", "16", "16|12|8",
                                          "rays of both searches together"};
  return parameter;
}

const EncoderParameter& OrderParameter() {
  static const EncoderParameter parameter{
      "order", "parallel", "parallel|sequential",
      "all rays at once, or bisecting towards the edge with at most 5 a "
      "search"};
  return parameter;
}

const EncoderParameter& FitParameter() {
  static const EncoderParameter parameter{
      "fit", "winner", "winner|all",
      "colors and edge from the stronger search's rays, or by least squares "
      "over all rays"};
  return parameter;
}

const EncoderParameter& FlatParameter() {
  static const EncoderParameter parameter{
      "flat", "3", "number >= 0",
      "a cell whose best split is weaker, in squared 8-bit codes, is a space"};
  return parameter;
}

struct SearchSettings {
  int strips = 8;
  Order order = Order::kParallel;
  FitTo fit = FitTo::kWinner;
  double flat = 3;
  std::optional<std::uint64_t> seed;
  Blend blend = Blend::kSrgb;
};

/// The split that was found in each cell and direction: in the order of
/// kDirections.
using CellSplits = std::array<EdgeSplit, 2>;

class Search : public Encoder {
 public:
  explicit Search(const SearchSettings& settings) : settings_(settings) {}

  std::vector<char32_t> Candidates() const override {
    std::vector<char32_t> glyphs = {U' '};
    for (char32_t glyph = 0x2581; glyph <= 0x258F; ++glyph) {
      if (glyph != kFullBlock) glyphs.push_back(glyph);
    }
    return glyphs;
  }

  Result<Encoding> Run(FragmentSource& source, GridSize grid,
                       double cell_aspect,
                       const EncodeContext& context) const override {
    SearchTracer tracer(
        source, {grid, cell_aspect, settings_.strips,
                 settings_.seed.value_or(context.seed), settings_.blend});
    std::vector<CellSplits> splits;
    if (settings_.order == Order::kParallel) {
      RTB_ASSIGN_OR_RETURN(splits, TraceAll(tracer));
    } else {
      RTB_ASSIGN_OR_RETURN(splits, Bisect(tracer));
    }
    Encoding encoding{CellGrid(grid), tracer.rays_per_cell(), {}};
    ParallelFor(grid.cells(), kGrain, context.threads, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        const auto at = static_cast<std::size_t>(i);
        encoding.grid.cells[at] = ChooseCell(tracer.cells()[at], splits[at]);
      }
    });
    encoding.evidence = tracer.TakeEvidence();
    return encoding;
  }

 private:
  /// Every strip of both searches.
  Result<std::vector<CellSplits>> TraceAll(SearchTracer& tracer) const {
    std::vector<int> strips(static_cast<std::size_t>(settings_.strips));
    std::iota(strips.begin(), strips.end(), 0);
    RTB_RETURN_IF_ERROR(tracer.TraceEverywhere(strips));
    std::vector<CellSplits> splits;
    for (const SearchedCell& state : tracer.cells()) {
      splits.push_back({StrongestSplit(state.rays.vertical),
                        StrongestSplit(state.rays.horizontal)});
    }
    return splits;
  }

  /// First, last and 4th strip, then towards the strongest edge.
  Result<std::vector<CellSplits>> Bisect(SearchTracer& tracer) const {
    const int last = settings_.strips - 1;
    const std::array<int, 3> first = {0, last, MiddleStrip(settings_.strips)};
    RTB_RETURN_IF_ERROR(tracer.TraceEverywhere(first));
    std::vector<std::array<Bisection, 2>> bisections;
    for (const SearchedCell& state : tracer.cells()) {
      bisections.push_back(
          {Bisection(state.rays.vertical), Bisection(state.rays.horizontal)});
    }
    while (true) {
      const std::vector<StripRequest> requests = NextStrips(bisections);
      if (requests.empty()) break;
      RTB_RETURN_IF_ERROR(tracer.Trace(requests));
      for (const StripRequest& request : requests) {
        const auto at = static_cast<std::size_t>(request.cell);
        bisections[at][static_cast<std::size_t>(request.direction)].Narrow(
            tracer.cells()[at].rays.of(request.direction));
      }
    }
    std::vector<CellSplits> splits;
    for (std::size_t i = 0; i < bisections.size(); ++i) {
      const SearchRays& rays = tracer.cells()[i].rays;
      splits.push_back({SplitAfter(rays.vertical, bisections[i][0].edge()),
                        SplitAfter(rays.horizontal, bisections[i][1].edge())});
    }
    return splits;
  }

  static std::vector<StripRequest> NextStrips(
      const std::vector<std::array<Bisection, 2>>& bisections) {
    std::vector<StripRequest> requests;
    for (std::size_t i = 0; i < bisections.size(); ++i) {
      for (const auto direction : kDirections) {
        const int strip =
            bisections[i][static_cast<std::size_t>(direction)].Next();
        if (strip < 0) continue;
        requests.push_back({static_cast<int>(i), direction, strip});
      }
    }
    return requests;
  }

  Cell ChooseCell(const SearchedCell& state, const CellSplits& splits) const {
    EdgeSplit best = IsStronger(splits[1], splits[0]) ? splits[1] : splits[0];
    if (settings_.fit == FitTo::kAll) best = StrongestSplit(state.placed);
    if (best.strength * 255 * 255 >= settings_.flat && best.strength > 0) {
      return CellOfSplit(settings_.blend, best);
    }
    V3d sum(0);
    for (const PlacedRay& ray : state.placed) sum += ray.color;
    return {U' ',
            {},
            ToRgb8(settings_.blend,
                   sum / static_cast<double>(state.placed.size()))};
  }

  SearchSettings settings_;
};

Result<SearchSettings> ReadSettings(const EncoderParameters& given) {
  SearchSettings settings;
  RTB_ASSIGN_OR_RETURN(const int rays, ReadChoice(RaysParameter(), given));
  settings.strips = kMaxStrips - 2 * rays;
  RTB_ASSIGN_OR_RETURN(const int order, ReadChoice(OrderParameter(), given));
  settings.order = static_cast<Order>(order);
  RTB_ASSIGN_OR_RETURN(const int fit, ReadChoice(FitParameter(), given));
  settings.fit = static_cast<FitTo>(fit);
  RTB_ASSIGN_OR_RETURN(settings.flat,
                       ReadNumber(FlatParameter(), given, 0, 255.0 * 255 * 3));
  RTB_ASSIGN_OR_RETURN(settings.seed, ReadSeed(given));
  RTB_ASSIGN_OR_RETURN(settings.blend, ReadBlend(given));
  return settings;
}

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const SearchSettings settings, ReadSettings(given));
  return std::make_unique<Search>(settings);
}

}  // namespace

EncoderEntry search_entry() {
  return {{"search",
           "the straight edge that rays in 8 rows and 8 columns find",
           2 * kMaxStrips,
           "space, U+2581-2587, U+2589-258F",
           {RaysParameter(), OrderParameter(), FitParameter(), FlatParameter(),
            SeedParameter(), BlendParameter()}},
          Make};
}

}  // namespace rtb
