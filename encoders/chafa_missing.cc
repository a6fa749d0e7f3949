#include "encoders/chafa.h"

namespace rtb {

Result<std::unique_ptr<Encoder>> MakeChafa(const ChafaOptions& /*options*/) {
  return Fail(
      Missing("chafa", "this program was built without libchafa",
              "install libchafa-dev and build again, or take external:chafa"));
}

std::string ChafaVersion() { return ""; }

}  // namespace rtb
