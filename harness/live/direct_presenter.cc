#include "harness/live/ansi_frame.h"
#include "harness/live/presenter.h"

namespace rtb {
namespace {

class DirectPresenter : public Presenter {
 public:
  explicit DirectPresenter(ColorDepth depth) : depth_(depth) {}

  const char* name() const override { return "direct"; }

  Result<std::string> Draw(const ScreenUpdate& update) override {
    return (update.clear ? "\x1b[m\x1b[2J" : "") +
           AnsiFrame(update.screen, update.changed, depth_);
  }

 private:
  ColorDepth depth_;
};

}  // namespace

std::unique_ptr<Presenter> MakeDirectPresenter(ColorDepth depth) {
  return std::make_unique<DirectPresenter>(depth);
}

}  // namespace rtb
