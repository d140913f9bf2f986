#include "app/commands/skin_evaluation.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/vector_json.hpp"
#include "core/skinning/mesh_report.hpp"
#include "core/skinning/regular_faces.hpp"

namespace hariko {

namespace {

using Json = nlohmann::ordered_json;

Json figures_json(const SkinMesh& mesh) {
  const ControlMeshFigures got = figures(mesh.control.mesh);
  Json extraordinary = Json::object();
  for (const auto& [kind, count] : got.extraordinary) extraordinary[kind] = count;
  return {{"vertices", got.vertices},
          {"faces", got.faces},
          {"edges", got.edges},
          {"quads", got.quads},
          {"tris", got.triangles},
          {"ngons", got.polygons},
          {"extraordinary", extraordinary},
          {"boundary_vertices", got.boundary_vertices},
          {"nonmanifold_edges", got.nonmanifold_edges},
          {"euler", got.euler},
          {"crease_edges", mesh.control.creases.size()},
          {"corner_vertices", mesh.control.corners.size()},
          {"regular_faces", regular_faces(mesh.control).size()}};
}

void add_control_mesh(const ControlMesh& control, Json& out) {
  Json points = Json::array(), faces = Json::array(), creases = Json::array(), corners = Json::array();
  for (const Vector3& p : control.mesh.positions) points.push_back(vector_json(p));
  for (std::size_t f = 0; f < control.mesh.face_count(); ++f) {
    Json face = Json::array();
    for (const Index v : control.mesh.face(f)) face.push_back(v);
    faces.push_back(face);
  }
  for (const ControlMesh::Crease& crease : control.creases)
    creases.push_back({{"edge", {crease.a, crease.b}}, {"sharpness", crease.sharpness}});
  for (const ControlMesh::Corner& corner : control.corners)
    corners.push_back({{"vertex", corner.vertex}, {"sharpness", corner.sharpness}});
  out["control"] = {{"points", points}, {"faces", faces}, {"creases", creases}, {"corners", corners}};
}

void add_lines(const SkinResult& result, Json& out) {
  if (result.mesh.rows.empty()) {
    out["params"] = result.mesh.parameters;
    out["grid"] = {result.mesh.grid_rows, result.mesh.grid_columns};
    return;
  }
  Json lines = Json::array();
  for (const PlannedStrip& strip : result.plan.strips) {
    Json pairs = Json::array();
    for (const PointPair& line : strip.lines) pairs.push_back({line.a, line.b});
    lines.push_back(pairs);
  }
  out["lines"] = lines;
  out["rows"] = result.mesh.rows;
}

Json samples_json(const Surface& surface) {
  const SubdivisionPatchSet& patches = *subdivision_patches(surface);
  Json out = Json::array();
  for (Index v = 0; v < Index(patches.control_points().size()); ++v) {
    const Index node = patches.topology().vertex_node(v);
    if (node == no_index) continue;
    const Vector3& normal = surface.node_normal(node);
    out.push_back({{"vertex", v},
                   {"control", vector_json(patches.control_points()[v])},
                   {"limit", vector_json(patches.limit_position(v))},
                   {"normal", normal.isZero(0) ? Json(nullptr) : vector_json(normal)}});
  }
  return out;
}

}  // namespace

Result<std::string> skin_evaluation_json(const Skin& skin) {
  const auto made = SkinSurfacer().surface(skin, Vector3::Zero());
  if (!made) return made.error();
  const SkinMesh& mesh = made->result.mesh;
  Json out = figures_json(mesh);
  const double condition = limit_condition(subdivision_patches(made->surface)->topology());
  out["limit_cond"] = std::isfinite(condition) ? Json(condition) : Json(nullptr);
  out["section_error"] = Json::array();
  for (const SectionMiss& miss : section_misses(skin, mesh, made->surface))
    out["section_error"].push_back(
        {{"max", miss.largest},
         {"rms", miss.root_mean_square},
         {"same_parameter_max", miss.same_parameter < 0 ? Json(nullptr) : Json(miss.same_parameter)}});
  add_lines(made->result, out);
  add_control_mesh(mesh.control, out);
  out["samples"] = samples_json(made->surface);
  return out.dump(1) + "\n";
}

}  // namespace hariko
