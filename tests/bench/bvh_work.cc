// The work of one frame of 240 x 67 cells of 32 samples by the flat BVH, for
// scenes that it is given: rays, nodes and packs tested, and what the tables
// take up. These numbers are the scene's and the tree's, whatever the machine;
// docs/cuda.md holds them against what a GPU can do.
//
//   rtb_bvh_work SCENE.yaml...
#include <cstdio>

#include "core/accel/bvh_accel.h"
#include "core/accel/bvh_tracer.h"
#include "core/render/integrators.h"
#include "core/render/traced_scene.h"
#include "core/scene/load.h"

namespace rtb {
namespace {

unsigned long long nodes = 0;
unsigned long long packs = 0;

/// PortableLanes, counted.
struct CountingLanes : PortableLanes {
  static unsigned MeetBoxes(const BvhNode& node, const BoxRay& ray, float t_max,
                            float* t) {
    ++nodes;
    return PortableLanes::MeetBoxes(node, ray, t_max, t);
  }
  static void MeetTriangles(const TrianglePack& pack, const ShearedRay& ray,
                            PackHits* found) {
    ++packs;
    PortableLanes::MeetTriangles(pack, ray, found);
  }
};

double KibibytesOf(const BvhArrays& arrays) {
  return static_cast<double>(arrays.nodes.size() * sizeof(BvhNode) +
                             arrays.packs.size() * sizeof(TrianglePack)) /
         1024;
}

Status Count(const char* file) {
  RTB_ASSIGN_OR_RETURN(const Scene scene, LoadScene(file));
  TracedScene<BvhAccel> prepared(scene);
  RTB_RETURN_IF_ERROR(prepared.GoTo(0, 1));
  RenderOptions options;
  options.threads = 1;
  const BvhAccel& accel = prepared.accel();
  const BasicBvhTracer<CountingLanes> tracer(accel.view());
  RayCounts rays;
  nodes = packs = 0;
  RenderPlan(tracer, ViewOf(prepared.shading()), scene,
             RegularPlan({240, 67}, 4, 8), options, &rays);
  std::printf(
      "%-12s %9llu camera %9llu other %9llu shadow %10llu nodes "
      "%10llu packs %8.0f KiB\n",
      scene.name.c_str(), static_cast<unsigned long long>(rays.camera),
      static_cast<unsigned long long>(rays.secondary()),
      static_cast<unsigned long long>(rays.shadow), nodes, packs,
      KibibytesOf(accel.still()) + KibibytesOf(accel.moving()) +
          KibibytesOf(accel.meshes()));
  return {};
}

}  // namespace
}  // namespace rtb

int main(int count, char** files) {
  for (int i = 1; i < count; ++i) {
    const rtb::Status counted = rtb::Count(files[i]);
    if (counted) continue;
    std::fprintf(stderr, "bvh_work: %s\n", counted.error().ToString().c_str());
    return 1;
  }
  return 0;
}
