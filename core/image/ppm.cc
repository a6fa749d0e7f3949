#include <cstddef>

#include "core/color/srgb.h"
#include "core/image/io.h"

namespace rtb {
namespace {

constexpr std::size_t kLongestLine = 70;

/// Appends words to lines that stay within the limit.
class LineFiller {
 public:
  explicit LineFiller(std::string* text) : text_(text) {}

  void Add(const std::string& word) {
    if (used_ > 0 && used_ + 1 + word.size() > kLongestLine) Break();
    if (used_ > 0) *text_ += ' ';
    used_ += (used_ > 0 ? 1 : 0) + word.size();
    *text_ += word;
  }

  void Break() {
    *text_ += '\n';
    used_ = 0;
  }

 private:
  std::string* text_;
  std::size_t used_ = 0;
};

}  // namespace

std::string EncodePpm(const Image& encoded) {
  std::string text = "P3\n" + std::to_string(encoded.width()) + " " +
                     std::to_string(encoded.height()) + "\n255\n";
  LineFiller lines(&text);
  for (int y = 0; y < encoded.height(); ++y) {
    for (int x = 0; x < encoded.width(); ++x) {
      const Rgb8 color = QuantizeEncoded(encoded.at(x, y));
      lines.Add(std::to_string(color.r));
      lines.Add(std::to_string(color.g));
      lines.Add(std::to_string(color.b));
    }
    lines.Break();
  }
  return text;
}

}  // namespace rtb
