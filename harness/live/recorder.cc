#include "harness/live/recorder.h"

#include <fcntl.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace rtb {
namespace {

using Json = nlohmann::ordered_json;

Status WriteLine(int fd, const std::string& file, const Json& line) {
  const int error = WriteAll(
      fd, line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  if (error == 0) return {};
  return Fail(Failure(file, ErrnoText(error)));
}

}  // namespace

Result<Recorder> Recorder::Start(const std::string& file, GridSize size,
                                 double now) {
  Recorder recorder;
  recorder.file_ = file;
  recorder.start_ = now;
  constexpr int kMode = 0666;
  recorder.fd_.Reset(
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode));
  if (!recorder.fd_.valid()) return Fail(Failure(file, ErrnoText()));
  const Json header = {{"version", 2},
                       {"width", size.columns},
                       {"height", size.rows},
                       {"title", "rtbench live"}};
  RTB_RETURN_IF_ERROR(WriteLine(recorder.fd_.get(), file, header));
  return recorder;
}

Status Recorder::Output(std::string_view bytes, double now) {
  return Event("o", bytes, now);
}

Status Recorder::Resize(GridSize size, double now) {
  return Event(
      "r", std::to_string(size.columns) + "x" + std::to_string(size.rows), now);
}

Status Recorder::Event(const char* kind, std::string_view data, double now) {
  const double microseconds = std::round((now - start_) * 1e6);
  return WriteLine(fd_.get(), file_,
                   Json::array({microseconds / 1e6, kind, data}));
}

}  // namespace rtb
