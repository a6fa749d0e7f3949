#include <chafa.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "encoders/chafa.h"
#include "encoders/palette.h"
#include "encoders/plan_encoder.h"

namespace rtb {
namespace {

/// Pixels of a cell in each direction, those of chafa's own symbols.
constexpr int kSide = 8;

struct FreeChafa {
  void operator()(ChafaSymbolMap* map) const { chafa_symbol_map_unref(map); }
  void operator()(ChafaCanvasConfig* config) const {
    chafa_canvas_config_unref(config);
  }
  void operator()(ChafaCanvas* canvas) const { chafa_canvas_unref(canvas); }
};
using SymbolMap = std::unique_ptr<ChafaSymbolMap, FreeChafa>;
using CanvasConfig = std::unique_ptr<ChafaCanvasConfig, FreeChafa>;
using Canvas = std::unique_ptr<ChafaCanvas, FreeChafa>;

ChafaCanvasMode ModeOf(ColorDepth depth) {
  switch (depth) {
    case ColorDepth::k256:
      return CHAFA_CANVAS_MODE_INDEXED_240;
    case ColorDepth::k16:
      return CHAFA_CANVAS_MODE_INDEXED_16;
    case ColorDepth::kMono:
      return CHAFA_CANVAS_MODE_FGBG;
    default:
      return CHAFA_CANVAS_MODE_TRUECOLOR;
  }
}

Rgb8 Unpack(int rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16),
          static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)};
}

/// The fragments as rows of RGBA pixels.
std::vector<std::uint8_t> Pixels(const Fragments& fragments) {
  const int width = fragments.grid.columns * kSide;
  std::vector<std::uint8_t> rgba;
  rgba.reserve(fragments.values.size() * 4);
  for (int y = 0; y < fragments.grid.rows * kSide; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto samples =
          fragments.cell(y / kSide * fragments.grid.columns + x / kSide);
      const Rgb8 color = Encode8(
          samples[static_cast<std::size_t>(y % kSide * kSide + x % kSide)]);
      rgba.insert(rgba.end(), {color.r, color.g, color.b, 255});
    }
  }
  return rgba;
}

class Chafa : public PlanEncoder {
 public:
  Chafa(const ChafaOptions& options, SymbolMap symbols)
      : options_(options), symbols_(std::move(symbols)) {}

 private:
  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, kSide, kSide, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    chafa_set_n_threads(context.threads > 0 ? context.threads : -1);
    const CanvasConfig config = Config(fragments.grid, context.depth);
    const Canvas canvas(chafa_canvas_new(config.get()));
    const int width = fragments.grid.columns * kSide;
    chafa_canvas_draw_all_pixels(canvas.get(), CHAFA_PIXEL_RGBA8_UNASSOCIATED,
                                 Pixels(fragments).data(), width,
                                 fragments.grid.rows * kSide, width * 4);
    CellGrid grid(fragments.grid);
    for (int row = 0; row < grid.size.rows; ++row) {
      for (int column = 0; column < grid.size.columns; ++column) {
        grid.at(column, row) =
            ReadCell(canvas.get(), column, row, context.depth);
      }
    }
    return grid;
  }

  CanvasConfig Config(GridSize grid, ColorDepth depth) const {
    CanvasConfig config(chafa_canvas_config_new());
    chafa_canvas_config_set_geometry(config.get(), grid.columns, grid.rows);
    chafa_canvas_config_set_cell_geometry(config.get(), kSide, kSide);
    chafa_canvas_config_set_canvas_mode(config.get(), ModeOf(depth));
    chafa_canvas_config_set_symbol_map(config.get(), symbols_.get());
    // As the program scales its 1 to 9.
    chafa_canvas_config_set_work_factor(
        config.get(), static_cast<float>(options_.work - 1) / 8);
    chafa_canvas_config_set_color_extractor(
        config.get(), options_.median ? CHAFA_COLOR_EXTRACTOR_MEDIAN
                                      : CHAFA_COLOR_EXTRACTOR_AVERAGE);
    chafa_canvas_config_set_color_space(
        config.get(),
        options_.din99d ? CHAFA_COLOR_SPACE_DIN99D : CHAFA_COLOR_SPACE_RGB);
    return config;
  }

  static Cell ReadCell(ChafaCanvas* canvas, int column, int row,
                       ColorDepth depth) {
    Cell cell;
    cell.glyph = chafa_canvas_get_char_at(canvas, column, row);
    int fg = -1;
    int bg = -1;
    chafa_canvas_get_raw_colors_at(canvas, column, row, &fg, &bg);
    cell.fg = ToColor(fg, depth, kDefaultForeground);
    cell.bg = ToColor(bg, depth, kDefaultBackground);
    return cell;
  }

  /// Of 0xRRGGBB or an index, as the depth says; -1 is the terminal's own.
  static Rgb8 ToColor(int raw, ColorDepth depth, Rgb8 by_default) {
    if (raw < 0 || depth == ColorDepth::kMono) return by_default;
    return depth == ColorDepth::kTruecolor ? Unpack(raw) : XtermColor(raw);
  }

  ChafaOptions options_;
  SymbolMap symbols_;
};

}  // namespace

Result<std::unique_ptr<Encoder>> MakeChafa(const ChafaOptions& options) {
  SymbolMap symbols(chafa_symbol_map_new());
  GError* error = nullptr;
  if (!chafa_symbol_map_apply_selectors(symbols.get(), options.symbols.c_str(),
                                        &error)) {
    const std::string what = error != nullptr ? error->message : "not known";
    g_clear_error(&error);
    return Fail(BadInput("symbols", what, "see `chafa --help`"));
  }
  chafa_symbol_map_remove_by_tags(symbols.get(), CHAFA_SYMBOL_TAG_WIDE);
  return std::make_unique<Chafa>(options, std::move(symbols));
}

std::string ChafaVersion() {
  // The library does not tell; the headers' version is that of the soname that
  // is linked.
  return std::to_string(CHAFA_MAJOR_VERSION) + "." +
         std::to_string(CHAFA_MINOR_VERSION) + "." +
         std::to_string(CHAFA_MICRO_VERSION);
}

}  // namespace rtb
