#include "ui/editor/paper_solid.hpp"

#include <limits>

#include "core/surface/facets.hpp"
#include "core/unfolding/pages/write_sheets.hpp"

namespace hariko {

namespace {

constexpr float paper_shade = 0.93F;

/// From mm to the document, so that the solid lies where the model is.
void take_to_document(const PaperLayout& layout, const std::vector<SpaceCorners>& solid,
                      std::vector<SpaceCorners>& corners) {
  const FacetGraph& graph = *layout.unfolding.graph;
  const double scale = layout.unfolding.settings.scale;
  const Vector3 shift = solid[0][0] - scale * graph.positions()[graph.triangle(0)[0]];
  for (SpaceCorners& facet : corners)
    for (Vector3& corner : facet) corner = (corner - shift) / scale;
}

std::array<float, 3> floats(const Vector3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

std::shared_ptr<const DisplayPolyhedron> lines_of(const PaperLayout& layout,
                                                  const std::vector<SpaceCorners>& corners,
                                                  const Vector3& origin) {
  auto out = std::make_shared<DisplayPolyhedron>();
  const Unfolding& u = layout.unfolding;
  out->origin = origin;
  for (const SpaceCorners& facet : corners)
    for (const Vector3& corner : facet) {
      out->positions.push_back(floats(corner - origin));
      out->box.extend(corner - origin);
    }
  for (Index f = 0; f < corners.size(); ++f) {
    for (Index side = 0; side < 3; ++side) {
      const FacetEdge& edge = u.graph->edge(u.graph->edge_at(f, side));
      const bool folded = u.folds[u.graph->edge_at(f, side)] != 0;
      if (folded &&
          (edge.inner || edge.facets[0] != f || fold_kind(edge.fold_angle, u.settings) == FoldKind::flat))
        continue;
      out->edges.push_back({3 * f + side, 3 * f + (side + 1) % 3});
      out->edge_kinds.push_back(folded ? EdgeKind::plain : EdgeKind::boundary);
    }
    for (Index corner = 0; corner < 3; ++corner) out->face_vertices.push_back(3 * f + corner);
    out->face_offsets.push_back(static_cast<Index>(out->face_vertices.size()));
  }
  return out;
}

}  // namespace

std::shared_ptr<const PaperSolid> fold_up(std::shared_ptr<const PaperLayout> layout, double folded) {
  auto out = std::make_shared<PaperSolid>();
  const double spacing = layout->unfolding.settings.page.width + page_spacing;
  out->folded = folded;
  out->corners = folded_positions(layout->unfolding, folded, spacing);
  const auto solid = folded < 1 ? folded_positions(layout->unfolding, 1, spacing) : out->corners;
  take_to_document(*layout, solid, out->corners);
  for (const SpaceCorners& facet : out->corners)
    for (const Vector3& corner : facet) out->box.extend(corner);
  const Vector3 origin = out->box.center();
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Element> sources;
  for (Index f = 0; f < out->corners.size(); ++f) {
    for (const Vector3& corner : out->corners[f]) positions.push_back(corner - origin);
    triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    sources.push_back(element_of(FaceId{f}));
  }
  out->mesh =
      DisplayMesh::build(facet_surface(origin, positions, std::move(triangles), sources), {1, {}, {}});
  out->lines = lines_of(*layout, out->corners, origin);
  out->layout = std::move(layout);
  return out;
}

SceneObject scene_object_of(const PaperSolid& solid, const PaperState& state) {
  SceneObject out;
  out.mesh = solid.mesh;
  out.polyhedron = solid.lines;
  out.color = {paper_shade, paper_shade, paper_shade, 1};
  out.show_polyhedron = true;
  out.show_points = false;
  out.elements_pickable = false;
  const Unfolding& u = solid.layout->unfolding;
  const auto count = static_cast<Index>(solid.corners.size());
  if (state.selected < count)
    for (Index f = 0; f < count; ++f)
      if (u.piece_of[f] == u.piece_of[state.selected]) out.selected_patches.push_back(f);
  const PaperHover& hover = state.hovered;
  for (Index f = 0; f < count && hover.facet < count; ++f)
    if (u.graph->face(f) == u.graph->face(hover.facet)) out.hovered_patches.push_back(f);
  const Index edge = hover.joint < u.joints.size() ? u.joints[hover.joint].edge : hover.edge;
  if (edge >= u.graph->edge_count()) return out;
  // Both sides of a cut, or the fold.
  const auto& corners = u.graph->edge(edge);
  for (Index e = 0; e < solid.lines->edges.size(); ++e) {
    const auto [from, to] = solid.lines->edges[e];
    const auto& triangle = u.graph->triangle(from / 3);
    const auto [low, high] = std::minmax(triangle[from % 3], triangle[to % 3]);
    if (low == corners.low && high == corners.high) out.hovered.edges.push_back(e);
  }
  return out;
}

PaperHover paper_under(const PaperSolid& solid, const Ray& ray, double reach) {
  PaperHover out;
  double nearest = std::numeric_limits<double>::infinity();
  Vector3 point = Vector3::Zero();
  for (Index f = 0; f < solid.corners.size(); ++f) {
    const auto& [a, b, c] = solid.corners[f];
    const Vector3 ab = b - a, ac = c - a, p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0) continue;
    const Vector3 from = ray.origin - a;
    const double s = from.dot(p) / determinant;
    if (!(s >= 0 && s <= 1)) continue;
    const Vector3 q = from.cross(ab);
    const double t = ray.direction.dot(q) / determinant, distance = ac.dot(q) / determinant;
    if (!(t >= 0 && s + t <= 1 && distance > 0 && distance < nearest)) continue;
    nearest = distance;
    out.facet = f;
    point = ray.at(distance);
  }
  if (out.facet == no_index) return out;
  const SpaceCorners& facet = solid.corners[out.facet];
  double best = reach;
  for (Index side = 0; side < 3; ++side) {
    const Vector3 along = (facet[(side + 1) % 3] - facet[side]).normalized();
    const Vector3 off = point - facet[side];
    const double distance = (off - off.dot(along) * along).norm();
    const FacetGraph& graph = *solid.layout->unfolding.graph;
    const Index edge = graph.edge_at(out.facet, side);
    if (distance >= best || graph.edge(edge).border() || graph.edge(edge).inner) continue;
    best = distance;
    out.edge = edge;
  }
  return out;
}

}  // namespace hariko
