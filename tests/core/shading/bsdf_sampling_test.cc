#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "tests/core/shading/bsdf_cases.h"
#include "tests/core/shading/chi_square.h"
#include "tests/core/shading/direction_charts.h"

namespace rtb {
namespace {

constexpr std::array<float, 4> kCosines = {0.05f, 0.3f, 0.8f, 1.0f};
constexpr int kBinsX = 32;
constexpr int kBinsY = 24;

/// The index of a chart's bin; the last index is for what is off the chart.
std::size_t BinOf(const V2d& p) {
  if (!(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1)) return kBinsX * kBinsY;
  return static_cast<std::size_t>(p.x * kBinsX) * kBinsY +
         static_cast<std::size_t>(p.y * kBinsY);
}

/// The integral of the pdf over one bin.
template <class Chart>
double PdfOverBin(const BsdfData& bsdf, const V3f& wo, const Chart& chart,
                  int x, int y) {
  static const std::vector<QuadraturePoint> kRule = GaussLegendre(6);
  double sum = 0;
  for (const QuadraturePoint& p : kRule) {
    for (const QuadraturePoint& q : kRule) {
      const ChartPoint at =
          chart.At(V2d((x + p.x) / kBinsX, (y + q.x) / kBinsY));
      sum += p.weight * q.weight * at.stretch *
             PdfBsdf(bsdf, TestEnergy(), wo, at.direction);
    }
  }
  return sum / (kBinsX * kBinsY);
}

/// The p-value of `count` samples against the pdf.
template <class Chart>
double SamplesAgainstPdf(const BsdfData& bsdf, const V3f& wo,
                         const Chart& chart, int count, std::uint64_t seed) {
  std::vector<ChiSquareBin> bins(kBinsX * kBinsY + 1);
  double rest = count;
  for (int x = 0; x < kBinsX; ++x) {
    for (int y = 0; y < kBinsY; ++y) {
      const double expected = count * PdfOverBin(bsdf, wo, chart, x, y);
      bins[static_cast<std::size_t>(x * kBinsY + y)].expected = expected;
      rest -= expected;
    }
  }
  // Delta samples and those that went below the surface.
  bins.back().expected = rest;
  for (int i = 0; i < count; ++i) {
    const BsdfSample sample =
        SampleBsdf(bsdf, TestEnergy(), wo,
                   RandomUniforms(static_cast<std::uint32_t>(i), seed));
    const bool drawn = sample.pdf > 0;
    ++bins[drawn ? BinOf(chart.Of(sample.wi)) : bins.size() - 1].observed;
  }
  // Rounding leaves a rest where there is none.
  if (bins.back().observed == 0 && std::abs(rest) < 1e-3 * count) {
    bins.pop_back();
  }
  return ChiSquarePValue(bins);
}

class BsdfSamplingTest : public testing::TestWithParam<BsdfCase> {};

TEST_P(BsdfSamplingTest, SamplesFollowThePdf) {
  const BsdfData& bsdf = GetParam().bsdf;
  const int tests =
      static_cast<int>(2 * kCosines.size() * SpreadCases().size());
  const double level = SidakLevel(0.01, tests);
  std::uint64_t seed = 1;
  for (const float cosine : kCosines) {
    const V3f wo = DirectionAt(cosine);
    const float width = bsdf.alpha > 0 ? bsdf.alpha : 1.0f;
    EXPECT_GT(
        SamplesAgainstPdf(bsdf, wo, HalfVectorChart(wo, width), 50000, ++seed),
        level)
        << "half vectors, cosine " << cosine;
    // Lobes that are narrow against the bins are beyond the quadrature.
    if (width < 0.3f) continue;
    EXPECT_GT(SamplesAgainstPdf(bsdf, wo, SphereChart(), 50000, ++seed), level)
        << "sphere, cosine " << cosine;
  }
}

TEST_P(BsdfSamplingTest, WeightIsTheValueOverThePdf) {
  const BsdfData& bsdf = GetParam().bsdf;
  for (const float cosine : kCosines) {
    const V3f wo = DirectionAt(cosine);
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const BsdfSample s =
          SampleBsdf(bsdf, TestEnergy(), wo, RandomUniforms(i, 7));
      if (s.delta) continue;
      if (s.pdf == 0) {
        EXPECT_EQ(s.weight, Rgb(0));
        EXPECT_LE(s.wi.z, 0);
        continue;
      }
      EXPECT_GT(s.wi.z, 0);
      EXPECT_NEAR(s.wi.length(), 1, 1e-6);
      EXPECT_EQ(s.pdf, PdfBsdf(bsdf, TestEnergy(), wo, s.wi));
      const Rgb value = EvalBsdf(bsdf, TestEnergy(), wo, s.wi) * s.wi.z / s.pdf;
      EXPECT_LT((s.weight - value).length(), 1e-5f * (1 + value.length()));
    }
  }
}

TEST_P(BsdfSamplingTest, WeightsAreBounded) {
  // No weight is far above the albedo: neither lobe can be drawn rarely where
  // it matters.
  for (const float cosine : {0.001f, 0.02f, 0.3f, 1.0f}) {
    for (std::uint32_t i = 0; i < 5000; ++i) {
      const BsdfSample s =
          SampleBsdf(GetParam().bsdf, TestEnergy(), DirectionAt(cosine),
                     RandomUniforms(i, 8));
      EXPECT_LT(MaxComponent(s.weight), 4) << cosine;
      EXPECT_GE(s.weight.x, 0);
    }
  }
}

TEST_P(BsdfSamplingTest, SamplesEstimateTheIntegralOfTheValue) {
  const BsdfData& bsdf = GetParam().bsdf;
  constexpr std::uint32_t kCount = 20000;
  for (const float cosine : kCosines) {
    const V3f wo = DirectionAt(cosine);
    double sum = 0;
    double squares = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const BsdfSample s =
          SampleBsdf(bsdf, TestEnergy(), wo, RandomUniforms(i, 10));
      const double weight = s.delta ? 0 : s.weight.x;
      sum += weight / kCount;
      squares += weight * weight / kCount;
    }
    const double deviation = std::sqrt((squares - sum * sum) / kCount);
    // 4 sigma: 60 comparisons fail by accident with a chance of 0.4 %.
    EXPECT_NEAR(sum, SpreadAlbedo(bsdf, wo).x, 4 * deviation + 1e-5)
        << "cosine " << cosine;
  }
}

TEST_P(BsdfSamplingTest, PdfIntegratesToTheChanceOfASpreadSample) {
  const BsdfData& bsdf = GetParam().bsdf;
  constexpr std::uint32_t kCount = 20000;
  for (const float cosine : kCosines) {
    const V3f wo = DirectionAt(cosine);
    const double integral = HemisphereIntegral(bsdf, wo, [&](const V3f& wi) {
                              return V3f(PdfBsdf(bsdf, TestEnergy(), wo, wi));
                            }).x;
    EXPECT_LE(integral, 1 + 1e-4);
    double drawn = 0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const V3f u = RandomUniforms(i, 11);
      drawn += SampleBsdf(bsdf, TestEnergy(), wo, u).pdf > 0;
    }
    const double share = drawn / kCount;
    const double deviation = std::sqrt(share * (1 - share) / kCount);
    EXPECT_NEAR(integral, share, 4 * deviation + 1e-4);
  }
}

TEST_P(BsdfSamplingTest, Reciprocal) {
  const BsdfData& bsdf = GetParam().bsdf;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const V3f u = RandomUniforms(i, 9);
    const V3f wo = DirectionAt(0.01f + 0.99f * u.x, 6 * u.y);
    // Half the pairs lie near the mirror direction, where lobes are high.
    const V3f wi = i % 2 == 0 ? SampleBsdf(bsdf, TestEnergy(), wo, u).wi
                              : DirectionAt(0.01f + 0.99f * u.z, 50 * u.y);
    const Rgb there = EvalBsdf(bsdf, TestEnergy(), wo, wi);
    const Rgb back = EvalBsdf(bsdf, TestEnergy(), wi, wo);
    EXPECT_LT((there - back).length(), 1e-4f * (there.length() + 1e-6f));
  }
}

TEST_P(BsdfSamplingTest, NothingBelowTheSurface) {
  const BsdfData& bsdf = GetParam().bsdf;
  const V3f up = DirectionAt(0.6f);
  const V3f down = DirectionAt(-0.4f);
  for (const auto& [wo, wi] : {std::pair{up, down},
                               {down, up},
                               {down, down},
                               {V3f(1, 0, 0), up},
                               {up, V3f(1, 0, 0)}}) {
    EXPECT_EQ(EvalBsdf(bsdf, TestEnergy(), wo, wi), Rgb(0));
    EXPECT_EQ(PdfBsdf(bsdf, TestEnergy(), wo, wi), 0);
  }
  EXPECT_EQ(SampleBsdf(bsdf, TestEnergy(), down, V3f(0.5f)).weight, Rgb(0));
}

TEST_P(BsdfSamplingTest, FiniteAtTheEdges) {
  const BsdfData& bsdf = GetParam().bsdf;
  constexpr float kLast = 0x1.fffffep-1f;
  for (const float cosine : {1e-20f, 1e-7f, 0.5f, 1.0f}) {
    for (int corner = 0; corner < 8; ++corner) {
      const V3f u(corner & 1 ? kLast : 0, corner & 2 ? kLast : 0,
                  corner & 4 ? kLast : 0);
      const BsdfSample s =
          SampleBsdf(bsdf, TestEnergy(), DirectionAt(cosine), u);
      EXPECT_TRUE(std::isfinite(s.pdf));
      EXPECT_TRUE(std::isfinite(s.weight.length()));
      EXPECT_NEAR(s.wi.length(), 1, 1e-6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryBsdf, BsdfSamplingTest,
                         testing::ValuesIn(SpreadCases()),
                         [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace rtb
