/// @file
/// FrameMaker: renders and encodes one picture after the other.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/render/ray_counts.h"
#include "encoders/encoder.h"
#include "harness/live/device_cells.h"
#include "harness/live/live_view.h"
#include "harness/live/region_source.h"
#include "harness/live/sample_store.h"
#include "harness/prepared_scene.h"

namespace rtb {

/// A picture to make.
struct FrameRequest {
  LiveView view;
  RayBudget budget;
};

/// A picture, and what it took.
struct LiveFrame {
  FrameRequest request;
  CellGrid picture;
  std::shared_ptr<const Scene> scene;
  double exposure = 0;       ///< Stops, that were applied.
  double rays_per_cell = 0;  ///< Eye rays really traced, mean over all cells.
  int samples_per_cell = 0;  ///< That the encoder asks for first; the most of
                             ///< both sides.
  RayCounts rays;
  double render_ms = 0;
  double encode_ms = 0;
  double total_ms = 0;  ///< From the request on, loading a scene included.
  bool loaded = false;  ///< A scene was loaded for it.
  /// Rays that every sample of the view has by now; 0: some show others' or
  /// rows are of older frames.
  int passes = 0;
};

/// Where a FrameMaker has its parts from.
struct FrameParts {
  std::function<Result<PreparedScene>(const SceneRequest&)> prepare =
      PrepareScene;
  DeviceCells::Maker device_encoder = DeviceEncoder::Make;
};

/// Keeps scene, encoders, samples and the last picture between frames. For
/// one thread.
class FrameMaker {
 public:
  explicit FrameMaker(FrameParts from = {})
      : prepare_(std::move(from.prepare)),
        device_(std::move(from.device_encoder)) {}

  /// @return the errors of loading, rendering and encoding. After one, the
  /// next request starts anew.
  Result<LiveFrame> Make(const FrameRequest& request);

 private:
  /// A region that is encoded by itself.
  struct Part {
    Region region;
    SampleStore store;
    int epoch = -1;          ///< When it was last drawn.
    bool on_device = false;  ///< So it was, and the store has nothing.
    CellGrid last = {};      ///< What its encoder chose then.
  };

  Status PrepareFor(const LiveView& view, LiveFrame* frame);
  /// The SPEC of a side's encoder, `temporal` added where it helps.
  static std::string SpecFor(const LiveView& view, const Part& part);
  Result<const Encoder*> FindEncoder(const std::string& spec);
  void MakeParts(const FrameRequest& request);
  Status DrawPart(const FrameRequest& request, Part* part, LiveFrame* frame);
  /// Where a GPU can choose the cells: of a whole picture, of which no samples
  /// are kept or wanted yet. @return whether it has.
  Result<bool> DrawOnDevice(const FrameRequest& request, Part* part,
                            LiveFrame* frame);
  /// From samples, which the store keeps.
  Status DrawSamples(const FrameRequest& request, Part* part, LiveFrame* frame);
  SampleStore::Tracer TracerFor(const FrameRequest& request, LiveFrame* frame);
  int Passes() const;

  std::function<Result<PreparedScene>(const SceneRequest&)> prepare_;
  DeviceCells device_;
  std::shared_ptr<PreparedScene> scene_;
  std::map<std::string, std::unique_ptr<Encoder>> encoders_;
  std::vector<Part> parts_;  ///< Sides, each with its row phases.
  FrameRequest last_;
  bool fresh_ = true;  ///< No frame before, or it failed.
  int epoch_ = 0;
  int phase_ = 0;
  CellGrid picture_;
};

}  // namespace rtb
