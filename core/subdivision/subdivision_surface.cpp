#include "core/subdivision/subdivision_surface.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/surface/triangle_collocation.hpp"

namespace hariko {

namespace {

constexpr double smooth_angle = 1e-6;

/// Weighted sum in the order of the kernel, hence with identical bits.
Vector3 sum(const std::vector<double>& weight, std::span<const Vector3> controls) {
  Vector3 out = Vector3::Zero();
  for (std::size_t k = 0; k < controls.size(); ++k) out += weight[k] * controls[k];
  return out;
}

/// Side that a parameter lies on and the fraction along it; -1 inside. A corner counts as on the side that
/// begins there.
struct OnSide {
  int side = -1;
  double x = 0;
};
OnSide on_side(const Vector2& p) {
  const double s = p.x(), t = p.y();
  if (t == 0 && s < 1) return {0, s};
  if (s == 1 && t < 1) return {1, t};
  if (t == 1 && s > 0) return {2, 1 - s};
  if (s == 0) return {3, 1 - t};
  return {};
}

}  // namespace

SubdivisionPatchSet::SubdivisionPatchSet(std::shared_ptr<const SubdivisionTopology> topology,
                                         std::vector<Vector3> positions,
                                         std::shared_ptr<const SkinResult> skin)
    : topology_(std::move(topology)), positions_(std::move(positions)), skin_(std::move(skin)) {
  HARIKO_ASSERT(positions_.size() == topology_->mesh().mesh.positions.size(), "one position a vertex");
}

std::vector<Vector3> SubdivisionPatchSet::gather(Index patch) const {
  const auto indices = topology_->controls(patch);
  std::vector<Vector3> out;
  out.reserve(indices.size());
  for (const Index v : indices) out.push_back(positions_[v]);
  return out;
}

Vector3 SubdivisionPatchSet::position_at(Index patch, const Vector2& parameter) const {
  return sum(topology_->weights(patch, parameter, Order::first).value, gather(patch));
}

Vector3 SubdivisionPatchSet::corner_position(Index patch, int corner) const {
  const auto& owner = topology_->node_owner(topology_->node(patch, corner));
  return position_at(owner.patch, corner_parameter(Domain::square, owner.corner));
}

Vector3 SubdivisionPatchSet::limit_position(Index vertex) const {
  const Index node = topology_->vertex_node(vertex);
  HARIKO_ASSERT(node != no_index, "no face uses the vertex");
  const auto& owner = topology_->node_owner(node);
  return position_at(owner.patch, corner_parameter(Domain::square, owner.corner));
}

PatchPoint SubdivisionPatchSet::evaluate(Index patch, const Vector2& parameter, Order order) const {
  const SubdivisionTopology::Weights w = topology_->weights(patch, parameter, order);
  const std::vector<Vector3> controls = gather(patch);
  PatchPoint out;
  out.ds = sum(w.ds, controls);
  out.dt = sum(w.dt, controls);
  if (order == Order::second) {
    out.dss = sum(w.dss, controls);
    out.dst = sum(w.dst, controls);
    out.dtt = sum(w.dtt, controls);
  }
  const auto [side, x] = on_side(parameter);
  if (side < 0) {
    out.position = sum(w.value, controls);
  } else if (x == 0) {
    out.position = corner_position(patch, side);
  } else {
    const auto& owner = topology_->owner({patch, std::uint8_t(side)});
    out.position = position_at(owner.side.patch,
                               side_parameter(Domain::square, owner.side.side, owner.reversed ? 1 - x : x));
  }
  return out;
}

/// Calls each(point of the grid, position) for the points on sides that belong to another patch.
template <class Each>
void SubdivisionPatchSet::for_border(Index patch, const GridPattern& pattern, const Each& each) const {
  using Derivatives = SubdivisionTopology::Derivatives;
  const int n = pattern.density;
  for (int s = 0; s < 4; ++s) {
    const std::vector<int> points = pattern.side(s);
    const auto& node = topology_->node_owner(topology_->node(patch, s));
    if (node.patch != patch || node.corner != s) {
      const auto table = topology_->table(node.patch, n, Derivatives::first);
      each(points[0], table_value(gather(node.patch), *table, std::size_t(pattern.side(node.corner)[0])));
    }
    const auto& owner = topology_->owner({patch, std::uint8_t(s)});
    if ((owner.side.patch == patch && owner.side.side == s) || n < 2) continue;
    const auto table = topology_->table(owner.side.patch, n, Derivatives::first);
    const std::vector<Vector3> controls = gather(owner.side.patch);
    const std::vector<int> theirs = pattern.side(owner.side.side);
    for (int k = 1; k < n; ++k)
      each(points[std::size_t(k)],
           table_value(controls, *table, std::size_t(theirs[std::size_t(owner.reversed ? n - k : k)])));
  }
}

void SubdivisionPatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                        std::span<Vector3> positions, std::span<Vector3> normals) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "the patches are squares");
  const auto points = std::size_t(pattern.point_count());
  HARIKO_ASSERT(positions.size() >= patches.size() * points && normals.size() >= patches.size() * points,
                "output arrays are too small");
  const StencilKernel kernel = stencil_kernel();
  const std::vector<Vector2> parameters = pattern.parameters();
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Index patch = patches[k];
    const auto table = topology_->table(patch, pattern.density, SubdivisionTopology::Derivatives::first);
    Vector3 *position = positions.data() + k * points, *normal = normals.data() + k * points;
    const bool degenerate = kernel.position_normal(gather(patch), *table, points, position, normal);
    for_border(patch, pattern, [&](int at, const Vector3& p) { position[at] = p; });
    if (!degenerate) continue;
    for (std::size_t i = 0; i < points; ++i)
      if (normal[i].isZero(0)) normal[i] = inner_normal(patch, parameters[i]);
  }
}

void SubdivisionPatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                        std::span<PatchPoint> out) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "the patches are squares");
  const auto points = std::size_t(pattern.point_count());
  HARIKO_ASSERT(out.size() >= patches.size() * points, "output array is too small");
  using Derivatives = SubdivisionTopology::Derivatives;
  const StencilKernel kernel = stencil_kernel();
  std::vector<Vector3> sums(3 * points);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    PatchPoint* point = out.data() + k * points;
    const std::vector<Vector3> controls = gather(patches[k]);
    for (const auto which : {Derivatives::first, Derivatives::second}) {
      kernel.accumulate(controls, *topology_->table(patches[k], pattern.density, which), points, sums.data());
      for (std::size_t i = 0; i < points; ++i) {
        const Vector3* three = sums.data() + 3 * i;
        if (which == Derivatives::first)
          point[i].position = three[0], point[i].ds = three[1], point[i].dt = three[2];
        else
          point[i].dss = three[0], point[i].dst = three[1], point[i].dtt = three[2];
      }
    }
    for_border(patches[k], pattern, [&](int at, const Vector3& p) { point[at].position = p; });
  }
}

void SubdivisionPatchSet::positions(Index patch, std::span<const Vector2> parameters,
                                    std::span<Vector3> out) const {
  const std::vector<Vector3> controls = gather(patch);
  for (std::size_t k = 0; k < parameters.size(); ++k)
    out[k] = sum(topology_->weights(patch, parameters[k], Order::first).value, controls);
}

void SubdivisionPatchSet::hull(Index, const ParameterTriangle&, std::span<const Vector3> samples,
                               std::span<HullBall> out) const {
  triangle_collocation(6).controls(samples, out);
}

namespace {

/// Common normal of the patches at each node, zero where there is none.
std::vector<Vector3> node_normals(const SubdivisionPatchSet& patches) {
  const SubdivisionTopology& topology = patches.topology();
  const std::size_t count = topology.patch_count();
  std::vector<Vector3> corner(4 * count);
  const GridPattern pattern{Domain::square, 1};
  parallel_for(count, 64, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> some;
    for (std::size_t p = begin; p < end; ++p) some.push_back(Index(p));
    std::vector<Vector3> positions(4 * some.size()), normals(4 * some.size());
    patches.evaluate_grid(some, pattern, positions, normals);
    for (std::size_t k = 0; k < some.size(); ++k)
      for (int c = 0; c < 4; ++c)
        corner[4 * some[k] + std::size_t(c)] = normals[4 * k + std::size_t(pattern.side(c)[0])];
  });
  std::vector<Vector3> out(topology.node_count(), Vector3::Zero());
  std::vector<char> seen(out.size(), 0);
  for (Index p = 0; p < count; ++p)
    for (int c = 0; c < 4; ++c) {
      const Index node = topology.node(p, c);
      const Vector3& normal = corner[4 * p + Index(c)];
      if (!seen[node])
        out[node] = normal;
      else if ((out[node] - normal).norm() > smooth_angle)
        out[node].setZero();
      seen[node] = 1;
    }
  return out;
}

}  // namespace

Surface subdivision_surface(const Vector3& origin, std::shared_ptr<const SubdivisionTopology> topology,
                            std::vector<Vector3> positions, std::shared_ptr<const SkinResult> skin) {
  auto patches = std::make_shared<const SubdivisionPatchSet>(topology, std::move(positions), std::move(skin));
  Surface::Parts parts;
  parts.origin = origin;
  parts.seams = topology->seams();
  parts.provenance = topology->provenance();
  parts.corner_nodes = topology->corner_nodes();
  parts.node_count = topology->node_count();
  parts.node_normals = std::make_shared<const std::vector<Vector3>>(node_normals(*patches));
  parts.boundary_sides = topology->boundary_sides();
  parts.boundary_sources = topology->boundary_sources();
  parts.patches = std::move(patches);
  return Surface(std::move(parts));
}

Result<Surface> subdivision_surface(const Vector3& origin, const ControlMesh& mesh) {
  auto topology = SubdivisionTopology::make(mesh);
  if (!topology) return topology.error();
  return subdivision_surface(origin, *topology, mesh.mesh.positions);
}

}  // namespace hariko
