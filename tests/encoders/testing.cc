#include "tests/encoders/testing.h"

#include <fstream>
#include <iterator>
#include <ostream>

#include "core/base/check.h"
#include "core/math/random.h"
#include "encoders/emit/emit.h"
#include "encoders/emit/hex_color.h"

namespace rtb {

Fragments GrayFragments(const SamplePlan& plan,
                        const std::vector<std::vector<int>>& codes) {
  Fragments fragments(plan);
  RTB_CHECK_EQ(codes.size(), static_cast<std::size_t>(plan.grid.cells()));
  for (std::size_t cell = 0; cell < codes.size(); ++cell) {
    const auto samples = fragments.cell(static_cast<int>(cell));
    RTB_CHECK_EQ(codes[cell].size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto code = static_cast<std::uint8_t>(codes[cell][i]);
      samples[i] = Rgb(SrgbDecode8(code));
    }
  }
  return fragments;
}

Cell EncodeOne(const std::string& spec, const std::vector<Rgb8>& colors) {
  const auto encoder = Make(spec);
  Fragments fragments(encoder->Plan({1, 1}, 0.5, 0));
  RTB_CHECK_EQ(fragments.values.size(), colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    fragments.values[i] = Decode8(colors[i]);
  }
  return encoder->Encode(fragments, {}).cells[0];
}

Cell EncodeOneGray(const std::string& spec, const std::vector<int>& codes) {
  std::vector<Rgb8> colors;
  for (const int code : codes) {
    const auto gray = static_cast<std::uint8_t>(code);
    colors.push_back({gray, gray, gray});
  }
  return EncodeOne(spec, colors);
}

std::vector<Rgb8> Drawn(const std::string& picture,
                        const std::map<char, Rgb8>& legend) {
  std::vector<Rgb8> colors;
  for (const char c : picture) {
    if (c != '\n') colors.push_back(legend.at(c));
  }
  return colors;
}

std::string GlyphText(const CellGrid& grid) {
  std::string text;
  for (int row = 0; row < grid.size.rows; ++row) {
    for (int column = 0; column < grid.size.columns; ++column) {
      text += Utf8(grid.at(column, row).glyph);
    }
    text += '\n';
  }
  return text;
}

std::unique_ptr<Encoder> Make(const std::string& spec) {
  auto encoder = MakeEncoder(spec);
  if (!encoder) CheckFailed(__FILE__, __LINE__, encoder.error().ToString());
  return std::move(*encoder);
}

Fragments RandomFragments(const SamplePlan& plan, std::uint64_t seed) {
  Fragments fragments(plan);
  for (std::size_t i = 0; i < fragments.values.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const float unit =
          UnitFloat(RandomBits(static_cast<std::uint32_t>(i), 0,
                               static_cast<std::uint32_t>(channel), seed));
      fragments.values[i][channel] = 1.4f * unit - 0.2f;
    }
  }
  return fragments;
}

std::string ReadTestFile(const std::string& path_below_tests) {
  const std::string path =
      std::string(RTB_TEST_SOURCE_DIR) + "/tests/" + path_below_tests;
  std::ifstream file(path, std::ios::binary);
  if (!file) CheckFailed(__FILE__, __LINE__, "cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void PrintTo(const Cell& cell, std::ostream* out) {
  *out << Utf8(cell.glyph) << " " << HexColor(cell.fg) << " on "
       << HexColor(cell.bg);
}

}  // namespace rtb
