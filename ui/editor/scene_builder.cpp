#include "ui/editor/scene_builder.hpp"

#include <cmath>

#include "core/document/object_shape.hpp"
#include "render/surface_maps.hpp"
#include "ui/editor/reference_pictures.hpp"

namespace hariko {

namespace {

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

/// The surface alone, for what is drawn over it: other lines would be taken for edges.
void clear_lines(SceneObject& out) {
  out.wire = PatchWire::none;
  out.show_surface = true;
  out.show_network = false;
  out.show_bodies = false;
  out.marks.reset();
  out.combs.reset();
  out.selected_patches.clear();
  out.hovered_patches.clear();
  out.dimmed = false;
}

/// The edges of the facets over the surface, or the facets in its place.
void show_facets(const MeshPreview& mesh, bool alone, SceneObject& out) {
  clear_lines(out);
  if (alone || !out.mesh) {
    out.mesh = mesh.mesh;
    out.map = SurfaceMap::shaded;
  }
  out.facet_edges = mesh.edges;
}

/// Errors have the sequential colours of a map that begins at zero.
void show_errors(const MeshPreview& mesh, MeshShown shown, SceneObject& out) {
  const MeshErrors& errors = mesh.of(shown);
  clear_lines(out);
  out.mesh = errors.mesh;
  out.map = SurfaceMap::gaussian;
  out.range = errors.range;
  out.facet_edges = mesh.edges;
}

/// Section curves over their combs.
void add_section_curves(const SectionCurves& sections, std::vector<SceneLines>& out) {
  if (!sections.shown) return;
  if (sections.teeth) out.push_back({sections.teeth, color_from_hex("#8f74d8"), 1});
  if (sections.lines) out.push_back({sections.lines, color_from_hex("#e07a2f"), 2});
}

/// The map that a surface shows now, with its range.
void show_map_of(const DisplaySettings& display, const SurfaceView& view, SceneObject& out) {
  // A new map shows when its values are there; until then, and where the object cannot have them, the surface
  // is drawn without.
  const bool ready =
      !has_values(display.map) || (view.object && view.object->display.map == display.map && !view.map_error);
  out.map = ready ? display.map : SurfaceMap::shaded;
  out.range = view.range;
}

/// An object that is chosen or pointed at as a whole: the outline of its surface, or all lines where it shows
/// none.
void mark_whole(const Editor& editor, const Object& object, SceneObject& out) {
  const ElementRef whole{object.id, element_of(object.id)};
  const bool selected = editor.selection.contains(whole), hovered = editor.hovered == whole;
  if (out.draws_surface()) {
    out.outlined = selected;
    out.outlined_as_hovered = hovered;
    return;
  }
  Highlights all;
  for (Index e = 0; (selected || hovered) && out.polyhedron && e < out.polyhedron->edges.size(); ++e)
    all.edges.push_back(e);
  if (selected) out.selected = all;
  if (hovered) out.hovered = all;
}

/// Object at one of its further places. Tinted patches stay, because the buffers are the same; marks of
/// single elements are drawn at the object's own place only.
SceneObject copy_at_places(const SceneObject& own, bool whole) {
  SceneObject out = own;
  out.copy = true;
  out.failed = {};
  if (!whole) out.selected = out.hovered = {};
  return out;
}

/// Elements that are chosen or pointed at, and the patches of such faces.
void mark_elements(const Editor& editor, const Object& object, SceneObject& out) {
  const auto mark = [&](const ElementSelection& elements, Highlights& lines, std::vector<Index>& patches) {
    lines = object_kind(object).highlights(object, elements, *out.polyhedron);
    if (out.mesh && object.cage()) patches = patches_of(*out.mesh, elements.faces);
  };
  mark(editor.selection.of(object.id), out.selected, out.selected_patches);
  if (!editor.hovered || editor.hovered->object != object.id) return;
  Selection hover;
  hover.select(*editor.hovered, Selection::How::replace);
  mark(hover.of(object.id), out.hovered, out.hovered_patches);
}

}  // namespace

Background background_of(ThemeId theme) {
  return theme == ThemeId::light ? Background::light : Background::dark;
}

std::optional<SectionPlane> section_plane(const ViewSettings& view) {
  if (!view.section.shown) return std::nullopt;
  const double side = view.section.flipped ? -1 : 1;
  return SectionPlane{side * Vector3::Unit(view.section.axis), side * view.section.offset};
}

void SceneBuilder::update(const Editor& editor) {
  Scene next;
  next.background = background_of(editor.settings.theme);
  next.grid.visible = editor.view.grid;
  if (const WorkingPlane& plane = editor.working_plane; !plane.is_ground())
    next.grid.plane = GridSettings::Plane{plane.frame.point, plane.frame.axes};
  next.zebra = editor.view.zebra;
  if (editor.view.environment && !editor.paper.covers_model())
    next.environment = {editor.environment, editor.settings.environment.turn,
                        editor.settings.environment.exposure};
  next.colour_blind_safe = editor.settings.colour_blind_maps;
  next.hidden_opacity = static_cast<float>(editor.view.x_ray_strength);
  next.section = section_plane(editor.view);
  next.pixel_scale = editor.pixel_scale;
  ids_.clear();
  fold_paper(editor.paper);
  if (paper_) {
    next.objects.push_back(scene_object_of(*paper_, editor.paper));
    ids_.push_back(ObjectId{});
  }
  if (const Object* active = editor.has_document ? editor.active_object() : nullptr; active && !paper_)
    next.lines = object_kind(*active).guides(*active);
  if (editor.paper.shown && editor.paper.fault)
    for (const auto& [from, to] : editor.paper.fault->lines)
      next.lines.push_back({from, to, color_from_hex("#e5484d"), 3, true});
  for (const auto& object : editor.document().objects) {
    if (paper_) break;
    if (!object->visible || !has_shape(*object)) continue;
    next.objects.push_back(describe(editor, object));
    if (const MeshingResult* meshed = editor.meshing.shown_for(object)) {
      const MeshShown shown = editor.meshing.shown;
      if (shown == MeshShown::facets)
        show_facets(meshed->mesh, editor.meshing.alone, next.objects.back());
      else
        show_errors(meshed->mesh, shown, next.objects.back());
    }
    ids_.push_back(object->id);
  }
  if (!paper_) next.pictures = scene_pictures(editor);
  if (!paper_) add_section_curves(editor.sections, next.curves);
  colour_by_view(editor, next);
  if (!paper_) add_copies(editor.document(), editor.mode == ElementMode::object, next);
  std::erase_if(entries_, [&](const auto& entry) { return !editor.document().find(entry.first); });
  const bool compared = !compared_.empty();
  if (!(next == scene_)) ++version_;
  scene_ = std::move(next);
  compare(editor);
  if (compared != !compared_.empty()) ++version_;
}

/// Live copies: what stands at an object's own place once more at each further one. `whole`: objects are
/// chosen and pointed at, not their elements.
void SceneBuilder::add_copies(const Document& document, bool whole, Scene& scene) {
  const std::size_t own = scene.objects.size();
  for (std::size_t i = 0; i < own; ++i) {
    const Object* object = document.find(ids_[i]);
    if (!object || object->copies->empty()) continue;
    const SceneObject copy = copy_at_places(scene.objects[i], whole);
    const std::vector<Similarity> places = places_of(*object);
    for (std::size_t k = 1; k < places.size(); ++k) {
      scene.objects.push_back(copy);
      scene.objects.back().transform = matrix_of(places[k]);
      ids_.push_back(object->id);
    }
  }
}

/// The four pictures: the same scene, with another mesh or another error in the object's place.
void SceneBuilder::compare(const Editor& editor) {
  compared_.clear();
  if (paper_ || !editor.meshing.comparing()) return;  // the paper stands in the place of the objects
  const auto object = meshed_object(editor.document(), editor.selection.active);
  const MeshingResult* result = object ? editor.meshing.shown_for(object) : nullptr;
  if (!result || !result->compared) return;
  compared_.resize(ViewLayout::count, scene_);
  std::size_t place = 0;
  for (const Pane& pane : editor.layout.panes()) {
    const ComparedPicture picture = compared_picture(place++);
    std::vector<SceneObject>& shown = compared_[static_cast<std::size_t>(pane.view)].objects;
    for (std::size_t i = 0; i < shown.size(); ++i)
      if (ids_[i] == object->id) show_errors((*result->compared)[picture.mesh], picture.shown, shown[i]);
  }
}

void SceneBuilder::fold_paper(const PaperState& paper) {
  if (!paper.covers_model()) return paper_.reset();
  const auto layout = paper.shared_visible();
  const double folded = double(paper.folded);
  if (!paper_ || paper_->layout != layout || paper_->folded != folded) paper_ = fold_up(layout, folded);
}

SceneObject SceneBuilder::describe(const Editor& editor, const std::shared_ptr<const Object>& object) {
  SceneObject out;
  const ObjectKind& kind = object_kind(*object);
  out.polyhedron = lines_of(editor.document(), object);
  out.transform = matrix_of(object->transform);
  const DisplaySettings display = shown_display(editor.view.map, *object);
  const bool bare = editor.view.surfaces_only;
  out.show_surface = display.surface;
  out.show_polyhedron = display.polyhedron && !bare;
  out.show_network = display.network && !bare;
  out.x_ray = editor.view.x_ray;
  out.material = display.material;
  out.color = color_of(display.colour);
  out.wire = bare ? PatchWire::none : display.wire;
  out.show_points = display.points && object->has_surface();
  out.show_tensions = display.tensions;
  kind.adjust(*object, editor.view, out);
  const SurfaceView* view = editor.view_of(object->id);
  if (view) out.mesh = view->mesh;
  if (editor.mode == ElementMode::object && !bare) mark_whole(editor, *object, out);
  out.map = display.map;
  if (!object->has_surface()) {
    if (view) show_map_of(display, *view, out);
    return out;
  }
  if (view) describe_surface(editor, *object, *view, out);
  const auto stale = editor.stale_since.find(object->id);
  out.dimmed = (stale != editor.stale_since.end() && editor.now - stale->second > 0.3) ||
               editor.recompute.outdated.contains(object->id);
  if (!bare && editor.mode != ElementMode::object && out.polyhedron) mark_elements(editor, *object, out);
  return out;
}

/// Describes the surface that is shown: curves over edges, combs, marks of continuity, its map and its error.
void SceneBuilder::describe_surface(const Editor& editor, const Object& object, const SurfaceView& view,
                                    SceneObject& out) {
  const DisplaySettings display = shown_display(editor.view.map, object);
  if (view.mesh && out.polyhedron) out.edge_curves = edge_curves_of(object, *view.mesh, *out.polyhedron);
  out.combs = display.combs.shown ? view.combs : nullptr;
  out.comb_scale = display.combs.scale;
  if (display.marks && view.continuity) out.marks = marks_of(object.id, view, editor.view.tolerance);
  if (view.error && out.polyhedron)
    out.failed = object_kind(object).failed(object, view.error->element, *out.polyhedron);
  show_map_of(display, view, out);
}

std::shared_ptr<const EdgeCurves> SceneBuilder::edge_curves_of(const Object& object, const DisplayMesh& mesh,
                                                               const DisplayPolyhedron& polyhedron) {
  if (!object_kind(object).curves_over_edges()) return nullptr;
  Entry& entry = entries_[object.id];
  const auto topology = object.cage()->shared_topology();
  if (!entry.edge_curves || entry.edge_curves->curves != mesh.curves() || entry.curves_topology != topology) {
    entry.edge_curves = edge_curves(mesh, polyhedron);
    entry.curves_topology = topology;
  }
  return entry.edge_curves;
}

/// One range for all surfaces that show the view's map, so that their colours compare. In a gesture it rests.
void SceneBuilder::colour_by_view(const Editor& editor, Scene& scene) {
  const ViewMap& view = editor.view.map;
  const auto slot = view.map ? range_slot(*view.map) : std::nullopt;
  std::vector<std::shared_ptr<const DisplayMesh>> meshes;
  std::vector<std::pair<SceneObject*, double>> followers;  // with what their values are divided by
  for (std::size_t i = 0; slot && !paper_ && i < scene.objects.size(); ++i) {
    SceneObject& shown = scene.objects[i];
    const Object* object = editor.document().find(ids_[i]);
    const SurfaceView* surface = editor.view_of(ids_[i]);
    // Not where triangles or errors stand in the surface's place.
    if (!object || !surface || shown.mesh != surface->mesh || shown.map != *view.map ||
        !follows_view(view, *object))
      continue;
    followers.emplace_back(&shown, std::pow(object->transform.scale, scale_power(*view.map)));
    meshes.push_back(shown.mesh);
  }
  if (followers.empty()) return view_scale_.reset();
  const bool same_map = view_scale_ && view_scale_->map == *view.map;
  const double limit = limit_of(editor.document(), *view.map);
  const bool fresh = same_map && scaled_settings_ == view.ranges[*slot] && scaled_limit_ == limit &&
                     (editor.history.in_gesture() || scaled_meshes_ == meshes);
  if (!fresh) {
    std::vector<float> values;
    for (const auto& [shown, divisor] : followers)
      for (const float value : values_of(*shown->mesh, *view.map))
        values.push_back(static_cast<float>(double(value) / divisor));
    constexpr int bins = 48;
    const ValueRange range = value_range(*view.map, view.ranges[*slot], values, limit);
    view_scale_ = ViewScale{*view.map, range, histogram(values, range, bins)};
    scaled_meshes_ = std::move(meshes);
    scaled_settings_ = view.ranges[*slot];
    scaled_limit_ = limit;
  }
  for (const auto& [shown, divisor] : followers)
    shown->range = {view_scale_->range.low * divisor, view_scale_->range.high * divisor,
                    view_scale_->range.centre * divisor};
}

std::shared_ptr<const EdgeMarks> SceneBuilder::marks_of(ObjectId id, const SurfaceView& view,
                                                        const ContinuityTolerance& tolerance) {
  if (!view.mesh || view.continuity->seams.size() != view.surface.seams().size()) return nullptr;
  Entry& entry = entries_[id];
  // Refreshed meshes share their curves; the marks follow them by the numbers of their vertices.
  if (!entry.marks || entry.marked_curves != view.mesh->curves() || entry.marked_report != view.continuity ||
      !(entry.marked_tolerance == tolerance)) {
    entry.marks = edge_marks(*view.mesh, classify(view.surface, *view.continuity, tolerance));
    entry.marked_curves = view.mesh->curves();
    entry.marked_report = view.continuity;
    entry.marked_tolerance = tolerance;
  }
  return entry.marks;
}

std::shared_ptr<const DisplayPolyhedron> SceneBuilder::lines_of(const Document& document,
                                                                const std::shared_ptr<const Object>& object) {
  Entry& entry = entries_[object->id];
  // Attached vertices follow objects that may have changed.
  if (entry.object == object && !entry.lines.attached) return entry.lines.polyhedron;
  entry.lines = object_kind(*object).lines(document, *object, entry.object.get(), entry.lines);
  entry.object = object;
  return entry.lines.polyhedron;
}

ElementRef element_at(const Document& document, ObjectId object, Element::Kind kind, Index index) {
  const Object* found = document.find(object);
  return {object, found ? object_kind(*found).element_at(*found, kind, index) : Element{}};
}

}  // namespace hariko
