#include "core/scene/subdivide.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <memory>
#include <new>

#include "core/base/check.h"
#include "core/scene/control_mesh.h"

namespace rtb {
namespace {

namespace far = OpenSubdiv::Far;
namespace sdc = OpenSubdiv::Sdc;

/// A vector in the form that OpenSubdiv sums up.
template <class V>
struct Weighted {
  V value{0};
  void Clear() { value = V(0); }
  void AddWithWeight(const Weighted& other, double weight) {
    value += other.value * weight;
  }
};
template <class V>
using WeightedList = std::vector<Weighted<V>>;

using Refiner = std::unique_ptr<far::TopologyRefiner>;
using Primvars = far::PrimvarRefinerReal<double>;

/// What OpenSubdiv said last on this thread; left alone, it would print.
std::string& LastWords() {
  thread_local std::string words;
  return words;
}

void ListenToOpenSubdiv() {
  [[maybe_unused]] static const bool kOnce = [] {
    far::SetErrorCallback(
        [](far::ErrorType, const char* words) { LastWords() = words; });
    far::SetWarningCallback([](const char* words) { LastWords() = words; });
    return true;
  }();
}

/// The refiner of a control mesh; null when OpenSubdiv does not take it.
Refiner MakeRefiner(const ControlMesh& control) {
  const std::vector<int> threes(control.point_corners.size() / 3, 3);
  const std::vector<float> sharpness(control.sharp_corners.size(),
                                     sdc::Crease::SHARPNESS_INFINITE);
  far::TopologyDescriptor topology;
  topology.numVertices = static_cast<int>(control.points.size());
  topology.numFaces = static_cast<int>(threes.size());
  topology.numVertsPerFace = threes.data();
  topology.vertIndicesPerFace = control.point_corners.data();
  topology.numCorners = static_cast<int>(sharpness.size());
  topology.cornerVertexIndices = control.sharp_corners.data();
  topology.cornerWeights = sharpness.data();
  far::TopologyDescriptor::FVarChannel uvs;
  uvs.numValues = static_cast<int>(control.uvs.size());
  uvs.valueIndices = control.uv_corners.data();
  if (!control.uvs.empty()) {
    topology.numFVarChannels = 1;
    topology.fvarChannels = &uvs;
  }
  sdc::Options rules;
  rules.SetVtxBoundaryInterpolation(sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  rules.SetFVarLinearInterpolation(sdc::Options::FVAR_LINEAR_CORNERS_PLUS1);
  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  return Refiner(
      Factory::Create(topology, Factory::Options(sdc::SCHEME_LOOP, rules)));
}

template <class V>
WeightedList<V> ListOf(const std::vector<V>& values) {
  WeightedList<V> list;
  list.reserve(values.size());
  for (const V& value : values) list.push_back({value});
  return list;
}

std::size_t Count(int n) { return static_cast<std::size_t>(n); }

/// The finest level's vertices on the limit surface.
struct LimitPoints {
  WeightedList<V3d> positions;
  WeightedList<V3d> tangents[2];
};

LimitPoints LimitOfPoints(const far::TopologyRefiner& refiner,
                          const std::vector<V3d>& points) {
  const Primvars primvars(refiner);
  WeightedList<V3d> refined = ListOf(points);
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
    WeightedList<V3d> next(Count(refiner.GetLevel(level).GetNumVertices()));
    primvars.Interpolate(level, refined, next);
    refined = std::move(next);
  }
  LimitPoints limit;
  limit.positions.resize(refined.size());
  for (WeightedList<V3d>& list : limit.tangents) list.resize(refined.size());
  primvars.Limit(refined, limit.positions, limit.tangents[0],
                 limit.tangents[1]);
  return limit;
}

WeightedList<V2d> LimitOfUvs(const far::TopologyRefiner& refiner,
                             const std::vector<V2d>& uvs) {
  const Primvars primvars(refiner);
  WeightedList<V2d> refined = ListOf(uvs);
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
    WeightedList<V2d> next(Count(refiner.GetLevel(level).GetNumFVarValues()));
    primvars.InterpolateFaceVarying(level, refined, next);
    refined = std::move(next);
  }
  WeightedList<V2d> limit(refined.size());
  primvars.LimitFaceVarying(refined, limit);
  return limit;
}

/// The mean of the triangles' normals around a vertex, by area.
V3f MeanNormal(const far::TopologyLevel& level, const LimitPoints& limit,
               int vertex) {
  V3d sum(0);
  V3d any(0, 0, 1);
  const auto faces = level.GetVertexFaces(vertex);
  for (int i = 0; i < faces.size(); ++i) {
    const auto corners = level.GetFaceVertices(faces[i]);
    const auto at = [&](int k) {
      return limit.positions[Count(corners[k])].value;
    };
    const V3d normal = (at(1) - at(0)).cross(at(2) - at(0));
    sum += normal;
    if (normal.length() > 0) any = normal;
  }
  // Triangles that turn their backs on each other cancel.
  return V3f((sum.length() > 1e-6 * any.length() ? sum : any).normalized());
}

/// The unit normal of the limit surface at a vertex of the finest level.
V3f LimitNormal(const far::TopologyLevel& level, const LimitPoints& limit,
                int vertex) {
  constexpr double kLeastSine = 1e-8;
  const V3d& u = limit.tangents[0][Count(vertex)].value;
  const V3d& v = limit.tangents[1][Count(vertex)].value;
  const V3d normal = u.cross(v);
  // Where several surfaces meet, and in cusps, there is no tangent plane.
  if (level.IsVertexNonManifold(vertex) ||
      !(normal.length() > kLeastSine * u.length() * v.length())) {
    return MeanNormal(level, limit, vertex);
  }
  return V3f(normal.normalized());
}

/// The finest level as a mesh: a vertex for each texture coordinate, which
/// belongs to one point, or for each point.
TriangleMesh MeshOf(const far::TopologyRefiner& refiner,
                    const LimitPoints& limit, const WeightedList<V2d>& uvs,
                    bool smooth) {
  const far::TopologyLevel level = refiner.GetLevel(refiner.GetMaxLevel());
  const std::size_t count = uvs.empty() ? limit.positions.size() : uvs.size();
  TriangleMesh mesh;
  mesh.positions.assign(count, V3f(0));
  if (smooth) mesh.normals.assign(count, V3f(0, 0, 1));
  for (const auto& uv : uvs) mesh.uvs.emplace_back(uv.value);
  mesh.triangles.reserve(Count(level.GetNumFaces()));
  std::vector<bool> done(count, false);
  for (int face = 0; face < level.GetNumFaces(); ++face) {
    const auto points = level.GetFaceVertices(face);
    const auto corners = uvs.empty() ? points : level.GetFaceFVarValues(face);
    mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    for (int k = 0; k < 3; ++k) {
      const std::size_t vertex = Count(corners[k]);
      if (done[vertex]) continue;
      done[vertex] = true;
      mesh.positions[vertex] = V3f(limit.positions[Count(points[k])].value);
      if (smooth) mesh.normals[vertex] = LimitNormal(level, limit, points[k]);
    }
  }
  return mesh;
}

Result<TriangleMesh> LimitMesh(const ControlMesh& control, int levels,
                               bool smooth, const std::string& file) {
  ListenToOpenSubdiv();
  LastWords().clear();
  const Refiner refiner = MakeRefiner(control);
  if (refiner == nullptr) {
    return Fail(BadInput(file, "cannot be subdivided: " + LastWords(),
                         "use subdivide: 0, or mend the mesh"));
  }
  far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;  // Limit asks for it
  refiner->RefineUniform(options);
  const LimitPoints limit = LimitOfPoints(*refiner, control.points);
  WeightedList<V2d> uvs;
  if (!control.uvs.empty()) uvs = LimitOfUvs(*refiner, control.uvs);
  return MeshOf(*refiner, limit, uvs, smooth);
}

}  // namespace

Status CheckSubdivision(std::size_t triangles, int levels,
                        const std::string& file) {
  // Compared before multiplying: nothing overflows.
  const std::size_t factor = std::size_t{1} << (2 * levels);
  if (triangles <= kMaxMeshTriangles / factor) return {};
  return Fail(BadInput(
      file,
      "`subdivide: " + std::to_string(levels) + "` makes " +
          std::to_string(triangles) + " x " + std::to_string(factor) +
          " triangles, expected at most " + std::to_string(kMaxMeshTriangles),
      "use a smaller `subdivide` or a coarser mesh"));
}

Result<TriangleMesh> Subdivide(const TriangleMesh& mesh, int levels,
                               bool smooth, const std::string& file) {
  RTB_CHECK_GE(levels, 1);
  RTB_CHECK(!mesh.triangles.empty());
  RTB_RETURN_IF_ERROR(CheckSubdivision(mesh.triangles.size(), levels, file));
  try {
    return LimitMesh(Connect(mesh), levels, smooth, file);
  } catch (const std::bad_alloc&) {
    return Fail(Failure(file,
                        "there is not enough memory for `subdivide: " +
                            std::to_string(levels) + "`",
                        "use a smaller `subdivide`"));
  }
}

}  // namespace rtb
