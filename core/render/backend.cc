#include "core/render/backend.h"

#include <array>

#include "core/render/bvh_backend.h"
#include "core/render/embree_backend.h"

namespace rtb {
namespace {

using Maker = Result<std::unique_ptr<Backend>> (*)(const Scene&);

/// The table that the command line and MakeBackend share.
struct Entry {
  BackendInfo info;
  Maker make;
};

constexpr std::array<Entry, 3> kEntries = {{
    {{"embree", "Embree on the CPU", true, ""}, MakeEmbreeBackend},
    {{"bvh", "flat BVH on the CPU", true, ""}, MakeBvhBackend},
    {{"cuda", "flat BVH on an NVIDIA GPU", false, "not part of this version"},
     nullptr},
}};

constexpr auto kInfos = [] {
  std::array<BackendInfo, kEntries.size()> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = kEntries[i].info;
  return infos;
}();

}  // namespace

std::span<const BackendInfo> Backends() { return kInfos; }

Result<std::unique_ptr<Backend>> MakeBackend(const std::string& name,
                                             const Scene& scene) {
  std::string names;
  for (const Entry& entry : kEntries) {
    if (name == entry.info.name) {
      if (entry.make != nullptr) return entry.make(scene);
      return Fail(Missing("--backend=" + name, entry.info.why_not,
                          "--backend=embree runs everywhere"));
    }
    names += (names.empty() ? "" : ", ") + std::string(entry.info.name);
  }
  return Fail(BadInput("--backend", "unknown backend `" + name + "`", names));
}

}  // namespace rtb
