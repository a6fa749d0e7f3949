#include "harness/live/live.h"

#include <unistd.h>

#include <utility>

#include "harness/live/live_loop.h"
#include "harness/live/live_setup.h"
#include "harness/live/terminal_session.h"

namespace rtb {
namespace {

/// Everything that speaks against a session, before anything is touched.
Result<Terminfo> CheckTerminal(const LiveRequest& request) {
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDOUT_FILENO) == 0) {
    return Fail(BadInput("live", "standard input or output is no terminal",
                         "run it in a terminal, or with --headless"));
  }
  RTB_ASSIGN_OR_RETURN(const Terminfo info, ReadTerminfo(request.term));
  if (!UserLocaleIsUtf8()) {
    return Fail(BadInput("LC_ALL", "the locale's characters are not UTF-8",
                         "set LC_ALL=C.UTF-8"));
  }
  return info;
}

Result<std::unique_ptr<TerminalSession>> StartSession(
    const LiveRequest& request, const Terminfo& info) {
  SessionOptions options;
  options.input = STDIN_FILENO;
  options.output = STDOUT_FILENO;
  options.keys = request.keys;
  options.terminfo = info;
  return TerminalSession::Start(options);
}

DepthChoice DepthOf(const LiveRequest& request, const Terminfo& info,
                    const TerminalCaps& caps) {
  if (request.depth) return {*request.depth, "forced"};
  return ChooseDepth(
      {info.name, request.color_term, request.no_color, info.colors}, caps);
}

LoopOptions OptionsOf(const LiveRequest& request, const TerminalCaps& caps,
                      const DepthChoice& choice) {
  LoopOptions options;
  options.target_fps = request.target_fps;
  options.sync = request.sync && caps.sync;
  options.fence = caps.answered;
  options.depth = choice.depth;
  options.color_reason = choice.reason;
  return options;
}

/// The session as the loop sees it; both must outlive what is returned.
LoopTerminal TerminalOf(TerminalSession* session, SignalCatcher* signals) {
  LoopTerminal terminal;
  terminal.input = session->fd();
  terminal.size = [session] { return session->size(); };
  terminal.cell_aspect = [session] { return session->cell_aspect(); };
  terminal.suspend = [session, signals] {
    session->Leave();
    signals->Stop();
  };
  // After a stop from outside the shell may have changed the modes.
  terminal.resume = [session] {
    session->Leave();
    static_cast<void>(session->Enter());
  };
  terminal.signals = signals;
  return terminal;
}

const char* YesNo(bool yes) { return yes ? "yes\n" : "no\n"; }

}  // namespace

Result<int> RunLive(const LiveRequest& request) {
  RTB_ASSIGN_OR_RETURN(const Terminfo info, CheckTerminal(request));
  RTB_ASSIGN_OR_RETURN(LiveState state, MakeLiveState(request));
  const WakePipe wake;
  SignalCatcher signals(wake);  // Before anything that ncurses might catch.
  RTB_ASSIGN_OR_RETURN(const auto session, StartSession(request, info));
  const TerminalCaps& caps = session->caps();
  const DepthChoice choice = DepthOf(request, info, caps);
  state.set_terminal_depth(choice.depth);
  state.set_key_releases(caps.key_release);
  if (!caps.version.empty()) state.Log(caps.version);
  RTB_ASSIGN_OR_RETURN(const auto presenter,
                       MakePresenter(request, choice.depth, session->size()));
  OutputQueue queue(session->fd());
  LoopTerminal terminal = TerminalOf(session.get(), &signals);
  terminal.output = &queue;
  terminal.presenter = presenter.get();
  const LoopOptions options = OptionsOf(request, caps, choice);
  LiveLoop loop(std::move(state), options, terminal, wake);
  loop.FeedInput(session->TakeEarlyInput());
  if (!request.record.empty()) {
    RTB_RETURN_IF_ERROR(loop.StartRecording(request.record));
  }
  return loop.Run();
}

Result<std::string> DescribeTerminal(const LiveRequest& request) {
  RTB_ASSIGN_OR_RETURN(const Terminfo info, CheckTerminal(request));
  TerminalCaps caps;
  GridSize size;
  double aspect = 0;
  {
    RTB_ASSIGN_OR_RETURN(const auto session, StartSession(request, info));
    caps = session->caps();
    size = session->size();
    aspect = session->cell_aspect();
  }
  const DepthChoice choice = DepthOf(request, info, caps);
  return "terminal         " + info.name + ", " +
         (caps.version.empty() ? "says no name" : caps.version) +
         "\nsize             " + std::to_string(size.columns) + " x " +
         std::to_string(size.rows) + ", cell aspect " + std::to_string(aspect) +
         "\ncolors           " + NameOf(choice.depth) + " (" + choice.reason +
         ")\nanswers          " + YesNo(caps.answered) + "synchronized     " +
         YesNo(caps.sync) + "key-up events    " + YesNo(caps.key_release);
}

}  // namespace rtb
