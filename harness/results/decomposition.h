/// @file
/// Decomposition: how much of a run's error comes from which step.
///
/// On the decoded raster, in sRGB-encoded values: R the reference, I_inf our
/// own converged image, I_n the fragments' image, T the decoded grid;
/// b = I_inf - R, s = I_n - I_inf, e = T - I_n, so that T - R = b + s + e.
#pragma once

#include <optional>

namespace rtb {

/// Means over pixels and channels; the first six add up to `total`.
struct MseTerms {
  double render = 0;             ///< |b|^2.
  double sampling = 0;           ///< |s|^2.
  double encoding = 0;           ///< |e|^2.
  double render_sampling = 0;    ///< 2 b.s
  double render_encoding = 0;    ///< 2 b.e
  double sampling_encoding = 0;  ///< 2 s.e
  double total = 0;              ///< |T - R|^2.
  /// What a font's shapes add: MSE of the font decode minus that of the
  /// geometric decode; none where no font could be read.
  std::optional<double> font;
  bool operator==(const MseTerms&) const = default;
};

/// Mean FLIP at kFlipPpd between the steps; these are distances and do not add
/// up.
struct FlipDistances {
  double reference_converged = 0;  ///< (R, I_inf)
  double converged_fragments = 0;  ///< (I_inf, I_n)
  double fragments_grid = 0;       ///< (I_n, T)
  double reference_grid = 0;       ///< (R, T)
  /// (R, the same encoder run on R as its source); none where it fails there.
  std::optional<double> oracle;
  bool operator==(const FlipDistances&) const = default;
};

/// The error of the encoder itself, MSE against the fragments' raster.
struct InnerTerms {
  double capacity = 0;  ///< Least MSE of two colors over its glyphs.
  double masks = 0;     ///< More by the masks chosen, in their best colors.
  double colors = 0;    ///< More by the colors chosen for those masks.
  bool operator==(const InnerTerms&) const = default;
};

/// All of it.
struct Decomposition {
  MseTerms mse;
  FlipDistances flip;
  std::optional<InnerTerms> inner;  ///< None where it is not defined.
  bool operator==(const Decomposition&) const = default;
};

}  // namespace rtb
