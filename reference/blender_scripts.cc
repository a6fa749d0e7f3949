#include "reference/blender_export.h"

namespace rtb {

std::vector<WorkFile> BlenderScripts() {
  return {
#include "blender_scripts.inc"
  };
}

}  // namespace rtb
