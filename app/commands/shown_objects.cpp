#include "app/commands/shown_objects.hpp"

#include "app/commands/console.hpp"
#include "core/analysis/combs.hpp"
#include "core/analysis/continuity.hpp"
#include "core/modeling/attached.hpp"
#include "render/picture.hpp"
#include "render/surface_maps.hpp"
#include "ui/object_lines.hpp"

namespace hariko {

namespace {

/// The object as a part of the scene; its surface is drawn at the density that looks smooth.
Result<ShownObject> shown_object(const Document& document, const Object& object,
                                 const RenderArguments& arguments) {
  const auto built = object_surface(document, object);
  if (!built.ok()) return built.error();
  SceneObject out;
  // Lines of the display mesh are there to be told apart.
  const int density = arguments.wire == PatchWire::mesh
                          ? object.display.density
                          : display_density(built->surface.patch_count(), built->surface.domain(), 1'000'000);
  out.mesh = DisplayMesh::build(built->surface, map_options(arguments.map, density));
  out.polyhedron = lines_of(document, object);
  out.transform = matrix_of(object.transform);
  out.map = arguments.map;
  const DisplaySettings display =
      with_material(object.display, arguments.material.value_or(object.display.material));
  out.material = display.material;
  out.color = color_of(arguments.colour.value_or(display.colour));
  out.show_polyhedron = arguments.polyhedron;
  if (object.solids()) {
    out.show_bodies = out.x_ray = arguments.polyhedron;
    out.show_points = false;
  }
  out.show_network = arguments.network;
  out.show_tensions = arguments.tensions;
  out.wire = arguments.wire;
  if (arguments.combs) {
    const CurvatureCombs combs = curvature_combs(built->surface, object.display.combs.density);
    out.combs = comb_lines(combs, built->surface.origin());
    out.comb_scale = object.display.combs.scale;
  }
  if (arguments.marks)
    out.marks = edge_marks(*out.mesh, classify(built->surface, continuity(built->surface), {}));
  return ShownObject{std::move(out), built->surface};
}

}  // namespace

std::optional<std::vector<ShownObject>> shown_objects_or_report(const Document& document,
                                                                const RenderArguments& arguments) {
  const std::string file = arguments.file.string();
  std::vector<ShownObject> out;
  for (const auto& object : document.objects) {
    if (!object->visible || !object->has_surface()) continue;
    auto shown = shown_object(document, *object, arguments);
    if (!shown.ok()) {
      report(file + ": " + object->name, shown.error());
      return std::nullopt;
    }
    out.push_back(std::move(shown).value());
  }
  if (!out.empty()) return out;
  report(file, make_error(e_nothing_to_show, "No visible object of the file has a surface.",
                          "Make an object visible, or add one."));
  return std::nullopt;
}

}  // namespace hariko
