#include "harness/measure/temporal.h"

#include <cmath>
#include <memory>
#include <utility>

#include "core/image/io.h"
#include "encoders/emit/emit.h"
#include "encoders/registry.h"
#include "harness/cell_shape.h"
#include "harness/measure/converged_image.h"
#include "harness/measure/frame_steps.h"
#include "harness/measure/warp_error.h"

namespace rtb {
namespace {

/// The means of what Add is given.
class TemporalMeans {
 public:
  TemporalMeans(int frames, double fps) {
    result_.frames = frames;
    result_.fps = fps;
  }

  void AddFrame(std::size_t bytes) {
    result_.bytes_per_frame += static_cast<double>(bytes) / result_.frames;
  }

  void AddStep(const Frame& now, const Frame& before,
               std::span<const PixelMotion> motions, int threads) {
    const double share = 1.0 / (result_.frames - 1);
    result_.tde += share * TemporalDifferenceError(now, before, threads);
    result_.t_flip += share * TemporalFlip(now, before, threads);
    result_.churn += share * ChangedCells(now.grid, before.grid);
    drawn_.Add(now.drawn, before.drawn, motions);
    reference_.Add(now.reference, before.reference, motions);
  }

  TemporalResult Take() {
    const auto drawn = drawn_.Mean();
    if (drawn) result_.warp_error = *drawn - *reference_.Mean();
    return result_;
  }

 private:
  TemporalResult result_;
  WarpError drawn_;
  WarpError reference_;
};

/// Draws frames of one request.
class FrameMaker {
 public:
  static Result<FrameMaker> Make(const TemporalRequest& request) {
    FrameMaker maker(request);
    RTB_ASSIGN_OR_RETURN(maker.encoder_, MakeEncoder(request.encoder));
    RTB_ASSIGN_OR_RETURN(maker.raster_,
                         RasterSize(request.grid, CellOf(request.decode)));
    return maker;
  }

  PixelSize raster() const { return raster_; }
  double aspect() const {
    return static_cast<double>(raster_.width) / raster_.height;
  }
  double TimeOf(int frame) const {
    return request_.scene.options.time + frame / request_.fps;
  }

  /// The grid at a time. @param previous the last frame's, or nullptr.
  Result<CellGrid> Draw(double time, std::uint64_t seed,
                        const CellGrid* previous) const {
    RenderOptions options = request_.scene.options;
    options.time = time;
    options.seed = seed;
    SceneSource source(*request_.scene.backend, options,
                       request_.scene.exposure);
    EncodeContext context;
    context.seed = seed;
    context.threads = options.threads;
    context.previous = previous;
    context.depth = request_.depth;
    RTB_ASSIGN_OR_RETURN(Encoding encoding,
                         encoder_->Run(source, request_.grid,
                                       CellAspect(request_.decode), context));
    return std::move(encoding.grid);
  }

  Result<Image> DecodeGrid(const CellGrid& grid) const {
    DecodeOptions decode = request_.decode;
    decode.threads = request_.scene.options.threads;
    return Decode(grid, decode);
  }

  Result<Image> Reference(double time) const {
    RTB_ASSIGN_OR_RETURN(
        const Image linear,
        ConvergedImage(request_.scene, time, raster_, request_.cache));
    return DisplayEncoded(linear, request_.scene.exposure, true);
  }

  /// The frame that comes after `previous` (nullptr: the first).
  Result<Frame> MakeFrame(int number, const Frame* previous) const {
    const double time = TimeOf(number);
    Frame frame;
    RTB_ASSIGN_OR_RETURN(frame.grid,
                         Draw(time, request_.scene.options.seed,
                              previous != nullptr ? &previous->grid : nullptr));
    RTB_ASSIGN_OR_RETURN(frame.drawn, DecodeGrid(frame.grid));
    RTB_ASSIGN_OR_RETURN(frame.reference, Reference(time));
    return frame;
  }

 private:
  explicit FrameMaker(const TemporalRequest& request) : request_(request) {}

  const TemporalRequest& request_;
  std::unique_ptr<Encoder> encoder_;
  PixelSize raster_;
};

Status CheckRequest(const TemporalRequest& request) {
  if (request.frames < kLeastFrames) {
    return Fail(BadInput("frames", "found " + std::to_string(request.frames) +
                                       ", expected at least " +
                                       std::to_string(kLeastFrames)));
  }
  if (!(request.fps > 0) || !std::isfinite(request.fps)) {
    return Fail(BadInput("fps", "expected a positive number"));
  }
  return {};
}

/// Draws a frame once more with another seed, the frame itself being the last
/// that an encoder saw.
Status MeasureStaticFlicker(const TemporalRequest& request,
                            const FrameMaker& maker, const Frame& frame,
                            TemporalResult* result) {
  const RenderOptions& options = request.scene.options;
  RTB_ASSIGN_OR_RETURN(
      const CellGrid again,
      maker.Draw(maker.TimeOf(0), options.seed + 1, &frame.grid));
  RTB_ASSIGN_OR_RETURN(const Image drawn, maker.DecodeGrid(again));
  result->static_flicker = ChangedCells(frame.grid, again);
  result->static_flicker_rms =
      RmsDifference(frame.drawn, drawn, options.threads);
  return {};
}

}  // namespace

Result<TemporalResult> MeasureTemporal(
    const TemporalRequest& request,
    const std::function<void(double, const std::string&)>& progress) {
  RTB_RETURN_IF_ERROR(CheckRequest(request));
  RTB_ASSIGN_OR_RETURN(const FrameMaker maker, FrameMaker::Make(request));
  const Scene& scene = *request.scene.scene;
  const int threads = request.scene.options.threads;
  const PixelSize raster = maker.raster();
  const auto moment = [&](int number) {
    return Moment::Make(scene, maker.TimeOf(number), maker.aspect(), threads);
  };
  TemporalMeans means(request.frames, request.fps);
  RTB_ASSIGN_OR_RETURN(Frame before, maker.MakeFrame(0, nullptr));
  RTB_ASSIGN_OR_RETURN(auto moment_before, moment(0));
  means.AddFrame(EmitAnsi(before.grid, request.depth).size());
  TemporalResult still;
  RTB_RETURN_IF_ERROR(MeasureStaticFlicker(request, maker, before, &still));
  for (int number = 1; number < request.frames; ++number) {
    progress(static_cast<double>(number) / request.frames, "frames");
    RTB_ASSIGN_OR_RETURN(Frame now, maker.MakeFrame(number, &before));
    RTB_ASSIGN_OR_RETURN(auto moment_now, moment(number));
    means.AddFrame(EmitAnsi(now.grid, request.depth).size());
    means.AddStep(now, before,
                  TraceMotion(*moment_now, *moment_before, raster.width,
                              raster.height, threads),
                  threads);
    before = std::move(now);
    moment_before = std::move(moment_now);
  }
  TemporalResult result = means.Take();
  result.static_flicker = still.static_flicker;
  result.static_flicker_rms = still.static_flicker_rms;
  progress(1, "frames");
  return result;
}

}  // namespace rtb
