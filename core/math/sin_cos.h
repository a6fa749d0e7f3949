/// @file
/// SinCosOf: sine and cosine by + - * alone, so that host and device agree in
/// every bit. Host and device.
#pragma once

#include "core/base/host_device.h"

namespace rtb {

/// Sine and cosine of one angle.
struct SineCosine {
  float sine, cosine;
};

/// The polynomials of Arm's optimized-routines (sincosf_data.c), which are
/// glibc's since 2.28; and pi / 2 in two parts, so that products with 0 .. 4
/// are exact.
struct SinCosTerms {
  static constexpr double kQuartersPerRadian = 0x1.45F306DC9C883p-1;
  static constexpr double kQuarterHigh = 0x1.921FB544p0;
  static constexpr double kQuarterLow = 0x1.0B46p-34;
  static constexpr double kC1 = -0x1.ffffffd0c621cp-2;
  static constexpr double kC2 = 0x1.55553e1068f19p-5;
  static constexpr double kC3 = -0x1.6c087e89a359dp-10;
  static constexpr double kC4 = 0x1.99343027bf8c3p-16;
  static constexpr double kS1 = -0x1.555545995a603p-3;
  static constexpr double kS2 = 0x1.1107605230bc4p-7;
  static constexpr double kS3 = -0x1.994eb3774cf24p-13;
};

/// In double precision, rounded: what std::sin and std::cos give on hosts with
/// that glibc (sin_cos_test.cc), at less than their price.
/// @param angle within [-2 pi, 2 pi]; NaN gives NaN.
RTB_HD inline SineCosine SinCosOf(float angle) {
  using T = SinCosTerms;
  const double x = angle < 0 ? -angle : angle;
  const bool usable = x < 7;  // NaN is no int
  const int quarters =
      usable ? static_cast<int>(x * T::kQuartersPerRadian + 0.5) : 0;
  const double y = (x - quarters * T::kQuarterHigh) - quarters * T::kQuarterLow;
  const double y2 = y * y;
  const double y4 = y2 * y2;
  const double c =
      (1 + y2 * T::kC1 + y4 * T::kC2) + y4 * y2 * (T::kC3 + y2 * T::kC4);
  const double s = (y + y * y2 * T::kS1) + y * y4 * (T::kS2 + y2 * T::kS3);
  const bool swapped = (quarters & 1) != 0;
  const auto sine = static_cast<float>(swapped ? c : s);
  const auto cosine = static_cast<float>(swapped ? s : c);
  const bool sine_falls = (quarters & 2) != 0;
  const bool cosine_falls = ((quarters + 1) & 2) != 0;
  return {sine_falls != (angle < 0) ? -sine : sine,
          cosine_falls ? -cosine : cosine};
}

}  // namespace rtb
