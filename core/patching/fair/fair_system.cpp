#include "core/patching/fair/fair_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/base/solvers/conjugate_gradients.hpp"
#include "core/patching/fair/fair_locals.hpp"
#include "core/patching/fair/fair_sweeps.hpp"

namespace hariko {

namespace {

constexpr std::size_t face_grain = 64;  ///< faces per task
constexpr std::size_t edge_grain = 128;
constexpr std::size_t dot_grain = 4096;

/// Tolerance from which on solutions are checked by the matrix itself, and corrected.
constexpr double checked_tolerance = 1e-12;
constexpr int most_corrections = 2;
/// Limit of the squared share of the residual that may come from rounding.
constexpr double largest_drift = 0.25;

using Array3 = Coefficients3;

}  // namespace

/// Workspace of a solve, and the vector operations on the active unknowns.
struct FairSystem::Workspace {
  FairSweeps::Plan plan;           ///< its faces are the active faces
  std::vector<Index> edges;        ///< smooth edges with an active face
  std::vector<Index> inner_edges;  ///< edges whose z are active: smooth with both faces active, or sharp
  ZeroedArray<double> local_in, local_out;  ///< per face, 3 x local size
  ZeroedArray<FairJump> jump;               ///< per edge
  /// Ranges of active unknowns, ascending, disjoint.
  std::vector<std::pair<std::size_t, std::size_t>> chunks;
  std::size_t chunk_grain = 1;  ///< chunks per task

  /// Appends a range of unknowns; consecutive ranges are merged up to the size of one task.
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
  /// Dot product per coordinate; summed by chunks, in order.
  Array3 dot(const Field& a, const Field& b) const {
    std::vector<Array3> parts(chunks.size());
    for_chunks([&](std::size_t k, std::size_t begin, std::size_t end) {
      Array3 part = Array3::Zero();
      for (std::size_t i = begin; i < end; ++i) part += a[i].array() * b[i].array();
      parts[k] = part;
    });
    return std::accumulate(parts.begin(), parts.end(), Array3(Array3::Zero()));
  }
  /// Computes y = scale y + factor x.
  void combine(Field& y, const Array3& scale, const Array3& factor, const Field& x) const {
    for_chunks([&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) y[i] = scale * y[i].array() + factor * x[i].array();
    });
  }
};

/// System in the form that `conjugate_gradients` needs.
struct FairSystem::Iteration {
  const FairSystem& system;
  Workspace& work;

  void apply(const Field& x, Field& y) { system.apply(work, x, y); }
  void precondition(const Field& r, Field& z, Field& image) { system.sweeps_->apply(work.plan, r, z, image); }
  Array3 dot(const Field& a, const Field& b) const { return work.dot(a, b); }
  void combine(Field& y, const Array3& scale, const Array3& factor, const Field& x) const {
    work.combine(y, scale, factor, x);
  }
};

FairSystem::FairSystem(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
                       const PatchConstants& constants, const std::vector<bool>& given_side,
                       const std::optional<FairWeights>& weights)
    : numbering_(std::move(mesh), constants, given_side),
      own_split_(constants.own_split),
      corner_(network.frames().charts.corner) {
  // In metric frames no two faces are equal.
  const Frames frames = network.frames().charts.frames;
  const bool shared = frames == Frames::equal;
  elements_ = std::make_unique<const FairElements>(
      fair_measures(*numbering_.mesh, network, constants, weights.value_or(fair_weights(frames))),
      *numbering_.mesh, shared);
  sweeps_ = std::make_unique<const FairSweeps>(*elements_, numbering_, shared);
}

FairSystem::~FairSystem() = default;

void FairSystem::collect_sides(const Workspace& work, Field& y) const {
  const HalfEdgeMesh& mesh = this->mesh();
  const auto share = [&](Index h, int end) -> Vector3 {
    const Index f = mesh.face(h);
    const std::size_t n = mesh.side_count(f), size = 3 + 4 * n, j = h - mesh.face_begin(f);
    const double* local =
        work.local_out.data() + 3 * numbering_.local_begin[f] + 3 + 2 * n + 2 * j + std::size_t(end);
    return numbering_.side_scale[h] * Vector3(local[0], local[size], local[2 * size]);
  };
  parallel_for(work.inner_edges.size(), edge_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index e = work.inner_edges[k], h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
      if (elements_->edge(e)) {
        y[numbering_.side_origin[h]] = share(h, 0) + share(twin, 1);
        y[numbering_.side_target[h]] = share(h, 1) + share(twin, 0);
        continue;
      }
      for (const Index side : {h, twin}) {
        if (side == no_index || !work.plan.active[mesh.face(side)] || numbering_.is_given(side)) continue;
        y[numbering_.side_origin[side]] = share(side, 0);
        y[numbering_.side_target[side]] = share(side, 1);
      }
    }
  });
}

void FairSystem::apply(Workspace& work, const Field& x, Field& y) const {
  const HalfEdgeMesh& mesh = this->mesh();
  parallel_for(work.plan.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      numbering_.gather(work.plan.faces[k], x, true,
                        work.local_in.data() + 3 * numbering_.local_begin[work.plan.faces[k]]);
  });
  const auto side_values = [&](Index h) {
    const Index f = mesh.face(h);
    const auto columns = elements_->face(f)->columns(h - mesh.face_begin(f));
    const double* local = work.local_in.data() + 3 * numbering_.local_begin[f];
    const std::size_t size = numbering_.local_begin[f + 1] - numbering_.local_begin[f];
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
        if (work.plan.active[mesh.face(side)])
          add_product(fair_jump_size, fair_unknown_count, columns.data(), side_values(side).data(),
                      jump.data());
      };
      add(elements_->edge(e)->first_columns, h);
      add(elements_->edge(e)->second_columns, twin);
    }
  });
  parallel_for(work.plan.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = work.plan.faces[k];
      double* out = work.local_out.data() + 3 * numbering_.local_begin[f];
      apply_element(elements_->face(f)->matrix, work.local_in.data() + 3 * numbering_.local_begin[f], out);
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
      numbering_.scatter_interior(f, out, y);
    }
  });
  collect_sides(work, y);
}

void FairSystem::right_side(Workspace& work, std::span<const QuarticPatch> base, Field& b) const {
  const HalfEdgeMesh& mesh = this->mesh();
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
  parallel_for(work.plan.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    std::vector<FairControls> controls;  // control points of the face's patches
    std::vector<PatchParts> room;
    EdgeRows edge_room;
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = work.plan.faces[k], first = mesh.face_begin(f), n = mesh.side_count(f);
      const FaceElement& element = *elements_->face(f);
      double* out = work.local_out.data() + 3 * numbering_.local_begin[f];
      std::fill(out, out + 3 * (numbering_.local_begin[f + 1] - numbering_.local_begin[f]), 0.0);
      const auto parts = elements_->parts(f, room);
      controls.clear();
      for (Index j = 0; j < n; ++j) controls.push_back(fair_controls(base[first + j]));
      for (Index j = 0; j < n; ++j) {
        const Index following = (j + 1) % n, behind = (j + n - 1) % n, e = mesh.edge(first + j);
        // The patch contributes to the jumps across its two split edges and across its side.
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
      numbering_.scatter_interior(f, out, b);
    }
  });
  collect_sides(work, b);
}

FairSystem::Workspace FairSystem::make_workspace(const SolveOptions& options) const {
  const HalfEdgeMesh& mesh = this->mesh();
  Workspace work;
  work.plan =
      sweeps_->plan(options.active_faces ? *options.active_faces : ascending_indices(mesh.face_count()));
  std::vector<std::size_t> sides;
  for (const Index f : work.plan.faces) {
    work.add_chunks(numbering_.face_begin[f],
                    numbering_.face_begin[f] + 3 + 2 * std::size_t(mesh.side_count(f)));
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      const Index e = mesh.edge(h), twin = mesh.twin(h);
      const bool smooth = elements_->edge(e) != nullptr;
      const bool both = twin != no_index && work.plan.active[mesh.face(twin)];
      if (!smooth && !numbering_.is_given(h)) sides.push_back(numbering_.side_origin[h]);
      if (both && mesh.half_edge_of_edge(e) != h) continue;  // taken from the other side
      if (smooth && both) sides.push_back(numbering_.side_origin[mesh.half_edge_of_edge(e)]);
      if (smooth) work.edges.push_back(e);
      if (both || !smooth) work.inner_edges.push_back(e);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (const std::size_t first : sides) work.add_chunks(first, first + 2);
  std::size_t total = 1;
  for (const auto& [begin, end] : work.chunks) total += end - begin;
  work.chunk_grain = std::max<std::size_t>(1, dot_grain * work.chunks.size() / total);
  work.local_in = ZeroedArray<double>(3 * numbering_.local_begin.back());
  work.local_out = ZeroedArray<double>(3 * numbering_.local_begin.back());
  work.jump = ZeroedArray<FairJump>(mesh.edge_count());
  return work;
}

FairSystem::Solution FairSystem::solve(std::span<const QuarticPatch> base, const SolveOptions& options,
                                       const CancelToken& cancel) const {
  Workspace work = make_workspace(options);
  Solution solution;
  solution.unknowns = Field(numbering_.count);
  Field& x = solution.unknowns;
  const Array3 one = Array3::Ones();
  if (options.start)
    work.combine(x, one, one, *options.start);
  else
    guess(work, base, x);
  Field right(numbering_.count);
  right_side(work, base, right);
  for (const BoundaryCurvatureLoad& rim : options.rims) {
    right[numbering_.side_origin[rim.half_edge]] += rim.at_origin;
    right[numbering_.side_target[rim.half_edge]] += rim.at_target;
  }
  ConjugateGradientsWorkspace<Field> room{Field(numbering_.count), Field(numbering_.count),
                                          Field(numbering_.count), Field(numbering_.count)};
  room.preconditioned_image = Field(numbering_.count);
  Iteration iteration{*this, work};
  /// Residual of x, by the matrix.
  const auto measure = [&](Field& residual, Field& image) {
    apply(work, x, image);
    work.combine(residual, 0 * one, one, right);
    work.combine(residual, one, -one, image);
  };
  measure(room.residual, room.image);
  room.square = work.dot(x, room.image);
  ConjugateGradientsOptions steps{false, options.tolerance, options.max_steps};
  steps.begun = true;
  const bool checks = options.tolerance <= checked_tolerance;
  for (int time = 0; time <= most_corrections; ++time) {
    const auto report = conjugate_gradients(iteration, x, room, steps, cancel);
    solution.iterations += report.iterations;
    solution.converged = report.converged;
    solution.cancelled = report.cancelled;
    if (!checks || !report.converged || report.cancelled) break;
    // After the sweeps, solved faces have no residual except for rounding errors, which are large in thin
    // faces: the true residual is computed with the matrix.
    measure(room.direction, room.image);
    work.combine(room.residual, -one, one, room.direction);
    const Array3 drift = work.dot(room.residual, room.residual),
                 left = work.dot(room.direction, room.direction);
    if (!(drift > largest_drift * left).any()) break;
    work.combine(room.residual, 0 * one, one, room.direction);
    steps.corrected = true;
  }
  return solution;
}

/// Initial guess: split points in the middle of their faces, and straight split edges.
void FairSystem::guess(const Workspace& work, std::span<const QuarticPatch> base, Field& x) const {
  const HalfEdgeMesh& mesh = this->mesh();
  parallel_for(work.plan.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = work.plan.faces[k];
      Vector3 middle = Vector3::Zero(), along_y = middle, along_x = middle;
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h)
        middle += base[h].control[quartic::d040] / double(mesh.side_count(f));
      double xx = 0, xy = 0, yy = 0;
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
        const Vector2& at = corner_[h];
        const Vector3 third = (base[h].control[quartic::d040] - middle) / 3;
        xx += at.x() * at.x();
        xy += at.x() * at.y();
        yy += at.y() * at.y();
        along_x += at.x() * third;
        along_y += at.y() * third;
      }
      const double det = xx * yy - xy * xy;
      Vector3* own = x.data() + numbering_.face_begin[f];
      own[0] = middle;
      own[1] = (xx * along_y - xy * along_x) / det;
      own[2] = (yy * along_x - xy * along_y) / det;
    }
  });
}

FairSystem::Field FairSystem::multiply(const Field& x) const {
  Workspace work = make_workspace({});
  Field y(numbering_.count);
  apply(work, x, y);
  return y;
}

void FairSystem::fill_split_points(const Field& unknowns, std::span<const Index> faces,
                                   PatchNetwork& out) const {
  for (const Index f : faces) {
    const Vector3* y = unknowns.data() + numbering_.face_begin[f];
    out.centre[f] = y[0];
    for (Index h = mesh().face_begin(f); h < mesh().face_end(f); ++h)
      out.centre_tangent[h] = corner_[h].y() * y[1] + corner_[h].x() * y[2];
  }
}

void FairSystem::add_free_parts(const Field& unknowns, std::span<const Index> faces,
                                std::span<QuarticPatch> patches) const {
  using namespace quartic;
  const HalfEdgeMesh& mesh = this->mesh();
  parallel_for(faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = faces[k], first = mesh.face_begin(f), n = mesh.side_count(f);
      const Vector3* split = unknowns.data() + numbering_.face_begin[f] + 3;
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
        d[d121u] += numbering_.side_scale[h] * unknowns[numbering_.side_origin[h]];
        d[d112u] += numbering_.side_scale[h] * unknowns[numbering_.side_target[h]];
      }
    }
  });
}

}  // namespace hariko
