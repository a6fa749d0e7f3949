/// @file
/// What the tests of encoders share.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "encoders/blend.h"
#include "encoders/cell_grid.h"
#include "encoders/registry.h"

namespace rtb {

/// Linear colors of the gray 8-bit codes[cell][sample].
std::vector<Rgb> GrayValues(const std::vector<std::vector<int>>& codes);

/// Encodes samples that are given cell by cell, each cell's in the plan's
/// order. They must be as many as the encoder asks for, all at once.
CellGrid EncodeValues(const std::string& spec, GridSize grid,
                      std::vector<Rgb> linear);

/// A one-cell grid's cell for colors given in the plan's order.
Cell EncodeOne(const std::string& spec, const std::vector<Rgb8>& colors);

/// The same for gray codes.
Cell EncodeOneGray(const std::string& spec, const std::vector<int>& codes);

/// The colors of a picture drawn in characters, each named in `legend`.
std::vector<Rgb8> Drawn(const std::string& picture,
                        const std::map<char, Rgb8>& legend);

/// A grid of one row.
CellGrid Row(std::vector<Cell> cells);

/// The glyphs of a grid as UTF-8 lines joined by LF.
std::string GlyphText(const CellGrid& grid);

/// Makes an encoder that must exist.
std::unique_ptr<Encoder> Make(const std::string& spec);

/// Linear colors, some beyond [0, 1], that depend on `seed` alone.
std::vector<Rgb> RandomValues(int count, std::uint64_t seed);

/// Encodes 1000 cells of random samples, and expects each glyph (which
/// `glyph` gives for a pattern) to stand for a partition of the least squared
/// error of all there are, and the colors for its rounded means.
void ExpectBestPartitions(const std::string& spec, int samples, Blend blend,
                          char32_t (*glyph)(unsigned));

/// Reads a file that must exist.
std::string ReadTestFile(const std::string& path_below_tests);

/// For readable failures.
void PrintTo(const Cell& cell, std::ostream* out);

}  // namespace rtb
