#include "core/modeling/operations/merge_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/selection/selected.hpp"
#include "core/polyhedron/near_vertices.hpp"

namespace hariko {
namespace {

/// Target vertex of each merged one; vertices that stay are absent.
using Targets = std::map<VertexId, VertexId>;

VertexId target_of(const Targets& targets, VertexId v) {
  const auto found = targets.find(v);
  return found == targets.end() ? v : found->second;
}

/// Corners after merging: consecutive corners that became the same vertex count once.
std::vector<VertexId> merged_corners(std::span<const VertexId> corners, const Targets& targets) {
  std::vector<VertexId> out;
  for (const VertexId v : corners)
    if (const VertexId target = target_of(targets, v); out.empty() || out.back() != target)
      out.push_back(target);
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

/// Settings of edges under their new ids; those of an edge that keeps its id take precedence.
template <class Value>
FlatMap<EdgeId, Value> renamed(const FlatMap<EdgeId, Value>& settings, const Targets& targets) {
  std::map<EdgeId, Value> moved;
  FlatMap<EdgeId, Value> out;
  for (const auto& [id, value] : settings) {
    const VertexId a = target_of(targets, id.low), b = target_of(targets, id.high);
    if (a == id.low && b == id.high)
      out.set(id, value);
    else if (a != b)
      moved.try_emplace(EdgeId::of(a, b), value);
  }
  for (const auto& [id, value] : moved)
    if (!out.contains(id)) out.set(id, value);
  return out;
}

Result<EditResult> merged(const PolyhedronSource& source, const Targets& targets,
                          const std::map<VertexId, Vector3>& moved) {
  MeshEditor draft(source);
  ElementSet selection;
  std::set<FaceId> touched;
  for (const auto& [from, to] : targets) {
    selection.vertices.insert(to);
    for (const FaceId f : draft.faces_at(from)) touched.insert(f);
  }
  for (const auto& [vertex, position] : moved) draft.move_vertex(vertex, position);
  for (const FaceId f : touched) {
    std::vector<VertexId> corners = merged_corners(draft.face(f), targets);
    if (corners.size() < 3)
      draft.remove_face(f);
    else
      draft.set_face(f, std::move(corners));
  }
  draft.shaping().beta = renamed(draft.shaping().beta, targets);
  draft.shaping().crease = renamed(draft.shaping().crease, targets);
  auto result = std::move(draft).finish();
  if (!result) return result.error();
  std::erase_if(selection.vertices, [&](VertexId v) { return result->polyhedron.find(v) == no_index; });
  return EditResult{std::move(result).value(), std::move(selection)};
}

Message too_few() {
  return make_error(e_wrong_selection, "There are no two vertices to merge.", "Select two or more.");
}

/// Mean of the points, computed relative to the first so that vertices far from zero lose no digits.
Vector3 centre_of(std::span<const Vector3> points) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& p : points) sum += (p - points[0]) / static_cast<double>(points.size());
  return points[0] + sum;
}

}  // namespace

Result<EditResult> merge_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                  MergeAt at) {
  const Polyhedron& polyhedron = source.polyhedron;
  const auto chosen = selected(polyhedron, vertices, "Select two or more vertices.");
  if (!chosen) return chosen.error();
  if (chosen->size() < 2) return too_few();
  const VertexId target = at == MergeAt::last ? vertices.back() : vertices.front();
  Targets targets;
  std::vector<Vector3> places;
  for (const Index v : *chosen) {
    places.push_back(polyhedron.position(v));
    if (polyhedron.vertex_id(v) != target) targets.emplace(polyhedron.vertex_id(v), target);
  }
  if (at != MergeAt::centre) return merged(source, targets, {});
  return merged(source, targets, {{target, centre_of(places)}});
}

Result<EditResult> collapse_edges(const PolyhedronSource& source, std::span<const EdgeId> edges) {
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto chosen = selected(polyhedron, edges, "Select edges.");
  if (!chosen) return chosen.error();
  // The lowest vertex of each connected group represents it.
  std::map<Index, Index> lower;
  const auto root = [&](Index v) {
    while (lower.contains(v)) v = lower.at(v);
    return v;
  };
  std::set<Index> ends;
  for (const Index e : *chosen) {
    const Index h = mesh.half_edge_of_edge(e);
    ends.insert({mesh.origin(h), mesh.target(h)});
    const Index a = root(mesh.origin(h)), b = root(mesh.target(h));
    if (a != b) lower[std::max(a, b)] = std::min(a, b);
  }
  std::map<Index, std::vector<Vector3>> places;
  Targets targets;
  for (const Index v : ends) {
    places[root(v)].push_back(polyhedron.position(v));
    if (root(v) != v) targets.emplace(polyhedron.vertex_id(v), polyhedron.vertex_id(root(v)));
  }
  std::map<VertexId, Vector3> moved;
  for (const auto& [v, points] : places) moved.emplace(polyhedron.vertex_id(v), centre_of(points));
  return merged(source, targets, moved);
}

Result<EditResult> merge_by_distance(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                     double distance) {
  const Polyhedron& polyhedron = source.polyhedron;
  if (!std::isfinite(distance) || distance < 0)
    return make_error(e_bad_amount, "The distance is not a length.", "Give a length of 0 or more.");
  const auto chosen = selected(polyhedron, vertices, "Select two or more vertices.");
  if (!chosen) return chosen.error();
  std::vector<Vector3> points;
  for (const Index v : *chosen) points.push_back(polyhedron.position(v));
  const std::vector<Index> standing = representatives(points, distance);
  Targets targets;
  for (std::size_t i = 0; i < standing.size(); ++i)
    if (standing[i] != i)
      targets.emplace(polyhedron.vertex_id((*chosen)[i]), polyhedron.vertex_id((*chosen)[standing[i]]));
  if (targets.empty())
    return make_error(e_wrong_selection, "No two of the vertices are so near to each other.",
                      "Use a larger distance.");
  return merged(source, targets, {});
}

}  // namespace hariko
