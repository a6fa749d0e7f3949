#include "harness/commands/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>

#include "harness/commands/console.h"
#include "harness/results/display_width.h"

namespace rtb {
namespace {

using Clock = std::chrono::steady_clock;

/// Whether a line of progress stands on the terminal without its end.
std::atomic<bool> line_is_open = false;

/// Columns of the terminal behind standard error.
int TerminalColumns() {
  constexpr int kUsual = 80;
  winsize size{};
  const bool known =
      ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : kUsual;
}

/// As much of a text without control characters as fits.
std::string Shortened(std::string text, int columns) {
  while (!text.empty() && DisplayWidth(text) > columns) text.pop_back();
  return text;
}

/// A share, rewritten in place on a terminal. Elsewhere a line every ten
/// seconds, so that short jobs leave nothing in a log.
class Progress {
 public:
  explicit Progress(bool bar) : bar_(bar) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (!in_place_) return;
    bar_ ? ClearProgress() : EndLine();
  }

  void Show(double share, const std::string& what) {
    const auto now = Clock::now();
    if (now - last_ < (in_place_ ? kRefresh : kLogged)) return;
    last_ = now;
    const std::string text = Text(std::clamp(share, 0.0, 1.0), what);
    if (!in_place_) return WriteToStderr(text + "\n");
    WriteToStderr("\r\033[K" + Shortened(text, TerminalColumns() - 1));
    line_is_open = true;
  }

 private:
  static constexpr std::chrono::milliseconds kRefresh{100};
  static constexpr std::chrono::milliseconds kLogged{10000};

  static void EndLine() {
    if (line_is_open.exchange(false)) WriteToStderr("\n");
  }

  std::string Text(double share, const std::string& what) const {
    constexpr int kWidth = 20;
    const std::string percent =
        std::to_string(static_cast<int>(share * 100)) + " %";
    if (!bar_) return Printable(what) + " " + percent;
    std::string text = in_place_ ? BarText(share, kWidth) + " " : "";
    return text + percent + Remaining(share) + "  " + Printable(what);
  }

  /// What is left if the rest goes as what is done went.
  std::string Remaining(double share) const {
    constexpr double kLeastKnown = 0.005;
    if (share < kLeastKnown) return "";
    const double elapsed =
        std::chrono::duration<double>(Clock::now() - start_).count();
    return ", " + DurationText(elapsed * (1 - share) / share) + " left";
  }

  bool bar_;
  bool in_place_ = ::isatty(STDERR_FILENO) != 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

std::function<void(double, const std::string&)> Shown(bool bar, bool quiet) {
  if (quiet) return [](double, const std::string&) {};
  return
      [line = std::make_shared<Progress>(bar)](
          double share, const std::string& what) { line->Show(share, what); };
}

}  // namespace

std::string DurationText(double seconds) {
  const auto whole = static_cast<long>(std::ceil(std::max(seconds, 0.0)));
  if (whole < 60) return std::to_string(whole) + " s";
  const long minutes = (whole + 59) / 60;
  if (minutes < 60) return std::to_string(minutes) + " min";
  const std::string rest = std::to_string(minutes % 60);
  return std::to_string(minutes / 60) + " h " + (rest.size() < 2 ? "0" : "") +
         rest + " min";
}

std::string BarText(double share, int width) {
  const auto filled = static_cast<std::size_t>(share * width);
  return "[" + std::string(filled, '#') +
         std::string(static_cast<std::size_t>(width) - filled, '-') + "]";
}

void ClearProgress() {
  if (line_is_open.exchange(false)) WriteToStderr("\r\033[K");
}

std::function<void(double, const std::string&)> ProgressLine(bool quiet) {
  return Shown(/*bar=*/false, quiet);
}

std::function<void(double, const std::string&)> ProgressBar(bool quiet) {
  return Shown(/*bar=*/true, quiet);
}

}  // namespace rtb
