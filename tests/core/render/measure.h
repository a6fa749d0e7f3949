// What the renderer's tests ask of pictures: means with their errors, and how
// two pictures differ.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/core/render/scenes.h"

namespace rtb::testing {

inline constexpr double kPiExact = std::numbers::pi;

/// A mean of independent numbers and its standard error, from their spread.
struct Estimate {
  double mean = 0;
  double error = 0;
};

inline Estimate EstimateOf(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) sum += v;
  for (const double v : values) squares += (v - sum / n) * (v - sum / n);
  return {sum / n, std::sqrt(squares / (n - 1) / n)};
}

/// The options of one integrator.
inline RenderOptions By(const char* integrator, int max_depth, int spp = 1) {
  RenderOptions options;
  options.integrator = integrator;
  options.max_depth = max_depth;
  options.spp = spp;
  return options;
}

/// The pictures of `runs` seeds: independent estimates of the same.
inline std::vector<Fragments> Runs(const SceneBuilder& b,
                                   const SamplePlan& plan,
                                   RenderOptions options, int runs,
                                   std::uint64_t first_seed = 1) {
  auto backend = MakeBackend("embree", b.scene).value();
  std::vector<Fragments> pictures;
  for (int i = 0; i < runs; ++i) {
    options.seed = first_seed + static_cast<std::uint64_t>(i);
    pictures.push_back(backend->Render(plan, options).value());
  }
  return pictures;
}

/// Green of one sample over pictures.
inline Estimate GreenOf(const std::vector<Fragments>& pictures,
                        std::size_t sample) {
  std::vector<double> values;
  for (const Fragments& f : pictures) values.push_back(f.values[sample].y);
  return EstimateOf(values);
}

/// Green of the single ray's direction at the center of a very narrow view.
inline Estimate CenterEstimate(SceneBuilder b, const RenderOptions& options,
                               int runs = 16) {
  b.scene.camera.vfov = 1e-3;
  return GreenOf(Runs(b, PixelPlan(1, 1), options, runs), 0);
}

/// How many samples of two pictures differ by more than `tolerance`.
inline int CountOff(const Fragments& a, const Fragments& b, float tolerance) {
  int off = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const Rgb d = a.values[i] - b.values[i];
    const float worst = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    off += !(worst <= tolerance);
  }
  return off;
}

/// How many samples are not black.
inline int CountLit(const Fragments& f) {
  return static_cast<int>(
      std::count_if(f.values.begin(), f.values.end(),
                    [](const Rgb& v) { return v != Rgb(0); }));
}

}  // namespace rtb::testing
