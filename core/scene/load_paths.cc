/// @file
/// Movement paths.
#include <array>

#include "core/scene/scene_reader.h"

namespace rtb {
namespace {

/// Reads `times`: one for each point, from 0, increasing.
std::vector<double> ReadTimes(MapReader& reader, std::size_t points) {
  const std::vector<double> times = reader.Numbers("times", kNonNegative);
  if (!reader.ok()) return times;
  const auto fail = [&](const std::string& what) {
    reader.context().Fail(reader.MarkOf("times"), what);
  };
  if (times.size() != points) {
    fail("`times` has " + std::to_string(times.size()) +
         " items, expected one for each of the " + std::to_string(points) +
         " points");
  } else if (times[0] != 0) {
    fail("`times` does not begin with 0");
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) continue;
    fail("`times` does not increase from item " + std::to_string(i) +
         " to the next");
  }
  return times;
}

/// The points' times when all segments of `duration` take equally long.
std::vector<double> EqualTimes(std::size_t points, bool loop, double duration) {
  const std::size_t segments = loop ? points : points - 1;
  std::vector<double> times(points, 0.0);
  for (std::size_t i = 1; i < points; ++i) {
    times[i] =
        duration * static_cast<double>(i) / static_cast<double>(segments);
  }
  return times;
}

}  // namespace

void SceneReader::ReadPaths(MapReader& root) {
  for (const YamlNode& node : Section(root, "paths")) {
    ReadPath(node);
    if (!context_.ok()) return;
  }
}

void SceneReader::ReadPath(YamlNode node) {
  static const std::array<std::string, 2> kInterpolations = {"linear",
                                                             "catmull_rom"};
  MapReader reader(node, "a path", context_);
  Path path;
  path.id = reader.Name("id");
  AddId(reader, path.id, static_cast<Index>(scene_.paths.size()), &path_ids_);
  path.points = reader.Vectors("points", 1);
  path.loop = reader.Bool("loop", false);
  path.interpolation = reader.Choice("interpolation", kInterpolations, 0) == 0
                           ? Path::Interpolation::kLinear
                           : Path::Interpolation::kCatmullRom;
  const bool timed = reader.Has("times");
  if (timed && reader.Has("duration")) {
    context_.Fail(reader.MarkOf("times"),
                  "a path has both `duration` and `times`, expected one");
  }
  if (timed) {
    path.times = ReadTimes(reader, path.points.size());
  } else {
    path.duration = reader.Number("duration", kPositive);
  }
  reader.Finish();
  if (!context_.ok()) return;
  if (timed) {
    path.duration = path.times.back();
  } else {
    path.times = EqualTimes(path.points.size(), path.loop, path.duration);
  }
  scene_.paths.push_back(std::move(path));
}

}  // namespace rtb
