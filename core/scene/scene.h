/// @file
/// Scene: a scene file as plain data, checked but not yet composed. Lengths
/// in scene units, angles in degrees, times in seconds, colors scene-linear
/// BT.709. Every member follows the key of the same name in the scene format.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "core/math/vec.h"

namespace rtb {

/// Where in the scene file something was written; 1-based, 0 = unknown.
struct SourceMark {
  int line = 0;
  int column = 0;
};

/// Index into one of Scene's lists; kNone where there is no such reference.
using Index = int;
inline constexpr Index kNone = -1;

/// The camera: a pinhole. right = direction x up.
struct Camera {
  V3d position{0};
  V3d look_at{0, 0, -1};    ///< Meaningful when `has_look_at`.
  V3d direction{0, 0, -1};  ///< View direction at time 0, not normalized.
  bool has_look_at = false;
  V3d up{0, 1, 0};
  double vfov = 40;  ///< Full vertical angle, also when given by focal length.
  Index path = kNone;
  Index look_path = kNone;
  bool user_control = true;
  std::optional<double> speed;  ///< Units per second in live mode.
};

struct ConstantBackground {
  Rgb color{0};
};
/// bottom + (top - bottom) * 0.5 * (y + 1), y of the unit ray direction.
struct GradientBackground {
  Rgb bottom{0};
  Rgb top{0};
};
/// Latitude-longitude image.
struct ImageBackground {
  std::filesystem::path file;
};
struct Background {
  std::variant<ConstantBackground, GradientBackground, ImageBackground> kind;
  SourceMark mark;
};

/// Defaults that a command line may override.
struct Settings {
  int max_depth = 8;
  Rgb ambient{0};
  double exposure = 0;  ///< Stops.
};

/// Solid texture: (floor(x/size) + floor(y/size) + floor(z/size)) even -> a.
struct CheckerTexture {
  Rgb a{1};
  Rgb b{0};
  double size = 1;
};
struct ImageTexture {
  std::filesystem::path file;
  V2d scale{1, 1};
};
/// std::monostate = no texture: the material's own albedo.
using Texture = std::variant<std::monostate, CheckerTexture, ImageTexture>;

struct BumpMap {
  std::filesystem::path file;
  double amount = 0;  ///< Height of image value 1, in scene units.
};

struct Lambertian {
  Rgb albedo{0.5f};
};
struct Mirror {
  Rgb reflectance{1};
};
struct Metal {
  Rgb albedo{1};  ///< Reflectance at normal incidence (F0).
  double roughness = 0;
};
struct Dielectric {
  double ior = 1.5;
  Rgb tint{1};
};
struct Plastic {
  Rgb albedo{0.5f};
  double ior = 1.5;
  double roughness = 0;
};
struct Phong {
  Rgb albedo{0.5f};
  Rgb specular{0};
  double exponent = 1;
  Rgb reflectance{0};
};
struct Emissive {
  Rgb radiance{0};
};

/// A material. `texture`, where present, stands in place of the albedo.
struct Material {
  std::string id;
  std::variant<Lambertian, Mirror, Metal, Dielectric, Plastic, Phong, Emissive>
      bsdf;
  Texture texture;
  std::optional<BumpMap> bump;
  SourceMark mark;
};

struct PointLight {
  V3d position{0};
  Rgb intensity{0};  ///< W/sr; without falloff the irradiance at any distance.
  bool inverse_square = true;
};
struct DirectionalLight {
  V3d direction{0, -1, 0};  ///< Direction the light travels, not normalized.
  Rgb irradiance{0};
};
struct SpotLight {
  V3d position{0};
  V3d direction{0, -1, 0};
  Rgb intensity{0};
  double cone = 30;     ///< Half angle of full intensity.
  double penumbra = 0;  ///< Degrees over which it falls to 0.
};
struct QuadLight {
  V3d corner{0};
  std::array<V3d, 2> edges;
  Rgb radiance{0};
  int samples = 1;
};
struct SphereLight {
  V3d center{0};
  double radius = 1;
  Rgb radiance{0};
  int samples = 1;
};
struct Light {
  std::string id;
  std::variant<PointLight, DirectionalLight, SpotLight, QuadLight, SphereLight>
      kind;
  Index path = kNone;
  SourceMark mark;
};

/// A triangle mesh in its own coordinates, one normal and one texture
/// coordinate per vertex or none at all.
struct TriangleMesh {
  std::vector<V3f> positions;
  std::vector<V3f> normals;
  std::vector<V2f> uvs;
  std::vector<std::array<int, 3>> triangles;
};

struct Sphere {
  V3d center{0};
  double radius = 1;
};
struct Plane {
  V3d point{0};
  V3d normal{0, 1, 0};  ///< Not normalized.
};
struct Disk {
  V3d center{0};
  V3d normal{0, 1, 0};  ///< Not normalized.
  double radius = 1;
};
struct Triangle {
  std::array<V3d, 3> vertices;
};
struct Quad {
  V3d corner{0};
  std::array<V3d, 2> edges;
};
/// Convex; a fan of triangles from vertex 0.
struct Polygon {
  std::vector<V3d> vertices;
};
struct Box {
  V3d min{0};
  V3d max{1, 1, 1};
};
struct Mesh {
  std::filesystem::path file;
  bool smooth = true;
  int subdivide = 0;
  Index data = kNone;  ///< Into Scene::meshes, where it is ready to render.
};
/// The children are in Object::children.
struct Group {};
struct Instance {
  std::string of;           ///< The id of a group or mesh.
  SourceMark of_mark = {};  ///< Where that id stands.
};

/// A node of the scene's tree: p_parent = position + Rz Ry Rx (scale * p).
struct Object {
  std::string id;
  std::variant<Sphere, Plane, Disk, Triangle, Quad, Polygon, Box, Mesh, Group,
               Instance>
      shape;
  V3d position{0};
  V3d rotate{0};
  V3d scale{1, 1, 1};
  Index material = kNone;  ///< kNone: the nearest ancestor's.
  Index path = kNone;
  std::vector<Object> children;  ///< Of a Group only.
  SourceMark mark;
};

/// A movement path: offsets added to the owner's position.
struct Path {
  enum class Interpolation { kLinear, kCatmullRom };
  std::string id;
  std::vector<V3d> points;
  std::vector<double> times;  ///< Of each point; the first is 0.
  double duration = 0;        ///< Until the end, or until it wraps.
  bool loop = false;
  Interpolation interpolation = Interpolation::kLinear;
};

/// A whole scene file.
struct Scene {
  std::filesystem::path file;  ///< Where it was read from.
  std::string sha256;          ///< Of the file's bytes.
  std::string name;
  std::string description;
  Camera camera;
  Background background;
  Settings settings;
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::vector<Object> objects;
  std::vector<Path> paths;
  /// Of each file, `smooth` and `subdivide` that objects name: subdivided,
  /// and with normals only where they are to be shaded with.
  std::vector<TriangleMesh> meshes;
  /// What was mended on loading (e.g. degenerate triangles of a mesh that were
  /// dropped), one sentence each.
  std::vector<std::string> warnings;
  /// Where objects with an id stand: positions among siblings, from the root.
  /// Filled by IndexObjects; FindObject does without, but slowly.
  std::unordered_map<std::string, std::vector<Index>> object_places;
};

/// The object with this id anywhere in the tree, or nullptr.
const Object* FindObject(const Scene& scene, const std::string& id);

/// Makes FindObject fast; to be called again when the tree has changed. The
/// loader does it.
void IndexObjects(Scene* scene);

}  // namespace rtb
