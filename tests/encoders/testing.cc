#include "tests/encoders/testing.h"

#include <fstream>
#include <iterator>
#include <ostream>
#include <utility>

#include "core/base/check.h"
#include "core/math/random.h"
#include "encoders/emit/emit.h"
#include "encoders/emit/hex_color.h"
#include "tests/encoders/given_source.h"

namespace rtb {

std::vector<Rgb> GrayValues(const std::vector<std::vector<int>>& codes) {
  std::vector<Rgb> values;
  for (const std::vector<int>& cell : codes) {
    for (const int code : cell) {
      values.emplace_back(SrgbDecode8(static_cast<std::uint8_t>(code)));
    }
  }
  return values;
}

CellGrid EncodeValues(const std::string& spec, GridSize grid,
                      std::vector<Rgb> linear) {
  GivenSource source(std::move(linear));
  auto encoding = Make(spec)->Run(source, grid, 0.5, {});
  if (!encoding) CheckFailed(__FILE__, __LINE__, encoding.error().ToString());
  return std::move(encoding->grid);
}

Cell EncodeOne(const std::string& spec, const std::vector<Rgb8>& colors) {
  std::vector<Rgb> linear;
  for (const Rgb8& color : colors) linear.push_back(Decode8(color));
  return EncodeValues(spec, {1, 1}, std::move(linear)).cells[0];
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

CellGrid Row(std::vector<Cell> cells) {
  CellGrid grid({static_cast<int>(cells.size()), 1});
  grid.cells = std::move(cells);
  return grid;
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

std::vector<Rgb> RandomValues(int count, std::uint64_t seed) {
  std::vector<Rgb> values(static_cast<std::size_t>(count), Rgb(0));
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const float unit =
          UnitFloat(RandomBits(static_cast<std::uint32_t>(i), 0,
                               static_cast<std::uint32_t>(channel), seed));
      values[i][channel] = 1.4f * unit - 0.2f;
    }
  }
  return values;
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
