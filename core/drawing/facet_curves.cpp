#include "core/drawing/facet_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace hariko {

namespace {

const double smooth_cosine = std::cos(30 * std::numbers::pi / 180);

using NodePair = std::pair<Index, Index>;

struct FacetEdge {
  Vector3 from, to;  ///< directions away from the surface at the lower node and at the higher one
  std::vector<Index> facets;
};

struct LineEdge {
  NodePair nodes;
  Vector3 from, to, away;
};

std::map<NodePair, FacetEdge> edges_of(const SurfaceGrid& grid) {
  std::map<NodePair, FacetEdge> out;
  for (Index facet = 0; facet < grid.surface().patch_count(); ++facet)
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const Index a = grid.surface().node(facet, k), b = grid.surface().node(facet, next);
      FacetEdge& edge = out[std::minmax(a, b)];
      edge.from = grid.position(facet, a < b ? k : next);
      edge.to = grid.position(facet, a < b ? next : k);
      edge.facets.push_back(facet);
    }
  return out;
}

/// Joins edges to chains through nodes where exactly two of them meet.
class Chains {
 public:
  Chains(LineKind kind, const std::vector<LineEdge>& edges) : kind_(kind), edges_(edges) {
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const Index node : {edges[e].nodes.first, edges[e].nodes.second}) at_[node].push_back(e);
    used_.assign(edges.size(), false);
  }

  std::vector<SpaceCurve> take() {
    for (const auto& [node, edges] : at_)
      if (edges.size() != 2)
        for (const std::size_t e : edges)
          if (!used_[e]) follow(e, node);
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!used_[e]) follow(e, edges_[e].nodes.first);
    return std::move(out_);
  }

 private:
  void follow(std::size_t e, Index node) {
    SpaceCurve curve{kind_, {}, {}};
    for (;;) {
      const LineEdge& edge = edges_[e];
      used_[e] = true;
      const bool forward = edge.nodes.first == node;
      if (curve.points.empty()) {
        curve.points.push_back(forward ? edge.from : edge.to);
        curve.away.push_back(edge.away);
      }
      curve.points.push_back(forward ? edge.to : edge.from);
      curve.away.push_back(edge.away);
      node = forward ? edge.nodes.second : edge.nodes.first;
      const std::vector<std::size_t>& here = at_[node];
      if (here.size() != 2) break;
      e = here[0] == e ? here[1] : here[0];
      if (used_[e]) break;
    }
    out_.push_back(std::move(curve));
  }

  LineKind kind_;
  const std::vector<LineEdge>& edges_;
  std::map<Index, std::vector<std::size_t>> at_;
  std::vector<bool> used_;
  std::vector<SpaceCurve> out_;
};

}  // namespace

bool is_facets(const Surface& surface) {
  return surface.patch_count() > 0 && surface.domain() == Domain::triangle && surface.seams().empty() &&
         surface.boundary_sides().empty();
}

std::vector<SpaceCurve> facet_curves(const SurfaceGrid& grid, const DrawingView& view) {
  std::map<LineKind, std::vector<LineEdge>> lines;
  for (const auto& [nodes, edge] : edges_of(grid)) {
    const Vector3 towards = view.towards_eye(0.5 * (edge.from + edge.to));
    Vector3 away = Vector3::Zero();
    std::vector<Vector3> normals;
    for (const Index facet : edge.facets) {
      normals.push_back(grid.normal(facet, 0));
      away += normals.back().dot(towards) < 0 ? Vector3(-normals.back()) : normals.back();
    }
    LineKind kind = LineKind::crease;
    if (normals.size() == 1)
      kind = LineKind::border;
    else if (normals.size() == 2) {
      const bool turns = (normals[0].dot(towards) < 0) != (normals[1].dot(towards) < 0);
      if (turns)
        kind = LineKind::silhouette;
      else if (normals[0].dot(normals[1]) >= smooth_cosine)
        continue;
    }
    lines[kind].push_back({nodes, edge.from, edge.to, away.stableNormalized()});
  }
  std::vector<SpaceCurve> out;
  for (const auto& [kind, edges] : lines)
    for (SpaceCurve& curve : Chains(kind, edges).take()) out.push_back(std::move(curve));
  return out;
}

}  // namespace hariko
