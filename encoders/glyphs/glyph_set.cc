#include "encoders/glyphs/glyph_set.h"

#include <system_error>
#include <utility>

#include "core/base/check.h"

namespace rtb {
namespace {

/// Where Debian's fonts-dejavu-core puts its files.
constexpr char kFolder[] = "/usr/share/fonts/truetype/dejavu/";
constexpr char kMono[] = "DejaVuSansMono.ttf";
constexpr char kSans[] = "DejaVuSans.ttf";

Error NoSuchFont(const std::filesystem::path& file) {
  if (file.string().starts_with(kFolder)) {
    return Missing(file.string(), "the font is not installed",
                   "apt install fonts-dejavu-core");
  }
  return BadInput(file.string(), "no such font file");
}

Result<std::unique_ptr<Font>> OpenExisting(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return Fail(NoSuchFont(file));
  return Font::Open(file);
}

}  // namespace

std::vector<std::filesystem::path> FontChain(
    const std::filesystem::path& font) {
  const std::filesystem::path folder = kFolder;
  std::vector<std::filesystem::path> chain = {folder / kMono, folder / kSans};
  if (!font.empty()) chain.insert(chain.begin(), font);
  return chain;
}

GlyphSet::GlyphSet(int width, int height, MaskSource source,
                   const std::filesystem::path& font)
    : width_(width), height_(height), source_(source), chain_(FontChain(font)) {
  RTB_CHECK_GT(width, 0);
  RTB_CHECK_GT(height, 0);
}

Result<const Mask*> GlyphSet::Get(char32_t glyph) {
  const std::lock_guard lock(mutex_);
  auto found = masks_.find(glyph);
  if (found == masks_.end()) {
    RTB_ASSIGN_OR_RETURN(Mask mask, Make(glyph));
    found = masks_.emplace(glyph, std::move(mask)).first;
  }
  return &found->second;
}

Result<Mask> GlyphSet::Make(char32_t glyph) {
  const auto shape = ShapeOf(glyph);
  if (shape && source_ == MaskSource::kGeometric) {
    return RasterizeShape(*shape, width_, height_);
  }
  RTB_ASSIGN_OR_RETURN(const Font* const font, FindFont(glyph));
  if (font != nullptr) return font->Render(glyph, width_, height_);
  if (shape) return RasterizeShape(*shape, width_, height_);
  return Fail(Missing(CodePointName(glyph), "no font has this glyph",
                      "give a font file that has it"));
}

/// The first font of the chain that has the glyph; nullptr when none has.
Result<const Font*> GlyphSet::FindFont(char32_t glyph) {
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    const OpenFont& font = FontAt(i);
    if (!font) return Fail(font.error());
    if ((*font)->Has(glyph)) return font->get();
  }
  return nullptr;
}

const GlyphSet::OpenFont& GlyphSet::FontAt(std::size_t index) {
  while (fonts_.size() <= index) {
    fonts_.push_back(OpenExisting(chain_[fonts_.size()]));
  }
  return fonts_[index];
}

}  // namespace rtb
