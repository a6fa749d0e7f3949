/// @file
/// The tree of objects.
#include <array>

#include "core/scene/read_shapes.h"
#include "core/scene/scene_reader.h"
#include "core/scene/yaml_scalars.h"

namespace rtb {
namespace {

constexpr int kMaxSubdivision = 6;

/// All shapes: the simple ones, then those with references, in this order.
enum Compound { kMesh, kGroup, kInstance };

const std::vector<std::string>& ShapeNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const SimpleShape& shape : SimpleShapes()) names.push_back(shape.type);
    for (const char* name : {"mesh", "group", "instance"}) {
      names.emplace_back(name);
    }
    return names;
  }();
  return kNames;
}

/// `scale`: a positive number, or three of them.
V3d ReadScale(MapReader& reader) {
  const auto node = reader.Find("scale");
  if (!node) return V3d(1, 1, 1);
  if (node->is_list()) {
    return ToVector(*node, "scale", kPositive, reader.context());
  }
  const double scale = ToNumber(*node, "scale", kPositive, reader.context());
  return V3d(scale, scale, scale);
}

}  // namespace

void SceneReader::ReadObjects(MapReader& root) {
  for (const YamlNode& node : Section(root, "objects")) {
    scene_.objects.push_back(ReadObject(node, 1));
    if (!context_.ok()) return;
  }
}

void SceneReader::ReadTransform(MapReader& reader, Object* object) {
  object->position = reader.Vector("position", V3d(0, 0, 0));
  object->rotate = reader.Vector("rotate", V3d(0, 0, 0));
  object->scale = ReadScale(reader);
  object->path = Reference(reader, "path", path_ids_);
  object->material = Reference(reader, "material", material_ids_);
}

Object SceneReader::ReadObject(YamlNode node, int level) {
  Object object;
  object.mark = node.mark();
  if (level > kMaxObjectDepth) {
    context_.Fail(node.mark(), "objects are nested more than " +
                                   std::to_string(kMaxObjectDepth) +
                                   " levels deep");
  }
  if (++objects_ > kMaxObjects) {
    context_.Fail(node.mark(), "more than " + std::to_string(kMaxObjects) +
                                   " objects in the scene");
  }
  MapReader reader(node, "an object", context_);
  object.id = reader.Name("id", "");
  const std::size_t type = reader.Type(ShapeNames());
  if (!context_.ok()) return object;
  reader.set_owner("an object of type " + ShapeNames()[type]);
  AddId(reader, object.id, 0, &object_ids_);
  ReadTransform(reader, &object);
  const auto simple = SimpleShapes();
  if (type < simple.size()) {
    object.shape = simple[type].read(reader);
  } else {
    ReadCompound(reader, static_cast<int>(type - simple.size()), level,
                 &object);
  }
  reader.Finish();
  return object;
}

void SceneReader::ReadCompound(MapReader& reader, int kind, int level,
                               Object* object) {
  if (kind == kInstance) {
    Instance instance{.of = reader.Name("of"), .of_mark = reader.MarkOf("of")};
    object->shape = std::move(instance);
  } else if (kind == kGroup) {
    object->shape = Group{};
    const auto children = reader.Require("children");
    if (!children) return;
    for (const YamlNode& node :
         ItemsOf(*children, "children", 0, kNoLimit, context_)) {
      object->children.push_back(ReadObject(node, level + 1));
      if (!context_.ok()) return;
    }
  } else {
    Mesh mesh;
    mesh.smooth = reader.Bool("smooth", mesh.smooth);
    mesh.subdivide = reader.Integer("subdivide", 0, kMaxSubdivision, 0);
    mesh.file = File(reader);
    mesh.data = ReadMesh(mesh, reader);
    object->shape = std::move(mesh);
  }
}

}  // namespace rtb
