#include <utility>

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

/// The object at a place, or nullptr when the tree has none there.
const Object* AtPlace(const Scene& scene, const std::vector<Index>& place) {
  const std::vector<Object>* level = &scene.objects;
  const Object* object = nullptr;
  for (const Index i : place) {
    if (static_cast<std::size_t>(i) >= level->size()) return nullptr;
    object = &(*level)[static_cast<std::size_t>(i)];
    level = &object->children;
  }
  return object;
}

using Places = decltype(Scene::object_places);

void AddPlaces(const std::vector<Object>& objects, std::vector<Index>& place,
               Places* places) {
  place.push_back(0);
  for (const Object& object : objects) {
    if (!object.id.empty()) places->emplace(object.id, place);
    AddPlaces(object.children, place, places);
    ++place.back();
  }
  place.pop_back();
}

}  // namespace

void IndexObjects(Scene* scene) {
  Places places;
  std::vector<Index> place;
  AddPlaces(scene->objects, place, &places);
  scene->object_places = std::move(places);
}

const Object* FindObject(const Scene& scene, const std::string& id) {
  if (id.empty()) return nullptr;
  const auto known = scene.object_places.find(id);
  if (known != scene.object_places.end()) {
    const Object* object = AtPlace(scene, known->second);
    if (object != nullptr && object->id == id) return object;
  }
  return FindAmong(scene.objects, id);
}

}  // namespace rtb
