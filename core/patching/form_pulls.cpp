#include "core/patching/form_pulls.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/network/kept_form.hpp"
#include "core/patching/surface_system.hpp"

namespace hariko {
namespace {

/// Power of a length: the energy of mode FAIR makes forces of it.
constexpr double force_power = 1.5;

/// Half-edges by which ends lead to the left: an end at the target of its half-edge looks from the other
/// side.
double left_sign(const HalfEdgeMesh& mesh, Index end) {
  const Index h = end / 2, first = mesh.half_edge_of_edge(mesh.edge(h));
  const bool at_origin_of_first = (h == first) == (end % 2 == 0);
  return at_origin_of_first ? 1 : -1;
}

/// Leans the faces beside edges and finds what holds them there.
class PullFinder {
 public:
  PullFinder(const PolyhedronSurfaceInput& input, const Vector3& image, const WantedNormals& wanted)
      : input_(input),
        polyhedron_(input.polyhedron),
        mesh_(polyhedron_.topology()),
        image_(image),
        wanted_(wanted),
        positions_(polyhedron_.positions()) {}

  Result<FlatMap<VertexId, KeptForm>> run() {
    auto network = NetworkSystem::assemble(polyhedron_, input_.shaping, {Frames::metric});
    if (!network) return network.error();
    system_.emplace(SurfaceSystem{
        polyhedron_.shared_topology(), std::move(network).value(), {}, Mode::fair, nullptr, nullptr});
    system_->constants = patch_constants(mesh_, system_->network.frames());
    system_->fair = std::make_unique<FairSystem>(system_->mesh, system_->network, system_->constants);
    const Network curves = system_->network.network(system_->network.solve(positions_, {}), positions_);
    std::vector<Index> faces(mesh_.face_count());
    std::iota(faces.begin(), faces.end(), Index(0));
    std::vector<QuarticPatch> patches(mesh_.half_edge_count());
    auto solved = build_patches(*system_, positions_, curves, {faces, {}}, {}, {}, patches);
    FairSystem::Field& unknowns = solved.unknowns;
    for (Index e = 0; e < mesh_.edge_count(); ++e) lean(e, patches, unknowns);

    const std::vector<QuarticPatch> base = base_patches(curves, faces);
    FairSystem::SolveOptions options;
    options.start = &unknowns;
    options.hold_sides = true;
    const auto held = system_->fair->solve(base, options);
    return forms(system_->fair->force(base, held.unknowns));
  }

 private:
  bool is_copy(VertexId id) const { return input_.aliases && input_.aliases->is_copy(id); }

  std::vector<Vector3> normals(Index a, Index b) const {
    const VertexId first = polyhedron_.vertex_id(a), second = polyhedron_.vertex_id(b);
    const bool copy = is_copy(first) || is_copy(second);
    if (!copy) return wanted_(first, second);
    std::vector<Vector3> out = wanted_(input_.aliases->original(first), input_.aliases->original(second));
    for (Vector3& normal : out) normal = normal.cwiseProduct(image_);
    return out;
  }

  /// Moves z at both ends of an edge along the normals there, so that the patches beside it touch the wanted
  /// planes: only z and what the network gives stand in their derivatives across the edge.
  void lean(Index e, const std::vector<QuarticPatch>& patches, FairSystem::Field& unknowns) const {
    Index h = mesh_.half_edge_of_edge(e);
    if (!system_->constants.smooth[h]) return;
    if (std::abs(system_->fair->side(mesh_.twin(h)).scale) > std::abs(system_->fair->side(h).scale))
      h = mesh_.twin(h);
    const std::vector<Vector3> wanted = normals(mesh_.origin(h), mesh_.target(h));
    if (wanted.empty()) return;
    using namespace quartic;
    const auto& d = patches[h].control;
    const FairSystem::Side side = system_->fair->side(h);
    const Vector3 &first = wanted.front(), &last = wanted.back();
    double aa = 0, ab = 0, bb = 0, ra = 0, rb = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double t = wanted_shares[i], s = 1 - t;
      const Vector3 row =
          s * s * s * d[d130] + 3 * s * s * t * d[d121u] + 3 * s * t * t * d[d112u] + t * t * t * d[d103];
      const Vector3 curve = s * s * s * s * d[d040] + 4 * s * s * s * t * d[d031] +
                            6 * s * s * t * t * d[d022] + 4 * s * t * t * t * d[d013] +
                            t * t * t * t * d[d004];
      const double off = (row - curve).dot(wanted[i]);
      const double a = 3 * s * s * t * side.scale * first.dot(wanted[i]);
      const double b = 3 * s * t * t * side.scale * last.dot(wanted[i]);
      aa += a * a;
      ab += a * b;
      bb += b * b;
      ra -= a * off;
      rb -= b * off;
    }
    const double det = aa * bb - ab * ab;
    if (!(det > 1e-6 * aa * bb)) return;
    unknowns[side.at_origin] += (bb * ra - ab * rb) / det * first;
    unknowns[side.at_target] += (aa * rb - ab * ra) / det * last;
  }

  /// Patches with all unknowns zero.
  std::vector<QuarticPatch> base_patches(const Network& curves, std::span<const Index> faces) const {
    PatchNetwork split;
    split.split_tangent.assign(mesh_.half_edge_count(), Vector3::Zero());
    split.centre.assign(mesh_.face_count(), Vector3::Zero());
    split.centre_tangent.assign(mesh_.half_edge_count(), Vector3::Zero());
    fill_split_tangents(mesh_, system_->network.frames(), system_->constants, positions_, curves, faces,
                        split);
    const PatchBuilder builder(mesh_, system_->constants, positions_, curves, split);
    std::vector<QuarticPatch> out;
    for (Index h = 0; h < mesh_.half_edge_count(); ++h) out.push_back(builder.base_patch(h));
    return out;
  }

  FlatMap<VertexId, KeptForm> forms(const FairSystem::Field& force) const {
    const FaceCharts& charts = system_->network.frames().charts;
    FlatMap<VertexId, KeptForm> out;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const VertexId id = polyhedron_.vertex_id(v);
      if (mesh_.outgoing(v) == no_index || is_copy(id)) continue;
      const std::vector<FanEnd> fan = fan_ends(mesh_, v);
      const std::vector<Matrix3> directions = edge_directions(polyhedron_, v, fan);
      const KeptForm* known = input_.shaping.form.find(id);
      KeptForm form;
      for (std::size_t k = 0; k < fan.size(); ++k) {
        const VertexId other = polyhedron_.vertex_id(fan[k].other);
        if (is_copy(other)) continue;
        const KeptForm::Edge* before = known ? known->find(other) : nullptr;
        KeptForm::Edge edge = before ? *before : KeptForm::Edge{other};
        const Index h = fan[k].end / 2, e = mesh_.edge(h), first = mesh_.half_edge_of_edge(e);
        const double length = charts.edge_length[e];
        if (system_->constants.smooth[h] && length > 0) {
          const FairSystem::Side side = system_->fair->side(first);
          const Vector3& own = force[mesh_.origin(first) == v ? side.at_origin : side.at_target];
          edge.pull = directions[k].transpose() * own *
                      (left_sign(mesh_, fan[k].end) / std::pow(length, force_power));
        }
        form.edges.push_back(edge);
      }
      std::sort(form.edges.begin(), form.edges.end(),
                [](const auto& x, const auto& y) { return x.to < y.to; });
      out.set(id, std::move(form));
    }
    return out;
  }

  const PolyhedronSurfaceInput& input_;
  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  Vector3 image_;
  const WantedNormals& wanted_;
  std::vector<Vector3> positions_;
  std::optional<SurfaceSystem> system_;
};

}  // namespace

std::vector<RimBend> form_pulls(const Polyhedron& polyhedron, const Shaping& shaping,
                                const VertexFrames& frames) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<RimBend> of_edge(shaping.form.empty() ? 0 : mesh.edge_count());
  for (const auto& [id, form] : shaping.form) {
    const Index v = polyhedron.find(id);
    if (v == no_index || mesh.outgoing(v) == no_index) continue;
    const std::vector<FanEnd> fan = fan_ends(mesh, v);
    const std::vector<Matrix3> directions = edge_directions(polyhedron, v, fan);
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const KeptForm::Edge* edge = form.find(polyhedron.vertex_id(fan[k].other));
      const Index e = mesh.edge(fan[k].end / 2), first = mesh.half_edge_of_edge(e);
      if (!edge || frames.sharp[e] || edge->pull.isZero(0)) continue;
      const Vector3 force = left_sign(mesh, fan[k].end) *
                            std::pow(frames.charts.edge_length[e], force_power) *
                            (directions[k] * edge->pull);
      of_edge[e].half_edge = first;
      (mesh.origin(first) == v ? of_edge[e].at_origin : of_edge[e].at_target) = force;
    }
  }
  std::erase_if(of_edge, [](const RimBend& each) { return each.half_edge == no_index; });
  return of_edge;
}

Result<FlatMap<VertexId, KeptForm>> with_pulls(const PolyhedronSurfaceInput& input, const Vector3& image,
                                               const WantedNormals& wanted) {
  return PullFinder(input, image, wanted).run();
}

}  // namespace hariko
