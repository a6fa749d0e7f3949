#include <wchar.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "encoders/glyphs/mask.h"
#include "encoders/glyphs/shape.h"
#include "encoders/palette.h"
#include "harness/live/ncurses_screen.h"
#include "harness/live/pair_pool.h"
#include "harness/live/presenter.h"
#include "harness/live/terminfo.h"

namespace rtb {
namespace {

/// A color as an entry with 24-bit colors takes it: values below 8 mean the
/// palette there, so they become the nearest that do not.
int DirectColor(Rgb8 color) {
  const int value = color.r << 16 | color.g << 8 | color.b;
  if (value >= 8) return value;
  return value <= 4 ? 0x000100 : 0x000008;
}

/// ncurses draws glyphs that libc knows no width of as blanks: a blank in the
/// glyph's mean color looks more like it.
Cell Drawable(const Cell& cell, ColorDepth depth) {
  if (::wcwidth(static_cast<wchar_t>(cell.glyph)) == 1) return cell;
  Cell blank{U' ', cell.bg, cell.bg};
  const auto shape = ShapeOf(cell.glyph);
  if (depth != ColorDepth::kTruecolor || !shape) return blank;
  const float covered = RasterizeShape(*shape, 1, 1).at(0, 0);
  for (const auto channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
    const float mean = static_cast<float>(cell.bg.*channel) * (1 - covered) +
                       static_cast<float>(cell.fg.*channel) * covered;
    blank.bg.*channel = static_cast<std::uint8_t>(mean + 0.5f);
  }
  return blank;
}

class NcursesPresenter : public Presenter {
 public:
  NcursesPresenter(std::unique_ptr<NcursesScreen> screen, ColorDepth depth,
                   GridSize size)
      : screen_(std::move(screen)), depth_(depth), pool_(0) {
    Forget(size);
  }

  const char* name() const override { return "ncurses"; }

  Result<std::string> Draw(const ScreenUpdate& update) override {
    if (update.screen.size != size_) {
      screen_->Resize(update.screen.size);
      Forget(update.screen.size);
    }
    if (update.clear) screen_->Clear();
    screen_->BeginFrame();
    for (const int index : update.changed) {
      Put(index, update.screen.cells[static_cast<std::size_t>(index)]);
    }
    std::string bytes = screen_->TakeFrame();
    pool_.Settle();
    return bytes;
  }

 private:
  /// Two pairs for each cell: what it shows and what it is to show.
  void Forget(GridSize size) {
    size_ = size;
    const int wanted = 2 * size.cells();
    pool_ = PairPool(std::clamp(wanted, 1, std::max(screen_->pairs(), 1)));
    shown_.assign(static_cast<std::size_t>(size.cells()), 0);
  }

  void Put(int index, const Cell& wanted) {
    const Cell cell = Drawable(wanted, depth_);
    int& shown = shown_[static_cast<std::size_t>(index)];
    pool_.Release(shown);
    bool bold = false;
    shown = depth_ == ColorDepth::kMono ? 0 : PairOf(cell, &bold);
    screen_->Put(index % size_.columns, index / size_.columns, cell.glyph,
                 shown, bold);
  }

  int PairOf(const Cell& cell, bool* bold) {
    const Cell canonical = Canonical(cell);
    PairColors colors{ColorOf(canonical.fg), ColorOf(canonical.bg)};
    *bold = screen_->colors() < 16 && colors.fg >= 8;
    if (screen_->colors() < 16) {
      colors.fg &= 7;
      colors.bg &= 7;
    }
    const auto lease = pool_.Acquire(colors);
    if (!lease) {
      const int pair = pool_.Substitute(colors);
      if (pair != 0) pool_.AcquireAgain(pair);
      return pair;
    }
    if (lease->is_new) screen_->DefinePair(lease->pair, colors.fg, colors.bg);
    return lease->pair;
  }

  int ColorOf(Rgb8 color) const {
    if (depth_ == ColorDepth::kTruecolor) return DirectColor(color);
    return IndexOf(color, depth_).value_or(0);
  }

  std::unique_ptr<NcursesScreen> screen_;
  ColorDepth depth_;
  GridSize size_;
  PairPool pool_;
  std::vector<int> shown_;  ///< Pair of each cell on the screen.
};

/// An entry whose 24-bit colors every terminal reads right: those with
/// semicolons first.
Result<std::string> DirectEntry() {
  for (const char* name : {"alacritty-direct", "konsole-direct", "vte-direct",
                           "st-direct", "xterm-direct"}) {
    const auto info = ReadTerminfo(name);
    if (info && info->direct && info->colors >= 1 << 24) return name;
  }
  return Fail(Missing("ncurses", "terminfo has no entry with 24-bit colors",
                      "install ncurses-term, or name --color=256"));
}

}  // namespace

Result<std::unique_ptr<Presenter>> MakeNcursesPresenter(const std::string& term,
                                                        ColorDepth depth,
                                                        GridSize size) {
  std::string entry = term;
  if (depth == ColorDepth::kTruecolor) {
    RTB_ASSIGN_OR_RETURN(entry, DirectEntry());
  }
  RTB_ASSIGN_OR_RETURN(auto screen, NcursesScreen::Open(entry, size));
  // With 8 colors the bright ones are bold.
  const int least = depth == ColorDepth::k256 ? 256 : 8;
  if (depth != ColorDepth::kMono && screen->colors() < least) {
    return Fail(BadInput("--color",
                         "the terminal '" + entry + "' has " +
                             std::to_string(screen->colors()) + " colors",
                         "name fewer, or --present=direct"));
  }
  return std::make_unique<NcursesPresenter>(std::move(screen), depth, size);
}

}  // namespace rtb
