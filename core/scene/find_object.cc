#include "core/scene/scene.h"

namespace rtb {
namespace {

const Object* FindAmong(const std::vector<Object>& objects,
                        const std::string& id) {
  for (const Object& object : objects) {
    if (object.id == id) return &object;
    if (const Object* found = FindAmong(object.children, id)) return found;
  }
  return nullptr;
}

}  // namespace

const Object* FindObject(const Scene& scene, const std::string& id) {
  return id.empty() ? nullptr : FindAmong(scene.objects, id);
}

}  // namespace rtb
