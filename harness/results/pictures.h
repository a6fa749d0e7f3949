/// @file
/// RunPictures: what was written of a run beside its record.
#pragma once

#include <string>

namespace rtb {

/// File names in the folder `pictures` beside the records; empty = not
/// written.
struct RunPictures {
  std::string cells;      ///< The grid: cells as JSON, compressed by gzip.
  std::string flip;       ///< Its FLIP map.
  std::string reference;  ///< The reference as displayed.
  bool operator==(const RunPictures&) const = default;
};

}  // namespace rtb
