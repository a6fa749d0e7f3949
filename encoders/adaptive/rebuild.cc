#include "encoders/adaptive/rebuild.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/color/srgb.h"
#include "encoders/adaptive/blend_nearest.h"
#include "encoders/adaptive/by_cell.h"
#include "encoders/adaptive/edge_metric.h"
#include "encoders/adaptive/reliance.h"
#include "encoders/adaptive/wide_mean.h"

namespace rtb {
namespace {

constexpr int kGrain = 16;

/// From here on the wide mean would move nothing that is seen.
constexpr float kFullReliance = 0.99f;

/// Rebuilds cells, one at a time.
class CellBuilder {
 public:
  CellBuilder(const ByCell& samples, int width, int height)
      : samples_(samples),
        places_(width, height, samples.cell_width()),
        turned_places_(places_),
        blended_(places_) {}

  /// @param reliance on the nearest samples.
  void Build(int cell, float reliance, std::span<Rgb> out) {
    samples_.Gather(cell, near_);
    BlendNearest();
    SrgbEncode(blended_.linear, blended_.linear);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Rgb& far = blended_.encoded[i];
      out[i] = far + (blended_.linear[i] - far) * blended_.share[i];
    }
    if (reliance < kFullReliance) MoveToWide(reliance, out);
  }

 private:
  /// Each place from its nearest samples, nearest by the metric of the cell. A
  /// pixel at the edge of a lamp is as bright as the lamp if little of it is
  /// seen in it: there both sides have to be mixed.
  void BlendNearest() {
    if (near_.Alike() || near_.Overexposed()) {
      rtb::BlendNearest(near_, places_, blended_);
      return;
    }
    const EdgeMetric metric = MetricOf(near_);
    turned_ = near_;
    metric.Turn(turned_.x, turned_.y);
    turned_places_ = places_;
    metric.Turn(turned_places_.x, turned_places_.y);
    rtb::BlendNearest(turned_, turned_places_, blended_);
  }

  void MoveToWide(float reliance, std::span<Rgb> out) {
    wide_.resize(out.size(), Rgb(0));
    BlendWide(near_, places_, wide_);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = wide_[i] + (out[i] - wide_[i]) * reliance;
    }
  }

  const ByCell& samples_;
  BlendPlaces places_;
  BlendPlaces turned_places_;
  NearSamples near_;
  NearSamples turned_;
  BlendedPlaces blended_;
  std::vector<Rgb> wide_;
};

}  // namespace

RebuiltRaster Rebuild(const SeenSamples& samples, int width, int height,
                      double cell_aspect, Texture texture, int threads) {
  const ByCell by_cell(samples, cell_aspect);
  const int cells = samples.grid().cells();
  const auto size =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  RebuiltRaster raster{width, height, {}};
  raster.encoded.resize(static_cast<std::size_t>(cells) * size, Rgb(0));
  const std::vector<float> reliances =
      texture == Texture::kExpected
          ? Reliances(by_cell, threads)
          : std::vector<float>(static_cast<std::size_t>(cells), 1.0f);
  ParallelFor(cells, kGrain, threads, [&](int begin, int end) {
    CellBuilder builder(by_cell, width, height);
    for (int cell = begin; cell < end; ++cell) {
      const auto at = static_cast<std::size_t>(cell);
      builder.Build(cell, reliances[at],
                    std::span(raster.encoded).subspan(at * size, size));
    }
  });
  return raster;
}

}  // namespace rtb
