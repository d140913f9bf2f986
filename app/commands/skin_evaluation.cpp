#include "app/commands/evaluation.hpp"

#include "core/base/text/json_writer.hpp"
#include "core/skinning/local_skin.hpp"
#include "core/subdivision/mesh_report.hpp"

namespace hariko {

namespace {

void write_figures(JsonWriter& json, const SkinMesh& mesh) {
  const ControlMeshFigures got = figures(mesh.control.mesh);
  json.member("vertices", got.vertices);
  json.member("faces", got.faces);
  json.member("edges", got.edges);
  json.member("quads", got.quads);
  json.member("tris", got.triangles);
  json.member("ngons", got.polygons);
  json.object("extraordinary", [&] {
    for (const auto& [kind, count] : got.extraordinary) json.member(kind, count);
  });
  json.member("boundary_vertices", got.boundary_vertices);
  json.member("nonmanifold_edges", got.nonmanifold_edges);
  json.member("euler", got.euler);
  json.member("crease_edges", mesh.control.creases.size());
  json.member("corner_vertices", mesh.control.corners.size());
  json.member("regular_faces", regular_face_count(mesh.control));
}

void write(JsonWriter& json, const SectionMiss& miss) {
  json.object([&] {
    json.member("max", miss.largest);
    json.member("rms", miss.root_mean_square);
    json.member("same_parameter_max",
                miss.same_parameter < 0 ? std::nullopt : std::optional(miss.same_parameter));
  });
}

void write_lines(JsonWriter& json, const SkinResult& result) {
  if (result.mesh.rows.empty()) {
    json.member("params", result.mesh.parameters);
    json.member("grid", {result.mesh.grid_rows, result.mesh.grid_columns});
    return;
  }
  json.list("lines", result.plan.strips, [&](const PlannedStrip& strip) {
    json.list(strip.lines, [&](const PointPair& line) { json.value({line.a, line.b}); });
  });
  json.member("rows", result.mesh.rows);
}

void write_control_mesh(JsonWriter& json, const ControlMesh& control, const Vector3& origin) {
  json.list("points", control.mesh.positions,
            [&](const Vector3& point) { json.value(Vector3(origin + point)); });
  json.array("faces", [&] {
    for (std::size_t f = 0; f < control.mesh.face_count(); ++f)
      json.list(control.mesh.face(f), [&](Index v) { json.value(v); });
  });
  json.list("creases", control.creases, [&](const ControlMesh::Crease& crease) {
    json.object([&] {
      json.member("edge", {crease.a, crease.b});
      json.member("sharpness", crease.sharpness);
    });
  });
  json.list("corners", control.corners, [&](const ControlMesh::Corner& corner) {
    json.object([&] {
      json.member("vertex", corner.vertex);
      json.member("sharpness", corner.sharpness);
    });
  });
}

void write_samples(JsonWriter& json, const Surface& surface) {
  const SubdivisionPatchSet& patches = *subdivision_patches(surface);
  for (Index v = 0; v < Index(patches.control_points().size()); ++v) {
    const Index node = patches.topology().vertex_node(v);
    if (node == no_index) continue;
    const Vector3& normal = surface.node_normal(node);
    json.object([&] {
      json.member("vertex", v);
      json.member("control", Vector3(surface.origin() + patches.control_points()[v]));
      json.member("limit", Vector3(surface.origin() + patches.limit_position(v)));
      json.member("normal", normal.isZero(0) ? std::nullopt : std::optional<Vector3>(normal));
    });
  }
}

}  // namespace

Result<std::string> skin_evaluation_json(const Skin& skin) {
  const LocalSkin local = local_skin(skin);
  const auto made = SkinSurfacer().surface(local.skin, local.origin);
  if (!made) return made.error();
  const SkinMesh& mesh = made->result.mesh;
  JsonWriter json(1);
  json.object([&] {
    write_figures(json, mesh);
    json.member("limit_cond", limit_condition(subdivision_patches(made->surface)->topology()));
    json.list("section_error", section_misses(local.skin, mesh, made->surface),
              [&](const SectionMiss& miss) { write(json, miss); });
    write_lines(json, made->result);
    json.object("control", [&] { write_control_mesh(json, mesh.control, local.origin); });
    json.array("samples", [&] { write_samples(json, made->surface); });
  });
  return json.take() + "\n";
}

}  // namespace hariko
