#include "ui/editor/object_lines.hpp"

#include <algorithm>
#include <set>

#include "ui/editor/object_kind.hpp"

namespace hariko {

namespace {

/// Picking names what it finds, though nothing of these lines can be selected alone.
void number_through(DisplayPolyhedron& lines) {
  for (Index v = 0; v < lines.positions.size(); ++v) lines.vertex_ids.push_back(VertexId{v});
  for (Index f = 0; f < lines.face_count(); ++f) lines.face_ids.push_back(FaceId{f});
}

}  // namespace

std::shared_ptr<const DisplayPolyhedron> lines_of(const MeshSource& source) {
  auto lines = std::make_shared<DisplayPolyhedron>();
  lines->origin = source.origin;
  const PolygonMesh& mesh = *source.mesh;
  for (const Vector3& position : mesh.positions) {
    lines->positions.push_back({static_cast<float>(position.x()), static_cast<float>(position.y()),
                                static_cast<float>(position.z())});
    lines->box.extend(position);
  }
  std::set<std::pair<Index, Index>> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
  }
  for (const auto& [a, b] : edges) lines->edges.push_back({a, b});
  lines->edge_kinds.assign(lines->edges.size(), EdgeKind::plain);
  lines->face_offsets = mesh.face_offsets;
  lines->face_vertices = mesh.face_vertices;
  number_through(*lines);
  return lines;
}

std::shared_ptr<const DisplayPolyhedron> lines_of(const BezierSource& source) {
  auto lines = std::make_shared<DisplayPolyhedron>();
  lines->origin = source.origin;
  for (const BezierPatch& patch : *source.patches) {
    const auto first = Index(lines->positions.size());
    for (const Vector3& p : patch.points) {
      lines->positions.push_back({float(p.x()), float(p.y()), float(p.z())});
      lines->box.extend(p);
    }
    for (int j = 0; j <= patch.degree_t; ++j)
      for (int i = 0; i <= patch.degree_s; ++i) {
        const auto at = [&](int k, int l) { return first + Index(patch.index(k, l)); };
        if (i < patch.degree_s) lines->edges.push_back({at(i, j), at(i + 1, j)});
        if (j < patch.degree_t) lines->edges.push_back({at(i, j), at(i, j + 1)});
      }
  }
  lines->edge_kinds.assign(lines->edges.size(), EdgeKind::plain);
  number_through(*lines);
  return lines;
}

std::shared_ptr<const DisplayPolyhedron> lines_of(const Outline& outline) {
  auto lines = std::make_shared<DisplayPolyhedron>();
  std::vector<Vector3> points;
  for (const OutlineLoop& loop : outline.loops)
    points.insert(points.end(), loop.points.begin(), loop.points.end());
  lines->origin = origin_for(points);
  for (const Vector3& point : points) {
    const Vector3 p = point - lines->origin;
    lines->positions.push_back({float(p.x()), float(p.y()), float(p.z())});
    lines->vertex_ids.push_back(VertexId{Index(lines->vertex_ids.size())});
    lines->box.extend(p);
  }
  Index first = 0;
  for (const OutlineLoop& loop : outline.loops) {
    const auto count = Index(loop.points.size());
    for (Index i = 0; i < count && count > 1; ++i)
      lines->edges.push_back({first + i, first + (i + 1) % count});
    first += count;
  }
  lines->edge_kinds.assign(lines->edges.size(), EdgeKind::plain);
  return lines;
}

std::shared_ptr<const DisplayPolyhedron> lines_of(const Document& document, const Object& object) {
  return object_kind(object).lines(document, object, nullptr, {}).polyhedron;
}

}  // namespace hariko
