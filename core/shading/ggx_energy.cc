#include "core/shading/ggx_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/math/gauss_legendre.h"

namespace rtb {
namespace {

using Rule = std::vector<QuadraturePoint>;

/// A view direction above microfacets of a given width.
struct View {
  double cosine;
  double sine;
  double alpha;
  double stretched;  ///< sqrt(cosine^2 + alpha^2 sine^2)
};

/// f cos d(wi) / d(slopes), over the slopes' density, of a facet with slope m
/// in azimuth phi from the view: 4 V cos_i (o.h) / h.z.
double Integrand(const View& o, double m, double cos_phi) {
  const double hz2 = 1 / (1 + m * m);
  // o.h = facing * h.z
  const double facing = o.sine * m * cos_phi + o.cosine;
  const double cos_i = 2 * facing * hz2 - o.cosine;
  if (!(cos_i > 0)) return 0;
  const double stretched_i =
      std::sqrt(cos_i * cos_i + o.alpha * o.alpha * (1 - cos_i * cos_i));
  return 2 * facing * cos_i / (cos_i * o.stretched + o.cosine * stretched_i);
}

/// The integral over the slopes of one azimuth that mirror the view upwards.
/// With m = alpha tan(psi) the density of slopes (Walter et al. 2007) is
/// 2 sin(psi) cos(psi) d(psi) d(phi) / 2 pi; t = tan(psi / 2) makes the
/// integrand rational.
double OverSlopes(const View& o, double cos_phi, const Rule& rule) {
  // cos_i > 0 where m^2 - 2 m k - 1 < 0, with k = tan(theta_o) cos(phi).
  const double k = o.sine * cos_phi / std::max(o.cosine, 1e-300);
  const double root = std::sqrt(k * k + 1);
  const double tan_max = (k > 0 ? k + root : 1 / (root - k)) / o.alpha;
  const double t_max = 1 / (1 / tan_max + std::sqrt(1 / tan_max / tan_max + 1));
  double sum = 0;
  for (const QuadraturePoint& q : rule) {
    // Points gather at the steep end, where narrow lobes fall off.
    const double t = t_max * q.x * (2 - q.x);
    const double plus = 1 / (1 + t * t);
    const double minus = 1 - t * t;
    sum += q.weight * (1 - q.x) * t * minus * plus * plus * plus *
           Integrand(o, o.alpha * 2 * t / minus, cos_phi);
  }
  return 16 * t_max * sum;
}

double Loss(double cosine, double alpha, const Rule& rule) {
  const double sine2 = 1 - cosine * cosine;
  const View o{cosine, std::sqrt(sine2), alpha,
               std::sqrt(cosine * cosine + alpha * alpha * sine2)};
  double albedo = 0;
  // Each half of the azimuths is smooth, but they part sharply at grazing
  // views: points gather there.
  for (const QuadraturePoint& q : rule) {
    const double cos_phi = std::sin(std::numbers::pi / 2 * q.x * q.x);
    albedo += q.weight * q.x *
              (OverSlopes(o, cos_phi, rule) + OverSlopes(o, -cos_phi, rule));
  }
  return std::max(0.0, 1 - albedo);
}

/// The table's entry `index`: the square root of the loss.
float RootLossAt(int index, const Rule& rule) {
  // Row 0 stands for the limit.
  const double roughness = std::max(
      1e-3, index / kGgxCosines / static_cast<double>(kGgxRoughnesses - 1));
  const double alpha = roughness * roughness;
  const double y = index % kGgxCosines / static_cast<double>(kGgxCosines - 1);
  const double cosine = alpha * y * y / (1 + alpha - y * y);
  return static_cast<float>(
      std::sqrt(Loss(std::min(1.0, cosine), alpha, rule)));
}

}  // namespace

GgxEnergy MakeGgxEnergy() {
  constexpr int kOrder = 10;
  const Rule rule = GaussLegendre(kOrder);
  GgxEnergy energy;
  energy.root_loss.resize(kGgxRoughnesses * kGgxCosines);
  ParallelFor(kGgxRoughnesses, 1, 0, [&](int begin, int end) {
    for (int i = begin * kGgxCosines; i < end * kGgxCosines; ++i) {
      energy.root_loss[static_cast<std::size_t>(i)] = RootLossAt(i, rule);
    }
  });
  return energy;
}

GgxEnergyView ViewOf(const GgxEnergy& energy) {
  if (energy.root_loss.empty()) return {};
  RTB_CHECK_EQ(energy.root_loss.size(),
               std::size_t{kGgxRoughnesses * kGgxCosines});
  return {energy.root_loss.data()};
}

double GgxLossByQuadrature(double cosine, double alpha, int order) {
  return Loss(cosine, alpha, GaussLegendre(order));
}

float GgxAverageLoss(const GgxEnergyView& energy, float alpha) {
  // With cos + alpha = alpha ((1 + alpha) / alpha)^w, w = 0..1, the points
  // are as dense around cos = alpha as around 1; 2 cos is the weight.
  constexpr int kPoints = 1024;
  const double width = alpha;
  const double log_range = std::log((1 + width) / width);
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double shifted = width * std::exp(log_range * (i + 0.5) / kPoints);
    const double cosine = shifted - width;
    sum += 2 * cosine * shifted * log_range / kPoints *
           GgxLoss(energy, static_cast<float>(cosine), alpha);
  }
  return static_cast<float>(sum);
}

}  // namespace rtb
