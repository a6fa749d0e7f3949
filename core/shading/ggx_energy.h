/// @file
/// The energy that one bounce off GGX microfacets loses, as a table for the
/// multiple-scattering compensation of metal and plastic (Kulla and Conty,
/// "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course).
///
/// The loss 1 - E of a white surface's directional albedo E is a function of
/// cos / alpha alone as alpha goes to 0. The table is therefore laid out over
/// y = sqrt(cos (1 + alpha) / (cos + alpha)) and roughness = sqrt(alpha), and
/// holds the loss' square root, which is close to linear in y at both ends:
/// linear interpolation is then good to 2e-4 at every angle, grazing included.
#pragma once

#include <cmath>
#include <vector>

#include "core/base/host_device.h"

namespace rtb {

/// Rows and columns of the table.
inline constexpr int kGgxRoughnesses = 64;
inline constexpr int kGgxCosines = 72;

/// The table, owned by the host: row by roughness, column by y, both 0..1.
struct GgxEnergy {
  std::vector<float> root_loss;
};

/// The same as a bare pointer, for host and device code.
struct GgxEnergyView {
  const float* root_loss = nullptr;
};

/// Computes the table by float64 quadrature: about 10 ms of one core, on all
/// cores, the same whatever their number.
GgxEnergy MakeGgxEnergy();

/// A view of a GgxEnergy, which must outlive it; a null one of an empty one.
GgxEnergyView ViewOf(const GgxEnergy& energy);

/// 1 - E by float64 quadrature, for any alpha > 0 and cosine in 0..1: what
/// the table holds the square root of.
/// @param order points per dimension; 10 give 1e-4, 48 give 1e-7.
double GgxLossByQuadrature(double cosine, double alpha, int order);

/// The cosine-weighted mean over the hemisphere of what GgxLoss returns for
/// that alpha: consistent with the interpolation, so that a white metal
/// reflects what the table says it lost, no more and no less.
float GgxAverageLoss(const GgxEnergyView& energy, float alpha);

/// 1 - E(cosine, alpha), interpolated.
RTB_HD inline float GgxLoss(const GgxEnergyView& energy, float cosine,
                            float alpha) {
  const float y = std::sqrt(cosine * (1 + alpha) / (cosine + alpha));
  const float column = (y < 1 ? y : 1.0f) * (kGgxCosines - 1);
  const float row = std::sqrt(alpha) * (kGgxRoughnesses - 1);
  const int c =
      column < kGgxCosines - 2 ? static_cast<int>(column) : kGgxCosines - 2;
  const int r =
      row < kGgxRoughnesses - 2 ? static_cast<int>(row) : kGgxRoughnesses - 2;
  const float s = column - static_cast<float>(c);
  const float t = row - static_cast<float>(r);
  const float* low = energy.root_loss + r * kGgxCosines + c;
  const float* high = low + kGgxCosines;
  const float root = (1 - t) * ((1 - s) * low[0] + s * low[1]) +
                     t * ((1 - s) * high[0] + s * high[1]);
  return root * root;
}

}  // namespace rtb
