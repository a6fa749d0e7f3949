#include "reference/reference.h"

#include "reference/pov_text.h"

namespace rtb {

std::filesystem::path ReferencePath(const std::filesystem::path& folder,
                                    const std::string& scene_name,
                                    const std::string& renderer, double time,
                                    int seed) {
  const std::string moment = time == 0 ? "" : ".t" + PovNumber(time);
  const std::string noise = seed == 0 ? "" : ".seed" + std::to_string(seed);
  return folder / (scene_name + moment + "." + renderer + noise + ".exr");
}

}  // namespace rtb
