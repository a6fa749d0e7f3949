/// @file
/// Checks of the object tree as a whole.
#include <algorithm>
#include <unordered_map>
#include <vector>

#include "core/base/suggest.h"
#include "core/scene/scene_reader.h"

namespace rtb {
namespace {

/// What an object becomes when instances are followed.
struct Extent {
  int objects = 1;  ///< Itself and its contents; kMaxObjects + 1 = more.
  int levels = 1;   ///< Of nesting, its own included.
};

bool MayBeInstanced(const Object& object) {
  return std::holds_alternative<Group>(object.shape) ||
         std::holds_alternative<Mesh>(object.shape);
}

/// Walks the tree, each instanced group only once.
class Composer {
 public:
  explicit Composer(const Scene& scene) : scene_(scene) {}

  Status Check() {
    int total = 0;
    for (const Object& object : scene_.objects) {
      RTB_ASSIGN_OR_RETURN(const Extent extent, Measure(object, 1));
      RTB_RETURN_IF_ERROR(Add(extent, object.mark, &total));
    }
    return {};
  }

 private:
  tl::unexpected<Error> FailAt(SourceMark mark, std::string what,
                               std::string hint = "") const {
    return Fail(BadInput(PlaceOf(scene_.file.string(), mark), std::move(what),
                         std::move(hint)));
  }

  Status Add(const Extent& extent, SourceMark mark, int* total) const {
    *total = std::min(*total + extent.objects, kMaxObjects + 1);
    if (*total <= kMaxObjects) return {};
    return FailAt(mark,
                  "more than " + std::to_string(kMaxObjects) +
                      " objects in the scene once instances are counted",
                  "this object takes it past the limit");
  }

  /// The extent of an object that stands `level` levels deep.
  Result<Extent> Measure(const Object& object, int level) {
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      return MeasureInstance(*instance, level);
    }
    if (!std::holds_alternative<Group>(object.shape)) return Extent{};
    const auto known = known_.find(&object);
    if (known != known_.end()) return known->second;
    open_.push_back(&object);
    Extent sum;
    for (const Object& child : object.children) {
      RTB_ASSIGN_OR_RETURN(const Extent extent, Measure(child, level + 1));
      RTB_RETURN_IF_ERROR(Add(extent, child.mark, &sum.objects));
      sum.levels = std::max(sum.levels, extent.levels + 1);
    }
    open_.pop_back();
    if (!object.id.empty()) known_.emplace(&object, sum);
    return sum;
  }

  Result<Extent> MeasureInstance(const Instance& instance, int level) {
    RTB_ASSIGN_OR_RETURN(const Object* target, Target(instance));
    if (std::find(open_.begin(), open_.end(), target) != open_.end()) {
      return FailAt(
          instance.of_mark,
          "`of` names `" + instance.of + "`, which contains this instance",
          "an object cannot contain itself");
    }
    // The chain of open groups bounds the recursion.
    Result<Extent> extent = Extent{};
    if (level <= kMaxObjectDepth) extent = Measure(*target, level);
    if (!extent) return extent;
    if (level + extent->levels - 1 <= kMaxObjectDepth) return extent;
    return FailAt(instance.of_mark, "with the contents of `" + instance.of +
                                        "`, objects are nested more than " +
                                        std::to_string(kMaxObjectDepth) +
                                        " levels deep");
  }

  Result<const Object*> Target(const Instance& instance) const {
    const Object* target = FindObject(scene_, instance.of);
    if (target == nullptr) {
      return FailAt(instance.of_mark,
                    "`of` names `" + instance.of.substr(0, 64) +
                        "`, which no object has as its id",
                    Suggestion(instance.of));
    }
    if (MayBeInstanced(*target)) return target;
    return FailAt(
        instance.of_mark,
        "`of` names `" + instance.of + "`, which is neither a group nor a mesh",
        "put the object into a group, and give that an id");
  }

  std::string Suggestion(const std::string& id) const {
    constexpr std::size_t kMostListed = 12;
    std::vector<std::string> ids;
    for (const auto& [known, place] : scene_.object_places) {
      if (MayBeInstanced(*FindObject(scene_, known))) ids.push_back(known);
    }
    if (ids.empty()) return "no group or mesh has an id";
    std::sort(ids.begin(), ids.end());
    const std::string near = DidYouMean(id, ids);
    if (!near.empty()) return near;
    ids.resize(std::min(ids.size(), kMostListed));
    return "groups and meshes are " + JoinNames(ids);
  }

  const Scene& scene_;
  std::unordered_map<const Object*, Extent> known_;
  std::vector<const Object*> open_;  ///< Groups around the current object.
};

}  // namespace

Status CheckComposition(const Scene& scene) { return Composer(scene).Check(); }

}  // namespace rtb
