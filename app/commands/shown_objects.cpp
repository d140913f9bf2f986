#include "app/commands/shown_objects.hpp"

#include "app/commands/console.hpp"
#include "app/files/left_out.hpp"
#include "app/files/walled_surface.hpp"
#include "core/analysis/combs.hpp"
#include "core/analysis/continuity.hpp"
#include "core/document/edits/edit_views.hpp"
#include "core/document/object_shape.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "render/picture.hpp"
#include "render/surface_maps.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/object_lines.hpp"
#include "ui/editor/saved_views.hpp"

namespace hariko {

namespace {

/// Surroundings that the map depends on, for all objects of a picture.
struct MapView {
  Vector3 pull = Vector3::UnitZ();
  std::shared_ptr<const DeviationReference> reference;
  ObjectId reference_id;
  Similarity reference_transform;
};

/// The map's view of the document; for deviations with the surface of the reference. Errors: E_MAP_REFERENCE,
/// those of surfaces.
Result<MapView> map_view(const Document& document, SurfaceMap map) {
  MapView out;
  out.pull = document.making.pull;
  if (map != SurfaceMap::deviation) return out;
  const Object* reference = document.find(document.making.reference);
  if (!reference || !has_shape(*reference))
    return make_error(e_map_reference, "There is no reference to deviate from.",
                      "Name an object with --deviation-from.");
  out.reference_id = reference->id;
  out.reference_transform = reference->transform;
  const auto surface = surface_or_facets(document, *reference);
  if (!surface) return surface.error();
  if (surface->patch_count() == 0)
    return make_error(e_map_reference, "The reference is empty.",
                      "Name another object with --deviation-from.");
  out.reference = std::make_shared<const DeviationReference>(
      *surface, is_faceted(*reference) ? DeviationReference::Kind::facets : DeviationReference::Kind::smooth);
  return out;
}

/// Builds the mesh of a part, with the values of the map where the object has them; else with why not.
std::optional<Message> build_mesh(const Object& object, const Surface& surface, SurfaceMap map, int density,
                                  const MapView& view, SceneObject& out) {
  MapPlace place;
  place.transform = object.transform;
  place.facets = is_faceted(object);
  place.pull = view.pull;
  place.reference_transform = view.reference_transform;
  if (object.id == view.reference_id)
    place.no_reference = make_warning(e_map_reference, "This object is the reference.");
  else
    place.reference = view.reference;
  const auto options = map_options(surface, map, density, place);
  out.mesh = DisplayMesh::build(surface, options ? *options : map_options(SurfaceMap::shaded, density));
  out.map = options ? map : SurfaceMap::shaded;
  return options ? std::nullopt : std::optional(options.error());
}

/// A part of a picture, and why it has no values of its map.
struct MappedObject {
  ShownObject shown;
  std::optional<Message> missing;
};

/// Reference facets as a part of the scene: flat, with their edges only.
MappedObject shown_facets(const Object& object, const RenderArguments& arguments, const MapView& view) {
  const Surface surface = facets_of(*object.mesh());
  SceneObject out;
  const SurfaceMap map = is_of_making(arguments.map) ? arguments.map : SurfaceMap::shaded;
  auto missing = build_mesh(object, surface, map, facet_density(map, surface.patch_count()), view, out);
  out.polyhedron = lines_of(*object.mesh());
  out.show_polyhedron = arguments.polyhedron;
  out.show_points = false;
  out.wire = arguments.wire;
  return {{std::move(out), surface}, std::move(missing)};
}

/// Adds combs and continuity marks of a surface.
void add_curves(const Object& object, const Surface& surface, const RenderArguments& arguments,
                SceneObject& out) {
  if (arguments.combs) {
    const CurvatureCombs combs = curvature_combs(surface, object.display.combs.density);
    out.combs = comb_lines(combs, surface.origin());
    out.comb_scale = object.display.combs.scale;
  }
  if (arguments.marks) out.marks = edge_marks(*out.mesh, classify(surface, continuity(surface), {}));
}

/// Surface of an object as a part of the scene, at a density that looks smooth.
Result<MappedObject> shown_surface(const Document& document, const Object& object,
                                   const RenderArguments& arguments, const MapView& view) {
  const auto built = object_surface(document, object);
  if (!built.ok()) return built.error();
  SceneObject out;
  // Lines of the display mesh need the object's own density to be distinguishable.
  const int density = arguments.wire == PatchWire::mesh
                          ? object.display.density
                          : display_density(built->surface.patch_count(), built->surface.domain(), 1'000'000);
  auto missing = build_mesh(object, built->surface, arguments.map, density, view, out);
  out.polyhedron = lines_of(document, object);
  out.show_polyhedron = arguments.polyhedron;
  if (object_kind(object).elements_shown() == ElementsShown::bodies) {
    out.show_bodies = out.x_ray = arguments.polyhedron;
    out.show_points = false;
  }
  out.show_network = arguments.network;
  out.show_tensions = arguments.tensions;
  out.wire = arguments.wire;
  add_curves(object, built->surface, arguments, out);
  return MappedObject{{std::move(out), built->surface}, std::move(missing)};
}

Result<MappedObject> shown_object(const Document& document, const Object& object,
                                  const RenderArguments& arguments, const MapView& view) {
  auto out = is_faceted(object) ? Result<MappedObject>(shown_facets(object, arguments, view))
                                : shown_surface(document, object, arguments, view);
  if (!out.ok()) return out;
  SceneObject& part = out.value().shown.part;
  part.transform = matrix_of(object.transform);
  const DisplaySettings display =
      with_material(object.display, arguments.material.value_or(object.display.material));
  part.material = display.material;
  part.color = color_of(arguments.colour.value_or(display.colour));
  return out;
}

}  // namespace

std::optional<std::vector<ShownObject>> shown_objects_or_report(const Document& document,
                                                                const RenderArguments& arguments) {
  const std::string file = arguments.file.string();
  const auto view = map_view(document, arguments.map);
  if (!view) {
    report(file, view.error());
    return std::nullopt;
  }
  std::vector<ShownObject> out;
  std::size_t count = 0;
  std::vector<std::pair<std::string, Message>> missing;  // with the object's name
  for (const Message& warning : left_out_of_triangles(document)) report(file, warning);
  for (const auto& object : document.objects) {
    if (!object->visible || !has_shape(*object)) continue;
    auto made = shown_object(document, *object, arguments, *view);
    if (!made.ok()) {
      report(file + ": " + object->name, made.error());
      return std::nullopt;
    }
    ++count;
    MappedObject mapped = std::move(made).value();
    if (mapped.missing) missing.emplace_back(object->name, *mapped.missing);
    for (const Similarity& place : places_of(*object)) {
      out.push_back(mapped.shown);
      out.back().part.transform = matrix_of(place);
    }
  }
  // A picture of nothing but objects without values would not be what was asked for.
  const bool failed = !missing.empty() && missing.size() == count;
  for (auto& [name, message] : missing) {
    if (!failed) message.severity = Severity::warning;
    report(file + ": " + name, message);
  }
  if (failed) return std::nullopt;
  if (!out.empty()) return out;
  report(file, make_error(e_nothing_to_show, "No visible object of the file has a shape to show.",
                          "Make an object visible, or add one."));
  return std::nullopt;
}

Result<Camera> camera_for(const Document& document, const std::string& saved, StandardView side,
                          const Box3& box, PixelSize size) {
  if (saved.empty()) return Camera::standard(side).frame(box, size);
  if (const SavedView* found = find_view(document, saved)) return camera_of(*found);
  std::string names;
  for (const SavedView& view : *document.saved_views) names += (names.empty() ? "" : ", ") + view.name;
  return make_error(e_unknown_view, "There is no saved view called \"" + saved + "\".",
                    names.empty() ? "The document has none: save a view in the window first."
                                  : "Choose one of these: " + names + ".");
}

}  // namespace hariko
