#include "core/render/wide/trace_paths.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/wide/trace_paths.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/render/wide/bsdf-inl.h"
#include "core/render/wide/lanes-inl.h"
#include "core/render/wide/quadrics-inl.h"
#include "core/render/wide/random-inl.h"
#include "core/render/wide/sky-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

/// PathTracer's Path, one in each lane.
struct State {
  V3 origin, direction;
  U pattern, index;
  V3 throughput, radiance;
  F pdf;
  I number;
};

HWY_INLINE V3 LoadRows(const Paths::Rows& rows, int first) {
  return {hn::LoadU(DF(), rows[0] + first), hn::LoadU(DF(), rows[1] + first),
          hn::LoadU(DF(), rows[2] + first)};
}

HWY_INLINE void KeepRows(const V3& v, M kept, int first, Paths::Rows* rows) {
  hn::CompressStore(v.x, kept, DF(), (*rows)[0] + first);
  hn::CompressStore(v.y, kept, DF(), (*rows)[1] + first);
  hn::CompressStore(v.z, kept, DF(), (*rows)[2] + first);
}

HWY_INLINE State LoadState(const Paths& paths, int first) {
  return {LoadRows(paths.origin, first),
          LoadRows(paths.direction, first),
          hn::LoadU(DU(), paths.pattern + first),
          hn::LoadU(DU(), paths.index + first),
          LoadRows(paths.throughput, first),
          LoadRows(paths.radiance, first),
          hn::LoadU(DF(), paths.pdf + first),
          hn::LoadU(DI(), paths.number + first)};
}

/// Stores the lanes of a mask one after the other.
HWY_INLINE void KeepState(const State& state, M kept, int first, Paths* paths) {
  KeepRows(state.origin, kept, first, &paths->origin);
  KeepRows(state.direction, kept, first, &paths->direction);
  KeepRows(state.throughput, kept, first, &paths->throughput);
  KeepRows(state.radiance, kept, first, &paths->radiance);
  hn::CompressStore(state.pdf, kept, DF(), paths->pdf + first);
  const auto kept_words = hn::RebindMask(DU(), kept);
  hn::CompressStore(state.pattern, kept_words, DU(), paths->pattern + first);
  hn::CompressStore(state.index, kept_words, DU(), paths->index + first);
  hn::CompressStore(state.number, hn::RebindMask(DI(), kept), DI(),
                    paths->number + first);
}

/// One bounce of path.h's PathTracer for the paths of a batch.
class WideBounce {
 public:
  WideBounce(const WideScene& scene, std::uint64_t seed, int depth, bool last,
             RayCounts* counts)
      : scene_(scene),
        sky_(scene),
        seed_(seed),
        depth_(depth),
        last_(last),
        counts_(*counts) {}

  /// PathTracer::Extend. @return the lanes that go on.
  HWY_INLINE M Extend(M lanes, State* path) const {
    const Hits hits = ClosestOf(scene_, path->origin, path->direction);
    const M escaped = hn::AndNot(hits.some, lanes);
    if (Any(escaped)) AddSky(escaped, path);
    const M met = hn::And(lanes, hits.some);
    if (!Any(met)) return None();
    const Points points =
        SurfaceOf(scene_, hits, path->origin, path->direction);
    const M outside = Dot(path->direction, points.normal) < hn::Zero(DF());
    const V3 geometric = Select(outside, points.normal, -points.normal);
    // A BSDF's frame is on the viewer's side, but outward for glass.
    const M glass = LanesOf(scene_, met, hits.primitive, WideScene::kGlass);
    const V3 axis = Select(glass, points.normal, geometric);
    const LaneFrame frame = FrameOf(axis);
    const Bsdfs bsdfs(scene_, met, hits.primitive,
                      ToLocal(frame, -path->direction));
    const M spread = bsdfs.Spread();
    if (Any(spread)) {
      AddSkyLight(spread, bsdfs, frame, points, geometric, path);
    }
    if (last_) return None();
    return Scatter(met, bsdfs, frame, points, geometric, path);
  }

 private:
  /// Sets of dimensions of one bounce, as in PathTracer.
  enum DimensionSet : std::uint32_t { kScatter, kLight, kSetsPerBounce };

  HWY_INLINE SobolPoint Uniforms(const State& path, DimensionSet set) const {
    return {path.pattern, path.index,
            static_cast<std::uint32_t>(depth_) * kSetsPerBounce + set, seed_};
  }

  static HWY_INLINE F PowerHeuristic(F a, F b) {
    const F one = Set(1);
    const F ratio = b / a;
    return Select(b > hn::Zero(DF()), one / (one + ratio * ratio), one);
  }

  /// AddBackground.
  HWY_INLINE void AddSky(M escaped, State* path) const {
    const F y = path->direction.y;
    const F weight =
        Select(path->pdf == hn::Zero(DF()), Set(1),
               PowerHeuristic(path->pdf, Set(scene_.sky_chance) * sky_.Pdf(y)));
    const V3 received = path->throughput * sky_.Radiance(y) * weight;
    path->radiance = Select(escaped, path->radiance + received, path->radiance);
  }

  /// AddDirectLight, where the sky is all that emits.
  HWY_INLINE void AddSkyLight(M spread, const Bsdfs& bsdfs,
                              const LaneFrame& frame, const Points& points,
                              const V3& geometric, State* path) const {
    const F zero = hn::Zero(DF());
    const SobolPoint u = Uniforms(*path, kLight);
    const SkySamples sky = sky_.Draw(u.x(), u.y());
    const F pdf = sky.pdf * Set(scene_.sky_chance);
    const V3 irradiance = sky.radiance / Divisor(pdf);
    const V3 wi = ToLocal(frame, sky.direction);
    const Densities f = bsdfs.Evaluate(wi);
    const V3 value = f.value * wi.z;
    M lit = hn::And(hn::And(spread, sky.pdf > zero),
                    Dot(sky.direction, geometric) > zero);
    lit = hn::AndNot(hn::Or(IsBlack(irradiance), IsBlack(value)), lit);
    if (!Any(lit)) return;
    counts_.shadow += Count(lit);
    const M blocked = Occluded(
        scene_, lit, LeavingOrigin(points, sky.direction), sky.direction);
    const F weight = last_ ? Set(1) : PowerHeuristic(pdf, f.pdf);
    const V3 received = path->throughput * value * irradiance * weight;
    path->radiance = Select(hn::AndNot(blocked, lit), path->radiance + received,
                            path->radiance);
  }

  /// Scatter and Survives.
  HWY_INLINE M Scatter(M met, const Bsdfs& bsdfs, const LaneFrame& frame,
                       const Points& points, const V3& geometric,
                       State* path) const {
    const F zero = hn::Zero(DF());
    const SobolPoint u = Uniforms(*path, kScatter);
    const BsdfSamples samples = bsdfs.Draw(u);
    const V3 direction = ToWorld(frame, samples.wi);
    const F above = Dot(direction, geometric);
    M on = hn::And(met, hn::Or(samples.delta, above > zero));
    path->throughput = path->throughput * samples.weight;
    on = hn::AndNot(IsBlack(path->throughput), on);
    if (depth_ >= kCertainBounces) on = Survivors(on, u.w(), path);
    path->origin = LeavingOrigin(points, direction);
    path->direction = direction;
    path->pdf = hn::IfThenElseZero(hn::Not(samples.delta), samples.pdf);
    CountBounces(on, above < zero, samples.delta);
    return on;
  }

  static constexpr int kCertainBounces = 3;

  static HWY_INLINE M Survivors(M lanes, F u, State* path) {
    const F survival = hn::Min(Set(0.95f), Largest(path->throughput));
    path->throughput = path->throughput / Divisor(survival);
    return hn::And(lanes, u < survival);
  }

  HWY_INLINE void CountBounces(M on, M crossed, M delta) const {
    const M behind = hn::And(on, crossed);
    const M mirrored = hn::And(hn::AndNot(crossed, on), delta);
    const std::uint64_t all = Count(on);
    counts_.refraction += Count(behind);
    counts_.reflection += Count(mirrored);
    counts_.scattered += all - Count(behind) - Count(mirrored);
  }

  const WideScene& scene_;
  const Sky sky_;
  const std::uint64_t seed_;
  const int depth_;
  const bool last_;
  RayCounts& counts_;
};

/// Paths that have ended leave their radiances behind.
HWY_INLINE void Finish(const State& path, M ended, Paths* paths) {
  alignas(64) float x[hn::MaxLanes(DF())], y[hn::MaxLanes(DF())],
      z[hn::MaxLanes(DF())];
  alignas(64) std::int32_t number[hn::MaxLanes(DF())];
  hn::CompressStore(path.radiance.x, ended, DF(), x);
  hn::CompressStore(path.radiance.y, ended, DF(), y);
  hn::CompressStore(path.radiance.z, ended, DF(), z);
  const std::size_t count =
      hn::CompressStore(path.number, hn::RebindMask(DI(), ended), DI(), number);
  for (std::size_t i = 0; i < count; ++i) {
    paths->result[0][number[i]] = x[i];
    paths->result[1][number[i]] = y[i];
    paths->result[2][number[i]] = z[i];
  }
}

/// Extends the batch's paths; those that go on close up.
void ExtendAll(const WideBounce& bounce, Paths* paths) {
  const int lanes = static_cast<int>(hn::Lanes(DF()));
  int kept = 0;
  for (int first = 0; first < paths->count; first += lanes) {
    const M own =
        hn::FirstN(DF(), static_cast<std::size_t>(paths->count - first));
    State state = LoadState(*paths, first);
    const M on = bounce.Extend(own, &state);
    Finish(state, hn::AndNot(on, own), paths);
    KeepState(state, on, kept, paths);
    kept += static_cast<int>(Count(on));
  }
  paths->count = kept;
}

void Begin(Paths* paths) {
  for (int i = 0; i < paths->count; ++i) {
    for (int c = 0; c < 3; ++c) {
      paths->throughput[c][i] = 1;
      paths->radiance[c][i] = 0;
    }
    paths->pdf[i] = 0;
    paths->number[i] = i;
  }
}

}  // namespace wide

void TracePathsOn(const WideScene& scene, std::uint64_t seed, int max_depth,
                  Paths* paths, RayCounts* counts) {
  wide::Begin(paths);
  const auto count = static_cast<std::uint64_t>(paths->count);
  counts->camera += count;
  counts->on_vectors += count;
  for (int depth = 0; paths->count > 0; ++depth) {
    const wide::WideBounce bounce(scene, seed, depth, depth == max_depth,
                                  counts);
    wide::ExtendAll(bounce, paths);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(TracePathsOn);

void TracePaths(const WideScene& scene, std::uint64_t seed, int max_depth,
                Paths* paths, RayCounts* counts) {
  HWY_DYNAMIC_DISPATCH(TracePathsOn)(scene, seed, max_depth, paths, counts);
}

}  // namespace rtb
#endif  // HWY_ONCE
