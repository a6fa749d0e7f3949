/// @file
/// EdgeMetric: distances that count more across edges than along them.
#pragma once

#include <span>

#include "encoders/adaptive/blend_nearest.h"

namespace rtb {

/// A symmetric linear map of determinant 1. What it makes of two places lies
/// farther apart than they where colors change from one to the other, nearer
/// where they stay: so that the samples nearest to a place are those on its
/// side of an edge.
struct EdgeMetric {
  float xx = 1;
  float xy = 0;
  float yy = 1;

  /// Maps places, as many x as y.
  void Turn(std::span<float> x, std::span<float> y) const;
};

/// The metric of samples around a cell; the identity where they are alike or
/// differ alike in all directions. As the steering matrix of Takeda, Farsiu and
/// Milanfar, "Kernel Regression for Image Processing and Reconstruction", IEEE
/// Trans. Image Processing 16(2), 2007, from pairs of samples in place of the
/// gradients that scattered samples do not have.
/// @param near any number of samples; of more than some tens only as many.
EdgeMetric MetricOf(const NearSamples& near);

}  // namespace rtb
