#include "encoders/fit/atlas_parameters.h"

#include <charconv>
#include <string_view>

#include "encoders/glyphs/glyph_lists.h"

namespace rtb {
namespace {

/// Sub-pixels in each direction.
constexpr int kMaxMask = 64;
constexpr char kGeometric[] = "geometric";

const EncoderParameter& GlyphsParameter() {
  static const EncoderParameter parameter{
      "glyphs", "blocks+quadrants+eighths", "names joined by +",
      "what to choose from: blocks, eighths, quadrants, shades, sextants, "
      "wedges, octants, braille, box, ascii"};
  return parameter;
}

const EncoderParameter& MaskParameter() {
  static const EncoderParameter parameter{
      "mask", "8x16", "WxH, each 1..64",
      "sub-pixels of a cell, and so samples"};
  return parameter;
}

const EncoderParameter& AtlasParameter() {
  static const EncoderParameter parameter{
      "atlas", kGeometric, "geometric or a font file",
      "where the shapes of the glyphs come from"};
  return parameter;
}

struct MaskSize {
  int width = 0;
  int height = 0;
};

/// A number in 1..kMaxMask that takes up the whole text; 0 for anything else.
int ReadExtent(std::string_view text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value > kMaxMask) return 0;
  return value < 0 ? 0 : value;
}

Result<MaskSize> ReadMaskSize(const EncoderParameters& given) {
  const std::string_view text = ValueOf(MaskParameter(), given);
  const std::size_t x = text.find('x');
  MaskSize size;
  if (x != std::string_view::npos) {
    size = {ReadExtent(text.substr(0, x)), ReadExtent(text.substr(x + 1))};
  }
  if (size.width == 0 || size.height == 0) {
    return Fail(BadInput("mask", "`" + std::string(text) +
                                     "` is no WIDTHxHEIGHT of 1 to 64 each"));
  }
  return size;
}

}  // namespace

std::vector<EncoderParameter> AtlasParameters() {
  return {GlyphsParameter(), MaskParameter(), AtlasParameter()};
}

Result<Atlas> ReadAtlas(const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const std::vector<char32_t> glyphs,
                       GlyphsOf(ValueOf(GlyphsParameter(), given)));
  RTB_ASSIGN_OR_RETURN(const MaskSize size, ReadMaskSize(given));
  const std::string& atlas = ValueOf(AtlasParameter(), given);
  if (atlas == kGeometric) return MakeAtlas(glyphs, size.width, size.height);
  return MakeAtlas(glyphs, size.width, size.height, MaskSource::kFont, atlas);
}

}  // namespace rtb
