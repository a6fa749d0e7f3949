#include "encoders/tiv_cell.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace rtb {
namespace {

constexpr int kPixels = kTivPixels;
using Pixels = std::span<const Rgb8, kPixels>;
using Bitmap = std::uint32_t;

constexpr bool IsSet(Bitmap bitmap, std::size_t pixel) {
  return (bitmap >> (kPixels - 1 - pixel) & 1) != 0;
}

/// The most frequent color and the second; the same where there is just one.
struct Dominant {
  Rgb8 first, second;
  bool direct;  ///< Together they cover more than half of the pixels.
};

Dominant FindDominant(Pixels pixels) {
  struct Counted {
    int count;
    Rgb8 color;
    auto operator<=>(const Counted&) const = default;
  };
  std::array<Rgb8, kPixels> sorted;
  std::ranges::copy(pixels, sorted.begin());
  std::ranges::sort(sorted);
  // Of equal counts the larger 0xRRGGBB comes first: what Rgb8's order says.
  Counted first{};
  Counted second{};
  for (auto run = sorted.begin(); run != sorted.end();) {
    const auto end = std::find_if(
        run, sorted.end(), [run](const Rgb8& color) { return color != *run; });
    const Counted counted{static_cast<int>(end - run), *run};
    if (counted > first) {
      second = std::exchange(first, counted);
    } else {
      second = std::max(second, counted);
    }
    run = end;
  }
  const bool direct = first.count + second.count > kPixels / 2;
  return {first.color, second.count > 0 ? second.color : first.color, direct};
}

int SquaredDistance(Rgb8 a, Rgb8 b) {
  const int r = a.r - b.r;
  const int g = a.g - b.g;
  const int blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

/// Pixels that `is_set` accepts.
template <class Predicate>
Bitmap BitmapOf(Pixels pixels, const Predicate& is_set) {
  Bitmap bitmap = 0;
  for (const Rgb8& pixel : pixels) bitmap = bitmap << 1 | is_set(pixel);
  return bitmap;
}

Bitmap DirectBitmap(Pixels pixels, const Dominant& dominant) {
  return BitmapOf(pixels, [&](const Rgb8& pixel) {
    return SquaredDistance(pixel, dominant.first) >
           SquaredDistance(pixel, dominant.second);
  });
}

/// The channel of the largest range, split at its middle.
Bitmap RangeBitmap(Pixels pixels) {
  std::uint8_t Rgb8::*widest = nullptr;
  int widest_range = -1;
  int split = 0;
  for (const auto channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
    const auto [low, high] = std::ranges::minmax(pixels, {}, channel);
    const int range = high.*channel - low.*channel;
    if (range <= widest_range) continue;
    widest = channel;
    widest_range = range;
    split = low.*channel + range / 2;
  }
  return BitmapOf(pixels,
                  [&](const Rgb8& pixel) { return pixel.*widest > split; });
}

/// The nearest glyph, and whether its complement is what came near.
struct Match {
  TivGlyph glyph = kTivDefault;
  bool complemented = false;
};

Match FindGlyph(Bitmap bitmap) {
  Match best;
  int best_distance = kTivTooFar;
  for (const TivGlyph& glyph : kTivGlyphs) {
    for (const bool complemented : {false, true}) {
      const Bitmap pattern = complemented ? ~glyph.pattern : glyph.pattern;
      const int distance = std::popcount(pattern ^ bitmap);
      if (distance >= best_distance) continue;
      best = {glyph, complemented};
      best_distance = distance;
    }
  }
  return best;
}

/// Truncated mean of the pixels whose bit equals `set`; black without any.
Rgb8 MeanUnder(Pixels pixels, Bitmap pattern, bool set) {
  int count = 0;
  int r = 0;
  int g = 0;
  int b = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (IsSet(pattern, i) != set) continue;
    ++count;
    r += pixels[i].r;
    g += pixels[i].g;
    b += pixels[i].b;
  }
  if (count == 0) return {};
  const auto mean = [count](int sum) {
    return static_cast<std::uint8_t>(sum / count);
  };
  return {mean(r), mean(g), mean(b)};
}

}  // namespace

Cell TivCell(Pixels pixels) {
  const Dominant dominant = FindDominant(pixels);
  const Bitmap bitmap =
      dominant.direct ? DirectBitmap(pixels, dominant) : RangeBitmap(pixels);
  const Match match = FindGlyph(bitmap);
  if (!dominant.direct) {
    // Under the pattern itself, even where its complement won.
    return {match.glyph.code_point,
            MeanUnder(pixels, match.glyph.pattern, true),
            MeanUnder(pixels, match.glyph.pattern, false)};
  }
  Cell cell{match.glyph.code_point, dominant.second, dominant.first};
  if (match.complemented) std::swap(cell.fg, cell.bg);
  return cell;
}

}  // namespace rtb
