#include "core/base/error.h"

#include <cstdio>
#include <utility>

namespace rtb {
namespace {

std::string Escaped(unsigned char c) {
  char text[8];
  std::snprintf(text, sizeof text, "\\x%02x", c);
  return text;
}

Error Make(ErrorKind kind, std::string place, std::string what,
           std::string hint) {
  return Error{kind, std::move(place), std::move(what), std::move(hint)};
}

}  // namespace

std::string Printable(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    // C1 controls are the two-byte UTF-8 sequences C2 80 .. C2 9F.
    const bool c1 = c == 0xC2 && i + 1 < text.size() &&
                    static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (c1) {
      out += Escaped(static_cast<unsigned char>(text[++i]));
    } else if (c < 0x20 || c == 0x7F) {
      out += Escaped(c);
    } else {
      out += text[i];
    }
  }
  return out;
}

std::string Error::ToString() const {
  std::string text = place.empty() ? what : place + ": " + what;
  if (!hint.empty()) text += " (" + hint + ")";
  return Printable(text);
}

Error Failure(std::string place, std::string what, std::string hint) {
  return Make(ErrorKind::kFailure, std::move(place), std::move(what),
              std::move(hint));
}

Error BadInput(std::string place, std::string what, std::string hint) {
  return Make(ErrorKind::kBadInput, std::move(place), std::move(what),
              std::move(hint));
}

Error Missing(std::string place, std::string what, std::string hint) {
  return Make(ErrorKind::kMissing, std::move(place), std::move(what),
              std::move(hint));
}

}  // namespace rtb
