/// @file
/// The camera.
#include <cmath>
#include <numbers>

#include "core/scene/geometry_checks.h"
#include "core/scene/scene_reader.h"

namespace rtb {
namespace {

/// `vfov`, or the angle that `focal_length` and `sensor_height` give.
double ReadFieldOfView(MapReader& reader) {
  const bool by_lens =
      reader.Has("focal_length") || reader.Has("sensor_height");
  if (reader.Has("vfov") && by_lens) {
    reader.context().Fail(reader.MarkOf("vfov"),
                          "the camera has both `vfov` and a focal length, "
                          "expected one of them");
  }
  if (!by_lens) return reader.Number("vfov", kFieldOfView);
  const double length = reader.Number("focal_length", kPositive);
  const double height = reader.Number("sensor_height", kPositive);
  const double vfov =
      2 * std::atan(0.5 * height / length) * 180 / std::numbers::pi;
  if (!kFieldOfView.Holds(vfov)) {
    reader.context().Fail(reader.MarkOf("sensor_height"),
                          "`sensor_height` and `focal_length` give no "
                          "vertical angle between 0 and 180 degrees");
  }
  return vfov;
}

/// The view at time 0 has a direction, and `up` is another one.
/// @param key what the direction comes from.
void CheckView(MapReader& reader, const Camera& camera, const char* key) {
  if (camera.direction.length() < kSmallestPositive) {
    reader.context().Fail(reader.MarkOf(key),
                          "`look_at` is the camera's own position, expected "
                          "another point");
  } else if (AreParallel(camera.direction, camera.up)) {
    reader.context().Fail(
        reader.MarkOf(reader.Has("up") ? "up" : key),
        "`up` is parallel to the view, expected another direction",
        "for a view straight up or down, up: [0, 0, -1] will do");
  }
}

}  // namespace

void SceneReader::ReadCamera(MapReader& root) {
  const auto node = root.Require("camera");
  if (!node) return;
  MapReader reader(*node, "the camera", context_);
  Camera& camera = scene_.camera;
  camera.position = reader.Vector("position");
  camera.up = reader.Direction("up", camera.up);
  camera.path = Reference(reader, "path", path_ids_);
  camera.vfov = ReadFieldOfView(reader);
  camera.user_control = reader.Bool("user_control", camera.user_control);
  if (reader.Has("speed")) camera.speed = reader.Number("speed", kPositive);
  ReadView(reader, &camera);
}

void SceneReader::ReadView(MapReader& reader, Camera* camera) {
  camera->has_look_at = reader.Has("look_at");
  const bool both = camera->has_look_at && reader.Has("direction");
  const char* const key = camera->has_look_at ? "look_at" : "direction";
  if (both) {
    context_.Fail(reader.MarkOf("direction"),
                  "the camera has both `look_at` and `direction`, expected "
                  "one of them");
  }
  camera->look_path = Reference(reader, "look_path", path_ids_);
  if (camera->look_path != kNone && !camera->has_look_at) {
    context_.Fail(reader.MarkOf("look_path"),
                  "`look_path` moves `look_at`, which the camera lacks",
                  "write `look_at` in place of `direction`");
  }
  if (camera->has_look_at) {
    camera->look_at = reader.Vector(key);
  } else {
    camera->direction = reader.Direction(key);
  }
  reader.Finish();
  if (!context_.ok()) return;
  if (camera->has_look_at) {
    camera->direction = camera->look_at + FirstOffset(camera->look_path) -
                        camera->position - FirstOffset(camera->path);
  }
  CheckView(reader, *camera, key);
}

V3d SceneReader::FirstOffset(Index path) const {
  if (path == kNone) return V3d(0, 0, 0);
  return scene_.paths[static_cast<std::size_t>(path)].points[0];
}

}  // namespace rtb
