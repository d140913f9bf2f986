#include "core/unfolding/facet_graph.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/ids.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/mesh_errors.hpp"
#include "core/polyhedron/message_group.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/unfolding/face_triangles.hpp"

namespace hariko {

namespace {

constexpr const char* refusal = "The mesh cannot be unfolded: ";

Vector3 area_of_facet(const std::vector<Vector3>& positions, std::span<const Index> face) {
  return area_vector(positions[face[0]], positions[face[1]], positions[face[2]]);
}

std::vector<std::array<Index, 3>> triangles_of(const PolygonMesh& mesh, std::size_t face) {
  std::vector<Vector3> corners;
  for (const Index v : mesh.face(face)) corners.push_back(mesh.positions[v]);
  return face_triangles(corners);
}

std::string edge_text(Index low, Index high, std::span<const EdgeUse> uses) {
  const std::string name = "(" + std::to_string(low) + "," + std::to_string(high) + ")";
  if (uses.size() == 2)
    return std::string(refusal) + "the two facets at edge " + name + " face opposite ways.";
  return std::string(refusal) + "non-manifold edge: " + std::to_string(uses.size()) + " facets share edge " +
         name + ".";
}

void report_degenerate(const PolygonMesh& mesh, const std::vector<char>& sound, std::size_t limit,
                       std::vector<Message>& out) {
  MessageGroup group(out, Severity::error, e_facet_degenerate,
                     "Remove the facet, or merge the vertices that lie on one line.", limit);
  for (std::size_t f = 0; f < sound.size(); ++f) {
    if (!sound[f] || !triangles_of(mesh, f).empty()) continue;
    const std::string name = std::to_string(f);
    group.add(element_of(FaceId{static_cast<Index>(f)}), [&] {
      return mesh.face(f).size() == 3 ? refusal + ("degenerate facet " + name) + " has zero area."
                                      : refusal + ("facet " + name) + " has no area, or crosses itself.";
    });
  }
}

void report_edges(const PolygonMesh& mesh, const std::vector<char>& sound, std::size_t limit,
                  std::vector<Message>& out) {
  MessageGroup group(out, Severity::error, e_edge_nonmanifold_or_flipped,
                     "Repair the orientation, or split the non-manifold edges.", limit);
  EdgeTable(mesh, sound).for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (!is_manifold_edge(mesh, uses))
      group.add(element_of(EdgeId{{low}, {high}}), [&] { return edge_text(low, high, uses); });
  });
}

/// Adds the connectivity faults that matter for unfolding; those at vertices do not.
void report_polygons(const PolygonMesh& mesh, std::size_t limit, std::vector<Message>& out) {
  for (Message& message : connectivity_errors(mesh, limit))
    if (message.code == e_no_faces || message.code == e_index_range || message.code == e_face_too_small ||
        message.code == e_face_repeated_vertex)
      out.push_back(std::move(message));
}

}  // namespace

std::vector<Message> unfolding_errors(const PolygonMesh& mesh, std::size_t limit) {
  std::vector<Message> out = position_errors(mesh, limit);
  if (!out.empty()) return out;
  report_polygons(mesh, limit, out);
  const std::vector<char> sound = sound_faces(mesh);
  report_degenerate(mesh, sound, limit, out);
  report_edges(mesh, sound, limit, out);
  return out;
}

Result<FacetGraph> FacetGraph::build(const PolygonMesh& mesh) {
  if (auto errors = unfolding_errors(mesh, 1); !errors.empty()) return std::move(errors.front());
  FacetGraph out;
  out.positions_ = mesh.positions;
  out.add_facets(mesh);
  // Sides of faces; each is numbered by the corner in the mesh's list where it begins.
  EdgeTable(mesh).for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    FacetEdge edge{low, high};
    for (std::size_t k = 0; k < uses.size(); ++k) {
      edge.facets[k] = out.corners_[uses[k].corner].facet;
      edge.sides[k] = out.corners_[uses[k].corner].corner;
    }
    out.add_edge(edge);
  });
  out.add_inner_edges();
  out.sort_edges();
  out.find_components();
  return out;
}

void FacetGraph::add_facets(const PolygonMesh& mesh) {
  corners_.resize(mesh.face_vertices.size());
  face_corners_ = mesh.face_offsets;
  face_facets_ = {0};
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (const auto& triangle : triangles_of(mesh, f)) {
      const auto facet = static_cast<Index>(triangles_.size());
      triangles_.push_back({face[triangle[0]], face[triangle[1]], face[triangle[2]]});
      areas_.push_back(0.5 * area_of_facet(positions_, triangles_.back()).norm());
      face_of_.push_back(static_cast<Index>(f));
      for (Index k = 0; k < 3; ++k)
        if (triangle[(k + 1) % 3] == (triangle[k] + 1) % face.size())
          corners_[mesh.face_offsets[f] + triangle[k]] = {facet, k};
    }
    face_facets_.push_back(static_cast<Index>(triangles_.size()));
  }
  edges_of_.assign(triangles_.size(), {no_index, no_index, no_index});
}

void FacetGraph::add_edge(FacetEdge edge) {
  // Orders the facets ascending.
  if (edge.facets[1] < edge.facets[0]) {
    std::swap(edge.facets[0], edge.facets[1]);
    std::swap(edge.sides[0], edge.sides[1]);
  }
  edge.length = (positions_[edge.high] - positions_[edge.low]).norm();
  if (!edge.border()) {
    const auto& corners = triangles_[edge.facets[0]];
    const Vector3 along = positions_[corners[(edge.sides[0] + 1) % 3]] - positions_[corners[edge.sides[0]]];
    edge.fold_angle = signed_angle(normal(edge.facets[0]), normal(edge.facets[1]), along / edge.length);
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (edge.facets[k] != no_index)
      edges_of_[edge.facets[k]][edge.sides[k]] = static_cast<Index>(edges_.size());
  longest_edge_ = std::max(longest_edge_, edge.length);
  edges_.push_back(edge);
}

/// Adds the edges between the facets of one face.
void FacetGraph::add_inner_edges() {
  for (Index f = 0; f < face_count(); ++f) {
    const std::size_t before = edges_.size();
    double bend = 0;
    for (Index a = face_facets_[f]; a < face_facets_[f + 1]; ++a)
      for (Index side = 0; side < 3; ++side) {
        if (edges_of_[a][side] != no_index) continue;
        const Index from = triangles_[a][side], to = triangles_[a][(side + 1) % 3];
        for (Index b = a + 1; b < face_facets_[f + 1]; ++b)
          for (Index other = 0; other < 3; ++other)
            if (triangles_[b][other] == to && triangles_[b][(other + 1) % 3] == from)
              add_edge({std::min(from, to), std::max(from, to), {a, b}, {side, other}});
        bend = std::max(bend, std::abs(edges_.back().fold_angle));
      }
    for (std::size_t e = before; e < edges_.size(); ++e) edges_[e].inner = bend <= flat_face_angle;
  }
}

void FacetGraph::sort_edges() {
  std::stable_sort(edges_.begin(), edges_.end(), [](const FacetEdge& a, const FacetEdge& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  for (Index e = 0; e < edges_.size(); ++e)
    for (std::size_t k = 0; k < 2; ++k)
      if (edges_[e].facets[k] != no_index) edges_of_[edges_[e].facets[k]][edges_[e].sides[k]] = e;
}

void FacetGraph::find_components() {
  component_of_.assign(facet_count(), no_index);
  std::vector<Index> stack;
  for (Index seed = 0; seed < facet_count(); ++seed) {
    if (component_of_[seed] != no_index) continue;
    component_of_[seed] = static_cast<Index>(component_count_);
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index facet = stack.back();
      stack.pop_back();
      for (Index side = 0; side < 3; ++side) {
        const Index next = neighbour(facet, side);
        if (next == no_index || component_of_[next] != no_index) continue;
        component_of_[next] = static_cast<Index>(component_count_);
        stack.push_back(next);
      }
    }
    ++component_count_;
  }
}

Index FacetGraph::mate_side(Index facet, Index side) const {
  const FacetEdge& edge = edges_[edges_of_[facet][side]];
  return edge.facets[0] == facet ? edge.sides[1] : edge.sides[0];
}

Index FacetGraph::find_edge(Index a, Index b) const {
  const std::pair<Index, Index> wanted = std::minmax(a, b);
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), wanted,
                       [](const auto& edge, const auto& w) { return std::pair(edge.low, edge.high) < w; });
  return found != edges_.end() && std::pair(found->low, found->high) == wanted
             ? static_cast<Index>(found - edges_.begin())
             : no_index;
}

double FacetGraph::total_area() const {
  double sum = 0;
  for (const double area : areas_) sum += area;
  return sum;
}

Vector3 FacetGraph::normal(Index facet) const {
  return area_of_facet(positions_, triangles_[facet]).normalized();
}

PolygonMesh polygons_of(const TriangleMesh& mesh) {
  PolygonMesh out;
  out.positions.reserve(mesh.positions.size());
  for (const Vector3& position : mesh.positions) out.positions.push_back(mesh.origin + position);
  for (const auto& triangle : mesh.triangles) out.add_face(triangle);
  return out;
}

}  // namespace hariko
