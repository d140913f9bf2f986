#include "core/modeling/cuts/cut.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/modeling/cuts/diagonal.hpp"
#include "core/modeling/cuts/edge_points.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/amount.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

std::size_t corner_of(std::span<const VertexId> face, VertexId v) {
  return static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
}

/// Splits the face between two corners if a new edge may run there; the part from a to b gets a new id.
bool split_between(MeshEditor& draft, FaceId face, VertexId a, VertexId b) {
  const auto corners = draft.face(face);
  const std::size_t n = corners.size(), i = corner_of(corners, a), j = corner_of(corners, b);
  if (a == b || i == n || j == n || draft.contains(EdgeId::of(a, b))) return false;
  if (!is_inner_diagonal(draft.corners(face), i, j)) return false;
  std::vector<VertexId> part, rest;
  for (std::size_t k = i;; k = (k + 1) % n) {
    part.push_back(corners[k]);
    if (k == j) break;
  }
  for (std::size_t k = j;; k = (k + 1) % n) {
    rest.push_back(corners[k]);
    if (k == i) break;
  }
  draft.set_face(face, std::move(rest));
  draft.add_face(std::move(part));
  return true;
}

/// Puts the points of a path into the draft, points of one edge in their order along it.
Result<std::vector<VertexId>> place_path(MeshEditor& draft, const PolyhedronSource& source,
                                         std::span<const CutPoint> path) {
  std::map<EdgeId, std::map<double, VertexId>> on_edges;
  for (const CutPoint& point : path) {
    if (const auto* vertex = std::get_if<VertexId>(&point)) {
      if (const auto known = selected(source.polyhedron, std::span<const VertexId>(vertex, 1), ""); !known)
        return known.error();
      continue;
    }
    const auto& on = std::get<EdgePoint>(point);
    if (const auto known = selected(source.polyhedron, std::span<const EdgeId>(&on.edge, 1), ""); !known)
      return known.error();
    if (!(on.share > 0 && on.share < 1))
      return make_error(e_bad_amount, "The point does not lie inside the edge.",
                        "Cut through the edge or an end.", element_of(on.edge));
    on_edges[on.edge][on.share] = {};
  }
  for (auto& [edge, points] : on_edges) {
    std::vector<double> shares;
    for (const auto& entry : points) shares.push_back(entry.first);
    const auto ids = add_edge_points(draft, edge.low, edge.high, shares);
    std::size_t i = 0;
    for (auto& entry : points) entry.second = ids[i++];
  }
  std::vector<VertexId> out;
  for (const CutPoint& point : path)
    if (const auto* vertex = std::get_if<VertexId>(&point))
      out.push_back(*vertex);
    else
      out.push_back(on_edges.at(std::get<EdgePoint>(point).edge).at(std::get<EdgePoint>(point).share));
  return out;
}

Element element_of_point(const CutPoint& point) {
  if (const auto* vertex = std::get_if<VertexId>(&point)) return element_of(*vertex);
  return element_of(std::get<EdgePoint>(point).edge);
}

}  // namespace

Result<EditResult> connect_points(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                  std::span<const EdgeId> edges, const SurfaceForm* on) {
  constexpr const char* remedy = "Select vertices, or edges to be connected at their middles.";
  if (vertices.empty() && edges.empty())
    return make_error(e_nothing_selected, "No vertices or edges are selected.", remedy);
  const Polyhedron& polyhedron = source.polyhedron;
  if (!vertices.empty())
    if (const auto known = selected(polyhedron, vertices, remedy); !known) return known.error();
  MeshEditor draft(source);
  std::set<VertexId> points(vertices.begin(), vertices.end());
  if (!edges.empty()) {
    const auto chosen = selected(polyhedron, edges, remedy);
    if (!chosen) return chosen.error();
    const double middle = 0.5;
    for (const Index e : *chosen) {
      const EdgeId edge = polyhedron.edge_id(e);
      points.insert(add_edge_points(draft, edge.low, edge.high, std::span<const double>(&middle, 1))[0]);
    }
  }
  std::map<FaceId, std::size_t> count;
  for (const VertexId v : points)
    for (const FaceId face : draft.faces_at(v)) ++count[face];
  ElementSet selection;
  for (const auto& [face, number] : count) {
    if (number < 2) continue;
    std::vector<VertexId> on_face;
    for (const VertexId v : draft.face(face))
      if (points.contains(v)) on_face.push_back(v);
    for (std::size_t i = 0; i < on_face.size(); ++i) {
      const VertexId a = on_face[i], b = on_face[(i + 1) % on_face.size()];
      if (split_between(draft, face, a, b)) selection.edges.insert(EdgeId::of(a, b));
    }
  }
  if (selection.edges.empty())
    return make_error(e_wrong_selection, "No two of the points can be joined by a line inside a face.",
                      "Select points that lie on a common face and are not joined yet.");
  return finish_refined(std::move(draft), std::move(selection), on);
}

Result<EditResult> cut_path(const PolyhedronSource& source, std::span<const CutPoint> path,
                            const SurfaceForm* on) {
  if (path.size() < 2)
    return make_error(e_nothing_selected, "A cut needs at least two points.", "Click two points or more.");
  MeshEditor draft(source);
  const auto points = place_path(draft, source, path);
  if (!points) return points.error();
  ElementSet selection;
  for (std::size_t i = 0; i + 1 < points->size(); ++i) {
    const VertexId a = (*points)[i], b = (*points)[i + 1];
    if (a == b) continue;
    bool joined = draft.contains(EdgeId::of(a, b));
    for (const FaceId face : draft.faces_at(a)) joined = joined || split_between(draft, face, a, b);
    if (!joined)
      return make_error(e_wrong_selection,
                        "The line from here to the next point does not run inside one face.",
                        "Put a point on every edge that the cut crosses.", element_of_point(path[i]));
    selection.edges.insert(EdgeId::of(a, b));
  }
  if (selection.edges.empty())
    return make_error(e_nothing_selected, "All points of the cut are the same.", "Click two points or more.");
  return finish_refined(std::move(draft), std::move(selection), on);
}

Result<EditResult> split_face(const PolyhedronSource& source, FaceId face, VertexId a, VertexId b,
                              const SurfaceForm* on) {
  const Polyhedron& polyhedron = source.polyhedron;
  const VertexId ends[2] = {a, b};
  if (const auto known = selected(polyhedron, std::span<const FaceId>(&face, 1), ""); !known)
    return known.error();
  if (const auto known = selected(polyhedron, ends, ""); !known) return known.error();
  MeshEditor draft(source);
  if (!split_between(draft, face, a, b))
    return make_error(e_wrong_selection, "The face cannot be split between these two vertices.",
                      "Select two corners of the face that are not joined, with a clear line between them.",
                      element_of(face));
  return finish_refined(std::move(draft), {{}, {EdgeId::of(a, b)}, {}}, on);
}

}  // namespace hariko
