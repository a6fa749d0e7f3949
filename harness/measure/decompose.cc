#include "harness/measure/decompose.h"

#include <utility>

#include "encoders/modifiers/raster.h"
#include "harness/cell_shape.h"
#include "harness/image_source.h"
#include "harness/measure/capacity.h"
#include "harness/metrics/flip_map.h"
#include "harness/metrics/mse.h"
#include "harness/metrics/rows.h"
#include "harness/rasters.h"

namespace rtb {
namespace {

double Mse(const Image& reference, const Image& test, int threads) {
  return MeanSquaredError(MetricInput(reference, test, threads));
}

/// An image brought to the size at which a run is compared.
Result<Image> Matched(const ErrorInput& input, const Image& image) {
  RTB_ASSIGN_OR_RETURN(RasterPair pair,
                       MatchRasters(input.reference, image, "--reference"));
  return std::move(pair.test);
}

Result<ErrorSteps> MakeSteps(const ErrorInput& input) {
  ErrorSteps steps;
  RTB_ASSIGN_OR_RETURN(const Image decoded,
                       Decode(input.encoding.grid, input.decode));
  RTB_ASSIGN_OR_RETURN(RasterPair pair,
                       MatchRasters(input.reference, decoded, "--reference"));
  steps.reference = std::move(pair.reference);
  steps.grid = std::move(pair.test);
  RTB_ASSIGN_OR_RETURN(steps.converged, Matched(input, input.converged));
  RTB_ASSIGN_OR_RETURN(
      steps.fragments,
      Matched(input, FragmentsImage(input.encoding, input.decode)));
  return steps;
}

/// MSE of the grid decoded by these masks.
Result<double> MseOfMasks(const ErrorInput& input, const Image& reference,
                          MaskSource masks) {
  DecodeOptions decode = input.decode;
  decode.masks = masks;
  RTB_ASSIGN_OR_RETURN(const Image raw, Decode(input.encoding.grid, decode));
  RTB_ASSIGN_OR_RETURN(const Image decoded, Matched(input, raw));
  return Mse(reference, decoded, decode.threads);
}

std::optional<double> FontTerm(const ErrorInput& input,
                               const Image& reference) {
  const auto font = MseOfMasks(input, reference, MaskSource::kFont);
  const auto geometric = MseOfMasks(input, reference, MaskSource::kGeometric);
  if (!font || !geometric) return std::nullopt;
  return *font - *geometric;
}

/// The reference as the same encoder draws it when it sees the reference.
Result<Image> DrawReference(const ErrorInput& input) {
  const Image linear = LinearOf(input.reference);
  ImageSource source(linear, Fit::kStretch, input.decode.threads);
  EncodeContext context;
  context.seed = input.scene.options.seed;
  context.threads = input.decode.threads;
  context.depth = input.depth;
  RTB_ASSIGN_OR_RETURN(const Encoding encoding,
                       input.encoder.Run(source, input.encoding.grid.size,
                                         CellAspect(input.decode), context));
  RTB_ASSIGN_OR_RETURN(const Image raw, Decode(encoding.grid, input.decode));
  return Matched(input, raw);
}

FlipDistances FlipBetween(const ErrorInput& input, const ErrorSteps& steps) {
  const auto flip = [&](const Image& a, const Image& b) {
    return MeanFlip(MetricInput(a, b, input.decode.threads));
  };
  FlipDistances distances{flip(steps.reference, steps.converged),
                          flip(steps.converged, steps.fragments),
                          flip(steps.fragments, steps.grid),
                          flip(steps.reference, steps.grid), std::nullopt};
  const auto drawn = DrawReference(input);
  if (drawn) distances.oracle = flip(steps.reference, *drawn);
  return distances;
}

}  // namespace

Image FragmentsImage(const Encoding& encoding, const DecodeOptions& decode) {
  const int width = decode.cell_width;
  const int height = decode.cell_height;
  const GridSize grid = encoding.grid.size;
  const SampleRaster raster = NearestRaster(encoding.evidence, width, height,
                                            Blend::kSrgb, decode.threads);
  Image image(grid.columns * width, grid.rows * height);
  ForRows(image.height(), decode.threads, [&](int y) {
    for (int x = 0; x < image.width(); ++x) {
      const int cell = y / height * grid.columns + x / width;
      const int at = y % height * width + x % width;
      image.at(x, y) = Rgb(raster.cell(cell)[static_cast<std::size_t>(at)]);
    }
  });
  return image;
}

MseTerms SplitMse(const ErrorSteps& steps, int threads) {
  const int width = steps.reference.width();
  const int height = steps.reference.height();
  // Mean over pixels and channels of f(b, s, e).
  const auto mean = [&](const auto& f) {
    return MeanOverPixels(width, height, threads,
                          [&](int x, int y) {
                            const V3d r(steps.reference.at(x, y));
                            const V3d i(steps.converged.at(x, y));
                            const V3d n(steps.fragments.at(x, y));
                            const V3d t(steps.grid.at(x, y));
                            return f(i - r, n - i, t - n);
                          }) /
           3;
  };
  MseTerms terms;
  terms.render = mean([](V3d b, V3d, V3d) { return b.length2(); });
  terms.sampling = mean([](V3d, V3d s, V3d) { return s.length2(); });
  terms.encoding = mean([](V3d, V3d, V3d e) { return e.length2(); });
  terms.render_sampling = mean([](V3d b, V3d s, V3d) { return 2 * b.dot(s); });
  terms.render_encoding = mean([](V3d b, V3d, V3d e) { return 2 * b.dot(e); });
  terms.sampling_encoding =
      mean([](V3d, V3d s, V3d e) { return 2 * s.dot(e); });
  terms.total = Mse(steps.reference, steps.grid, threads);
  return terms;
}

Result<InnerTerms> SplitEncoding(const ErrorInput& input) {
  const CellGrid& grid = input.encoding.grid;
  const DecodeOptions& decode = input.decode;
  RTB_ASSIGN_OR_RETURN(
      const Atlas atlas,
      MakeAtlas(GlyphsOfRun(input.encoder, grid), decode.cell_width,
                decode.cell_height, decode.masks, decode.font));
  RTB_ASSIGN_OR_RETURN(const Image decoded, Decode(grid, decode));
  const Image seen = FragmentsImage(input.encoding, decode);
  const double capacity = Capacity(seen, grid.size, atlas, decode.threads);
  const double masks = CapacityOfMasks(seen, grid, atlas, decode.threads);
  const double all = Mse(seen, decoded, decode.threads);
  return InnerTerms{capacity, masks - capacity, all - masks};
}

Result<Decomposition> Decompose(const ErrorInput& input) {
  Decomposition parts;
  RTB_ASSIGN_OR_RETURN(const ErrorSteps steps, MakeSteps(input));
  parts.mse = SplitMse(steps, input.decode.threads);
  parts.mse.font = FontTerm(input, steps.reference);
  parts.flip = FlipBetween(input, steps);
  RTB_ASSIGN_OR_RETURN(parts.inner, SplitEncoding(input));
  return parts;
}

}  // namespace rtb
