#include "encoders/cuda/device_encoder.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/check.h"
#include "core/cuda/cuda_handles.h"
#include "core/cuda/device_array.h"
#include "core/cuda/device_stage.h"
#include "encoders/cuda/encode_launch.h"
#include "encoders/glyphs/patterns.h"

namespace rtb {
namespace {

/// How one encoder differs from another.
struct Kind {
  const char* name;
  int columns, rows;  ///< Of samples.
  cudaError_t (*launch)(const EncodeJob&, cudaStream_t);
  std::vector<char32_t> (*glyphs)();  ///< EncodeTables's.

  int samples() const { return columns * rows; }
};

template <char32_t (*kGlyph)(unsigned), int kSamples>
std::vector<char32_t> OfPatterns() {
  return GlyphsOfPatterns(kGlyph, kSamples);
}
std::vector<char32_t> LowerHalf() { return {U'▄'}; }
std::vector<char32_t> None() { return {}; }

constexpr std::array<Kind, 5> kKinds = {{
    {"half", 1, 2, LaunchEncodeHalf, LowerHalf},
    {"quadrant", 2, 2, LaunchEncodeQuadrant, OfPatterns<QuadrantGlyph, 4>},
    {"sextant", 2, 3, LaunchEncodePartition, OfPatterns<SextantGlyph, 6>},
    {"octant", 2, 4, LaunchEncodePartition, OfPatterns<OctantGlyph, 8>},
    {"tiv", kTivColumns, kTivRows, LaunchEncodeTiv, None},
}};

/// One frame's cells, from the kernel to the host.
class CellStage : public DeviceStage {
 public:
  Status Prepare(const Kind& kind, const EncodeTables& tables, GridSize grid,
                 float gain) {
    launch_ = kind.launch;
    grid_ = grid;
    job_.gain = gain;
    job_.samples_per_cell = kind.samples();
    job_.cell_count = static_cast<std::size_t>(grid.cells());
    job_.tables = tables;
    RTB_RETURN_IF_ERROR(device_.Reserve(job_.cell_count));
    RTB_RETURN_IF_ERROR(host_.Reserve(job_.cell_count));
    job_.cells = device_.data();
    if (encoded_.get() != nullptr) return {};
    RTB_ASSIGN_OR_RETURN(encoded_, MakeCudaEvent());
    return {};
  }

  Status Queue(const DeviceSamples& samples) override {
    job_.samples = samples.values;
    RTB_RETURN_IF_ERROR(CheckCuda(launch_(job_, samples.compute), "encoding"));
    RTB_RETURN_IF_ERROR(CheckCuda(
        cudaEventRecord(encoded_.get(), samples.compute), "cudaEventRecord"));
    RTB_RETURN_IF_ERROR(
        CheckCuda(cudaStreamWaitEvent(samples.copy, encoded_.get(), 0),
                  "cudaStreamWaitEvent"));
    return CheckCuda(cudaMemcpyAsync(host_.data(), device_.data(),
                                     job_.cell_count * sizeof(Cell),
                                     cudaMemcpyDeviceToHost, samples.copy),
                     "copying cells from the device");
  }

  /// After the frame was collected.
  CellGrid Grid() const {
    CellGrid grid;
    grid.size = grid_;
    grid.cells.assign(host_.data(), host_.data() + job_.cell_count);
    return grid;
  }

 private:
  cudaError_t (*launch_)(const EncodeJob&, cudaStream_t) = nullptr;
  GridSize grid_;
  EncodeJob job_;
  DeviceArray<Cell> device_;
  PinnedArray<Cell> host_;
  CudaEvent encoded_;
};

class KernelEncoder : public DeviceEncoder {
 public:
  explicit KernelEncoder(const Kind& kind) : kind_(kind) {}

  /// Frames under way, which nobody collects any more, write to the stages.
  ~KernelEncoder() override { (void)cudaDeviceSynchronize(); }

  /// Copies the tables, once for all frames.
  Status Upload() {
    const std::vector<char32_t> glyphs = kind_.glyphs();
    RTB_ASSIGN_OR_RETURN(const CudaStream stream, MakeCudaStream());
    RTB_RETURN_IF_ERROR(
        codes_.Upload(std::span(&SrgbCodes(), 1), stream.get()));
    RTB_RETURN_IF_ERROR(
        curve_.Upload(std::span(&SrgbCurve(), 1), stream.get()));
    RTB_RETURN_IF_ERROR(
        glyphs_.Upload(std::span<const char32_t>(glyphs), stream.get()));
    RTB_RETURN_IF_ERROR(tiv_glyphs_.Upload(kTivGlyphs, stream.get()));
    return FinishUploads(stream.get());
  }

  SamplePlan Plan(GridSize grid, double cell_aspect) const override {
    return RegularPlan(grid, kind_.columns, kind_.rows, cell_aspect);
  }

  Status Submit(AheadBackend& backend, const SamplePlan& plan,
                const RenderOptions& options, double exposure) override {
    RTB_CHECK_EQ(plan.samples_per_cell, kind_.samples());
    CellStage& stage = stages_[submitted_ % stages_.size()];
    const auto gain = static_cast<float>(std::exp2(exposure));
    RTB_RETURN_IF_ERROR(stage.Prepare(
        kind_,
        {codes_.data(), curve_.data(), glyphs_.data(), tiv_glyphs_.data()},
        plan.grid, gain));
    RTB_RETURN_IF_ERROR(backend.Submit(plan, options, &stage));
    ++submitted_;
    return {};
  }

  Result<CellGrid> Collect(AheadBackend& backend) override {
    RTB_CHECK_LT(collected_, submitted_);
    const CellStage& stage = stages_[collected_++ % stages_.size()];
    RTB_ASSIGN_OR_RETURN(const Fragments empty, backend.Collect());
    RTB_CHECK(empty.values.empty());
    return stage.Grid();
  }

 private:
  const Kind& kind_;
  DeviceArray<SrgbCodeTable> codes_;
  DeviceArray<SrgbCurveTable> curve_;
  DeviceArray<char32_t> glyphs_;
  DeviceArray<TivGlyph> tiv_glyphs_;
  std::array<CellStage, AheadBackend::kFramesAhead> stages_;
  std::size_t submitted_ = 0;
  std::size_t collected_ = 0;
};

}  // namespace

Result<std::unique_ptr<DeviceEncoder>> DeviceEncoder::Make(
    const std::string& name) {
  RTB_RETURN_IF_ERROR(CudaRuns());
  std::string names;
  for (const Kind& kind : kKinds) {
    if (name == kind.name) {
      auto encoder = std::make_unique<KernelEncoder>(kind);
      RTB_RETURN_IF_ERROR(encoder->Upload());
      return encoder;
    }
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return Fail(BadInput("--encoder",
                       "encoder `" + name + "` does not run on a GPU", names));
}

}  // namespace rtb
