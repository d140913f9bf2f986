#include "app/commands/commands.hpp"

#include <vector>

#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/files/walled_surface.hpp"
#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_io.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/document/object_shape.hpp"
#include "core/drawing/write_section_set.hpp"
#include "core/exchange/number_text.hpp"
#include "render/picture.hpp"
#include "render/scene.hpp"

namespace hariko {

namespace {

/// Surfaces to cut, and the names of their objects.
struct CutObjects {
  std::vector<DrawnSurface> surfaces;
  std::vector<std::string> names;
};

Result<CutObjects> cut_objects(const Document& document) {
  CutObjects out;
  for (const auto& object : document.objects) {
    if (!object->visible || !has_shape(*object)) continue;
    const auto surface = surface_or_facets(document, *object);
    if (!surface) return surface.error();
    const std::vector<Similarity> places = places_of(*object);
    for (std::size_t k = 0; k < places.size(); ++k) {
      out.surfaces.push_back({*surface, Eigen::Affine3d(matrix_of(places[k]))});
      out.names.push_back(name_of_place(*object, k));
    }
  }
  if (out.surfaces.empty())
    return make_error(e_nothing_to_show, "No visible object of the file has a shape to show.",
                      "Make an object visible, or add one.");
  return out;
}

/// Box of the surfaces' corners, over which planes are spread.
Box3 box_of_corners(const std::vector<DrawnSurface>& surfaces) {
  Box3 box;
  for (const DrawnSurface& drawn : surfaces) {
    const GridPattern pattern{drawn.surface.domain(), 1};
    std::vector<Vector3> positions(std::size_t(pattern.point_count())), normals(positions.size());
    for (Index patch = 0; patch < drawn.surface.patch_count(); ++patch) {
      drawn.surface.patches().evaluate_grid(std::span(&patch, 1), pattern, positions, normals);
      for (const Vector3& p : positions) box.extend(drawn.transform * (drawn.surface.origin() + p));
    }
  }
  return box;
}

SectionPlanes planes_of(const SectionsArguments& arguments, const Box3& box) {
  SectionPlanes out;
  out.direction = arguments.direction.stableNormalized();
  out.count = arguments.count;
  if (!box.isEmpty()) out = spread_planes(arguments.direction, arguments.count, box);
  if (arguments.spacing) {
    // Without a first one the set stays in the middle.
    out.first += 0.5 * (out.spacing - *arguments.spacing) * (out.count - 1);
    out.spacing = *arguments.spacing;
  }
  if (arguments.first) out.first = *arguments.first;
  return out;
}

double length_of_section(const SectionCurve& curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    length += (curve.points[i] - curve.points[i - 1]).norm();
  return length;
}

double greatest_tooth(const SectionCurve& curve) {
  double greatest = 0;
  for (const Vector3& tooth : curve.teeth) greatest = std::max(greatest, tooth.norm());
  return greatest;
}

std::string sections_json(const SectionSet& set, const std::vector<std::string>& names) {
  JsonWriter json(2);
  json.object([&] {
    json.member("direction", set.planes.direction);
    json.list("curves", set.curves, [&](const SectionCurve& curve) {
      json.object([&] {
        json.member("object", names[curve.surface]);
        json.member("plane", curve.plane + 1);
        json.member("offset", set.planes.offset(curve.plane));
        json.member("closed", curve.closed);
        json.member("length", length_of_section(curve));
        json.member("greatest_curvature", greatest_tooth(curve));
      });
    });
  });
  return json.take() + "\n";
}

std::string sections_text(const SectionSet& set, const std::vector<std::string>& names) {
  std::string out;
  for (const SectionCurve& curve : set.curves) {
    out += "plane " + std::to_string(curve.plane + 1) + " at ";
    append_real(out, set.planes.offset(curve.plane));
    out += ", " + names[curve.surface] + ": " + (curve.closed ? "closed" : "open") + ", length ";
    append_real(out, length_of_section(curve));
    out += ", greatest curvature ";
    append_real(out, greatest_tooth(curve));
    out += '\n';
  }
  return out;
}

}  // namespace

int run_sections(const SectionsArguments& arguments) {
  const auto read = read_document_or_report(arguments.file, arguments.construction);
  if (!read) return exit_failed;
  const auto document = with_only(*read, arguments.only);
  if (!document.ok()) return failure(arguments.file, document.error());
  const auto objects = cut_objects(*document);
  if (!objects.ok()) return failure(arguments.file, objects.error());
  const auto set = section_set(objects->surfaces, planes_of(arguments, box_of_corners(objects->surfaces)));
  if (!set.ok()) return failure(arguments.file, set.error());
  const double millimetres = millimetres_per(document->unit);
  const std::string bytes = lower_ending(arguments.out) == ".dxf"
                                ? write_sections_dxf(*set, arguments.combs, millimetres)
                                : write_sections_svg(*set, arguments.combs, millimetres);
  if (const auto written = write_file_atomic(arguments.out, bytes); !written.ok())
    return failure(arguments.out, written.error());
  const std::string text =
      arguments.json ? sections_json(*set, objects->names) : sections_text(*set, objects->names);
  return print(text) ? exit_fine : exit_failed;
}

}  // namespace hariko
