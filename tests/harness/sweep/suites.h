/// @file
/// A folder with scenes and suites for tests.
#pragma once

#include <string>

#include "core/base/check.h"
#include "harness/sweep/suite.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {

/// Two scenes, `sky` and `sun`, found by name, and whatever a test adds.
class SuiteFolder {
 public:
  SuiteFolder() {
    folder_.Write("data/scenes/sky.yaml", SceneText("sky"));
    folder_.Write("data/scenes/sun.yaml", SceneText("sun"));
  }

  static std::string SceneText(const std::string& name) {
    return "rtbench_scene: 1\nname: " + name +
           "\ncamera: {position: [0, 0, 0], look_at: [0, 0, -1], vfov: 40}\n"
           "background: {type: constant, color: [0.25, 0.5, 0]}\n";
  }

  std::filesystem::path file() const { return folder_.path() / "suite.yaml"; }
  DataFolders data() const { return {folder_.path() / "data"}; }
  TemporaryFolder& folder() { return folder_; }

  /// Reads what follows the two lines that every suite has.
  Result<Suite> Parse(const std::string& rest) const {
    return ParseSuite("rtbench_suite: 1\nname: test\n" + rest, file(), data());
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace rtb
