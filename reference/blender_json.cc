#include "reference/blender_json.h"

#include <openssl/evp.h>

#include <vector>

namespace rtb {
namespace {

std::string Base64(std::span<const std::byte> bytes) {
  // EVP_EncodeBlock takes an int: in chunks that leave no rest.
  constexpr std::size_t kChunk = 3 << 20;
  std::string text;
  std::vector<unsigned char> encoded(kChunk / 3 * 4 + 1);
  for (std::size_t i = 0; i < bytes.size(); i += kChunk) {
    const auto part = bytes.subspan(i, std::min(kChunk, bytes.size() - i));
    const int length = EVP_EncodeBlock(
        encoded.data(), reinterpret_cast<const unsigned char*>(part.data()),
        static_cast<int>(part.size()));
    text.append(encoded.begin(), encoded.begin() + length);
  }
  return text;
}

}  // namespace

nlohmann::ordered_json BlenderVector(const V3d& v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json BlenderColor(const Rgb& color) {
  return {color.x, color.y, color.z};
}

nlohmann::ordered_json BlenderMatrix(const Affined& map) {
  nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
  for (const V3d& v : {map.x, map.y, map.z, map.origin}) {
    for (int i = 0; i < 3; ++i) numbers.push_back(v[i]);
  }
  return numbers;
}

std::string BlenderArray(std::span<const float> numbers) {
  return Base64(std::as_bytes(numbers));
}

std::string BlenderArray(std::span<const int> numbers) {
  return Base64(std::as_bytes(numbers));
}

nlohmann::ordered_json BlenderImage(const Image& linear) {
  std::vector<float> numbers;
  numbers.reserve(3 * linear.pixels().size());
  for (int y = linear.height() - 1; y >= 0; --y) {
    for (int x = 0; x < linear.width(); ++x) {
      const Rgb& color = linear.at(x, y);
      numbers.insert(numbers.end(), {color.x, color.y, color.z});
    }
  }
  return {{"width", linear.width()},
          {"height", linear.height()},
          {"pixels", BlenderArray(numbers)}};
}

}  // namespace rtb
