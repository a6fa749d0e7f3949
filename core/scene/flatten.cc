#include <cmath>
#include <string>

#include "core/base/check.h"
#include "core/math/frame.h"
#include "core/scene/animation.h"
#include "core/scene/flat_scene.h"

namespace rtb {
namespace {

/// What a node of the tree inherits.
struct Context {
  Affined to_world;
  Index material = kNone;
};

/// The map that places the unit sphere or disk: axes s, t, n and a center.
Affined Placed(const V3d& s, const V3d& t, const V3d& n, const V3d& center) {
  Affined map;
  map.x = s;
  map.y = t;
  map.z = n;
  map.origin = center;
  return map;
}

/// Rendering is done in float: beyond this, squares of lengths overflow.
constexpr double kLargest = 1e18;

bool Representable(const V3d& v) {
  return std::abs(v.x) <= kLargest && std::abs(v.y) <= kLargest &&
         std::abs(v.z) <= kLargest;
}

/// Whether a map and its inverse fit into single precision.
bool Representable(const Affined& map) {
  const auto all = [](const Affined& m) {
    return Representable(m.x) && Representable(m.y) && Representable(m.z) &&
           Representable(m.origin);
  };
  return all(map) && all(map.Inverse());
}

/// Instances are expanded: more triangles than this would not fit into the
/// memory of common machines (some 200 bytes each, accelerator included).
constexpr std::size_t kMostTriangles = std::size_t{1} << 26;

/// Appends the primitives of one object to a FlatScene.
class ShapeFlattener {
 public:
  ShapeFlattener(const Scene& scene, const Affined& to_world, FlatScene* flat)
      : scene_(scene),
        to_world_(to_world),
        object_(static_cast<Index>(flat->objects.size()) - 1),
        flat_(*flat) {}

  void operator()(const Sphere& sphere) {
    const double r = sphere.radius;
    const Affined local =
        Placed(V3d(r, 0, 0), V3d(0, r, 0), V3d(0, 0, r), sphere.center);
    flat_.spheres.push_back({Kept(to_world_ * local), object_});
  }
  void operator()(const Disk& disk) {
    const V3d n = disk.normal.normalized();
    const Tangents<double> frame = TangentsOf(n);
    const double r = disk.radius;
    const Affined local = Placed(frame.s * r, frame.t * r, n * r, disk.center);
    flat_.disks.push_back({Kept(to_world_ * local), object_});
  }
  void operator()(const Plane& plane) {
    const V3d normal =
        to_world_.Inverse().Transposed(plane.normal.normalized());
    flat_.planes.push_back(
        {Kept(to_world_.Point(plane.point)), normal.normalized(), object_});
  }
  void operator()(const Triangle& triangle) {
    Add(triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]);
  }
  void operator()(const Quad& quad) {
    AddQuad(quad.corner, quad.edges[0], quad.edges[1]);
  }
  void operator()(const Polygon& polygon) {
    const auto& v = polygon.vertices;
    for (std::size_t i = 2; i < v.size(); ++i) Add(v[0], v[i - 1], v[i]);
  }
  void operator()(const Box& box) {
    const V3d size = box.max - box.min;
    const V3d x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    AddQuad(box.min, z, y);  // -x
    AddQuad(box.min, x, z);  // -y
    AddQuad(box.min, y, x);  // -z
    AddQuad(box.min + x, y, z);
    AddQuad(box.min + y, z, x);
    AddQuad(box.min + z, x, y);
  }
  void operator()(const Mesh& mesh) {
    const auto& data = scene_.meshes[static_cast<std::size_t>(mesh.data)];
    const auto at = [&](int i) {
      return V3d(data.positions[static_cast<std::size_t>(i)]);
    };
    for (const auto& [a, b, c] : data.triangles) Add(at(a), at(b), at(c));
  }
  void operator()(const Group&) {}
  void operator()(const Instance&) {}

  /// Whether everything that was added fits into single precision.
  bool representable() const { return representable_; }

 private:
  /// The argument, noted when it leaves float's range.
  const V3d& Kept(const V3d& v) {
    representable_ = representable_ && Representable(v);
    return v;
  }
  const Affined& Kept(const Affined& m) {
    representable_ = representable_ && Representable(m);
    return m;
  }
  /// Adds a triangle of the object's own coordinates, unless it vanishes in
  /// single precision.
  void Add(const V3d& a, const V3d& b, const V3d& c) {
    const std::array<V3f, 3> v = {V3f(Kept(to_world_.Point(a))),
                                  V3f(Kept(to_world_.Point(b))),
                                  V3f(Kept(to_world_.Point(c)))};
    const V3d normal = V3d(v[1] - v[0]).cross(V3d(v[2] - v[0]));
    if (normal.length2() > 0) flat_.triangles.push_back({v, object_});
  }
  void AddQuad(const V3d& corner, const V3d& e0, const V3d& e1) {
    Add(corner, corner + e0, corner + e0 + e1);
    Add(corner, corner + e0 + e1, corner + e1);
  }

  const Scene& scene_;
  const Affined& to_world_;
  const Index object_;
  FlatScene& flat_;
  bool representable_ = true;
};

/// Walks the tree.
class Flattener {
 public:
  Flattener(const Scene& scene, double time) : scene_(scene), time_(time) {}

  Status Visit(const Object& object, const Context& parent) {
    const Object* source = &object;
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      source = FindObject(scene_, instance->of);
      RTB_CHECK(source != nullptr);  // the loader has resolved it
    }
    RTB_ASSIGN_OR_RETURN(const Context context, Enter(object, *source, parent));
    if (std::holds_alternative<Group>(source->shape)) {
      for (const Object& child : source->children) {
        RTB_RETURN_IF_ERROR(Visit(child, context));
      }
      return {};
    }
    flat_.objects.push_back({context.material, context.to_world});
    if (flat_.triangles.size() + TrianglesOf(*source) > kMostTriangles) {
      return Fail(TooMany(object));
    }
    ShapeFlattener shape(scene_, context.to_world, &flat_);
    std::visit(shape, source->shape);
    if (!shape.representable()) return Fail(OutOfRange(object));
    return {};
  }

  FlatScene Take() { return std::move(flat_); }

 private:
  /// The context inside a node: placed as `object` is, filled by `source`.
  Result<Context> Enter(const Object& object, const Object& source,
                        const Context& parent) const {
    V3d position = object.position;
    if (object.path != kNone) {
      position += PathOffset(
          scene_.paths[static_cast<std::size_t>(object.path)], time_);
    }
    Context context;
    context.to_world =
        parent.to_world *
        PositionRotateScale(position, object.rotate, object.scale);
    context.material = object.material != kNone   ? object.material
                       : source.material != kNone ? source.material
                                                  : parent.material;
    if (!Representable(context.to_world)) return Fail(OutOfRange(object));
    return context;
  }

  /// How many triangles a mesh adds; other shapes add few.
  std::size_t TrianglesOf(const Object& object) const {
    const auto* mesh = std::get_if<Mesh>(&object.shape);
    if (mesh == nullptr) return 0;
    return scene_.meshes[static_cast<std::size_t>(mesh->data)].triangles.size();
  }

  std::string Place(const Object& object) const {
    return scene_.file.string() + ":" + std::to_string(object.mark.line) + ":" +
           std::to_string(object.mark.column);
  }

  Error TooMany(const Object& object) const {
    return BadInput(Place(object),
                    "the scene has more than " +
                        std::to_string(kMostTriangles) +
                        " triangles up to here, each instance counted",
                    "use fewer instances or a coarser mesh");
  }

  Error OutOfRange(const Object& object) const {
    return BadInput(Place(object),
                    "the object, composed, leaves single precision's range",
                    "check the sizes, `position` and `scale` of it and its "
                    "groups");
  }

  const Scene& scene_;
  const double time_;
  FlatScene flat_;
};

}  // namespace

Result<FlatScene> Flatten(const Scene& scene, double time) {
  Flattener flattener(scene, time);
  for (const Object& object : scene.objects) {
    RTB_RETURN_IF_ERROR(flattener.Visit(object, Context{}));
  }
  return flattener.Take();
}

}  // namespace rtb
