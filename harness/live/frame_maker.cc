#include "harness/live/frame_maker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "encoders/registry.h"
#include "harness/run_encoder.h"

namespace rtb {
namespace {

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start)
      .count();
}

/// While the view moves: less than a step of 8 bits. The pictures of a view at
/// rest follow every ray.
constexpr float kLeastWeight = 1.0f / 256;

/// Whether samples come with noise that the modifier `temporal` can judge.
bool IsNoisy(const LiveView& view) {
  return view.integrator == "path" || view.spp > 1;
}

/// A SPEC with the modifier `temporal`, unless it has one.
std::string WithTemporal(const std::string& spec) {
  if (spec.find("temporal=") != std::string::npos ||
      spec.starts_with("external:")) {
    return spec;
  }
  return spec + ":temporal=3";
}

/// What the first pass of a view is rendered with.
RenderOptions OptionsFor(const FrameRequest& request) {
  RenderOptions options;
  options.time = request.view.time;
  options.spp = request.budget.spp;
  options.seed = request.view.seed;
  options.max_depth = request.view.max_depth;
  options.threads = request.view.threads;
  options.integrator = request.view.integrator;
  options.camera = request.view.camera;
  options.least_weight = kLeastWeight;
  return options;
}

/// The columns of one side.
Region SideOf(const LiveView& view, std::size_t side) {
  Region region{.grid = view.grid, .columns = view.grid.columns};
  if (!view.split) return region;
  region.first_column = side == 0 ? 0 : view.divider;
  region.columns = side == 0 ? view.divider : view.grid.columns - view.divider;
  return region;
}

void Paste(const CellGrid& part, const Region& region, CellGrid* picture) {
  for (int cell = 0; cell < part.size.cells(); ++cell) {
    picture->cells[static_cast<std::size_t>(region.CellOf(cell))] =
        part.cells[static_cast<std::size_t>(cell)];
  }
}

}  // namespace

Result<LiveFrame> FrameMaker::Make(const FrameRequest& request) {
  const auto start = Clock::now();
  LiveFrame frame;
  frame.request = request;
  const bool changed = fresh_ || !SameSamples(request.view, last_.view);
  const bool first = std::exchange(fresh_, true);  // Until it has succeeded.
  if (changed) ++epoch_;
  RTB_RETURN_IF_ERROR(PrepareFor(request.view, &frame));
  frame.scene = std::shared_ptr<const Scene>(scene_, scene_->scene.get());
  frame.exposure = request.view.exposure.value_or(scene_->exposure);
  if (first || request.budget.row_step != last_.budget.row_step ||
      request.view.split != last_.view.split ||
      request.view.divider != last_.view.divider ||
      request.view.grid != last_.view.grid) {
    MakeParts(request);
  }
  phase_ = (phase_ + 1) % request.budget.row_step;
  for (Part& part : parts_) {
    if (part.region.first_row != phase_) continue;
    RTB_RETURN_IF_ERROR(DrawPart(request, &part, &frame));
  }
  frame.picture = picture_;
  frame.passes = Passes();
  frame.total_ms = MillisecondsSince(start);
  last_ = request;
  fresh_ = false;
  return frame;
}

Status FrameMaker::PrepareFor(const LiveView& view, LiveFrame* frame) {
  if (scene_ != nullptr && view.scene == last_.view.scene &&
      view.backend == last_.view.backend) {
    return {};
  }
  frame->loaded = true;
  scene_ = nullptr;
  RTB_ASSIGN_OR_RETURN(PreparedScene prepared,
                       prepare_({.scene = view.scene,
                                 .backend = view.backend,
                                 .exposure = {},
                                 .options = {}}));
  scene_ = std::make_shared<PreparedScene>(std::move(prepared));
  return {};
}

std::string FrameMaker::SpecFor(const LiveView& view, const Part& part) {
  const std::string& spec = view.encoders[part.region.first_column > 0 ? 1 : 0];
  return view.temporal && IsNoisy(view) ? WithTemporal(spec) : spec;
}

Result<const Encoder*> FrameMaker::FindEncoder(const std::string& spec) {
  const auto found = encoders_.find(spec);
  if (found != encoders_.end()) return found->second.get();
  RTB_ASSIGN_OR_RETURN(auto encoder, MakeEncoder(spec));
  return encoders_.emplace(spec, std::move(encoder)).first->second.get();
}

void FrameMaker::MakeParts(const FrameRequest& request) {
  const LiveView& view = request.view;
  parts_.clear();
  if (picture_.size != view.grid) picture_ = CellGrid(view.grid);
  for (std::size_t side = 0; side < (view.split ? 2 : 1); ++side) {
    for (int row = 0; row < request.budget.row_step; ++row) {
      Region region = SideOf(view, side);
      region.first_row = row;
      region.row_step = request.budget.row_step;
      if (region.size().cells() > 0) parts_.push_back({region, {}});
    }
  }
}

SampleStore::Tracer FrameMaker::TracerFor(const FrameRequest& request,
                                          LiveFrame* frame) {
  return [this, options = OptionsFor(request), frame, seed = request.view.seed](
             const SamplePlan& plan, int pass) mutable {
    constexpr std::uint64_t kPassStride = 0x9E3779B97F4A7C15;
    options.seed = seed + kPassStride * static_cast<std::uint64_t>(pass);
    options.least_weight = pass == 0 ? kLeastWeight : 0;
    SceneSource source(*scene_->backend, options, frame->exposure);
    auto fragments = source.Query(plan);
    frame->rays += scene_->backend->ray_counts();
    return fragments;
  };
}

Status FrameMaker::DrawPart(const FrameRequest& request, Part* part,
                            LiveFrame* frame) {
  RTB_ASSIGN_OR_RETURN(part->on_device, DrawOnDevice(request, part, frame));
  if (!part->on_device) {
    RTB_RETURN_IF_ERROR(DrawSamples(request, part, frame));
  }
  part->epoch = epoch_;
  Paste(part->last, part->region, &picture_);
  return {};
}

Result<bool> FrameMaker::DrawOnDevice(const FrameRequest& request, Part* part,
                                      LiveFrame* frame) {
  const LiveView& view = request.view;
  const bool rests = part->epoch == epoch_;  // samples are gathered then
  if (rests || !part->region.whole() || request.budget.share < 1 ||
      view.depth != ColorDepth::kTruecolor) {
    return false;
  }
  const auto start = Clock::now();
  RTB_ASSIGN_OR_RETURN(
      auto picture,
      device_.Draw(*scene_->backend,
                   {SpecFor(view, *part), view.grid, view.cell_aspect,
                    OptionsFor(request), frame->exposure}));
  if (!picture) return false;
  frame->render_ms += MillisecondsSince(start);
  frame->rays += picture->rays;
  frame->samples_per_cell =
      std::max(frame->samples_per_cell, picture->samples_per_cell);
  frame->rays_per_cell += picture->samples_per_cell * request.budget.spp;
  part->last = std::move(picture->grid);
  return true;
}

Status FrameMaker::DrawSamples(const FrameRequest& request, Part* part,
                               LiveFrame* frame) {
  const LiveView& view = request.view;
  RTB_ASSIGN_OR_RETURN(const Encoder* encoder,
                       FindEncoder(SpecFor(view, *part)));
  // The tracer asks the whole picture's backend for the region's cells.
  const auto trace = TracerFor(request, frame);
  part->store.BeginFrame(
      [&trace, part](const SamplePlan& plan, int pass) mutable {
        struct Picture : FragmentSource {
          SampleStore::Tracer tracer;
          int number = 0;
          Result<Fragments> Query(const SamplePlan& mapped) override {
            return tracer(mapped, number);
          }
        } picture;
        picture.tracer = trace;
        picture.number = pass;
        return RegionSource(picture, part->region).Query(plan);
      },
      epoch_, request.budget.share, view.threads);
  EncodeContext context;
  context.seed = view.seed;
  context.threads = view.threads;
  context.depth = view.depth;
  if (part->last.size == part->region.size()) context.previous = &part->last;
  RTB_ASSIGN_OR_RETURN(TimedEncoding run,
                       RunEncoder(*encoder, part->store, part->region.size(),
                                  view.cell_aspect, context));
  frame->render_ms += run.render.wall_ms;
  frame->encode_ms += run.plan.wall_ms + run.encode.wall_ms;
  frame->rays_per_cell += static_cast<double>(part->store.traced()) *
                          request.budget.spp / view.grid.cells();
  frame->samples_per_cell =
      std::max(frame->samples_per_cell, part->store.samples_per_cell());
  part->last = std::move(run.encoding.grid);
  return {};
}

int FrameMaker::Passes() const {
  const auto rays_of = [](const Part& part) {
    return part.on_device ? 1 : part.store.least_rays();
  };
  int least = parts_.empty() ? 0 : rays_of(parts_.front());
  for (const Part& part : parts_) {
    if (part.epoch != epoch_) return 0;
    least = std::min(least, rays_of(part));
  }
  return least;
}

}  // namespace rtb
