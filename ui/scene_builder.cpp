#include "ui/scene_builder.hpp"

#include <algorithm>

namespace hariko {

namespace {

bool same(const ZebraSettings& a, const ZebraSettings& b) {
  return a.stripes == b.stripes && a.direction == b.direction && a.fixed == b.fixed &&
         a.reflection == b.reflection;
}

bool same(const GridSettings& a, const GridSettings& b) {
  return a.visible == b.visible && a.height == b.height && a.spacing == b.spacing;
}

bool same(const SceneObject& a, const SceneObject& b) {
  return a.mesh == b.mesh && a.polyhedron == b.polyhedron && a.transform == b.transform && a.map == b.map &&
         a.range == b.range && a.show_surface == b.show_surface && a.show_polyhedron == b.show_polyhedron &&
         a.show_network == b.show_network && a.show_split_edges == b.show_split_edges &&
         a.show_points == b.show_points && a.x_ray == b.x_ray && a.dimmed == b.dimmed &&
         a.selected == b.selected && a.hovered == b.hovered && a.selected_patches == b.selected_patches &&
         a.hovered_patches == b.hovered_patches;
}

bool same(const Scene& a, const Scene& b) {
  return a.objects.size() == b.objects.size() && a.lines.empty() && b.lines.empty() &&
         a.background == b.background && same(a.grid, b.grid) && same(a.zebra, b.zebra) &&
         a.pixel_scale == b.pixel_scale &&
         std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(),
                    [](const SceneObject& x, const SceneObject& y) { return same(x, y); });
}

/// Patches that come from some faces, ascending.
std::vector<Index> patches_of(const DisplayMesh& mesh, const std::set<FaceId>& faces) {
  std::vector<Index> patches;
  if (faces.empty()) return patches;
  for (Index p = 0; p < mesh.patch_count(); ++p) {
    const Element& element = mesh.provenance(p).element;
    if (element.kind == Element::Kind::face && faces.contains(FaceId{static_cast<std::uint32_t>(element.id)}))
      patches.push_back(p);
  }
  return patches;
}

/// Facets of a reference mesh as lines.
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
  return lines;
}

}  // namespace

void SceneBuilder::update(const Editor& editor) {
  Scene next;
  next.background = editor.settings.theme == ThemeId::light ? Background::light : Background::dark;
  next.grid.visible = editor.view.grid;
  next.zebra = editor.view.zebra;
  ids_.clear();
  for (const auto& object : editor.document().objects) {
    if (!object->visible || (!object->polyhedron() && !object->mesh())) continue;
    next.objects.push_back(describe(editor, object));
    ids_.push_back(object->id);
  }
  std::erase_if(entries_, [&](const auto& entry) { return !editor.document().find(entry.first); });
  if (!same(next, scene_)) ++version_;
  scene_ = std::move(next);
}

SceneObject SceneBuilder::describe(const Editor& editor, const std::shared_ptr<const Object>& object) {
  SceneObject out;
  out.polyhedron = polyhedron_of(object);
  out.transform = matrix_of(object->transform);
  const DisplaySettings& display = object->display;
  out.show_surface = display.surface;
  out.show_polyhedron = display.polyhedron;
  out.show_network = display.network;
  out.x_ray = editor.view.x_ray;
  const PolyhedronSource* source = object->polyhedron();
  if (!source) {
    out.show_points = false;
    return out;
  }
  if (const SurfaceView* view = editor.view_of(object->id)) {
    out.mesh = view->mesh;
    // A new map shows when its values are there; until then the surface is drawn without.
    const bool ready = !has_values(display.map) || (view->object && view->object->display.map == display.map);
    out.map = ready ? display.map : SurfaceMap::shaded;
    out.range = view->range;
  }
  const auto stale = editor.stale_since.find(object->id);
  out.dimmed = stale != editor.stale_since.end() && editor.now - stale->second > 0.3;
  const ElementSelection& selected = editor.selection.of(object->id);
  out.selected = highlights_of(selected, source->polyhedron);
  if (out.mesh) out.selected_patches = patches_of(*out.mesh, selected.faces);
  if (editor.hovered && editor.hovered->object == object->id) {
    Selection hover;
    hover.select(*editor.hovered, Selection::How::replace);
    out.hovered = highlights_of(hover.of(object->id), source->polyhedron);
    if (out.mesh) out.hovered_patches = patches_of(*out.mesh, hover.of(object->id).faces);
  }
  return out;
}

std::shared_ptr<const DisplayPolyhedron> SceneBuilder::polyhedron_of(
    const std::shared_ptr<const Object>& object) {
  Entry& entry = entries_[object->id];
  if (entry.object == object) return entry.polyhedron;
  const PolyhedronSource* source = object->polyhedron();
  const PolyhedronSource* before = entry.object ? entry.object->polyhedron() : nullptr;
  if (!source) {
    const MeshSource* mesh_before = entry.object ? entry.object->mesh() : nullptr;
    if (!mesh_before || !(*mesh_before == *object->mesh())) entry.polyhedron = lines_of(*object->mesh());
  } else if (before && before->polyhedron.shared_topology() == source->polyhedron.shared_topology() &&
             before->origin == source->origin && before->shaping->crease == source->shaping->crease) {
    if (!(before->polyhedron == source->polyhedron))
      entry.polyhedron = entry.polyhedron->moved(source->polyhedron);
  } else {
    entry.polyhedron = DisplayPolyhedron::build(source->polyhedron, *source->shaping, source->origin);
  }
  entry.object = object;
  return entry.polyhedron;
}

ElementRef element_at(const Document& document, ObjectId object, Element::Kind kind, Index index) {
  const Object* found = document.find(object);
  const PolyhedronSource* source = found ? found->polyhedron() : nullptr;
  if (!source) return {object, {}};
  const Polyhedron& polyhedron = source->polyhedron;
  switch (kind) {
    case Element::Kind::vertex:
      return {object, element_of(polyhedron.vertex_id(index))};
    case Element::Kind::edge:
      return {object, element_of(polyhedron.edge_id(index))};
    case Element::Kind::face:
      return {object, element_of(polyhedron.face_id(index))};
    default:
      return {object, {}};
  }
}

}  // namespace hariko
