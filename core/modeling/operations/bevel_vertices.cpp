#include "core/modeling/operations/bevel_vertices.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/amount.hpp"
#include "core/modeling/operations/short_edges.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

using Measure = BevelVerticesOptions::Measure;

std::vector<char> marked(Index count, const std::vector<Index>& chosen) {
  std::vector<char> out(count, 0);
  for (const Index v : chosen) out[v] = 1;
  return out;
}

double length_of(const Polyhedron& polyhedron, Index a, Index b) {
  return (polyhedron.position(b) - polyhedron.position(a)).stableNorm();
}

double limit_of(const Polyhedron& polyhedron, const std::vector<char>& cut, Measure measure) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  double limit = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), a = mesh.origin(h), b = mesh.target(h);
    const int ends = cut[a] + cut[b];
    if (ends == 0) continue;
    const double length = measure == Measure::share ? 1.0 : length_of(polyhedron, a, b);
    limit = std::min(limit, length / ends);
  }
  return limit;
}

class VertexBevel {
 public:
  VertexBevel(const PolyhedronSource& source, const std::vector<Index>& chosen,
              const BevelVerticesOptions& options)
      : source_(source),
        polyhedron_(source.polyhedron),
        mesh_(polyhedron_.topology()),
        before_(*source.shaping),
        options_(options),
        chosen_(chosen),
        cut_(marked(polyhedron_.vertex_count(), chosen)),
        draft_(source) {}

  Result<EditResult> run() {
    place_points();
    rewrite_faces();
    carry_edges();
    for (const Index v : chosen_) close_cut(v);
    Result<PolyhedronSource> result = std::move(draft_).finish();
    if (!result) return result.error();
    tighten_short_edges(result.value(), source_);
    return EditResult{std::move(result).value(), std::move(selection_)};
  }

 private:
  /// Places a new vertex on each edge near each end that is cut: index 0 for the origin, 1 for the target of
  /// the edge's first half-edge.
  void place_points() {
    near_[0].resize(mesh_.edge_count());
    near_[1].resize(mesh_.edge_count());
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const Index h = mesh_.half_edge_of_edge(e);
      const Index ends[2] = {mesh_.origin(h), mesh_.target(h)};
      for (int end = 0; end < 2; ++end) {
        const Index v = ends[end], other = ends[1 - end];
        near_[end][e] = polyhedron_.vertex_id(v);
        if (!cut_[v]) continue;
        const Vector3 &p = polyhedron_.position(v), &q = polyhedron_.position(other);
        const double share = options_.measure == Measure::share
                                 ? options_.amount
                                 : options_.amount / length_of(polyhedron_, v, other);
        near_[end][e] = draft_.add_vertex(p + share * (q - p));
        draft_.inherit(polyhedron_.vertex_id(v), near_[end][e]);
      }
    }
  }

  VertexId point(Index v, Index e) const {
    return near_[mesh_.origin(mesh_.half_edge_of_edge(e)) == v ? 0 : 1][e];
  }

  void rewrite_faces() {
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      std::vector<VertexId> corners;
      bool changed = false;
      for (Index h = mesh_.face_begin(f); h < mesh_.face_end(f); ++h) {
        const Index v = mesh_.origin(h);
        if (cut_[v]) corners.push_back(point(v, mesh_.edge(mesh_.previous(h))));
        corners.push_back(point(v, mesh_.edge(h)));
        changed = changed || cut_[v];
      }
      if (changed) draft_.set_face(polyhedron_.face_id(f), std::move(corners));
    }
  }

  void carry_edges() {
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const EdgeId from = polyhedron_.edge_id(e), to = EdgeId::of(near_[0][e], near_[1][e]);
      if (from != to) draft_.inherit(from, to);
    }
  }

  void close_cut(Index v) {
    std::vector<Index> edges;  // counter-clockwise
    for (const FanEnd& each : fan_ends(mesh_, v)) edges.push_back(mesh_.edge(each.end / 2));
    const bool closed = !mesh_.is_border_vertex(v);
    std::vector<VertexId> corners;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      corners.push_back(point(v, edges[i]));
      if (!closed && i + 1 == edges.size()) break;
      const Index next = edges[(i + 1) % edges.size()];
      if (before_.crease.contains(polyhedron_.edge_id(edges[i])) &&
          before_.crease.contains(polyhedron_.edge_id(next)))
        draft_.shaping().crease.set(EdgeId::of(corners.back(), point(v, next)), true);
    }
    if (corners.size() == 2)
      selection_.edges.insert(EdgeId::of(corners[0], corners[1]));
    else if (corners.size() > 2)
      selection_.faces.insert(draft_.add_face(std::move(corners)));
  }

  const PolyhedronSource& source_;
  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const Shaping& before_;
  BevelVerticesOptions options_;
  const std::vector<Index>& chosen_;
  std::vector<char> cut_;
  std::vector<VertexId> near_[2];
  MeshEditor draft_;
  ElementSet selection_;
};

/// Returns the selected vertices that have faces; others have nothing to cut.
Result<std::vector<Index>> chosen_vertices(const Polyhedron& polyhedron, std::span<const VertexId> vertices) {
  auto chosen = selected(polyhedron, vertices, "Select the vertices to bevel.");
  if (!chosen) return chosen;
  for (const Index v : *chosen)
    if (polyhedron.topology().outgoing(v) == no_index)
      return make_error(e_wrong_selection, "The vertex has no edges that could be cut.",
                        "Select vertices of faces.", element_of(polyhedron.vertex_id(v)));
  return chosen;
}

}  // namespace

Result<double> largest_vertex_bevel(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                    Measure measure) {
  const auto chosen = chosen_vertices(source.polyhedron, vertices);
  if (!chosen) return chosen.error();
  return limit_of(source.polyhedron, marked(source.polyhedron.vertex_count(), *chosen), measure);
}

Result<EditResult> bevel_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                  const BevelVerticesOptions& options) {
  if (const auto positive = detail::check_positive(options.amount); !positive) return positive.error();
  const auto limit = largest_vertex_bevel(source, vertices, options.measure);
  if (!limit) return limit.error();
  if (!(options.amount < *limit))
    return make_error(e_bad_amount, "The bevel is too large: on one of the edges nothing would be left.",
                      "Use a smaller amount.");
  const auto chosen = chosen_vertices(source.polyhedron, vertices);
  return VertexBevel(source, *chosen, options).run();
}

}  // namespace hariko
