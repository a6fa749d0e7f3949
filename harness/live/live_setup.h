/// @file
/// What the live mode needs before its loop begins, with or without a person.
#pragma once

#include <memory>

#include "harness/live/live_request.h"
#include "harness/live/live_state.h"
#include "harness/live/presenter.h"

namespace rtb {

/// The view and the choices that a request begins with.
/// @return kBadInput for encoders and scenes that there are not.
Result<LiveState> MakeLiveState(const LiveRequest& request);

/// The presenter of a request for these colors of the terminal.
Result<std::unique_ptr<Presenter>> MakePresenter(const LiveRequest& request,
                                                 ColorDepth depth,
                                                 GridSize size);

/// Makes LC_CTYPE a UTF-8 one, whatever it takes, for ncurses' sake.
void UseUtf8Locale();

/// Whether the user's own locale is a UTF-8 one.
bool UserLocaleIsUtf8();

}  // namespace rtb
