#include "core/modeling/operations/extrude.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/base/index_list.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/amount.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/operations/short_edges.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

constexpr const char* select_faces = "Select the faces to extrude.";
constexpr const char* select_borders = "Select edges of an open border.";

Result<Done> check_region(const Region& region, const Vector3& normal, double distance, FaceId first) {
  if (region.rim.empty())
    return make_error(e_wrong_selection, "The faces form a closed surface, which has no rim to extrude from.",
                      "Leave at least one face out, or extrude each face by itself.", element_of(first));
  if (normal.isZero(0) && distance != 0)
    return make_error(e_wrong_selection, "The faces have no common direction to be extruded in.",
                      "Extrude by 0 and move them, or extrude each face by itself.", element_of(first));
  return Done{};
}

/// Carries the shaping of the old rim, which keeps it, to the copy and the walls.
void carry_shaping(MeshEditor& draft, const Polyhedron& polyhedron, const Shaping& before,
                   const std::vector<Region>& regions) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto creased = [&](Index e) { return before.crease.contains(polyhedron.edge_id(e)); };

  for (const Region& region : regions) {
    std::map<Index, VertexId> arriving;  // top of the rim point where the rim arrives along a half-edge
    for (const RimPoint& point : region.rim) arriving.emplace(point.in, point.top);
    for (const RimPoint& point : region.rim) {
      draft.inherit(point.base, point.top);
      draft.inherit(polyhedron.edge_id(mesh.edge(point.out)), EdgeId::of(point.top, arriving.at(point.out)));
      if (!std::any_of(point.inner_edges.begin(), point.inner_edges.end(), creased)) continue;
      // Finds whether the crease comes from outside: the edges there run between `in` and `out`, outside the
      // region.
      bool outside = false;
      for (const Index h : mesh.fan_corners(point.vertex)) {
        const Index e = mesh.edge(h);
        outside = creased(e) && e != mesh.edge(point.in) && e != mesh.edge(point.out) &&
                  std::find(point.inner_edges.begin(), point.inner_edges.end(), e) == point.inner_edges.end();
        if (outside) break;
      }
      if (outside) draft.shaping().crease.set(EdgeId::of(point.base, point.top), true);
    }
  }
}

/// Closes the body of a sheet that was extruded as a whole. The faces of the back are new; the sheet's inner
/// vertices moved with the front, so the back gets new ones.
void add_back(MeshEditor& draft, const Polyhedron& polyhedron, const Region& region,
              std::vector<FaceId>& back) {
  std::map<Index, VertexId> base;
  for (const RimPoint& point : region.rim) base.emplace(point.vertex, point.base);
  for (const Index v : region.inner_vertices) {
    const VertexId copy = draft.add_vertex(polyhedron.position(v));
    draft.inherit(polyhedron.vertex_id(v), copy);
    base.emplace(v, copy);
  }
  const HalfEdgeMesh& mesh = polyhedron.topology();
  for (const Index f : region.faces) {
    std::vector<VertexId> corners;
    for (const Index v : mesh.face_vertices(f)) corners.push_back(base.at(v));
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h)
      draft.inherit(polyhedron.edge_id(mesh.edge(h)),
                    EdgeId::of(base.at(mesh.origin(h)), base.at(mesh.target(h))));
    std::reverse(corners.begin(), corners.end());
    back.push_back(draft.add_face(std::move(corners)));
  }
}

void turn_over(MeshEditor& draft, FaceId face) {
  std::vector<VertexId> corners(draft.face(face).begin(), draft.face(face).end());
  std::reverse(corners.begin(), corners.end());
  draft.set_face(face, std::move(corners));
}

/// Reverses every face of the body: front, back and the walls, which are the faces at the base of the rim.
void turn_body(MeshEditor& draft, const Polyhedron& polyhedron, const Region& region,
               const std::vector<FaceId>& back) {
  std::vector<FaceId> body = back;
  for (const Index f : region.faces) body.push_back(polyhedron.face_id(f));
  for (const RimPoint& point : region.rim)
    for (const FaceId face : draft.faces_at(point.base)) body.push_back(face);
  sort_unique(body);
  for (const FaceId face : body) turn_over(draft, face);
}

}  // namespace

Result<EditResult> extrude_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                                 const ExtrudeOptions& options) {
  if (const auto finite = detail::check_finite(options.distance); !finite) return finite.error();
  const Polyhedron& polyhedron = source.polyhedron;
  const auto chosen = selected(polyhedron, faces, select_faces);
  if (!chosen) return chosen.error();
  std::vector<Region> regions = find_regions(polyhedron, *chosen, options.as);
  std::vector<Vector3> offsets;
  for (const Region& region : regions) {
    const Vector3 normal = mean_normal(polyhedron, region.faces);
    const FaceId first = polyhedron.face_id(region.faces[0]);
    if (const auto fits = check_region(region, normal, options.distance, first); !fits) return fits.error();
    offsets.emplace_back(options.distance * normal);
  }

  MeshEditor draft(source);
  raise_regions(draft, polyhedron, regions);
  carry_shaping(draft, polyhedron, *source.shaping, regions);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const Region& region = regions[r];
    for (const RimPoint& point : region.rim)
      draft.move_vertex(point.top, polyhedron.position(point.vertex) + offsets[r]);
    for (const Index v : region.inner_vertices)
      draft.move_vertex(polyhedron.vertex_id(v), polyhedron.position(v) + offsets[r]);
    if (!region.whole_part) continue;
    std::vector<FaceId> back;
    add_back(draft, polyhedron, region, back);
    if (options.distance < 0) turn_body(draft, polyhedron, region, back);
  }
  Result<PolyhedronSource> result = std::move(draft).finish();
  if (!result) return result.error();
  if (options.distance != 0) tighten_short_edges(result.value(), source);
  EditResult out{std::move(result).value(), {}};
  for (const Index f : *chosen) out.selection.faces.insert(polyhedron.face_id(f));
  return out;
}

Result<EditResult> extrude_borders(const PolyhedronSource& source, std::span<const EdgeId> edges,
                                   double distance) {
  if (const auto finite = detail::check_finite(distance); !finite) return finite.error();
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto chosen = selected(polyhedron, edges, select_borders);
  if (!chosen) return chosen.error();
  std::map<Index, std::pair<Vector3, Vector3>> outwards;  // per vertex, from the edges before and after it
  for (const Index e : *chosen) {
    if (!mesh.is_border_edge(e))
      return make_error(e_wrong_selection,
                        "The edge lies between two faces; only open edges can be extruded.", select_borders,
                        element_of(polyhedron.edge_id(e)));
    const Index h = mesh.half_edge_of_edge(e);
    const Vector3 out = -inward_direction(polyhedron, h);
    outwards.try_emplace(mesh.origin(h), Vector3::Zero(), Vector3::Zero()).first->second.second = out;
    outwards.try_emplace(mesh.target(h), Vector3::Zero(), Vector3::Zero()).first->second.first = out;
  }

  MeshEditor draft(source);
  std::map<Index, VertexId> copy;
  for (const auto& [v, out] : outwards) {
    copy[v] = draft.add_vertex(polyhedron.position(v) + distance * miter(out.first, out.second));
    draft.inherit(polyhedron.vertex_id(v), copy[v]);
    draft.release_corner(polyhedron.vertex_id(v));
  }
  ElementSet selection;
  for (const Index e : *chosen) {
    const Index h = mesh.half_edge_of_edge(e), a = mesh.origin(h), b = mesh.target(h);
    draft.add_face({polyhedron.vertex_id(b), polyhedron.vertex_id(a), copy[a], copy[b]});
    const EdgeId border = EdgeId::of(copy[a], copy[b]);
    draft.inherit(polyhedron.edge_id(e), border);
    selection.edges.insert(border);
  }
  Result<PolyhedronSource> result = std::move(draft).finish();
  if (!result) return result.error();
  if (distance != 0) tighten_short_edges(result.value(), source);
  return EditResult{std::move(result).value(), std::move(selection)};
}

}  // namespace hariko
