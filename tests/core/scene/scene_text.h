/// @file
/// Short scenes for the loader's tests.
#pragma once

#include <string>

namespace rtb {

/// The required keys, three lines; sections may follow.
inline const std::string kPreamble =
    "rtbench_scene: 1\n"
    "name: test\n"
    "camera: {position: [0, 0, 5], direction: [0, 0, -1], vfov: 40}\n";

}  // namespace rtb
