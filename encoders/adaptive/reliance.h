/// @file
/// Reliances: how far the nearest samples foretell what lies between them.
/// ByCell -> Reliances -> Rebuild.
#pragma once

#include <vector>

#include "encoders/adaptive/by_cell.h"

namespace rtb {

/// For each cell the share, in 0..1, by which a place is to be moved from the
/// wide mean (wide_mean.h) towards the mean of its nearest samples. 1 where
/// samples foretell one another, 0 where they do so no better than the wide
/// mean: in noise, and in texture finer than their distances.
///
/// It is the regression of each sample on what the others say, left out one by
/// one and pooled over 3 x 3 cells (W. James and C. Stein, "Estimation with
/// Quadratic Loss", 4th Berkeley Symposium, 1961, shrinks means likewise; the
/// cross-validation is M. Stone's, J. Royal Statistical Society B 36, 1974).
std::vector<float> Reliances(const ByCell& samples, int threads);

}  // namespace rtb
