/// @file
/// The survey of all candidates for many cells at once: each vector lane is a
/// cell. It bounds every candidate's error from below in single precision; who
/// asks decides with the bounds, and finishes what they leave open exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vec.h"
#include "encoders/fit/survey_plan.h"
#include "encoders/steps.h"

namespace rtb {

/// What the survey found of as many cells as there are lanes. Values of one
/// kind stand lane by lane, `stride` lanes apart: of lane i the channel c of
/// sample s is steps[(3 s + c) * stride + i]. Squared errors are in codes.
struct SurveyBatch {
  explicit SurveyBatch(const SurveyPlan& plan);

  /// Room for the lanes of any instruction set.
  static constexpr std::size_t stride = 16;

  template <class T>
  using Values = std::vector<T>;

  Values<std::int32_t> steps;  ///< Samples, in steps.
  Values<std::int32_t> mean;   ///< Of each channel, nearly, in whole steps.
  Values<std::int32_t> rest;   ///< Sum of the samples - n mean.
  Values<std::int32_t> bands;  ///< Sums of samples - mean.
  Values<std::int32_t> sums;   ///< Correlations of kDifference, exactly.
  Values<float> pixels;        ///< Samples - mean, for kPixels.
  Values<float> spread;        ///< Bound of the sum of squares around the mean.
  /// Of each candidate of the plan the error, less the sum of squares; a lower
  /// bound but for rounding errors.
  Values<float> errors;
  Values<float> least;          ///< The least of these.
  Values<float> second;         ///< The least of the others.
  Values<std::int32_t> chosen;  ///< Position in the plan of the least.
};

/// Surveys cells of linear samples, unclipped, one cell's after the other's,
/// and calls `decide(context, first, lanes)` after each batch of cells.
/// @return the number of cells surveyed: a multiple of the lanes.
using SurveyCallback = void (*)(void* context, std::size_t first,
                                std::size_t lanes);
std::size_t SurveyCells(const SurveyPlan& plan, std::span<const Rgb> linear,
                        std::size_t cells, SurveyBatch& batch,
                        SurveyCallback decide, void* context);

}  // namespace rtb
