#include "encoders/adaptive/found_rays.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace rtb {
namespace {

/// Of equal gains those of a cell's first rays count first.
constexpr std::size_t kFew = 2;

std::size_t CountOf(std::span<const FoundRays> parts) {
  std::size_t count = 0;
  for (const FoundRays& part : parts) count += part.rays.size();
  return count;
}

/// What the last of the wanted rays gains.
float LeastOf(std::span<const FoundRays> parts, int count,
              const GainThreshold& threshold) {
  const auto [from, to, above] = threshold.Of(count);
  std::vector<float> gains(CountOf(parts) + 1);  // One to write past them.
  std::size_t found = 0;
  for (const FoundRays& part : parts) {
    for (const RayChoice& ray : part.rays) {
      gains[found] = ray.gain;
      // Without a branch, which would be a guess.
      found += static_cast<std::size_t>((ray.gain >= from) & (ray.gain < to));
    }
  }
  const auto nth = static_cast<std::size_t>(count - above);
  if (nth > found) return 0;
  const auto at = gains.begin() + static_cast<std::ptrdiff_t>(nth) - 1;
  std::nth_element(gains.begin(), at,
                   gains.begin() + static_cast<std::ptrdiff_t>(found),
                   std::greater<>());
  return *at;
}

/// Adds the rays that gain so much, by rising cells.
void AddFrom(float least, const FoundRays& part, std::vector<RayChoice>& rays) {
  const auto place = [&part](const RayChoice& ray) {
    return static_cast<std::size_t>(ray.cell - part.begin);
  };
  // Of each cell, where its next one goes; what is not taken goes to the end.
  std::vector<std::size_t> next(
      static_cast<std::size_t>(part.end - part.begin));
  for (const RayChoice& ray : part.rays) {
    next[place(ray)] += ray.gain >= least ? 1 : 0;
  }
  std::size_t at = rays.size();
  for (std::size_t& cell : next) at += std::exchange(cell, at);
  rays.resize(at + 1);
  for (const RayChoice& ray : part.rays) {
    const bool taken = ray.gain >= least;
    std::size_t& cell = next[place(ray)];
    rays[taken ? cell : at] = ray;
    cell += taken ? 1 : 0;
  }
  rays.pop_back();
}

/// Whether a ray is the n-th or a later one of its cell.
bool IsLater(std::span<const RayChoice> rays, std::size_t i, std::size_t n) {
  return i >= n && rays[i - n].cell == rays[i].cell;
}

/// Of the rays that gain `least` and no more, leaves out those that are too
/// many.
/// @param rays what gains more or as much, by rising cells.
std::vector<RayChoice> WithoutSurplus(std::span<const RayChoice> rays,
                                      std::size_t count, float least) {
  std::size_t more = 0;
  std::size_t early = 0;  // Cells' first ones.
  bool wanted = false;    // Whether some cell's later ones gain more.
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!IsLater(rays, i, kFew)) ++early;
    if (rays[i].gain == least) continue;
    ++more;
    if (IsLater(rays, i, kFew - 1)) wanted = true;
  }
  const bool later = wanted || early < count;
  std::size_t equal = count - more;
  std::vector<RayChoice> left;
  left.reserve(count);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].gain == least) {
      if (equal == 0 || (!later && IsLater(rays, i, kFew))) continue;
      --equal;
    }
    left.push_back(rays[i]);
  }
  return left;
}

}  // namespace

std::vector<RayChoice> TakeBest(std::span<const FoundRays> parts, int count,
                                const GainThreshold& threshold) {
  const float least = LeastOf(parts, count, threshold);
  std::vector<RayChoice> rays;
  rays.reserve(CountOf(parts) + 1);
  for (const FoundRays& part : parts) AddFrom(least, part, rays);
  const auto most = static_cast<std::size_t>(count);
  return rays.size() > most ? WithoutSurplus(rays, most, least) : rays;
}

}  // namespace rtb
