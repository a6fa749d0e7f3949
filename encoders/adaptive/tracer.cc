#include "encoders/adaptive/tracer.h"

#include <algorithm>
#include <vector>

#include "encoders/adaptive/choose_rays.h"

namespace rtb {
namespace {

/// Rounds that share what is left after the first rays. More of them gain
/// little and cost time.
constexpr int kRounds = 5;

/// The places of the first rays. Two lie as on a lattice of triangles.
std::vector<V2f> FirstPositions(double rays) {
  if (rays < 2) return {V2f(0.5f, 0.5f)};
  return {V2f(0.25f, 0.25f), V2f(0.75f, 0.75f)};
}

class Tracer {
 public:
  Tracer(FragmentSource& source, const TraceRequest& request)
      : source_(source),
        request_(request),
        samples_(request.grid),
        map_(request.grid, request.cell_aspect, request.priority),
        chooser_(map_, samples_) {
    samples_.Reserve(
        static_cast<std::size_t>(request.rays * request.grid.cells()));
    plan_.grid = request.grid;
    plan_.cell_aspect = request.cell_aspect;
    // A sub-pixel of the canonical raster.
    plan_.footprint = V2f(1.0f / 8, 1.0f / 16);
  }

  /// The same places in every cell.
  Status TraceEverywhere() {
    SamplePlan plan = plan_;
    plan.positions = FirstPositions(request_.rays);
    plan.samples_per_cell = static_cast<int>(plan.positions.size());
    RTB_RETURN_IF_ERROR(Trace(plan));
    map_.Start(samples_.all(), plan.positions, request_.threads);
    return {};
  }

  Status TraceRounds() {
    const double rest = request_.rays * request_.grid.cells() -
                        static_cast<double>(samples_.all().size());
    RayRequest rays;
    rays.seed = request_.seed;
    rays.threads = request_.threads;
    // Twice the mean, and enough for edges in a picture that is flat elsewhere.
    rays.most_per_cell +=
        static_cast<int>(2 * rest / kRounds / request_.grid.cells());
    int spent = 0;
    for (int round = 1; round <= kRounds; ++round) {
      rays.rays = static_cast<int>(rest * round / kRounds) - spent;
      spent += rays.rays;
      RTB_RETURN_IF_ERROR(TraceBest(rays));
    }
    return {};
  }

  SeenSamples&& TakeSamples() { return std::move(samples_); }

 private:
  Status TraceBest(const RayRequest& request) {
    const std::vector<RayChoice> rays = chooser_.Choose(request);
    if (rays.empty()) return {};
    SamplePlan plan = plan_;
    plan.samples_per_cell = 1;
    plan.samples_before.resize(rays.size());
    plan.cells.resize(rays.size());
    plan.positions.resize(rays.size());
    int before = -1;
    int count = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const int cell = rays[i].cell;
      count = cell == before ? count + 1 : samples_.count(cell);
      before = cell;
      plan.samples_before[i] = count;
      plan.cells[i] = cell;
      plan.positions[i] = rays[i].position;
    }
    RTB_RETURN_IF_ERROR(Trace(plan));
    map_.Insert(samples_.all().last(rays.size()), request_.threads);
    return {};
  }

  Status Trace(const SamplePlan& plan) {
    RTB_ASSIGN_OR_RETURN(const Fragments fragments, source_.Query(plan));
    samples_.Add(plan, fragments);
    return {};
  }

  FragmentSource& source_;
  const TraceRequest& request_;
  SamplePlan plan_;
  SeenSamples samples_;
  VoronoiMap map_;
  RayChooser chooser_;
};

}  // namespace

Result<SeenSamples> TraceAdaptively(FragmentSource& source,
                                    const TraceRequest& request) {
  Tracer tracer(source, request);
  RTB_RETURN_IF_ERROR(tracer.TraceEverywhere());
  RTB_RETURN_IF_ERROR(tracer.TraceRounds());
  return tracer.TakeSamples();
}

}  // namespace rtb
