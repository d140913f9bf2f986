#include "core/modeling/cuts/loop_cut.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/modeling/cuts/edge_points.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/amount.hpp"
#include "core/modeling/operations/short_edges.hpp"
#include "core/modeling/selection/edge_paths.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

/// Cuts the quads of a ring.
class RingCut {
 public:
  RingCut(const PolyhedronSource& source, const EdgeRing& ring, std::vector<double> shares)
      : source_(source),
        polyhedron_(source.polyhedron),
        mesh_(polyhedron_.topology()),
        before_(*source.shaping),
        shares_(std::move(shares)),
        draft_(source) {
    for (std::size_t i = 0; i < ring.edges.size(); ++i) {
      const Index e = ring.edges[i], h = mesh_.half_edge_of_edge(e);
      const Index start = ring.starts[i], end = start == mesh_.origin(h) ? mesh_.target(h) : mesh_.origin(h);
      cuts_[e] = {start,
                  add_edge_points(draft_, polyhedron_.vertex_id(start), polyhedron_.vertex_id(end), shares_)};
      quads_.insert(mesh_.face(h));
      if (mesh_.twin(h) != no_index) quads_.insert(mesh_.face(mesh_.twin(h)));
    }
  }

  Result<EditResult> run(const SurfaceForm* on) {
    for (const Index f : quads_)
      if (mesh_.side_count(f) == 4) cut_quad(f);
    Result<EditResult> result = finish_refined(std::move(draft_), std::move(selection_), on);
    if (result && !on) tighten_short_edges(result.value().source, source_);
    return result;
  }

 private:
  struct Cut {
    Index start;
    std::vector<VertexId> points;  ///< ordered from the edge's start
  };
  using Row = std::vector<VertexId>;

  /// Vertices along a half-edge, ends included.
  Row along(Index h) const {
    Row row{polyhedron_.vertex_id(mesh_.origin(h))};
    if (const auto cut = cuts_.find(mesh_.edge(h)); cut != cuts_.end()) {
      const auto& points = cut->second.points;
      if (cut->second.start == mesh_.origin(h))
        row.insert(row.end(), points.begin(), points.end());
      else
        row.insert(row.end(), points.rbegin(), points.rend());
    }
    row.push_back(polyhedron_.vertex_id(mesh_.target(h)));
    return row;
  }

  void cut_quad(Index f) {
    std::array<Row, 4> sides;
    const Index first = mesh_.face_begin(f);
    for (Index i = 0; i < 4; ++i) sides[i] = along(first + i);
    std::reverse(sides[2].begin(), sides[2].end());
    std::reverse(sides[3].begin(), sides[3].end());
    // Columns run along sides 0 and 2, rows along sides 1 and 3: a grid with the sides as its border.
    const std::size_t columns = sides[0].size(), rows = sides[1].size();
    std::vector<Row> grid(rows, Row(columns));
    grid.front() = sides[0];
    grid.back() = sides[2];
    for (std::size_t j = 1; j + 1 < rows; ++j) {
      grid[j].front() = sides[3][j];
      grid[j].back() = sides[1][j];
      const double share = share_of(first + 1, j);
      for (std::size_t i = 1; i + 1 < columns; ++i) {
        const Vector3 position =
            (1 - share) * draft_.position(sides[0][i]) + share * draft_.position(sides[2][i]);
        grid[j][i] = draft_.add_vertex(position, FacePoint{polyhedron_.face_id(f), position});
      }
    }
    for (std::size_t j = 0; j + 1 < rows; ++j)
      for (std::size_t i = 0; i + 1 < columns; ++i) {
        std::vector<VertexId> corners{grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]};
        if (i == 0 && j == 0)
          draft_.set_face(polyhedron_.face_id(f), std::move(corners));
        else
          draft_.add_face(std::move(corners));
      }
    for (std::size_t j = 0; j + 1 < rows; ++j)
      for (std::size_t i = 1; i + 1 < columns; ++i)
        add_new_edge(grid[j][i], grid[j + 1][i], mesh_.edge(first + 1), mesh_.edge(first + 3));
    for (std::size_t j = 1; j + 1 < rows; ++j)
      for (std::size_t i = 0; i + 1 < columns; ++i)
        add_new_edge(grid[j][i], grid[j][i + 1], mesh_.edge(first), mesh_.edge(first + 2));
  }

  /// Fraction at which point j of a cut half-edge lies, from its own origin.
  double share_of(Index h, std::size_t j) const {
    return cuts_.at(mesh_.edge(h)).start == mesh_.origin(h) ? shares_[j - 1]
                                                            : 1 - shares_[shares_.size() - j];
  }

  void add_new_edge(VertexId a, VertexId b, Index beside, Index other_side) {
    const EdgeId edge = EdgeId::of(a, b);
    const double beta = before_.beta.get_or(polyhedron_.edge_id(beside), 1);
    if (beta != 1 && beta == before_.beta.get_or(polyhedron_.edge_id(other_side), 1))
      draft_.shaping().beta.set(edge, beta);
    selection_.edges.insert(edge);
  }

  const PolyhedronSource& source_;
  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const Shaping& before_;
  std::vector<double> shares_;
  MeshEditor draft_;
  std::map<Index, Cut> cuts_;
  std::set<Index> quads_;  ///< faces at the ring, including those at its ends that are not quads
  ElementSet selection_;
};

}  // namespace

std::vector<double> cut_shares(const LoopCutOptions& options) {
  std::vector<double> out;
  for (int i = 1; i <= options.count; ++i) out.push_back((i + options.slide) / (options.count + 1));
  return out;
}

Result<EditResult> loop_cut(const PolyhedronSource& source, EdgeId edge, const LoopCutOptions& options,
                            const SurfaceForm* on) {
  if (const auto finite = detail::check_finite(options.slide); !finite) return finite.error();
  if (options.count < 1 || options.count > max_cuts)
    return make_error(e_bad_amount, "The number of cuts is out of range.", "Use 1 to 1000 cuts.");
  const std::vector<double> shares = cut_shares(options);
  if (!(shares.front() > 0) || !(shares.back() < 1))
    return make_error(e_bad_amount, "The cuts would slide off the ends of the edges.",
                      "Keep the slide between -1 and 1.");
  const Polyhedron& polyhedron = source.polyhedron;
  const auto chosen = selected(polyhedron, std::span<const EdgeId>(&edge, 1), "Select an edge.");
  if (!chosen) return chosen.error();
  EdgeRing ring = find_edge_ring(polyhedron, chosen->front());
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Index h = mesh.half_edge_of_edge(chosen->front()), t = mesh.twin(h);
  if (mesh.side_count(mesh.face(h)) != 4 && (t == no_index || mesh.side_count(mesh.face(t)) != 4))
    return make_error(e_wrong_selection,
                      "There is no four-sided face at the edge that a loop could run through.",
                      "Choose an edge of a quad, or subdivide the edge.", element_of(edge));
  const auto per_edge = static_cast<std::size_t>(options.count);
  if (ring.edges.size() * per_edge * (per_edge + 1) > max_new_elements)
    return make_error(e_too_many_elements, "So many cuts would make more faces than can be handled.",
                      "Use fewer cuts.");
  // The shares count from the end with the smaller id of the given edge.
  const auto own = static_cast<std::size_t>(std::find(ring.edges.begin(), ring.edges.end(), chosen->front()) -
                                            ring.edges.begin());
  if (polyhedron.vertex_id(ring.starts[own]) != edge.low)
    for (std::size_t i = 0; i < ring.edges.size(); ++i) {
      const Index half = mesh.half_edge_of_edge(ring.edges[i]);
      ring.starts[i] = ring.starts[i] == mesh.origin(half) ? mesh.target(half) : mesh.origin(half);
    }
  return RingCut(source, ring, shares).run(on);
}

}  // namespace hariko
