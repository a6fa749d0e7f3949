#include "harness/live/free_name.h"

#include <algorithm>
#include <filesystem>

namespace rtb {

Result<std::string> FreeName(const std::vector<std::string>& extensions) {
  constexpr int kMost = 999;
  for (int number = 1; number <= kMost; ++number) {
    const std::string digits = std::to_string(1000 + number).substr(1);
    const std::string name = "rtbench-live-" + digits;
    const bool taken =
        std::ranges::any_of(extensions, [&](const std::string& extension) {
          std::error_code error;
          return std::filesystem::exists(name + extension, error);
        });
    if (!taken) return name;
  }
  return Fail(Failure("rtbench-live-999", "all names are taken",
                      "move the files elsewhere"));
}

}  // namespace rtb
