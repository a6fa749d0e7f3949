#include "harness/live/screenshot.h"

#include "core/base/file.h"
#include "core/image/io.h"
#include "encoders/decode.h"
#include "encoders/emit/emit.h"
#include "harness/live/free_name.h"

namespace rtb {

Result<std::string> WriteScreenshot(const CellGrid& picture, ColorDepth depth) {
  RTB_ASSIGN_OR_RETURN(const std::string name,
                       FreeName({".png", ".ansi", ".json"}));
  RTB_ASSIGN_OR_RETURN(const Image image, Decode(picture, {}));
  RTB_RETURN_IF_ERROR(WritePng(name + ".png", image));
  RTB_RETURN_IF_ERROR(
      WriteFileAtomically(name + ".ansi", EmitAnsi(picture, depth)));
  RTB_RETURN_IF_ERROR(WriteFileAtomically(name + ".json", EmitJson(picture)));
  return name;
}

}  // namespace rtb
