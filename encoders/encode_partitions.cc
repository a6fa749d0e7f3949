#include "encoders/encode_partitions.h"

#include <bit>

#include "encoders/encode_cells.h"
#include "encoders/partition.h"
#include "encoders/simd/kernels.h"

namespace rtb {

CellGrid EncodePartitionGrid(const Fragments& fragments,
                             std::span<const char32_t> glyphs, Blend blend,
                             const EncodeContext& context) {
  const int samples = std::countr_zero(glyphs.size());
  if (context.scalar || blend != Blend::kSrgb) {
    return EncodeCells(fragments, samples, context.threads,
                       [&](std::span<const Rgb> linear) {
                         return BestPartitionCell(blend, linear, glyphs);
                       });
  }
  return EncodeCells(fragments, samples, context.threads,
                     [&](std::span<const Rgb> linear, std::span<Cell> cells) {
                       EncodePartitions(linear, glyphs, cells);
                     });
}

}  // namespace rtb
