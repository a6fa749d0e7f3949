#include <string>

#include "core/base/check.h"
#include "core/scene/animation.h"
#include "core/scene/flat_scene.h"
#include "core/scene/shape_flattener.h"
#include "core/scene/yaml_tree.h"

namespace rtb {
namespace {

/// What a node of the tree inherits.
struct Context {
  Affined to_world;
  Index material = kNone;
  bool moves = false;
};

Error OutOfRange(const Scene& scene, SourceMark mark) {
  return BadInput(PlaceOf(scene.file.string(), mark),
                  "the object, composed, leaves single precision's range",
                  "check the sizes, `position` and `scale` of it and its "
                  "groups");
}

bool Wanted(FlatPart part, bool moves) {
  return part == FlatPart::kAll || (part == FlatPart::kMoving) == moves;
}

/// Walks the tree.
class Flattener {
 public:
  Flattener(const Scene& scene, double time, FlatPart part)
      : scene_(scene), time_(time), part_(part) {}

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
    if (!Wanted(part_, context.moves)) return {};
    flat_.objects.push_back({context.material, context.to_world});
    ShapeFlattener shape(scene_, context.to_world, &flat_);
    std::visit(shape, source->shape);
    if (!shape.representable()) return Fail(OutOfRange(scene_, object.mark));
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
    context.moves = parent.moves || object.path != kNone;
    context.to_world =
        parent.to_world *
        PositionRotateScale(position, object.rotate, object.scale);
    context.material = object.material != kNone   ? object.material
                       : source.material != kNone ? source.material
                                                  : parent.material;
    if (!Representable(context.to_world)) {
      return Fail(OutOfRange(scene_, object.mark));
    }
    return context;
  }

  const Scene& scene_;
  const double time_;
  const FlatPart part_;
  FlatScene flat_;
};

}  // namespace

Result<FlatScene> Flatten(const Scene& scene, double time, FlatPart part) {
  Flattener flattener(scene, time, part);
  for (const Object& object : scene.objects) {
    RTB_RETURN_IF_ERROR(flattener.Visit(object, Context{}));
  }
  return flattener.Take();
}

Status AddLightShapes(const Scene& scene, double time, FlatPart part,
                      FlatScene* flat) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    const auto* quad = std::get_if<QuadLight>(&light.kind);
    const auto* sphere = std::get_if<SphereLight>(&light.kind);
    if (quad == nullptr && sphere == nullptr) continue;
    if (!Wanted(part, light.path != kNone)) continue;
    FlatObject object;
    object.light = static_cast<Index>(i);
    object.object_to_world.origin = LightOffset(scene, light, time);
    flat->objects.push_back(object);
    ShapeFlattener shape(scene, object.object_to_world, flat);
    if (quad != nullptr) shape(Quad{quad->corner, quad->edges});
    if (sphere != nullptr) shape(Sphere{sphere->center, sphere->radius});
    if (!shape.representable()) return Fail(OutOfRange(scene, light.mark));
  }
  return {};
}

}  // namespace rtb
