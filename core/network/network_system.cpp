#include "core/network/network_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/base/solvers/conjugate_gradients.hpp"
#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

namespace {

constexpr std::size_t grain = 2048;  ///< vertices per task: about 0.1 ms of a step
/// 0.268^30 and 0.38^60 are below any sensible tolerance; ties of curves need more steps.
constexpr int max_steps = 30, max_steps_with_rays = 60, max_steps_with_ties = 400;

std::string name_of(VertexId id) {
  return "Vertex " + std::to_string(id.value);
}

}  // namespace

Result<NetworkSystem> NetworkSystem::assemble(const Polyhedron& polyhedron, const Shaping& shaping,
                                              const VertexFrameOptions& options) {
  NetworkSystem system;
  system.mesh_ = polyhedron.shared_topology();
  if (auto failed = system.read_tensions(polyhedron, shaping)) return *failed;
  auto frames = build_vertex_frames(polyhedron, shaping, options);
  if (!frames) return frames.error();
  system.frames_ = std::move(frames).value();

  const HalfEdgeMesh& mesh = *system.mesh_;
  system.all_vertices_ = ascending_indices(mesh.vertex_count());
  system.edge_ends_.resize(2 * std::size_t(mesh.edge_count()));
  system.incident_begin_.assign(mesh.vertex_count() + 1, 0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    system.edge_ends_[2 * e] = system.frames_.ends[2 * h];
    system.edge_ends_[2 * e + 1] = system.frames_.ends[2 * h + 1];
    ++system.incident_begin_[mesh.origin(h) + 1];
    ++system.incident_begin_[mesh.target(h) + 1];
  }
  std::partial_sum(system.incident_begin_.begin(), system.incident_begin_.end(),
                   system.incident_begin_.begin());
  system.incident_ends_.resize(2 * std::size_t(mesh.edge_count()));
  std::vector<Index> cursor(system.incident_begin_.begin(), system.incident_begin_.end() - 1);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    system.incident_ends_[cursor[mesh.origin(h)]++] = 2 * e;
    system.incident_ends_[cursor[mesh.target(h)]++] = 2 * e + 1;
  }
  NetworkWeights weights = network_weights(mesh, system.frames_);
  if (!weights.ray.empty()) {
    const auto& positions = polyhedron.positions();
    system.balanced_ = BalancedPulls(mesh, system.frames_, weights, system.beta_, positions);
    system.ties_ = CurveTies(mesh, system.frames_, weights, system.beta_, positions);
  }
  system.edge_weight_ = std::move(weights.edge);
  if (!weights.ray.empty())
    system.rays_ = NetworkRays(system.mesh_, system.frames_, system.alpha_, weights.ray, system.balanced_);
  if (auto failed = system.read_pins(polyhedron, shaping)) return *failed;
  if (auto failed = system.factor_blocks(polyhedron)) return *failed;
  return system;
}

std::optional<Message> NetworkSystem::read_tensions(const Polyhedron& polyhedron, const Shaping& shaping) {
  const auto check = [](double value, const std::string& what, Element element) -> std::optional<Message> {
    if (!std::isfinite(value))
      return make_error(e_tension_nonfinite, what + " is not a number.", "Set it to a finite value.",
                        element);
    if (value < 0)
      return make_error(e_tension_negative, what + " is negative.", "Set it to zero or more.", element);
    return std::nullopt;
  };
  alpha_.assign(polyhedron.vertex_count(), 0.0);
  for (const auto& [id, value] : shaping.alpha) {
    if (auto failed = check(value, "The tension of vertex " + std::to_string(id.value), element_of(id)))
      return failed;
    if (const Index v = polyhedron.find(id); v != no_index) alpha_[v] = value;
  }
  beta_.assign(polyhedron.edge_count(), 1.0);
  for (const auto& [id, value] : shaping.beta) {
    if (auto failed = check(value, "The tension of edge " + to_string(id), element_of(id))) return failed;
    if (const Index e = polyhedron.find(id); e != no_index) beta_[e] = value;
  }
  return std::nullopt;
}

std::optional<Message> NetworkSystem::read_pins(const Polyhedron& polyhedron, const Shaping& shaping) {
  for (const auto& [id, pin] : shaping.pin) {
    const Index v = polyhedron.find(id);
    if (v == no_index) continue;
    const Index count = frames_.basis_begin[v + 1] - frames_.basis_begin[v];
    const bool right_size =
        pin.kind == Pin::Kind::normal ? pin.vectors.size() == 1 : pin.vectors.size() == count;
    bool usable = right_size && count > 0;
    for (const Vector3& vector : pin.vectors) usable = usable && vector.allFinite();
    if (usable && pin.kind == Pin::Kind::normal) usable = pin.vectors[0].stableNorm() > 0;
    if (!usable)
      return make_error(e_pin_mismatch,
                        "The pin at vertex " + std::to_string(id.value) + " does not fit the vertex: " +
                            (pin.kind == Pin::Kind::normal
                                 ? "it needs one normal that is not zero."
                                 : "it needs " + std::to_string(count) + " finite tangent vectors."),
                        "Release the pin and set it again.", element_of(id));
    if (pin_state_.empty()) {
      pin_state_.assign(polyhedron.vertex_count(), PinState::none);
      pin_normal_.assign(polyhedron.vertex_count(), Vector3::Zero());
      pinned_basis_.assign(frames_.basis_count(), Vector3::Zero());
    }
    if (pin.kind == Pin::Kind::normal) {
      pin_state_[v] = PinState::normal;
      pin_normal_[v] = pin.vectors[0].stableNormalized();
      couples_coordinates_ = true;
    } else {
      pin_state_[v] = PinState::fixed;
      for (Index b = 0; b < count; ++b) pinned_basis_[frames_.basis_begin[v] + b] = pin.vectors[b];
    }
  }
  return std::nullopt;
}

Eigen::MatrixXd NetworkSystem::diagonal_block(Index v) const {
  const Index first = frames_.basis_begin[v];
  const Index count = frames_.basis_begin[v + 1] - first;
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(count, count);
  for (Index i = incident_begin_[v]; i < incident_begin_[v + 1]; ++i) {
    const TangentCoefficients& end = edge_ends_[incident_ends_[i]];
    const Index e = incident_ends_[i] / 2;
    const double weight = 2 * edge_weight_[e] * (beta_[e] + alpha_[v]);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        if (end.basis[a] != no_index && end.basis[b] != no_index)
          block(end.basis[a] - first, end.basis[b] - first) += weight * end.c[a] * end.c[b];
  }
  return block;
}

void NetworkSystem::set_conditions(std::span<const BasisCondition> conditions) {
  conditioned_.clear();
  plane_conditions_ = false;
  for (const BasisCondition& condition : conditions) {
    const Index v = condition.vertex, first = frames_.basis_begin[v];
    const std::size_t count = frames_.basis_begin[v + 1] - first;
    HARIKO_ASSERT(condition.basis >= first && condition.basis - first < count,
                  "a basis vector of the vertex");
    HARIKO_ASSERT(pin_state_.empty() || pin_state_[v] == PinState::none, "a pin and a condition at a vertex");
    ConditionedVertex& vertex = conditioned_[v];
    if (vertex.free.empty()) {
      vertex.free.assign(count, Matrix3::Identity());
      vertex.known.assign(count, Vector3::Zero());
    }
    const std::size_t b = condition.basis - first;
    if (condition.kind == BasisCondition::Kind::fixed) {
      vertex.free[b].setZero();
      vertex.known[b] = condition.vector;
    } else {
      const Vector3 normal = condition.vector.stableNormalized();
      vertex.free[b] -= normal * normal.transpose();
      plane_conditions_ = true;
    }
  }
  for (auto& [v, vertex] : conditioned_) {
    Eigen::MatrixXd block = diagonal_block(v);
    rays_.add_diagonal(v, frames_.basis_begin[v], block);
    ties_.add_diagonal(v, frames_.basis_begin[v], block);
    const Eigen::Index count = block.rows();
    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(3 * count, 3 * count), full = free;
    for (Eigen::Index i = 0; i < count; ++i) {
      free.block<3, 3>(3 * i, 3 * i) = vertex.free[std::size_t(i)];
      for (Eigen::Index j = 0; j < count; ++j)
        full.block<3, 3>(3 * i, 3 * j) = block(i, j) * Matrix3::Identity();
    }
    const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(3 * count, 3 * count) - free;
    const Eigen::MatrixXd whole = matrix_product(matrix_product(free, full), free) + rest;
    vertex.inverse = matrix_product(matrix_product(free, inverse_matrix(whole)), free);
  }
}

std::optional<Message> NetworkSystem::factor_blocks(const Polyhedron& polyhedron) {
  block_begin_.reserve(polyhedron.vertex_count() + 1);
  std::size_t begin = 0;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    block_begin_.push_back(begin);
    const Index first = frames_.basis_begin[v];
    const Index count = frames_.basis_begin[v + 1] - first;
    begin += std::size_t(count) * count;
  }
  block_begin_.push_back(begin);
  block_inverse_.resize(begin);
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    const Index first = frames_.basis_begin[v];
    const Index count = frames_.basis_begin[v + 1] - first;
    if (count == 0) continue;
    Eigen::MatrixXd block = diagonal_block(v);
    const Eigen::VectorXd eigenvalues = symmetric_eigenvalues(block);
    const double largest = eigenvalues.maxCoeff();
    const bool fixed = !pin_state_.empty() && pin_state_[v] == PinState::fixed;
    if (!fixed && !(eigenvalues.minCoeff() > 1e-12 * largest))
      return make_error(e_singular_vertex,
                        name_of(polyhedron.vertex_id(v)) +
                            " has no tension in some direction, so its tangents are not determined.",
                        "Raise the tension of one of its edges above zero.",
                        element_of(polyhedron.vertex_id(v)));
    rays_.add_diagonal(v, first, block);
    ties_.add_diagonal(v, first, block);
    const Eigen::MatrixXd inverse =
        fixed ? Eigen::MatrixXd(Eigen::MatrixXd::Zero(count, count)) : inverse_matrix(block);
    for (Index i = 0; i < count; ++i)
      for (Index j = 0; j < count; ++j) block_inverse_[block_begin_[v] + i * count + j] = inverse(i, j);
  }
  return std::nullopt;
}

void NetworkSystem::apply(std::span<const Index> vertices, const std::vector<Vector3>& x, Workspace& work,
                          std::vector<Vector3>& y) const {
  parallel_for(vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (Index i = incident_begin_[vertices[k]]; i < incident_begin_[vertices[k] + 1]; ++i) {
        const Index at = incident_ends_[i];
        work.end_tangents[at] = tangent_image(edge_ends_[at], x);
      }
      if (!rays_.empty()) rays_.set_tangents(vertices[k], x, work.rays);
    }
  });
  parallel_for(work.rays.faces.size(), grain,
               [&](std::size_t begin, std::size_t end) { rays_.answer(begin, end, work.rays); });
  parallel_for(vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index v = vertices[k];
      for (Index b = frames_.basis_begin[v]; b < frames_.basis_begin[v + 1]; ++b) y[b].setZero();
      for (Index i = incident_begin_[v]; i < incident_begin_[v + 1]; ++i) {
        const Index at = incident_ends_[i];
        const double beta = beta_[at / 2];
        const Vector3 gradient =
            edge_weight_[at / 2] * (2 * (beta + alpha_[v]) * work.end_tangents[at] -
                                    balanced_.of_edge(at / 2) * beta * work.end_tangents[at ^ 1U]);
        add_to_basis(edge_ends_[at], gradient, y);
      }
      if (!rays_.empty()) rays_.add_product(v, work.rays, y);
      ties_.add_product(v, x, y);
    }
  });
}

void NetworkSystem::precondition(std::span<const Index> vertices, const std::vector<Vector3>& r,
                                 std::vector<Vector3>& z) const {
  parallel_for(vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index v = vertices[k], first = frames_.basis_begin[v], count = frames_.basis_begin[v + 1] - first;
      const double* inverse = block_inverse_.data() + block_begin_[v];
      for (Index i = 0; i < count; ++i) {
        Vector3 sum = Vector3::Zero();
        for (Index j = 0; j < count; ++j) sum += inverse[i * count + j] * r[first + j];
        z[first + i] = sum;
      }
    }
  });
  if (conditioned_.empty()) return;
  for (const Index v : vertices) {
    const auto found = conditioned_.find(v);
    if (found == conditioned_.end()) continue;
    const Index first = frames_.basis_begin[v];
    const Eigen::Index size = found->second.inverse.rows();
    const Eigen::VectorXd given = Eigen::Map<const Eigen::VectorXd>(r[first].data(), size);
    const Eigen::VectorXd got = matrix_product(found->second.inverse, given);
    std::copy_n(got.data(), size, z[first].data());
  }
}

void NetworkSystem::keep_in_planes(std::span<const Index> vertices, std::vector<Vector3>& x) const {
  if (pin_state_.empty()) return;
  for (const Index v : vertices)
    if (pin_state_[v] == PinState::normal)
      for (Index b = frames_.basis_begin[v]; b < frames_.basis_begin[v + 1]; ++b)
        x[b] -= pin_normal_[v] * pin_normal_[v].dot(x[b]);
}

void NetworkSystem::project(std::span<const Index> vertices, std::vector<Vector3>& r) const {
  keep_in_planes(vertices, r);
  if (!pin_state_.empty())
    for (const Index v : vertices)
      if (pin_state_[v] == PinState::fixed)
        for (Index b = frames_.basis_begin[v]; b < frames_.basis_begin[v + 1]; ++b) r[b].setZero();
  for (const auto& [v, vertex] : conditioned_)
    for (std::size_t b = 0; b < vertex.free.size(); ++b) {
      Vector3& vector = r[frames_.basis_begin[v] + b];
      vector = vertex.free[b] * vector;
    }
}

std::vector<Vector3> NetworkSystem::right_side(std::span<const Index> vertices,
                                               std::span<const Vector3> positions) const {
  std::vector<Vector3> b(frames_.basis_count(), Vector3::Zero());
  for (const Index v : vertices)
    for (Index i = incident_begin_[v]; i < incident_begin_[v + 1]; ++i) {
      const Index at = incident_ends_[i], h = mesh_->half_edge_of_edge(at / 2);
      const Index other = at & 1U ? mesh_->origin(h) : mesh_->target(h);
      // D has the same weight as both tangents of a straight edge together.
      const double share = (2 + balanced_.of_edge(at / 2)) / 3;
      const Vector3 pull = edge_weight_[at / 2] * beta_[at / 2] * share * (positions[other] - positions[v]);
      add_to_basis(edge_ends_[at], pull, b);
    }
  rays_.add_right_side(vertices, positions, b);
  balanced_.add_right_side(*mesh_, vertices, positions, b);
  ties_.add_right_side(vertices, positions, b);
  return b;
}

std::vector<Vector3> NetworkSystem::starting_point(std::span<const Index> vertices,
                                                   const SolveOptions& options) const {
  const bool warm = options.start && options.start->size() == frames_.basis_count();
  std::vector<Vector3> x =
      warm ? *options.start : std::vector<Vector3>(frames_.basis_count(), Vector3::Zero());
  project(vertices, x);
  if (options.homogeneous) return x;
  if (!pin_state_.empty())
    for (const Index v : vertices)
      if (pin_state_[v] == PinState::fixed)
        for (Index i = frames_.basis_begin[v]; i < frames_.basis_begin[v + 1]; ++i) x[i] = pinned_basis_[i];
  for (const auto& [v, vertex] : conditioned_)
    for (std::size_t b = 0; b < vertex.known.size(); ++b) x[frames_.basis_begin[v] + b] += vertex.known[b];
  return x;
}

double NetworkSystem::dot(std::span<const Index> vertices, const std::vector<Vector3>& a,
                          const std::vector<Vector3>& b) const {
  return parallel_sum(vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t k = begin; k < end; ++k)
      for (Index i = frames_.basis_begin[vertices[k]]; i < frames_.basis_begin[vertices[k] + 1]; ++i)
        sum += a[i].dot(b[i]);
    return sum;
  });
}

void NetworkSystem::combine(std::span<const Index> vertices, std::vector<Vector3>& y, double scale,
                            double factor, const std::vector<Vector3>& x) const {
  parallel_for(vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      for (Index i = frames_.basis_begin[vertices[k]]; i < frames_.basis_begin[vertices[k] + 1]; ++i)
        y[i] = scale * y[i] + factor * x[i];
  });
}

/// System at some vertices in the form that conjugate gradients need, projected onto the directions that pins
/// and conditions leave free.
struct NetworkSystem::Projected {
  using Field = std::vector<Vector3>;
  const NetworkSystem& system;
  std::span<const Index> vertices;
  Workspace& work;

  void apply(const Field& x, Field& y) const {
    system.apply(vertices, x, work, y);
    system.project(vertices, y);
  }
  void precondition(const Field& r, Field& z) const { system.precondition(vertices, r, z); }
  double dot(const Field& a, const Field& b) const { return system.dot(vertices, a, b); }
  void combine(Field& y, double scale, double factor, const Field& x) const {
    system.combine(vertices, y, scale, factor, x);
  }
};

NetworkSystem::Solution NetworkSystem::solve(std::span<const Vector3> positions,
                                             const SolveOptions& options) const {
  const std::vector<Index>& vertices = options.active_vertices ? *options.active_vertices : all_vertices_;
  const std::vector<Vector3> zero(frames_.basis_count(), Vector3::Zero());
  ConjugateGradientsWorkspace<std::vector<Vector3>, double> room{zero, zero, zero, zero};
  std::vector<Vector3>&r = room.residual, &q = room.image;
  Workspace work{std::vector<Vector3>(edge_ends_.size(), Vector3::Zero()), rays_.make_workspace(vertices)};
  const int limit = !ties_.empty() ? max_steps_with_ties : rays_.empty() ? max_steps : max_steps_with_rays;
  Solution solution;
  std::vector<Vector3>& x = solution.basis;
  x = starting_point(vertices, options);

  r = right_side(vertices, positions);
  if (!frames_.offset.empty() && !options.homogeneous) {  // the solution is offset by kept forms
    apply(vertices, frames_.offset, work, q);
    combine(vertices, r, 1, 1, q);
  }
  std::vector<Vector3> b = r;
  project(vertices, b);
  precondition(vertices, b, room.preconditioned);
  room.enough = options.tolerance * options.tolerance * dot(vertices, b, room.preconditioned);
  // The initial guess need not lie in the free directions: its residual is projected here, and measured
  // against b.
  apply(vertices, x, work, q);
  combine(vertices, r, 1, -1, q);
  project(vertices, r);
  Projected system{*this, vertices, work};
  solution.iterations =
      conjugate_gradients(system, x, room, {.max_steps = limit, .corrected = true}, {}).iterations;
  // The rounding errors of many steps would otherwise move the tangents slightly out of the pinned planes.
  keep_in_planes(vertices, x);
  for (const auto& [v, vertex] : conditioned_)
    for (std::size_t k = 0; k < vertex.known.size(); ++k) {
      Vector3& vector = x[frames_.basis_begin[v] + k];
      vector = vertex.free[k] * vector;
      if (!options.homogeneous) vector += vertex.known[k];
    }
  return solution;
}

std::pair<Vector3, Vector3> NetworkSystem::tangents(Index half_edge, std::span<const Vector3> basis) const {
  return {tangent_image(frames_.ends[2 * half_edge], basis),
          tangent_image(frames_.ends[2 * half_edge + 1], basis)};
}

Network NetworkSystem::network(const Solution& solution, std::span<const Vector3> positions) const {
  const HalfEdgeMesh& mesh = *mesh_;
  Network network;
  network.iterations = solution.iterations;
  network.start.resize(mesh.half_edge_count());
  network.end.resize(mesh.half_edge_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    std::tie(network.start[h], network.end[h]) = tangents(h, solution.basis);

  network.normal.assign(mesh.vertex_count(), Vector3::Zero());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index first = frames_.basis_begin[v];
    const Vector3* x = solution.basis.data() + first;
    const bool one_sector = mesh.is_border_vertex(v) && frames_.basis_begin[v + 1] - first == 2;
    Vector3 normal = Vector3::Zero();
    if (frames_.kind[v] == FrameKind::smooth)
      normal = x[1].cross(x[0]);
    else if (one_sector && frames_.kind[v] == FrameKind::corner)  // its opening may exceed a half turn
      normal = network.start[mesh.outgoing(v)].cross(network.end[mesh.previous(mesh.outgoing(v))]);
    else if (one_sector)  // Tc, Ts
      normal = x[0].cross(x[1]);
    network.normal[v] = normal.stableNormalized();
  }

  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), a = mesh.origin(h), b = mesh.target(h);
    const Vector3 d = positions[b] - positions[a];
    const Vector3 bend_a = d + network.end[h] - 2 * network.start[h];
    const Vector3 bend_b = -d + network.start[h] - 2 * network.end[h];
    network.energy += edge_weight_[e] *
                      (beta_[e] / 3 * (bend_a.squaredNorm() + bend_a.dot(bend_b) + bend_b.squaredNorm()) +
                       alpha_[a] * network.start[h].squaredNorm() + alpha_[b] * network.end[h].squaredNorm());
  }
  return network;
}

}  // namespace hariko
