#include "core/render/backend.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/render/bvh_backend.h"
#include "core/render/cuda_backend.h"
#include "core/render/embree_backend.h"

namespace rtb {
namespace {

using Maker = Result<std::unique_ptr<Backend>> (*)(const Scene&);

/// The table that the command line and MakeBackend share.
struct Entry {
  BackendInfo info;
  Maker make;
};

constexpr std::size_t kCount = 3;

Status RunsEverywhere() { return {}; }

Result<std::unique_ptr<Backend>> MakeCuda(const Scene& scene) {
  return MakeCudaBackend(scene);
}

const std::array<Entry, kCount>& Entries() {
  static const std::array<Entry, kCount> entries = {{
      {{"embree", "Embree on the CPU", true, RunsEverywhere},
       MakeEmbreeBackend},
      {{"bvh", "flat BVH on the CPU", true, RunsEverywhere}, MakeBvhBackend},
      {{"cuda", "flat BVH on an NVIDIA GPU", CudaIsCompiledIn(), CudaRuns},
       MakeCuda},
  }};
  return entries;
}

}  // namespace

std::span<const BackendInfo> Backends() {
  static const auto infos = [] {
    std::array<BackendInfo, kCount> list{};
    std::ranges::transform(Entries(), list.begin(), &Entry::info);
    return list;
  }();
  return infos;
}

Result<std::unique_ptr<Backend>> MakeBackend(const std::string& name,
                                             const Scene& scene) {
  std::string names;
  for (const Entry& entry : Entries()) {
    if (name == entry.info.name) return entry.make(scene);
    names += (names.empty() ? "" : ", ") + std::string(entry.info.name);
  }
  return Fail(BadInput("--backend", "unknown backend `" + name + "`", names));
}

}  // namespace rtb
