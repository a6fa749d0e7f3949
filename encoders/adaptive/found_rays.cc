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
  for (const FoundRays& part : parts) count += part.count;
  return count;
}

/// What the last of the wanted rays gains.
float LeastOf(std::span<const FoundRays> parts, int count,
              const GainThreshold& threshold) {
  const auto [from, to, above] = threshold.Of(count);
  std::vector<float> gains(CountOf(parts) + 1);  // One to write past them.
  std::size_t found = 0;
  for (const FoundRays& part : parts) {
    for (const RayChoice& ray : part.found()) {
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

/// Puts the rays that gain so much, by rising cells.
/// @param out room for all of the part's, and one more.
/// @return how many.
std::size_t PutFrom(float least, const FoundRays& part, RayChoice* out) {
  const auto place = [&part](const RayChoice& ray) {
    return static_cast<std::size_t>(ray.cell - part.begin);
  };
  // Of each cell, where its next one goes; what is not taken goes to the end.
  std::vector<std::uint32_t> next(
      static_cast<std::size_t>(part.end - part.begin));
  for (const RayChoice& ray : part.found()) {
    next[place(ray)] += ray.gain >= least ? 1 : 0;
  }
  std::uint32_t count = 0;
  for (std::uint32_t& cell : next) count += std::exchange(cell, count);
  for (const RayChoice& ray : part.found()) {
    const std::uint32_t taken = ray.gain >= least ? 1 : 0;
    std::uint32_t& cell = next[place(ray)];
    // Without a branch, which would be a guess.
    out[taken * cell + (1 - taken) * count] = ray;
    cell += taken;
  }
  return count;
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

void FoundRays::Add(std::size_t each, std::span<const int> counts) {
  rays.resize(std::max(rays.size(), count + counts.size() * each));
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    const auto own = static_cast<std::size_t>(counts[cell]);
    // All of them: how many count cannot be guessed.
    for (std::size_t i = 0; i < each; ++i) {
      rays[count + i] = scratch[cell * each + i];
    }
    count += own;
  }
}

std::vector<RayChoice> TakeBest(std::span<const FoundRays> parts, int count,
                                const GainThreshold& threshold) {
  const float least = LeastOf(parts, count, threshold);
  std::vector<RayChoice> rays(CountOf(parts) + 1);  // One to write past them.
  std::size_t found = 0;
  for (const FoundRays& part : parts) {
    found += PutFrom(least, part, rays.data() + found);
  }
  rays.resize(found);
  const auto most = static_cast<std::size_t>(count);
  return found > most ? WithoutSurplus(rays, most, least) : rays;
}

}  // namespace rtb
