#include "app/commands/object_info.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <variant>

#include "app/commands/console.hpp"
#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/group_tree.hpp"
#include "core/document/object_shape.hpp"
#include "core/document/words.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/subdivision/mesh_report.hpp"

namespace hariko {

namespace {

void count_topology(const HalfEdgeMesh& mesh, ObjectInfo& info) {
  info.vertices = mesh.vertex_count();
  info.edges = mesh.edge_count();
  info.faces = mesh.face_count();
  const auto of_face = mesh.face_components();
  const std::size_t components = of_face.empty() ? 0 : *std::max_element(of_face.begin(), of_face.end()) + 1;
  info.components = components;
  info.boundary_loops = mesh.border_loop_count();
  long used = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) used += mesh.outgoing(v) != no_index ? 1 : 0;
  // Euler characteristic: V - E + F = 2 components - 2 genus - loops, summed over the components.
  const long euler = used - long(mesh.edge_count()) + long(mesh.face_count());
  info.genus = static_cast<std::size_t>((2 * long(components) - long(*info.boundary_loops) - euler) / 2);
}

/// Replaces the dense indices that validation reports by stable ids.
Element named(const Polyhedron& polyhedron, const Element& element) {
  const auto vertex = [&](std::uint64_t v) { return polyhedron.vertex_id(static_cast<Index>(v)); };
  switch (element.kind) {
    case Element::Kind::vertex:
      return element.id < polyhedron.vertex_count() ? element_of(vertex(element.id)) : element;
    case Element::Kind::face:
      return element.id < polyhedron.face_count()
                 ? element_of(polyhedron.face_id(static_cast<Index>(element.id)))
                 : element;
    case Element::Kind::edge: {
      const EdgeId dense = EdgeId::from_packed(element.id);
      if (dense.high.value >= polyhedron.vertex_count()) return element;
      return element_of(EdgeId::of(vertex(dense.low.value), vertex(dense.high.value)));
    }
    default:
      return element;
  }
}

std::optional<SurfaceComparison> compare(const Surface& surface, const Object& object,
                                         const Document& against) {
  const Object* other = against.find(object.id);
  if (!other || !other->has_surface()) return std::nullopt;
  const auto built = object_surface(against, *other);
  if (!built.ok()) return std::nullopt;
  return compare_surfaces(surface, built->surface);
}

EnvelopeInfo envelope_info(const EnvelopeSurface& made, const EnvelopeInput& input, double scale) {
  EnvelopeInfo out;
  out.solids = input.solids.size();
  out.symmetry = enum_word(input.settings.symmetry);
  out.images = images_of(input).size();
  out.symmetric = made.symmetric;
  out.method = made.network ? "network" : "ball";
  out.enclosed = made.enclosed;
  if (made.sticks_out) out.sticks_out = scale * *made.sticks_out;
  out.folds = made.folds;
  out.coarse = made.coarse;
  out.rounds = made.rounds;
  if (made.check) {
    out.worst = made.check->worst / made.diagonal;
    out.tested = made.check->tested;
    out.outside = made.check->outside;
    out.crossing = made.check->covered;
  }
  return out;
}

/// Adds the figures of a surface round solids, and of its network.
void add_envelope(const EnvelopeSurface& made, const EnvelopeInput& input, double scale, ObjectInfo& info) {
  info.envelope = envelope_info(made, input, scale);
  if (!made.network) return;
  info.vertices = made.network->cage.vertices.size();
  info.edges = made.network->curves.size();
  info.faces = made.network->cage.faces.size();
  info.components = 1;
  info.genus = 0;
}

SkinInfo skin_info(const SubdivisionPatchSet& patches, const Surface& surface, double scale) {
  const Skin& skin = patches.skin()->skin;
  const SkinMesh& mesh = patches.skin()->mesh;
  SkinInfo out;
  out.sections = skin.sections.size();
  out.method = enum_word(skin.method);
  out.columns = std::size_t(mesh.grid_columns);
  out.rows = std::size_t(mesh.grid_rows);
  // The border rows of a section belong to both its strips.
  for (const auto& rows : mesh.rows) out.rows += rows.size() - 1;
  if (!mesh.rows.empty() && !skin.path.closed) ++out.rows;
  out.extraordinary = figures(mesh.control.mesh).extraordinary;
  out.creases = mesh.control.creases.size();
  out.regular_faces = regular_face_count(mesh.control);
  const double condition = limit_condition(patches.topology());
  if (std::isfinite(condition)) out.condition = condition;
  for (const SectionMiss& miss : section_misses(skin, mesh, surface))
    out.section_miss.push_back(miss.largest * scale);
  return out;
}

/// Adds the figures of a skin and of its control mesh, where the surface is one.
void add_skin(const Surface& surface, double scale, ObjectInfo& info) {
  const SubdivisionPatchSet* patches = subdivision_patches(surface);
  if (!patches || !patches->skin()) return;
  info.skin = skin_info(*patches, surface, scale);
  if (const auto topology = HalfEdgeMesh::build(patches->skin()->mesh.control.mesh); topology.ok())
    count_topology(*topology, info);
}

// Sources of which nothing is said beside their surfaces.
void inspect_source(const MeshSource&, double, ObjectInfo&) {}
void inspect_source(const PatchSource&, double, ObjectInfo&) {}
void inspect_source(const BezierSource&, double, ObjectInfo&) {}
void inspect_source(const SolidsSource&, double, ObjectInfo&) {}
void inspect_source(const SkinSource&, double, ObjectInfo&) {}
void inspect_source(const PictureSource&, double, ObjectInfo&) {}
void inspect_source(const UnknownSource&, double, ObjectInfo&) {}

void inspect_source(const PolyhedronSource& source, double, ObjectInfo& info) {
  for (Message message : validate(source.polyhedron.to_mesh())) {
    message.element = named(source.polyhedron, message.element);
    info.messages.push_back(std::move(message));
  }
}

/// Adds the figures of an outline's control points; its errors are reported with its surface.
void inspect_source(const OutlineSource& source, double scale, ObjectInfo& info) {
  const auto points = control_points(*source.outline, gauss_options(source.settings));
  if (!points) return;
  OutlineInfo out;
  out.method = enum_word(source.settings.mode);
  out.loops = source.outline->loops.size();
  out.points = points->boundary_count;
  out.inserted = points->points.size() - points->boundary_count;
  out.gap = points->gap * scale;
  info.outline = out;
  if (const auto made = outline_polyhedron(*points)) count_topology(made->polyhedron.topology(), info);
}

void inspect_surface(const Document& document, const Object& object, const Document* against,
                     ObjectInfo& info) {
  const double scale = object.transform.scale;
  Stopwatch watch;
  const auto lap = [&](const char* step) { info.milliseconds.emplace_back(step, watch.lap()); };
  std::visit([&](const auto& source) { inspect_source(source, scale, info); }, object.source);
  lap("validate");

  const auto built = object_surface(document, object);
  lap("rebuild");
  if (!built.ok()) return info.messages.push_back(built.error());
  if (const auto* made = std::get_if<std::shared_ptr<const EnvelopeSurface>>(&built->details))
    add_envelope(**made, *object.solids()->input, scale, info);
  add_skin(built->surface, scale, info);
  info.messages.insert(info.messages.end(), built->warnings.begin(), built->warnings.end());
  const Surface& surface = built->surface;
  info.patches = surface.patch_count();
  if (against) {
    info.against = compare(surface, object, *against);
    lap("against");
  }

  const Measures measures = measure(surface);
  lap("measures");
  info.area = measures.area * scale * scale;
  if (measures.volume) info.volume = *measures.volume * scale * scale * scale;
  info.bending = measures.bending;

  const ContinuityReport report = continuity(surface);
  lap("continuity");
  info.largest_gap = report.largest_gap * scale;
  info.largest_normal_jump = report.largest_normal_jump;
  info.rms_curvature_jump = report.rms_curvature_jump;
  info.degenerate_samples = report.degenerate_samples;
  info.folded_samples = report.folded_samples;

  const auto statistics = curvature_statistics(surface);
  lap("statistics");
  if (statistics) {
    const double square = scale * scale;
    info.gauss_range = {statistics->gauss.least / square, statistics->gauss.greatest / square};
    info.mean_range = {statistics->mean.least / scale, statistics->mean.greatest / scale};
  }
}

/// Adds the figures of facets; faces are triangulated round the mean of their corners.
void inspect_facets(const PolygonMesh& mesh, double scale, ObjectInfo& info) {
  Stopwatch watch;
  info.vertices = mesh.positions.size();
  info.faces = mesh.face_count();
  double area = 0, volume = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vector3 centre = Vector3::Zero();
    for (const Index v : face) centre += mesh.positions[v] / double(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vector3 a = mesh.positions[face[k]], b = mesh.positions[face[(k + 1) % face.size()]];
      const Vector3 cross = (a - centre).cross(b - centre);
      area += cross.norm() / 2;
      volume += centre.dot(cross) / 6;
    }
  }
  info.area = area * scale * scale;
  const auto topology = HalfEdgeMesh::build(mesh);
  if (topology.ok()) {
    count_topology(*topology, info);
    if (*info.boundary_loops == 0) info.volume = volume * scale * scale * scale;
  }
  info.milliseconds.emplace_back("measures", watch.lap());
}

/// Lets the totals be those of all places of an object.
void count_places(std::size_t places, ObjectInfo& info) {
  info.places = places;
  for (std::optional<double>* total : {&info.area, &info.volume, &info.bending})
    if (*total) **total *= static_cast<double>(places);
}

}  // namespace

bool ObjectInfo::failed() const {
  return std::ranges::any_of(messages,
                             [](const Message& message) { return message.severity == Severity::error; });
}

ObjectInfo inspect_at_once(const Object& object) {
  ObjectInfo info;
  info.name = object.name;
  info.kind = kind_of(object.source);
  if (const Polyhedron* cage = object.cage()) count_topology(cage->topology(), info);
  return info;
}

ObjectInfo inspect(const Document& document, const Object& object, const Document* against) {
  ObjectInfo info = inspect_at_once(object);
  if (against) info.against.emplace();
  const double scale = object.transform.scale;
  if (object.has_surface()) {
    inspect_surface(document, object, against, info);
  } else if (is_faceted(object)) {
    inspect_facets(*object.mesh()->mesh, scale, info);
  }
  if (!object.copies->empty()) count_places(place_count(object), info);
  return info;
}

ObjectInfo inspect_broken(const OpenedFile& input) {
  ObjectInfo info;
  info.name = input.name;
  info.kind = "polyhedron";
  info.vertices = input.broken_mesh->positions.size();
  info.faces = input.broken_mesh->face_count();
  return info;
}

std::vector<GroupInfo> inspect_groups(const Document& document) {
  std::vector<GroupInfo> out;
  if (document.groups->empty()) return out;
  const GroupTree tree(document);
  std::map<ObjectId, const Object*> objects;
  for (const auto& object : document.objects) objects.emplace(object->id, object.get());
  for (const Group& group : *document.groups) {
    GroupInfo& info = out.emplace_back();
    info.id = group.id.value;
    info.name = group.name;
    if (group.parent != GroupId{}) info.parent = group.parent.value;
    info.visible = is_visible(document, group.id);
    info.locked = is_locked(document, group.id);
    for (const ObjectId id : tree.objects_in(group.id)) info.objects.push_back(objects.at(id)->name);
  }
  return out;
}

std::string groups_text(const std::vector<GroupInfo>& groups) {
  if (groups.empty()) return {};
  std::string out = info_line("groups", std::to_string(groups.size()));
  for (const GroupInfo& info : groups) {
    std::string text = sanitized_utf8(info.name);
    if (info.parent) {
      const auto round = std::ranges::find(groups, *info.parent, &GroupInfo::id);
      text += ", in " + sanitized_utf8(round->name);
    }
    text += info.visible ? "" : ", hidden";
    text += info.locked ? ", locked" : "";
    std::string names;
    for (const std::string& name : info.objects) names += (names.empty() ? "" : ", ") + sanitized_utf8(name);
    out += info_line("group", text + "  (" + names + ")");
  }
  return out;
}

}  // namespace hariko
