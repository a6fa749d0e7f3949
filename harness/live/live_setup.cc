#include "harness/live/live_setup.h"

#include <langinfo.h>

#include <clocale>
#include <cstring>

#include "encoders/registry.h"
#include "harness/lookup.h"

namespace rtb {
namespace {

bool IsUtf8() { return std::strcmp(::nl_langinfo(CODESET), "UTF-8") == 0; }

LiveChoices MakeChoices() {
  LiveChoices choices;
  if (const auto specs = ParseEncoderSpecs("all")) {
    for (const EncoderSpec& spec : *specs) {
      choices.encoders.push_back(spec.text);
    }
  }
  for (const NamedScene& scene : ListScenes(FindDataFolders())) {
    choices.scenes.push_back(scene.name);
  }
  for (const BackendInfo& backend : Backends()) {
    if (backend.check()) choices.backends.emplace_back(backend.name);
  }
  return choices;
}

}  // namespace

Result<LiveState> MakeLiveState(const LiveRequest& request) {
  RTB_ASSIGN_OR_RETURN(const auto specs, ParseEncoderSpecs(request.encoder));
  if (specs.size() > 2) {
    return Fail(BadInput("--encoder",
                         "found " + std::to_string(specs.size()) +
                             " encoders, expected one, or two to compare"));
  }
  for (const EncoderSpec& spec : specs) {
    RTB_RETURN_IF_ERROR(MakeEncoder(spec));
  }
  LiveView view;
  view.scene = request.scene.scene;
  view.backend = request.scene.backend;
  view.integrator = request.scene.options.integrator;
  view.encoders = {specs.front().text, specs.back().text};
  view.split = specs.size() == 2;
  view.spp = request.scene.options.spp;
  view.max_depth = request.scene.options.max_depth;
  view.time = request.scene.options.time;
  view.exposure = request.scene.exposure;
  view.seed = request.scene.options.seed;
  view.threads = request.scene.options.threads;
  RTB_RETURN_IF_ERROR(FindScene(FindDataFolders(), view.scene));
  return LiveState(view, MakeChoices());
}

Result<std::unique_ptr<Presenter>> MakePresenter(const LiveRequest& request,
                                                 ColorDepth depth,
                                                 GridSize size) {
  if (request.present == PresentMode::kNcurses) {
    return MakeNcursesPresenter(request.term, depth, size);
  }
  if (request.present == PresentMode::kAuto &&
      depth != ColorDepth::kTruecolor) {
    auto ncurses = MakeNcursesPresenter(request.term, depth, size);
    if (ncurses) return ncurses;
    // Colors were forced that terminfo does not know of.
  }
  return MakeDirectPresenter(depth);
}

void UseUtf8Locale() {
  std::setlocale(LC_CTYPE, "");
  if (!IsUtf8()) std::setlocale(LC_CTYPE, "C.UTF-8");
}

bool UserLocaleIsUtf8() {
  std::setlocale(LC_CTYPE, "");
  return IsUtf8();
}

}  // namespace rtb
