#include "app/files/model_facets.hpp"

#include <algorithm>
#include <map>

#include "app/files/export_surfaces.hpp"
#include "app/files/left_out.hpp"
#include "app/files/open_file.hpp"
#include "core/approximation/approximate.hpp"
#include "core/document/edits/edit_paper.hpp"
#include "core/document/object_shape.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/repair/clean_part.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/unfolding/facet_graph.hpp"
#include "core/unfolding/join_corners.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_facets = 1'000'000;

Message too_many() {
  return make_error(e_too_many_triangles,
                    "The paper model would have more than " + std::to_string(max_facets) + " facets.",
                    "Choose a larger distance.");
}

/// Appends polygons, moved into the document's space, as further components. Mirror images stay oriented
/// outward.
void append(ModelFacets& out, const PolygonMesh& mesh, const Vector3& origin, const Similarity& transform,
            std::vector<PaperVertex> names) {
  const auto first = static_cast<Index>(out.mesh.positions.size());
  for (const Vector3& position : mesh.positions)
    out.mesh.positions.push_back(transform.apply(origin + position));
  out.names.insert(out.names.end(), names.begin(), names.end());
  std::vector<Index> face;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    face.assign(mesh.face(f).begin(), mesh.face(f).end());
    for (Index& vertex : face) vertex += first;
    if (transform.mirrors()) std::reverse(face.begin() + 1, face.end());
    out.mesh.add_face(face);
  }
}

/// Appends the polygons of an object, which are in its own space, at all its places. At the further ones
/// their vertices have names of their own: numbers go on, parameters are two larger from place to place.
/// Stops behind the place that exceeds the limit of facets.
void append_places(ModelFacets& out, const Object& object, const PolygonMesh& mesh, const Vector3& origin,
                   std::vector<PaperVertex> names) {
  const auto count = static_cast<std::uint32_t>(names.size());
  for (const Similarity& place : places_of(object)) {
    append(out, mesh, origin, place, names);
    if (out.mesh.face_count() > max_facets) return;
    for (PaperVertex& name : names) {
      if (name.element.kind == Element::Kind::none)
        name.side += count;
      else
        name.u += 2;
    }
  }
}

std::vector<PaperVertex> numbered(ObjectId object, std::size_t count) {
  std::vector<PaperVertex> names(count);
  for (std::size_t v = 0; v < count; ++v) names[v] = {object, {}, static_cast<std::uint32_t>(v), 0, 0};
  return names;
}

/// Side number of each patch for `PaperVertex`: patches of the same element and side get different ones.
std::vector<std::uint32_t> patch_sides(const Surface& surface) {
  std::vector<std::uint32_t> out;
  std::map<std::pair<std::uint64_t, std::uint32_t>, std::uint32_t> seen;
  for (const Provenance& from : surface.provenance())
    out.push_back(from.side + (seen[{from.element.id, from.side}]++ << 16));
  return out;
}

/// Names of vertices by their places on the patches; the least one of several.
std::vector<PaperVertex> names_on(const Surface& surface, const MeshApproximation& made, ObjectId object) {
  const std::vector<std::uint32_t> sides = patch_sides(surface);
  std::vector<PaperVertex> out(made.mesh.positions.size());
  std::vector<char> named(out.size(), 0);
  for (const ParameterFacet& part : made.parts)
    for (Index corner = 0; corner < 3; ++corner) {
      const PaperVertex name{object, surface.provenance()[part.patch].element, sides[part.patch],
                             part.parameter[corner].x(), part.parameter[corner].y()};
      const Index vertex = part.vertex[corner];
      if (named[vertex] && !(name < out[vertex])) continue;
      out[vertex] = name;
      named[vertex] = 1;
    }
  return out;
}

/// Appends a reference mesh; in meshes whose faces have separate corners equal corners are joined.
void append_mesh(ModelFacets& out, const Object& object, const MeshSource& source) {
  PolygonMesh mesh = *source.mesh;
  join_equal_corners(mesh);
  append_places(out, object, mesh, source.origin, numbered(object.id, mesh.positions.size()));
}

void append_polyhedron(ModelFacets& out, const Object& object) {
  const Polyhedron& polyhedron = object.polyhedron()->polyhedron;
  PolygonMesh mesh;
  mesh.positions = polyhedron.positions();
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const auto corners = polyhedron.topology().face_vertices(f);
    mesh.add_face(std::vector<Index>(corners.begin(), corners.end()));
  }
  std::vector<PaperVertex> names;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    names.push_back({object.id, element_of(polyhedron.vertex_id(v)), 0, 0, 0});
  append_places(out, object, mesh, object.cage_origin(), std::move(names));
}

Result<Done> append_surface(ModelFacets& out, const Document& document, const Object& object,
                            const FacetOptions& options, double distance, const CancelToken& cancel,
                            const Progress& progress) {
  const auto named = [&](Message error) {
    error.text = object.name + ": " + error.text;
    return error;
  };
  const auto built = object_surface(document, object, cancel);
  if (cancel.cancelled()) return make_error(e_cancelled, "Meshing was cancelled.");
  if (!built.ok()) return named(built.error());
  MeshOptions meshing;
  meshing.criteria.distance = distance / object.transform.scale;
  if (options.normal_angle > 0) meshing.criteria.normal_angle = options.normal_angle;
  meshing.optimise = options.optimise;
  meshing.facet_limit = max_facets;
  meshing.report = MeshReport::none;
  const auto made = approximate(built->surface, meshing, cancel, progress);
  if (!made.ok()) return named(made.error());
  for (const Message& warning : made->warnings) {
    if (warning.code == w_mesh_limit) return too_many();
    out.warnings.push_back(named(warning));
  }
  append_places(out, object, polygons_of(made->mesh), Vector3::Zero(),
                names_on(built->surface, *made, object.id));
  return Done{};
}

/// Turns closed parts outwards; returns the number of faces that were turned.
std::size_t turn_part_outwards(PolygonMesh& mesh) {
  PolygonMesh turned = orient_where_possible(mesh);
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    count += !std::equal(mesh.face(f).begin(), mesh.face(f).end(), turned.face(f).begin());
  if (count > 0) mesh = std::move(turned);
  return count;
}

/// W_INSIDE_OUT about so many faces.
Message print_inside_message(std::size_t faces) {
  return make_warning(w_inside_out,
                      counted(faces, " face belongs to a closed part", " faces belong to closed parts") +
                          " inside out: the print comes to lie inside.",
                      "Turn what is inside out while opening the file (--repair).");
}

/// Repairs parts that cannot be unfolded or are inside out, or warns that they can be repaired.
void repair_parts(std::vector<ImportedPart>& parts, bool repair, std::vector<Message>& warnings) {
  RepairReport done;
  bool faulty = false, helps = true;
  std::size_t inside_out = 0;
  for (ImportedPart& part : parts) {
    if (unfolding_errors(part.mesh, 1).empty()) {
      PolygonMesh turned = part.mesh;
      inside_out += turn_part_outwards(turned);
      if (repair) part.mesh = std::move(turned);
      continue;
    }
    faulty = true;
    auto repaired = make_manifold(part.mesh);
    helps = helps && repaired.ok() && unfolding_errors(repaired->mesh, 1).empty();
    if (!repaired.ok()) continue;
    add_counts(done, repaired->report);
    if (repair) part.mesh = std::move(repaired).value().mesh;
  }
  if (inside_out > 0)
    warnings.push_back(repair ? turned_outwards_message(inside_out) : print_inside_message(inside_out));
  if (!faulty) return;
  if (repair)
    warnings.push_back(repaired_message(done));
  else if (const std::string changes = repair_text(done); helps)
    warnings.push_back(make_warning(
        w_can_be_opened, changes.empty() ? std::string("The mesh can be unfolded: --repair mends it.")
                                         : "The mesh can be unfolded: --repair mends it (" + changes + ")."));
}

/// Facets from the polygons of a mesh file.
ModelFacets polygons_of_file(ImportedScene scene, const Reading& reading) {
  ModelFacets out;
  out.warnings = std::move(scene.warnings);
  CleanReport cleaned;
  for (ImportedPart& part : scene.parts) clean(part, join_choice(reading), cleaned);
  for (Message& message : cleaned.messages()) out.warnings.push_back(std::move(message));
  repair_parts(scene.parts, reading.repair, out.warnings);
  const double factor = scene.metres_per_unit.value_or(0.001) / 0.001;
  out.mesh = merged(std::move(scene)).mesh;
  if (factor != 1)
    for (Vector3& position : out.mesh.positions) position *= factor;
  out.names = numbered(ObjectId{0}, out.mesh.positions.size());
  join_equal_corners(out.mesh);
  return out;
}

}  // namespace

Result<ModelFacets> document_facets(const Document& document, std::span<const ObjectId> objects,
                                    const FacetOptions& options, const CancelToken& cancel,
                                    const Progress& progress) {
  ModelFacets out;
  out.millimetres_per_unit = millimetres_per(document.unit);
  const double distance = options.distance.value_or(proposed_distance(document, objects));
  double done = 0;
  for (const ObjectId id : objects) {
    const Progress part = progress.part(done / double(objects.size()), (done + 1) / double(objects.size()));
    ++done;
    const Object* object = document.find(id);
    if (!object) continue;
    if (is_faceted(*object))
      append_mesh(out, *object, *object->mesh());
    else if (options.of_polyhedra && object->polyhedron())
      append_polyhedron(out, *object);
    else if (object->has_surface())
      if (const auto added = append_surface(out, document, *object, options, distance, cancel, part);
          !added.ok())
        return added.error();
    if (out.mesh.face_count() > max_facets) return too_many();
    if (cancel.cancelled()) return make_error(e_cancelled, "Meshing was cancelled.");
  }
  if (out.mesh.face_count() == 0)
    return make_error(e_no_surface, "There is no visible surface to unfold.",
                      "Show an object or import one.");
  return out;
}

Result<ModelFacets> model_facets(const std::filesystem::path& file, const FacetOptions& options,
                                 const Reading& reading, const CancelToken& cancel,
                                 const Progress& progress) {
  constexpr double opening = 0.3;  // share of the time; meshing takes the rest
  FacetOptions meshing = options;
  if (format_of_extension(file)) {
    auto scene = read_scene_file(file, {.cancel = cancel, .progress = progress.part(0, opening)});
    if (!scene.ok()) return scene.error();
    if (scene->patches.empty()) return polygons_of_file(std::move(scene).value(), reading);
    meshing.of_polyhedra = true;  // polygons beside patches stay unchanged
  }
  OpenedFile opened = open_file(file, cancel, progress.part(0, opening), join_choice(reading));
  if (reading.repair) turn_outwards(opened);
  if (auto warning = inside_out_message(opened)) opened.messages.push_back(*std::move(warning));
  const bool repairs = !opened.document && reading.repair && opened.repaired;
  const auto& document = repairs ? opened.repaired : opened.document;
  if (!document) {
    const Message* error = opened.error();
    return error ? *error : make_error(e_no_surface, "The file holds no document.");
  }
  if (repairs) {
    std::erase_if(opened.messages,
                  [](const Message& message) { return message.severity == Severity::error; });
    opened.messages.push_back(repaired_message(opened.repair));
  }
  auto facets =
      document_facets(*document, unfoldable_objects(*document), meshing, cancel, progress.part(opening, 1));
  for (Message& warning : left_out_of_triangles(*document)) opened.messages.push_back(std::move(warning));
  if (facets.ok())
    facets.value().warnings.insert(facets.value().warnings.begin(), opened.messages.begin(),
                                   opened.messages.end());
  return facets;
}

}  // namespace hariko
