#include "core/patching/vertex_shares.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "core/patching/surface_system.hpp"

namespace hariko {

namespace {

/// Distance in rings of faces up to which a vertex has shares in a face, and that between vertices that are
/// solved at once, whose shares then lie in different faces.
constexpr int rings_of_shares = 1, rings_apart = 2 * rings_of_shares + 2;
constexpr double share_tolerance = 1e-7;
constexpr std::size_t faces_per_task = 4;

/// Faces at each vertex, and vertices by their distance: one step to the others of a face.
class FaceRings {
 public:
  explicit FaceRings(const HalfEdgeMesh& mesh) : mesh_(mesh), faces_(mesh.vertex_count()) {
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (const Index v : mesh.face_vertices(f)) faces_[v].push_back(f);
    seen_.assign(mesh.vertex_count(), no_index);
  }

  /// Vertices within so many steps of the given ones, these included, in the order of their distance.
  std::vector<Index> within(std::vector<Index> begin, int steps) {
    ++mark_;
    for (const Index v : begin) seen_[v] = mark_;
    std::size_t from = 0;
    for (int step = 0; step < steps; ++step) {
      const std::size_t end = begin.size();
      for (; from < end; ++from)
        for (const Index f : faces_[begin[from]])
          for (const Index v : mesh_.face_vertices(f))
            if (std::exchange(seen_[v], mark_) != mark_) begin.push_back(v);
    }
    return begin;
  }

 private:
  const HalfEdgeMesh& mesh_;
  std::vector<std::vector<Index>> faces_;
  std::vector<Index> seen_;
  Index mark_ = 0;
};

/// Colours of the vertices: no two of a colour are nearer than `rings_apart`.
struct VertexColours {
  std::vector<Index> of;
  Index count = 0;
};

VertexColours coloured(const HalfEdgeMesh& mesh, FaceRings& rings) {
  VertexColours out{std::vector<Index>(mesh.vertex_count(), no_index)};
  std::vector<Index> taken_by;  // per colour: the last vertex that may not have it
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    taken_by.resize(out.count, no_index);
    for (const Index near : rings.within({v}, rings_apart - 1))
      if (out.of[near] != no_index) taken_by[out.of[near]] = v;
    Index colour = 0;
    while (colour < out.count && taken_by[colour] == v) ++colour;
    out.of[v] = colour;
    out.count = std::max(out.count, colour + 1);
  }
  return out;
}

Shaping without_planes(Shaping shaping) {
  FlatMap<VertexId, Pin> pins;
  for (const auto& [id, pin] : shaping.pin)
    if (pin.kind == Pin::Kind::tangents) pins.set(id, pin);
  shaping.pin = std::move(pins);
  return shaping;
}

Result<SurfaceSystem> system_of(const PolyhedronSurfaceInput& input) {
  auto network = NetworkSystem::assemble(input.polyhedron, without_planes(input.shaping),
                                         {frames_in(input.mode, input.frames), {}, {}});
  if (!network) return network.error();
  const Mode mode = input.mode == Mode::g2 ? Mode::fair : input.mode;
  SurfaceSystem out{input.polyhedron.shared_topology(), std::move(network).value(), {}, mode, nullptr};
  out.constants = patch_constants(*out.mesh, out.network.frames());
  if (mode == Mode::fair) out.fair = std::make_unique<FairSystem>(out.mesh, out.network, out.constants);
  return out;
}

/// Patches of a field over the vertices, with the frames as they are.
std::optional<QuarticPatchArray> patches_of(const SurfaceSystem& system, std::span<const Vector3> field,
                                            const CancelToken& cancel) {
  const HalfEdgeMesh& mesh = *system.mesh;
  NetworkSystem::SolveOptions solve;
  solve.tolerance = share_tolerance;
  solve.homogeneous = true;
  const auto solution = system.network.solve(field, solve);
  Network network;
  network.start.assign(mesh.half_edge_count(), Vector3::Zero());
  network.end.assign(mesh.half_edge_count(), Vector3::Zero());
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    std::tie(network.start[h], network.end[h]) = system.network.tangents(h, solution.basis);
  const std::vector<Index> faces = ascending_indices(mesh.face_count()),
                           vertices = ascending_indices(mesh.vertex_count());
  FairSystem::SolveOptions fair;
  fair.tolerance = share_tolerance;
  std::vector<QuarticPatch> patches(mesh.half_edge_count());
  const auto made = build_patches(system, field, network, {faces, vertices}, fair, cancel, patches);
  if (made.cancelled || cancel.cancelled()) return std::nullopt;
  return QuarticPatchArray(patches);
}

/// Takes the shares of the vertices of three colours from the coordinates of patches.
void take_shares(const HalfEdgeMesh& mesh, const BatchEvaluation& batch, std::size_t parameters,
                 const std::vector<Index>& colours, Index first, std::vector<FaceShares>& out) {
  parallel_for(out.size(), faces_per_task, [&](std::size_t begin, std::size_t end) {
    std::vector<PatchPoint> points;
    std::vector<Index> patches;
    for (std::size_t f = begin; f < end; ++f) {
      FaceShares& face = out[f];
      patches.resize(mesh.side_count(static_cast<Index>(f)));
      std::iota(patches.begin(), patches.end(), mesh.face_begin(static_cast<Index>(f)));
      points.resize(patches.size() * parameters);
      batch.evaluate(patches, Order::first, points);
      for (std::size_t j = 0; j < face.vertices.size(); ++j) {
        const Index colour = colours[face.vertices[j]];
        if (colour < first || colour >= first + 3) continue;
        for (std::size_t p = 0; p < points.size(); ++p)
          face.share[p * face.vertices.size() + j] =
              points[p].position[static_cast<Eigen::Index>(colour - first)];
      }
    }
  });
}

/// Scales the shares of each point to a sum of 1, as a displacement of all vertices is one of the surface.
/// Those of degenerate shapes, which are no shares of anything, stay.
void complete_shares(FaceShares& face) {
  const std::size_t count = face.vertices.size();
  for (std::size_t begin = 0; begin < face.share.size(); begin += count) {
    const auto share = std::span(face.share).subspan(begin, count);
    const double sum = std::accumulate(share.begin(), share.end(), 0.0);
    if (!(sum > 0.5)) continue;
    for (double& one : share) one /= sum;
  }
}

}  // namespace

Result<std::vector<FaceShares>> vertex_shares(const PolyhedronSurfaceInput& input,
                                              std::span<const Vector2> parameters,
                                              const CancelToken& cancel) {
  const auto system = system_of(input);
  if (!system) return system.error();
  const HalfEdgeMesh& mesh = *system->mesh;
  FaceRings rings(mesh);
  std::vector<FaceShares> out(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face_vertices(f);
    out[f].vertices = rings.within({corners.begin(), corners.end()}, rings_of_shares);
    std::sort(out[f].vertices.begin(), out[f].vertices.end());
    out[f].share.resize(out[f].vertices.size() * parameters.size() * mesh.side_count(f));
  }
  const VertexColours colours = coloured(mesh, rings);
  const auto tables = std::make_shared<QuarticTables>();
  std::vector<Vector3> field(mesh.vertex_count());
  for (Index first = 0; first < colours.count; first += 3) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const Index k = colours.of[v] - first;  // wraps below the first colour
      field[v].setZero();
      if (k < 3) field[v][static_cast<Eigen::Index>(k)] = 1;
    }
    auto patches = patches_of(*system, field, cancel);
    if (!patches) return make_error(e_cancelled, "The shares were not finished.");
    const QuarticPatchSet set(*std::move(patches), tables);
    const auto batch = set.batch({parameters.begin(), parameters.end()});
    take_shares(mesh, *batch, parameters.size(), colours.of, first, out);
  }
  for (FaceShares& face : out) complete_shares(face);
  return out;
}

}  // namespace hariko
