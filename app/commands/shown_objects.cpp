#include "app/commands/shown_objects.hpp"

#include "app/commands/console.hpp"
#include "app/files/left_out.hpp"
#include "app/files/reference_facets.hpp"
#include "core/analysis/combs.hpp"
#include "core/analysis/continuity.hpp"
#include "core/document/object_shape.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "render/picture.hpp"
#include "render/surface_maps.hpp"
#include "ui/editor/object_lines.hpp"

namespace hariko {

namespace {

/// Reference facets as a part of the scene: flat, with their edges only.
ShownObject shown_facets(const Object& object, const RenderArguments& arguments) {
  const Surface surface = facets_of(*object.mesh());
  SceneObject out;
  out.mesh = DisplayMesh::build(surface, map_options(SurfaceMap::shaded, 1));
  out.polyhedron = lines_of(*object.mesh());
  out.show_polyhedron = arguments.polyhedron;
  out.show_points = false;
  out.wire = arguments.wire;
  return {std::move(out), surface};
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
Result<ShownObject> shown_surface(const Document& document, const Object& object,
                                  const RenderArguments& arguments) {
  const auto built = object_surface(document, object);
  if (!built.ok()) return built.error();
  SceneObject out;
  // Lines of the display mesh need the object's own density to be distinguishable.
  const int density = arguments.wire == PatchWire::mesh
                          ? object.display.density
                          : display_density(built->surface.patch_count(), built->surface.domain(), 1'000'000);
  out.mesh = DisplayMesh::build(built->surface, map_options(arguments.map, density));
  out.polyhedron = lines_of(document, object);
  out.map = arguments.map;
  out.show_polyhedron = arguments.polyhedron;
  if (object.solids()) {
    out.show_bodies = out.x_ray = arguments.polyhedron;
    out.show_points = false;
  }
  out.show_network = arguments.network;
  out.show_tensions = arguments.tensions;
  out.wire = arguments.wire;
  add_curves(object, built->surface, arguments, out);
  return ShownObject{std::move(out), built->surface};
}

Result<ShownObject> shown_object(const Document& document, const Object& object,
                                 const RenderArguments& arguments) {
  auto out = object.mesh() ? Result<ShownObject>(shown_facets(object, arguments))
                           : shown_surface(document, object, arguments);
  if (!out.ok()) return out;
  SceneObject& part = out.value().part;
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
  std::vector<ShownObject> out;
  for (const Message& warning : left_out_of_triangles(document)) report(file, warning);
  for (const auto& object : document.objects) {
    if (!object->visible || !has_shape(*object)) continue;
    auto shown = shown_object(document, *object, arguments);
    if (!shown.ok()) {
      report(file + ": " + object->name, shown.error());
      return std::nullopt;
    }
    out.push_back(std::move(shown).value());
  }
  if (!out.empty()) return out;
  report(file, make_error(e_nothing_to_show, "No visible object of the file has a shape to show.",
                          "Make an object visible, or add one."));
  return std::nullopt;
}

}  // namespace hariko
