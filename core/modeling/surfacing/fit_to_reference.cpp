#include "core/modeling/surfacing/fit_to_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/base/solvers/sparse_solver.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/surfacing/project_to_reference.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/patching/vertex_shares.hpp"

namespace hariko {

namespace {

constexpr int cells_a_side = 4;  ///< equal triangles along the side of a patch's domain
constexpr std::size_t patches_per_task = 4;
/// Weight of the differences between neighbours, and of the displacements themselves, relative to the mean
/// weight that the samples give a displacement.
constexpr double neighbour_weight = 3e-3, rest_weight = 1e-6;
/// Shares of a step that are tried.
constexpr std::array<double, 4> step_shares{1, 0.5, 0.25, 0.125};
/// Share of the root mean square that a step has to take away for another one.
constexpr double worthwhile = 0.01;

/// Parameters of the centres of the cells.
std::vector<Vector2> cell_centres() {
  std::vector<Vector2> out;
  const double width = 1.0 / cells_a_side;
  for (int j = 0; j < cells_a_side; ++j)
    for (int i = 0; i + j < cells_a_side; ++i) {
      out.emplace_back((i + 1.0 / 3) * width, (j + 1.0 / 3) * width);
      if (i + j + 1 < cells_a_side) out.emplace_back((i + 2.0 / 3) * width, (j + 2.0 / 3) * width);
    }
  return out;
}

/// Point of a surface and its foot on the reference.
struct FitSample {
  Vector3 direction = Vector3::Zero();  ///< in which the distance grows
  double distance = 0;
  double area = 0;  ///< area that it stands for, in any unit; 0 where it does not count
};

/// A polyhedron, what its surface is made of, and the samples of the faces in question, patch by patch.
struct FitState {
  PolyhedronSource source;
  Polyhedron prepared;
  std::shared_ptr<const ElementAliases> aliases;
  std::vector<Index> faces, patches;
  std::vector<FitSample> samples;
  ReferenceDistance distance;
};

ReferenceDistance distance_of(const std::vector<FitSample>& samples) {
  ReferenceDistance out;
  double area = 0, sum = 0, squares = 0;
  for (const FitSample& sample : samples) {
    if (sample.area == 0) {
      ++out.beyond;
      continue;
    }
    ++out.counted;
    area += sample.area;
    sum += sample.area * sample.distance;
    squares += sample.area * sample.distance * sample.distance;
    out.largest = std::max(out.largest, sample.distance);
  }
  if (!(area > 0)) return out;
  out.mean = sum / area;
  out.root_mean_square = std::sqrt(squares / area);
  return out;
}

/// Unknowns: the coordinates of the displacements of those vertices that move.
struct FitUnknowns {
  std::vector<std::array<Eigen::Index, 3>> of;  ///< per vertex of the designer's polyhedron; -1: stays 0
  Eigen::Index count = 0;

  FitUnknowns(const PolyhedronSource& source, const std::vector<Index>& moving) {
    of.assign(source.polyhedron.vertex_count(), {-1, -1, -1});
    std::vector<char> seam(of.size());
    if (source.mirror) seam = mirror_seam(source.polyhedron, source.origin, *source.mirror);
    for (const Index v : moving)
      for (Eigen::Index k = 0; k < 3; ++k)
        if (!seam[v] || k != index_of(source.mirror->axis)) of[v][static_cast<std::size_t>(k)] = count++;
  }
  bool moves(Index v) const {
    return std::any_of(of[v].begin(), of[v].end(), [](auto u) { return u >= 0; });
  }
};

class ReferenceFitter {
 public:
  ReferenceFitter(const PolyhedronSource& source, const std::vector<Index>& moving,
                  const ReferenceFacets& reference, const CancelToken& cancel)
      : unknowns_(source, moving), reference_(reference), cancel_(cancel), parameters_(cell_centres()) {}

  Result<FitState> state_of(PolyhedronSource source);
  /// Displacements of all vertices in a step; nothing where the samples determine none.
  std::optional<std::vector<Vector3>> step(const FitState& state) const;

 private:
  struct Corner {
    Index vertex = no_index;  ///< vertex of the designer's polyhedron
    bool image = false;       ///< moves as its mirror image
  };
  Corner corner(const FitState& state, Index prepared) const;
  /// Coordinate of a displacement, which moves a vertex of a face's shares along `way`.
  struct Column {
    Eigen::Index unknown = 0;
    std::size_t vertex = 0;
    Vector3 way = Vector3::Zero();
  };
  std::vector<Column> columns(const FitState& state, Index face) const;
  void find_faces(FitState& state) const;
  void add_face(const FitState& state, Index face, std::size_t first, Eigen::VectorXd& right,
                SparseEntries& entries) const;
  void add_neighbours(const FitState& state, double weight, SparseEntries& entries) const;
  void fill_samples(const Surface& surface, FitState& state) const;

  FitUnknowns unknowns_;
  const ReferenceFacets& reference_;
  CancelToken cancel_;
  std::vector<Vector2> parameters_;
  PolyhedronSurfacer surfacer_;
  SurfaceInputCache cache_;
  std::vector<FaceShares> shares_;  ///< shares of this connectivity's faces
  std::shared_ptr<const HalfEdgeMesh> shared_by_;
};

ReferenceFitter::Corner ReferenceFitter::corner(const FitState& state, Index prepared) const {
  const VertexId id = state.prepared.vertex_id(prepared);
  if (!state.aliases) return {state.source.polyhedron.find(id), false};
  return {state.source.polyhedron.find(state.aliases->original(id)), state.aliases->is_copy(id)};
}

/// Faces in which a vertex that moves has shares, with their patches.
void ReferenceFitter::find_faces(FitState& state) const {
  const HalfEdgeMesh& mesh = state.prepared.topology();
  std::vector<char> moves(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index own = corner(state, v).vertex;
    moves[v] = own != no_index && unknowns_.moves(own) ? 1 : 0;
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& vertices = shares_[f].vertices;
    if (std::none_of(vertices.begin(), vertices.end(), [&](Index v) { return moves[v] != 0; })) continue;
    state.faces.push_back(f);
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) state.patches.push_back(h);
  }
}

void ReferenceFitter::fill_samples(const Surface& surface, FitState& state) const {
  const std::size_t count = parameters_.size();
  const Vector3 shift = surface.origin() - state.source.origin;
  const auto batch = surface.patches().batch(parameters_);
  state.samples.resize(state.patches.size() * count);
  parallel_for(state.patches.size(), patches_per_task, [&](std::size_t begin, std::size_t end) {
    if (cancel_.cancelled()) return;
    std::vector<PatchPoint> points((end - begin) * count);
    batch->evaluate(std::span(state.patches).subspan(begin, end - begin), Order::first, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ReferenceFoot foot = reference_.foot(points[i].position + shift);
      const double area = foot.is_beyond ? 0 : points[i].ds.cross(points[i].dt).norm();
      state.samples[begin * count + i] = {foot.direction, foot.distance, area};
    }
  });
  state.distance = distance_of(state.samples);
}

Result<FitState> ReferenceFitter::state_of(PolyhedronSource source) {
  const auto input = surface_input(source, Quality::final, &cache_);
  if (!input) return input.error();
  const auto made = surfacer_.rebuild(*input, Quality::final, cancel_);
  if (!made) return made.error();
  HARIKO_ASSERT(made->surface.patch_count() == input->polyhedron.topology().half_edge_count(),
                "a patch belongs to each half-edge");
  FitState out{std::move(source), input->polyhedron, input->aliases, {}, {}, {}, {}};
  if (shared_by_ != input->polyhedron.shared_topology()) {
    auto shares = vertex_shares(*input, parameters_, cancel_);
    if (!shares) return shares.error();
    shares_ = std::move(shares).value();
    shared_by_ = input->polyhedron.shared_topology();
  }
  find_faces(out);
  fill_samples(made->surface, out);
  if (cancel_.cancelled()) return make_error(e_cancelled, "The fit was not finished.");
  return out;
}

/// The displacements that move a face, by the vertices that have shares in it.
std::vector<ReferenceFitter::Column> ReferenceFitter::columns(const FitState& state, Index face) const {
  std::vector<Column> out;
  for (std::size_t j = 0; j < shares_[face].vertices.size(); ++j) {
    const Corner at = corner(state, shares_[face].vertices[j]);
    if (at.vertex == no_index) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Eigen::Index unknown = unknowns_.of[at.vertex][axis];
      if (unknown < 0) continue;
      Vector3 way = Vector3::Unit(static_cast<Eigen::Index>(axis));
      if (at.image && static_cast<Eigen::Index>(axis) == index_of(state.source.mirror->axis)) way = -way;
      out.push_back({unknown, j, way});
    }
  }
  return out;
}

/// Adds the samples of one face, of which the first is number `first` of the state's.
void ReferenceFitter::add_face(const FitState& state, Index face, std::size_t first, Eigen::VectorXd& right,
                               SparseEntries& entries) const {
  const std::vector<Column> column = columns(state, face);
  const auto size = static_cast<Eigen::Index>(column.size());
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd row(size), sum = Eigen::VectorXd::Zero(size);
  const std::size_t count = state.prepared.topology().side_count(face) * parameters_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FitSample& sample = state.samples[first + i];
    if (sample.area == 0) continue;
    const auto share = shares_[face].of_point(i);
    for (Eigen::Index c = 0; c < size; ++c) {
      const Column& own = column[static_cast<std::size_t>(c)];
      row[c] = share[own.vertex] * own.way.dot(sample.direction);
    }
    for (Eigen::Index c = 0; c < size; ++c) {
      const double weighted = sample.area * row[c];
      sum[c] -= weighted * sample.distance;
      for (Eigen::Index d = 0; d <= c; ++d) gram(c, d) += weighted * row[d];
    }
  }
  for (Eigen::Index c = 0; c < size; ++c) {
    const Eigen::Index a = column[static_cast<std::size_t>(c)].unknown;
    right[a] += sum[c];
    for (Eigen::Index d = 0; d <= c; ++d) {
      const Eigen::Index b = column[static_cast<std::size_t>(d)].unknown;
      // A vertex and its image in one face: two equal entries are one on the diagonal.
      entries.emplace_back(std::max(a, b), std::min(a, b), gram(c, d) * (a == b && c != d ? 2 : 1));
    }
  }
}

/// Adds the differences of displacements along the edges, and the displacements themselves, which keep the
/// matrix regular.
void ReferenceFitter::add_neighbours(const FitState& state, double weight, SparseEntries& entries) const {
  const HalfEdgeMesh& mesh = state.source.polyhedron.topology();
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    const auto &from = unknowns_.of[mesh.origin(h)], &to = unknowns_.of[mesh.target(h)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (from[k] >= 0) entries.emplace_back(from[k], from[k], neighbour_weight * weight);
      if (to[k] >= 0) entries.emplace_back(to[k], to[k], neighbour_weight * weight);
      if (from[k] >= 0 && to[k] >= 0)
        entries.emplace_back(std::max(from[k], to[k]), std::min(from[k], to[k]), -neighbour_weight * weight);
    }
  }
  for (Eigen::Index u = 0; u < unknowns_.count; ++u) entries.emplace_back(u, u, rest_weight * weight);
}

std::optional<std::vector<Vector3>> ReferenceFitter::step(const FitState& state) const {
  SparseEntries entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns_.count);
  std::size_t first = 0;
  for (const Index face : state.faces) {
    add_face(state, face, first, right, entries);
    first += state.prepared.topology().side_count(face) * parameters_.size();
  }
  double trace = 0;
  for (const auto& entry : entries)
    if (entry.row() == entry.col()) trace += entry.value();
  if (!(trace > 0)) return std::nullopt;
  add_neighbours(state, trace / static_cast<double>(unknowns_.count), entries);
  const SparseCholesky factor(sparse_matrix(unknowns_.count, unknowns_.count, entries));
  if (!factor.succeeded()) return std::nullopt;
  const Eigen::VectorXd solution = factor.solve(right);
  std::vector<Vector3> out(unknowns_.of.size(), Vector3::Zero());
  for (std::size_t v = 0; v < out.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      if (const Eigen::Index u = unknowns_.of[v][k]; u >= 0)
        out[v][static_cast<Eigen::Index>(k)] = solution[u];
  return out;
}

Result<PolyhedronSource> displaced_source(const PolyhedronSource& source, const std::vector<Index>& moving,
                                          const std::vector<Vector3>& step, double share) {
  std::vector<Vector3> places;
  for (const Index v : moving) places.push_back(source.polyhedron.position(v) + share * step[v]);
  auto moved = source.polyhedron.with_positions(moving, places);
  if (!moved) return moved.error();
  PolyhedronSource out = source;
  out.polyhedron = std::move(moved).value();
  return out;
}

/// The state after the largest share of a step that lowers the mean square; nothing where none does.
Result<std::optional<FitState>> improved_state(ReferenceFitter& fitter, const FitState& from,
                                               const std::vector<Index>& moving, const CancelToken& cancel) {
  const auto step = fitter.step(from);
  if (!step) return std::optional<FitState>();
  for (const double share : step_shares) {
    auto source = displaced_source(from.source, moving, *step, share);
    if (!source) continue;
    auto next = fitter.state_of(std::move(source).value());
    if (cancel.cancelled()) return make_error(e_cancelled, "The fit was not finished.");
    if (next && next->distance.counted > 0 &&
        next->distance.root_mean_square < from.distance.root_mean_square)
      return std::optional<FitState>(std::move(next).value());
  }
  return std::optional<FitState>();
}

}  // namespace

Result<ReferenceFit> fit_to_reference(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                      const ReferenceFacets& reference, const FitOptions& options,
                                      const CancelToken& cancel, const Progress& progress) {
  if (options.steps < 1 || options.steps > max_fit_steps)
    return make_error(e_bad_amount, "A fit takes 1 to " + std::to_string(max_fit_steps) + " steps.",
                      "Use a number between these.");
  const auto moving = vertices_to_move(source, vertices);
  if (!moving) return moving.error();
  ReferenceFitter fitter(source, *moving, reference, cancel);
  auto first = fitter.state_of(source);
  if (!first) return first.error();
  FitState state = std::move(first).value();
  if (state.distance.counted == 0)
    return make_error(e_wrong_selection, "No part of the surface lies over the reference.",
                      "Move the object to where the reference is.");
  ReferenceFit out{source, state.distance, state.distance, 0};
  while (out.steps < options.steps) {
    progress.report(double(out.steps + 1) / (options.steps + 1));  // the first surface counts as a step
    auto next = improved_state(fitter, state, *moving, cancel);
    if (!next) return next.error();
    if (!*next) break;
    const double before = state.distance.root_mean_square;
    state = std::move(**next);
    ++out.steps;
    if (state.distance.root_mean_square > (1 - worthwhile) * before) break;
  }
  out.source = std::move(state.source);
  out.after = state.distance;
  return out;
}

}  // namespace hariko
