// Encoder `tiv`: exactly what TerminalImageViewer 1.3 computes with its
// default options and 24-bit colors from the same 4 x 8 8-bit pixels. Its
// direct mode costs quality on clean renders; it is kept exact nevertheless.
#include <algorithm>
#include <array>
#include <bit>
#include <memory>

#include "encoders/encode_cells.h"
#include "encoders/plan_encoder.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

constexpr int kColumns = 4;
constexpr int kRows = 8;
constexpr int kPixels = kColumns * kRows;
using Pixels = std::array<Rgb8, kPixels>;

/// A set of pixels: most significant bit = top left, row by row.
using Bitmap = std::uint32_t;

constexpr bool IsSet(Bitmap bitmap, std::size_t pixel) {
  return (bitmap >> (kPixels - 1 - pixel) & 1) != 0;
}

struct Glyph {
  Bitmap pattern;
  char32_t code_point;
};

constexpr Glyph kGlyphs[] = {
#include "encoders/tiv_table.inc"
};

/// The most frequent color and the second; the same where there is just one.
struct Dominant {
  Rgb8 first, second;
  bool direct;  ///< Together they cover more than half of the pixels.
};

Dominant FindDominant(const Pixels& pixels) {
  struct Counted {
    int count;
    Rgb8 color;
    auto operator<=>(const Counted&) const = default;
  };
  Pixels sorted = pixels;
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
Bitmap BitmapOf(const Pixels& pixels, const Predicate& is_set) {
  Bitmap bitmap = 0;
  for (const Rgb8& pixel : pixels) bitmap = bitmap << 1 | is_set(pixel);
  return bitmap;
}

Bitmap DirectBitmap(const Pixels& pixels, const Dominant& dominant) {
  return BitmapOf(pixels, [&](const Rgb8& pixel) {
    return SquaredDistance(pixel, dominant.first) >
           SquaredDistance(pixel, dominant.second);
  });
}

/// The channel of the largest range, split at its middle.
Bitmap RangeBitmap(const Pixels& pixels) {
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
  Glyph glyph{0x0000ffff, 0x2584};
  bool complemented = false;
};

Match FindGlyph(Bitmap bitmap) {
  Match best;
  int best_distance = 8;
  for (const Glyph& glyph : kGlyphs) {
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
Rgb8 MeanUnder(const Pixels& pixels, Bitmap pattern, bool set) {
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

Cell EncodePixels(const Pixels& pixels) {
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

class Tiv : public PlanEncoder {
 public:
  std::vector<char32_t> Candidates() const override {
    std::vector<char32_t> glyphs;
    for (const Glyph& glyph : kGlyphs) glyphs.push_back(glyph.code_point);
    return glyphs;
  }

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, kColumns, kRows, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    return EncodeCells(
        fragments, kPixels, context.threads, [](std::span<const Rgb> linear) {
          Pixels pixels;
          std::ranges::transform(linear, pixels.begin(), [](const Rgb& color) {
            return Encode8(color);
          });
          return EncodePixels(pixels);
        });
  }
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& /*given*/) {
  return std::make_unique<Tiv>();
}

}  // namespace

EncoderEntry tiv_entry() {
  return {{"tiv",
           "what TerminalImageViewer 1.3 chooses, cell for cell",
           kPixels,
           "U+00A0, U+2581-2587, U+258A, U+258C, U+258E, U+2596-2598, U+259A, "
           "U+259D and box drawing",
           {}},
          Make};
}

}  // namespace rtb
