#include "core/patching/fair_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/conjugate_gradients.hpp"
#include "core/base/dense_solver.hpp"
#include "core/base/parallel.hpp"
#include "core/patching/fair_locals.hpp"

namespace hariko {

namespace {

constexpr std::size_t face_grain = 64;  ///< faces a task: about 0.1 ms of a step
constexpr std::size_t edge_grain = 128;
constexpr std::size_t dot_grain = 4096;
constexpr std::size_t block_grain = 16;  ///< blocks a task

using Array3 = Coefficients3;

}  // namespace

/// What one solve needs beside the unknowns, and the vector operations on the active ones.
struct FairSystem::Workspace {
  std::vector<Index> faces;        ///< active faces
  std::vector<Index> edges;        ///< smooth edges with an active face
  std::vector<Index> inner_edges;  ///< edges whose z are active: smooth with both faces active, or sharp
  std::vector<bool> active;        ///< per face
  ZeroedArray<double> local_in, local_out;  ///< per face, 3 x local size
  ZeroedArray<FairJump> jump;               ///< per edge
  std::vector<std::pair<std::size_t, std::size_t>>
      chunks;                   ///< ranges of active unknowns, ascending, disjoint
  std::size_t chunk_grain = 1;  ///< chunks a task

  /// Consecutive ranges grow together up to one task's worth.
  void add_chunks(std::size_t begin, std::size_t end) {
    if (!chunks.empty() && chunks.back().second == begin && end - chunks.back().first <= dot_grain) {
      chunks.back().second = end;
      return;
    }
    for (; begin < end; begin += dot_grain) chunks.emplace_back(begin, std::min(end, begin + dot_grain));
  }

  template <class Body>
  void for_chunks(const Body& body) const {
    parallel_for(chunks.size(), chunk_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) body(k, chunks[k].first, chunks[k].second);
    });
  }
  /// Per coordinate; sums a chunk at a time, in order.
  Array3 dot(const Field& a, const Field& b) const {
    std::vector<Array3> parts(chunks.size());
    for_chunks([&](std::size_t k, std::size_t begin, std::size_t end) {
      Array3 part = Array3::Zero();
      for (std::size_t i = begin; i < end; ++i) part += a[i].array() * b[i].array();
      parts[k] = part;
    });
    return std::accumulate(parts.begin(), parts.end(), Array3(Array3::Zero()));
  }
  /// y = scale y + factor x
  void combine(Field& y, const Array3& scale, const Array3& factor, const Field& x) const {
    for_chunks([&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) y[i] = scale * y[i].array() + factor * x[i].array();
    });
  }
};

/// The system as `conjugate_gradients` sees it.
struct FairSystem::Iteration {
  const FairSystem& system;
  Workspace& work;
  bool hold_sides = false;

  void apply(const Field& x, Field& y) { system.apply(work, x, y); }
  void precondition(const Field& r, Field& z) {
    system.precondition(work, r, z);
    if (hold_sides)
      for (std::size_t i = system.first_side_; i < system.unknown_count_; ++i) z[i].setZero();
  }
  Array3 dot(const Field& a, const Field& b) const { return work.dot(a, b); }
  void combine(Field& y, const Array3& scale, const Array3& factor, const Field& x) const {
    work.combine(y, scale, factor, x);
  }
};

FairSystem::FairSystem(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
                       const PatchConstants& constants, const std::vector<bool>& given_side,
                       const std::optional<FairWeights>& weights)
    : mesh_(std::move(mesh)), given_side_(given_side), corner_(network.frames().charts.corner) {
  number_unknowns();
  number_sides(constants);
  // Frames by measure: no two faces are equal.
  const Frames frames = network.frames().charts.frames;
  const bool shared = frames == Frames::equal;
  elements_ = std::make_shared<FairElements>(
      fair_measures(*mesh_, network, constants, weights.value_or(fair_weights(frames))), *mesh_, shared);
  build_preconditioner(shared);
}

void FairSystem::number_unknowns() {
  std::size_t next = 0, local = 0;
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    face_begin_.push_back(next);
    local_begin_.push_back(local);
    next += 3 + 2 * mesh_->side_count(f);
    local += static_cast<std::size_t>(local_size(f));
  }
  local_begin_.push_back(local);
  unknown_count_ = next;
}

void FairSystem::number_sides(const PatchConstants& constants) {
  const HalfEdgeMesh& mesh = *mesh_;
  side_origin_.resize(mesh.half_edge_count());
  side_target_.resize(mesh.half_edge_count());
  side_scale_.assign(mesh.half_edge_count(), 1.0);
  own_split_ = constants.own_split;
  std::size_t next = first_side_ = unknown_count_;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
    side_origin_[h] = next;
    side_target_[h] = next + 1;
    next += 2;
    if (twin == no_index) continue;
    if (constants
            .smooth[h]) {  // the condition is a_own G_own + a_other G_other = R: z moves along its null space
      side_origin_[twin] = side_target_[h];
      side_target_[twin] = side_origin_[h];
      side_scale_[h] = constants.own[twin];
      side_scale_[twin] = -constants.own[h];
    } else {
      side_origin_[twin] = next;
      side_target_[twin] = next + 1;
      next += 2;
    }
  }
  unknown_count_ = next;
}

void FairSystem::build_preconditioner(bool shared) {
  const HalfEdgeMesh& mesh = *mesh_;
  block_.resize(mesh.face_count());
  if (!shared) {
    parallel_for(mesh.face_count(), block_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        block_[f] = std::make_shared<const Block>(make_block(Index(f)));
    });
    return;
  }
  std::map<std::vector<const void*>, std::shared_ptr<const Block>> known;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    // Equal elements all round mean an equal block; the neighbour's element decides the scale of shared z as
    // well.
    std::vector<const void*> key{elements_->face(f)};
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      const Index e = mesh.edge(h);
      key.push_back(elements_->edge(e));
      const bool smooth = elements_->edge(e) != nullptr;
      key.push_back(smooth ? elements_->face(mesh.face(mesh.twin(h))) : nullptr);
      key.push_back(mesh.half_edge_of_edge(e) == h ? this : nullptr);
      key.push_back(is_given(h) ? this : nullptr);
    }
    auto& block = known[key];
    if (!block) block = std::make_shared<const Block>(make_block(f));
    block_[f] = block;
  }
}

FairSystem::Block FairSystem::make_block(Index face) const {
  const HalfEdgeMesh& mesh = *mesh_;
  const FaceElement& element = *elements_->face(face);
  const Eigen::Index n = Eigen::Index(element.sides), size = local_size(face);
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(size), weight = Eigen::VectorXd::Ones(size);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Index h = mesh.face_begin(face) + Index(j);
    for (const Eigen::Index at : {3 + 2 * n + 2 * j, 4 + 2 * n + 2 * j}) {
      scale[at] = side_scale_[h];
      if (elements_->edge(mesh.edge(h))) weight[at] = std::sqrt(0.5);
    }
  }
  Eigen::MatrixXd matrix = scaled_both_sides(scale, element.matrix);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Index h = mesh.face_begin(face) + Index(j), e = mesh.edge(h);
    const EdgeElement* edge = elements_->edge(e);
    if (!edge) continue;
    const bool first = mesh.half_edge_of_edge(e) == h;
    const JumpColumns& own = first ? edge->first_columns : edge->second_columns;
    const JumpColumns& other = first ? edge->second_columns : edge->first_columns;
    const Index twin = mesh.twin(h);
    const auto columns = element.columns(Index(j));
    JumpColumns rows = own;
    for (int a = 0; a < patch_unknown_count; ++a) rows.col(a) *= scale[columns[std::size_t(a)]];
    // The neighbour's z at its origin is ours at the target.
    rows.col(8) += side_scale_[twin] * other.col(7);
    rows.col(7) += side_scale_[twin] * other.col(8);
    for (int a = 0; a < patch_unknown_count; ++a)
      for (int b = 0; b < patch_unknown_count; ++b)
        matrix(columns[std::size_t(a)], columns[std::size_t(b)]) += rows.col(a).dot(rows.col(b));
    // The neighbour's own element also sees the shared z.
    const FaceElement& neighbour = *elements_->face(mesh.face(twin));
    const auto theirs = neighbour.columns(twin - mesh.face_begin(mesh.face(twin)));
    const double square = side_scale_[twin] * side_scale_[twin];
    const int mine[2] = {columns[7], columns[8]}, their[2] = {theirs[8], theirs[7]};
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) matrix(mine[a], mine[b]) += square * neighbour.matrix(their[a], their[b]);
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    if (!is_given(mesh.face_begin(face) + Index(j))) continue;
    for (const Eigen::Index known : {3 + 2 * n + 2 * j, 4 + 2 * n + 2 * j}) {
      for (Eigen::Index i = 0; i < size; ++i) matrix(known, i) = matrix(i, known) = 0;
      matrix(known, known) = 1;
      weight[known] = 0;
    }
  }
  const auto inverse = solve_definite(matrix, Eigen::MatrixXd::Identity(size, size));
  HARIKO_ASSERT(inverse, "the fairness energy of a face is positive definite");
  return scaled_both_sides(weight, *inverse);
}

void FairSystem::gather(Index face, const Field& x, bool scaled, double* local) const {
  const HalfEdgeMesh& mesh = *mesh_;
  const std::size_t n = mesh.side_count(face), size = 3 + 4 * n, first = face_begin_[face];
  const auto put = [&](std::size_t at, double scale, const Vector3& value) {
    for (std::size_t c = 0; c < 3; ++c) local[c * size + at] = scale * value[Eigen::Index(c)];
  };
  for (std::size_t i = 0; i < 3 + 2 * n; ++i) put(i, 1, x[first + i]);
  for (std::size_t j = 0; j < n; ++j) {
    const Index h = mesh.face_begin(face) + Index(j);
    const double scale = scaled ? side_scale_[h] : 1.0;
    put(3 + 2 * n + 2 * j, scale, x[side_origin_[h]]);
    put(4 + 2 * n + 2 * j, scale, x[side_target_[h]]);
  }
}

void FairSystem::scatter_interior(Index face, const double* local, Field& y) const {
  const std::size_t n = mesh_->side_count(face), size = 3 + 4 * n;
  for (std::size_t i = 0; i < 3 + 2 * n; ++i)
    y[face_begin_[face] + i] = Vector3(local[i], local[size + i], local[2 * size + i]);
}

void FairSystem::collect_sides(const Workspace& work, bool scaled, Field& y) const {
  const HalfEdgeMesh& mesh = *mesh_;
  const auto share = [&](Index h, int end) -> Vector3 {
    const Index f = mesh.face(h);
    const std::size_t n = mesh.side_count(f), size = 3 + 4 * n, j = h - mesh.face_begin(f);
    const double* local = work.local_out.data() + 3 * local_begin_[f] + 3 + 2 * n + 2 * j + std::size_t(end);
    return (scaled ? side_scale_[h] : 1.0) * Vector3(local[0], local[size], local[2 * size]);
  };
  parallel_for(work.inner_edges.size(), edge_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index e = work.inner_edges[k], h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
      if (elements_->edge(e)) {
        y[side_origin_[h]] = share(h, 0) + share(twin, 1);
        y[side_target_[h]] = share(h, 1) + share(twin, 0);
        continue;
      }
      for (const Index side : {h, twin}) {
        if (side == no_index || !work.active[mesh.face(side)] || is_given(side)) continue;
        y[side_origin_[side]] = share(side, 0);
        y[side_target_[side]] = share(side, 1);
      }
    }
  });
}

void FairSystem::apply(Workspace& work, const Field& x, Field& y) const {
  const HalfEdgeMesh& mesh = *mesh_;
  parallel_for(work.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      gather(work.faces[k], x, true, work.local_in.data() + 3 * local_begin_[work.faces[k]]);
  });
  const auto side_values = [&](Index h) {
    const Index f = mesh.face(h);
    const auto columns = elements_->face(f)->columns(h - mesh.face_begin(f));
    const double* local = work.local_in.data() + 3 * local_begin_[f];
    const std::size_t size = local_begin_[f + 1] - local_begin_[f];
    FairUnknowns values;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t a = 0; a < fair_unknown_count; ++a)
        values[c * fair_unknown_count + a] = local[c * size + std::size_t(columns[a])];
    return values;
  };
  parallel_for(work.edges.size(), edge_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index e = work.edges[k], h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
      FairJump& jump = work.jump[e];
      jump.fill(0);
      const auto add = [&](const JumpColumns& columns, Index side) {
        if (work.active[mesh.face(side)])
          add_product(fair_jump_size, fair_unknown_count, columns.data(), side_values(side).data(),
                      jump.data());
      };
      add(elements_->edge(e)->first_columns, h);
      add(elements_->edge(e)->second_columns, twin);
    }
  });
  parallel_for(work.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = work.faces[k];
      double* out = work.local_out.data() + 3 * local_begin_[f];
      apply_element(elements_->face(f)->matrix, work.local_in.data() + 3 * local_begin_[f], out);
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
        const Index e = mesh.edge(h);
        if (!elements_->edge(e)) continue;
        const bool first = mesh.half_edge_of_edge(e) == h;
        const JumpColumns& own =
            first ? elements_->edge(e)->first_columns : elements_->edge(e)->second_columns;
        FairUnknowns values{};
        add_transposed_product(fair_unknown_count, fair_jump_size, own.data(), work.jump[e].data(),
                               values.data());
        add_to_face(*elements_->face(f), h - mesh.face_begin(f), 1, values, out);
      }
      scatter_interior(f, out, y);
    }
  });
  collect_sides(work, true, y);
}

void FairSystem::precondition(Workspace& work, const Field& r, Field& z) const {
  parallel_for(work.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = work.faces[k];
      double* in = work.local_in.data() + 3 * local_begin_[f];
      double* out = work.local_out.data() + 3 * local_begin_[f];
      gather(f, r, false, in);
      apply_element(*block_[f], in, out);
      scatter_interior(f, out, z);
    }
  });
  collect_sides(work, false, z);
}

void FairSystem::right_side(Workspace& work, std::span<const QuarticPatch> base, Field& b) const {
  const HalfEdgeMesh& mesh = *mesh_;
  parallel_for(work.edges.size(), edge_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index e = work.edges[k], h = mesh.half_edge_of_edge(e);
      EdgeRows room;
      const EdgeRows& rows = elements_->rows(e, room);
      work.jump[e].fill(0);
      add_jump(rows.first, fair_controls(base[h]), work.jump[e]);
      add_jump(rows.second, fair_controls(base[mesh.twin(h)]), work.jump[e]);
    }
  });
  parallel_for(work.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    std::vector<FairControls> controls;  // of the face's patches
    std::vector<PatchParts> room;
    EdgeRows edge_room;
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = work.faces[k], first = mesh.face_begin(f), n = mesh.side_count(f);
      const FaceElement& element = *elements_->face(f);
      double* out = work.local_out.data() + 3 * local_begin_[f];
      std::fill(out, out + 3 * (local_begin_[f + 1] - local_begin_[f]), 0.0);
      const auto parts = elements_->parts(f, room);
      controls.clear();
      for (Index j = 0; j < n; ++j) controls.push_back(fair_controls(base[first + j]));
      for (Index j = 0; j < n; ++j) {
        const Index following = (j + 1) % n, behind = (j + n - 1) % n, e = mesh.edge(first + j);
        // The patch takes part in the jumps over its two split edges and over its side.
        FairJump before{}, after{};
        add_jump(parts[j].first, controls[j], before);
        add_jump(parts[behind].second, controls[behind], before);
        add_jump(parts[following].first, controls[following], after);
        add_jump(parts[j].second, controls[j], after);
        FairControls gradient{};
        add_product(fair_control_count, fair_control_count, parts[j].energy.data(), controls[j].data(),
                    gradient.data());
        add_gradient(parts[j].first, before, gradient);
        add_gradient(parts[j].second, after, gradient);
        if (elements_->edge(e)) {
          const bool first_side = mesh.half_edge_of_edge(e) == first + j;
          const EdgeRows& rows = elements_->rows(e, edge_room);
          add_gradient(first_side ? rows.first : rows.second, work.jump[e], gradient);
        }
        FairUnknowns values{};
        add_transposed_product(fair_unknown_count, fair_control_count, parts[j].dependence.data(),
                               gradient.data(), values.data());
        add_to_face(element, j, -1, values, out);
      }
      scatter_interior(f, out, b);
    }
  });
  collect_sides(work, true, b);
}

FairSystem::Workspace FairSystem::make_workspace(const SolveOptions& options) const {
  const HalfEdgeMesh& mesh = *mesh_;
  Workspace work;
  if (options.active_faces) {
    work.faces = *options.active_faces;
  } else {
    work.faces.resize(mesh.face_count());
    std::iota(work.faces.begin(), work.faces.end(), Index(0));
  }
  work.active.assign(mesh.face_count(), false);
  for (const Index f : work.faces) work.active[f] = true;
  std::vector<std::size_t> sides;
  for (const Index f : work.faces) {
    work.add_chunks(face_begin_[f], face_begin_[f] + 3 + 2 * std::size_t(mesh.side_count(f)));
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      const Index e = mesh.edge(h), twin = mesh.twin(h);
      const bool smooth = elements_->edge(e) != nullptr;
      const bool both = twin != no_index && work.active[mesh.face(twin)];
      if (!smooth && !is_given(h)) sides.push_back(side_origin_[h]);
      if (both && mesh.half_edge_of_edge(e) != h) continue;  // taken from the other side
      if (smooth && both) sides.push_back(side_origin_[mesh.half_edge_of_edge(e)]);
      if (smooth) work.edges.push_back(e);
      if (both || !smooth) work.inner_edges.push_back(e);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (const std::size_t first : sides) work.add_chunks(first, first + 2);
  std::size_t total = 1;
  for (const auto& [begin, end] : work.chunks) total += end - begin;
  work.chunk_grain = std::max<std::size_t>(1, dot_grain * work.chunks.size() / total);
  work.local_in = ZeroedArray<double>(3 * local_begin_.back());
  work.local_out = ZeroedArray<double>(3 * local_begin_.back());
  work.jump = ZeroedArray<FairJump>(mesh.edge_count());
  return work;
}

FairSystem::Solution FairSystem::solve(std::span<const QuarticPatch> base, const SolveOptions& options,
                                       const CancelToken& cancel) const {
  Workspace work = make_workspace(options);
  Solution solution;
  solution.unknowns = Field(unknown_count_);
  if (options.start) work.combine(solution.unknowns, Array3::Ones(), Array3::Ones(), *options.start);
  ConjugateGradientsRoom<Field> room{Field(unknown_count_), Field(unknown_count_), Field(unknown_count_),
                                     Field(unknown_count_)};
  right_side(work, base, room.residual);
  for (const RimBend& rim : options.rims) {
    room.residual[side_origin_[rim.half_edge]] += rim.at_origin;
    room.residual[side_target_[rim.half_edge]] += rim.at_target;
  }
  Iteration iteration{*this, work, options.hold_sides};
  const auto report =
      conjugate_gradients(iteration, solution.unknowns, room,
                          {options.start != nullptr, options.tolerance, options.max_steps}, cancel);
  solution.iterations = report.iterations;
  solution.converged = report.converged;
  solution.cancelled = report.cancelled;
  return solution;
}

FairSystem::Field FairSystem::force(std::span<const QuarticPatch> base, const Field& unknowns) const {
  Workspace work = make_workspace({});
  Field out(unknown_count_), right(unknown_count_);
  apply(work, unknowns, out);
  right_side(work, base, right);
  work.combine(out, Array3::Ones(), -Array3::Ones(), right);
  return out;
}

FairSystem::Field FairSystem::multiply(const Field& x) const {
  Workspace work = make_workspace({});
  Field y(unknown_count_);
  apply(work, x, y);
  return y;
}

void FairSystem::fill_split_points(const Field& unknowns, std::span<const Index> faces,
                                   PatchNetwork& out) const {
  for (const Index f : faces) {
    const Vector3* y = unknowns.data() + face_begin_[f];
    out.centre[f] = y[0];
    for (Index h = mesh_->face_begin(f); h < mesh_->face_end(f); ++h)
      out.centre_tangent[h] = corner_[h].y() * y[1] + corner_[h].x() * y[2];
  }
}

void FairSystem::add_free_parts(const Field& unknowns, std::span<const Index> faces,
                                std::span<QuarticPatch> patches) const {
  using namespace quartic;
  const HalfEdgeMesh& mesh = *mesh_;
  parallel_for(faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = faces[k], first = mesh.face_begin(f), n = mesh.side_count(f);
      const Vector3* split = unknowns.data() + face_begin_[f] + 3;
      for (Index j = 0; j < n; ++j) {
        auto& d = patches[first + j].control;
        const Index h = first + j, following = (j + 1) % n;
        // z moves the points beside a split edge in opposite directions, each by the other's weight in the
        // condition.
        const double other = 1 - own_split_[h], own = own_split_[first + following];
        d[d211w] += other * split[2 * j];
        d[d121w] -= other * split[2 * j + 1];
        d[d211v] -= own * split[2 * following];
        d[d112v] += own * split[2 * following + 1];
        d[d121u] += side_scale_[h] * unknowns[side_origin_[h]];
        d[d112u] += side_scale_[h] * unknowns[side_target_[h]];
      }
    }
  });
}

}  // namespace hariko
