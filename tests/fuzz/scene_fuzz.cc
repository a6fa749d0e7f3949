/// @file
/// libFuzzer's entry into the scene loader: any bytes give a Scene or an
/// Error. See tests/fuzz/CMakeLists.txt for how to run it.
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/check.h"
#include "core/scene/load.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scene = rtb::ParseScene(text, "scene.yaml");
  if (scene) {
  } else {
    RTB_CHECK(scene.error().kind == rtb::ErrorKind::kBadInput);
  }
  return 0;
}
