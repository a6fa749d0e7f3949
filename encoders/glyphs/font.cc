#include "encoders/glyphs/font.h"

#include <ft2build.h>

#include <cmath>
#include <cstdio>
#include <utility>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace rtb {
namespace {

constexpr int kGrayLevels = 256;
constexpr double kFixed26_6 = 64;

/// An outline's coordinate or length in 26.6 pixels.
FT_Pos ToFixed(double pixels) { return std::lround(pixels * kFixed26_6); }

/// Scales from font units to 26.6 pixels, and moves the baseline up from the
/// cell's bottom.
void PlaceOutline(FT_Outline& outline, double scale, double baseline) {
  const FT_Pos shift = ToFixed(baseline);
  for (int i = 0; i < outline.n_points; ++i) {
    FT_Vector& point = outline.points[i];
    point.x = ToFixed(static_cast<double>(point.x) * scale);
    point.y = ToFixed(static_cast<double>(point.y) * scale) + shift;
  }
}

/// Area coverage of an outline, clipped to the mask.
Result<Mask> Rasterize(FT_Library library, FT_Outline& outline, Mask mask,
                       const std::string& place) {
  std::vector<unsigned char> gray(mask.coverage.size());
  FT_Bitmap bitmap{};
  bitmap.rows = static_cast<unsigned>(mask.height);
  bitmap.width = static_cast<unsigned>(mask.width);
  bitmap.pitch = mask.width;  // Positive: rows run downwards.
  bitmap.buffer = gray.data();
  bitmap.num_grays = kGrayLevels;
  bitmap.pixel_mode = FT_PIXEL_MODE_GRAY;
  if (FT_Outline_Get_Bitmap(library, &outline, &bitmap) != 0) {
    return Fail(Failure(place, "FreeType cannot draw the glyph"));
  }
  for (std::size_t i = 0; i < gray.size(); ++i) {
    mask.coverage[i] = static_cast<float>(gray[i]) / (kGrayLevels - 1);
  }
  return mask;
}

}  // namespace

/// FreeType's handles.
struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }
};

Font::Font(std::unique_ptr<Face> face, std::filesystem::path file)
    : face_(std::move(face)), file_(std::move(file)) {}
Font::~Font() = default;

Result<std::unique_ptr<Font>> Font::Open(const std::filesystem::path& file) {
  auto face = std::make_unique<Face>();
  if (FT_Init_FreeType(&face->library) != 0) {
    return Fail(Failure(file.string(), "FreeType does not start"));
  }
  if (FT_New_Face(face->library, file.c_str(), 0, &face->face) != 0 ||
      !FT_IS_SCALABLE(face->face)) {
    return Fail(BadInput(file.string(), "not a scalable font, or unreadable",
                         "give a TrueType or OpenType file"));
  }
  return std::unique_ptr<Font>(new Font(std::move(face), file));
}

bool Font::Has(char32_t glyph) const {
  return FT_Get_Char_Index(face_->face, glyph) != 0;
}

Result<Mask> Font::Render(char32_t glyph, int width, int height) const {
  const std::string place = file_.string() + ": " + CodePointName(glyph);
  const FT_Face face = face_->face;
  if (FT_Load_Char(face, glyph, FT_LOAD_NO_SCALE) != 0 ||
      face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
    return Fail(Failure(place, "the font has no outline for the glyph"));
  }
  const auto advance = static_cast<double>(face->glyph->metrics.horiAdvance);
  if (advance <= 0) return Fail(Failure(place, "the glyph has no width"));
  const double scale = width / advance;
  const double ascender = face->ascender * scale;
  const double descender = -face->descender * scale;
  const double baseline = descender + (height - ascender - descender) / 2;
  PlaceOutline(face->glyph->outline, scale, baseline);
  return Rasterize(face_->library, face->glyph->outline, Mask(width, height),
                   place);
}

std::string CodePointName(char32_t glyph) {
  char text[16];
  std::snprintf(text, sizeof text, "U+%04X", static_cast<unsigned>(glyph));
  return text;
}

}  // namespace rtb
