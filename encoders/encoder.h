/// @file
/// Encoder: turns samples into cells. The flow: SamplePlan -> FragmentSource ->
/// Fragments -> CellGrid, once (plan_encoder.h) or in rounds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/render/fragment_source.h"
#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"
#include "encoders/evidence.h"

namespace rtb {

/// One parameter of an encoder, as `list encoders` shows it.
struct EncoderParameter {
  std::string name;
  std::string default_value;
  std::string
      values;  ///< What is allowed: `srgb|linear|oklab`, `integer >= 0`.
  std::string description;
};

/// What a user may know of an encoder without making one.
struct EncoderInfo {
  std::string name;
  std::string description;
  int samples_per_cell;  ///< With default parameters; where it varies, the
                         ///< most that the mean over cells can be.
  std::string glyphs;    ///< The code points it may use, in words.
  std::vector<EncoderParameter> parameters;
  bool needs_parameters = false;  ///< Its name alone is no SPEC.
  std::string version = {};  ///< Of the library that chooses; empty = ours.
  std::string why_not = {};  ///< Why it cannot run here; empty = it can.
};

/// What an encoding depends on beside the picture.
struct EncodeContext {
  std::uint64_t seed = 0;
  int threads = 0;                     ///< Upper bound; 0 = all cores.
  const CellGrid* previous = nullptr;  ///< Last frame, for temporal encoders.
  /// The colors that the terminal has.
  ColorDepth depth = ColorDepth::kTruecolor;
  bool scalar = false;  ///< Without vectors: the same cells, more slowly.
};

/// An encoding and what it took.
struct Encoding {
  CellGrid grid;
  double rays_per_cell = 0;  ///< Samples really asked for, mean over cells.
  Evidence evidence;         ///< What the cells were chosen from.
};

/// An encoder with its parameters fixed. Immutable and safe to share between
/// threads.
class Encoder {
 public:
  virtual ~Encoder() = default;

  /// Encodes the picture that the source shows: asks it for samples, in one
  /// plan of the whole grid or in several that build on one another, and
  /// chooses the cells. The samples are linear radiance with exposure applied;
  /// values outside [0, 1] are clipped, NaN counts as 0. The result depends on
  /// the source's answers and the arguments, but not on context.threads.
  /// @param cell_aspect cell width / height, passed on to the plans.
  /// @return the source's errors, and whatever the encoder itself fails at.
  virtual Result<Encoding> Run(FragmentSource& source, GridSize grid,
                               double cell_aspect,
                               const EncodeContext& context) const = 0;

  /// The code points that it may choose. Empty: those that it chose are all
  /// that is known (another program's).
  virtual std::vector<char32_t> Candidates() const { return {}; }

  /// The glyph whose coverage stood for that of a candidate when it was chosen:
  /// itself, unless the encoder takes it for something else.
  virtual char32_t ChosenAs(char32_t glyph) const { return glyph; }
};

}  // namespace rtb
