// Samples of cells of every kind, for kernels that must choose what the
// encoders choose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/color/srgb.h"
#include "core/math/random.h"
#include "core/math/vec.h"
#include "encoders/cuda/encode_kernels.h"

namespace rtb::testing {

/// Sample `i` of a cell: cells take turns to be random, of one color, of two,
/// of few that are close (ties; runs for tiv), a ramp, or not of this world.
inline Rgb VariedSample(std::uint32_t cell, std::uint32_t i) {
  const auto random = [cell](std::uint32_t number, std::uint32_t channel) {
    return UnitFloat(RandomBits(cell, number, channel, 17));
  };
  const auto color = [&](std::uint32_t number) {
    return Rgb(1.4f * random(number, 0) - 0.2f, random(number, 1),
               random(number, 2));
  };
  constexpr float kOdd[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            -3.0f,
                            -0.0f,
                            1e-40f,
                            0.5f,
                            7.0f};
  switch (cell % 6) {
    case 0:
      return color(i);
    case 1:
      return color(0);
    case 2:
      return color(RandomBits(cell, i, 3, 17) % 2);
    case 3: {
      const auto level = [&](std::uint32_t channel) {
        return static_cast<std::uint8_t>(
            100 + RandomBits(cell, i, channel, 18) % (1 + cell % 5));
      };
      return Decode8({level(0), level(1), level(2)});
    }
    case 4:
      return color(0) * (static_cast<float>(i) / 31);
    default: {
      const auto odd = [&](std::uint32_t channel) {
        return kOdd[RandomBits(cell, i, channel, 19) % 8];
      };
      return {odd(0), odd(1), odd(2)};
    }
  }
}

/// A kernel's job on all cells of some samples, which must outlive it.
inline EncodeJob JobOf(const std::vector<Rgb>& samples, int samples_per_cell,
                       const std::vector<char32_t>& glyphs,
                       std::vector<Cell>* cells) {
  cells->resize(samples.size() / static_cast<std::size_t>(samples_per_cell));
  EncodeJob job;
  job.samples = samples.data();
  job.samples_per_cell = samples_per_cell;
  job.cell_count = cells->size();
  job.tables = {&SrgbCodes(), &SrgbCurve(), glyphs.data(), kTivGlyphs};
  job.cells = cells->data();
  return job;
}

/// Cell by cell.
inline std::vector<Rgb> VariedSamples(int cells, int samples_per_cell) {
  std::vector<Rgb> samples;
  for (int cell = 0; cell < cells; ++cell) {
    for (int i = 0; i < samples_per_cell; ++i) {
      samples.push_back(VariedSample(static_cast<std::uint32_t>(cell),
                                     static_cast<std::uint32_t>(i)));
    }
  }
  return samples;
}

}  // namespace rtb::testing
