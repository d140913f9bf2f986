#include "app/commands/evaluation.hpp"

#include <cmath>
#include <map>

#include "app/commands/ring_residual.hpp"
#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/document/words.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/patching/fair/fair_elements.hpp"
#include "core/patching/quartic/quartic_patch.hpp"

namespace hariko {

namespace {

constexpr std::array<std::array<double, 3>, 5> barycentric_samples{
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.6, 0.3, 0.1}, {0.1, 0.2, 0.7}}};

void write_tangents(JsonWriter& json, const Polyhedron& polyhedron, const Network& network) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto name = [&](Index a, Index b) {
    return std::to_string(polyhedron.vertex_id(a).value) + "-" +
           std::to_string(polyhedron.vertex_id(b).value);
  };
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index a = mesh.origin(h), b = mesh.target(h);
    json.member(name(a, b), network.start[h]);
    if (mesh.twin(h) == no_index) json.member(name(b, a), network.end[h]);
  }
}

/// Tangent of a cubic from its quartic form: degree elevation gives D310 = (V0 + 3 V1) / 4.
Vector3 tangent_from(const Vector3& end, const Vector3& beside) {
  return 4.0 / 3 * (beside - end);
}

/// Writes a face. Control points are those of extended quartics; mode G2 has none and gives only the centre
/// points.
void write_face(JsonWriter& json, Index f, const Polyhedron& polyhedron, const Surface& surface,
                const QuarticPatchSet* quartics) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<std::uint32_t> vertices;
  std::vector<Vector3> at_centre, at_vertex;
  for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
    vertices.push_back(polyhedron.vertex_id(mesh.origin(h)).value);
    if (!quartics) continue;
    const auto& d = quartics->patch(h).control;
    at_centre.push_back(tangent_from(d[quartic::d400], d[quartic::d310]));
    at_vertex.push_back(tangent_from(d[quartic::d040], d[quartic::d130]));
  }
  const PatchPoint centre = surface.patches().evaluate(mesh.face_begin(f), Vector2(0, 0), Order::first);
  json.object([&] {
    json.member("vertices", vertices);
    json.member("O", Vector3(surface.origin() + centre.position));
    if (!quartics) return;
    json.member("Y", at_centre);
    json.member("split_tangents", at_vertex);
  });
}

void write_patch(JsonWriter& json, Index h, const HalfEdgeMesh& mesh, const Surface& surface,
                 const QuarticPatchSet* quartics) {
  const Vector3& origin = surface.origin();
  json.object([&] {
    json.member("face", mesh.face(h));
    json.member("side", h - mesh.face_begin(mesh.face(h)));
    if (quartics)
      json.list("D", quartics->patch(h).control, [&](const Vector3& d) { json.value(Vector3(origin + d)); });
    json.list("points", barycentric_samples, [&](const auto& uvw) {
      const PatchPoint at = surface.patches().evaluate(h, Vector2(uvw[1], uvw[2]), Order::first);
      json.value(Vector3(origin + at.position));
    });
    json.list("normals", barycentric_samples,
              [&](const auto& uvw) { json.value(Vector3(surface.normal(h, Vector2(uvw[1], uvw[2])))); });
  });
}

/// Thin-plate energy in the regular charts of mode FAIR: sum of D^T K_n D over the patches.
double plate_energy(const HalfEdgeMesh& mesh, const QuarticPatchSet& patches) {
  std::map<Index, ControlMatrix> plate;
  double sum = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index sides = mesh.side_count(mesh.face(h));
    auto found = plate.find(sides);
    if (found == plate.end()) found = plate.emplace(sides, patch_energy(sides).plate).first;
    Eigen::Matrix<double, quartic_control_count, 3> d;
    for (std::size_t k = 0; k < quartic_control_count; ++k)
      d.row(static_cast<Eigen::Index>(k)) = patches.patch(h).control[k].transpose();
    sum += (d.transpose() * found->second * d).trace();
  }
  return sum;
}

void write_metrics(JsonWriter& json, const HalfEdgeMesh& mesh, const Surface& surface,
                   const QuarticPatchSet* quartics) {
  const Measures measures = measure(surface);
  const ContinuityReport report = continuity(surface);
  struct Sum {
    double jump = 0, count = 0;
    double root() const { return count > 0 ? std::sqrt(jump / count) : 0; }
  } poly, split;
  double curvature = 0, largest = 0;
  for (std::size_t i = 0; i < report.seams.size(); ++i) {
    if (surface.seams()[i].intended == Continuity::g0) continue;
    const SeamContinuity& seam = report.seams[i];
    Sum& sum = surface.seams()[i].source.kind == Element::Kind::edge ? poly : split;
    sum.jump += seam.curvature_samples * seam.curvature_jump * seam.curvature_jump;
    sum.count += seam.curvature_samples;
    curvature += seam.curvature_samples * seam.curvature * seam.curvature;
    largest = std::max(largest, seam.largest_curvature_jump);
  }
  const double count = poly.count + split.count;
  const double norm = curvature > 0 ? std::sqrt(curvature / count) : 1;
  json.member("area", measures.area);
  json.member("bend", measures.bending);
  if (quartics) json.member("tp", plate_energy(mesh, *quartics));
  json.member("g1", report.largest_normal_jump.value_or(0.0));
  json.member("gap", report.largest_gap);
  json.member("jump_rms_rel", report.rms_curvature_jump.value_or(0.0));
  json.member("jump_max_rel", largest / norm);
  json.member("jump_poly", poly.root() / norm);
  json.member("jump_split", split.root() / norm);
}

}  // namespace

Result<std::string> evaluation_json(const PolyhedronSource& half) {
  const auto whole = baked(half);
  if (!whole) return whole.error();
  const auto input = surface_input(*whole);
  if (!input) return input.error();
  // Reports the polyhedron after preparation, which the surface is made from.
  PolyhedronSource source = *whole;
  source.polyhedron = input->polyhedron;
  source.shaping = input->shaping;
  const auto built = PolyhedronSurfacer().rebuild(*input);
  if (!built.ok()) return built.error();
  const Surface& surface = built->surface;
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  const auto* patches = dynamic_cast<const QuarticPatchSet*>(&surface.patches());
  HARIKO_ASSERT((patches || source.mode == Mode::g2) && built->network,
                "a polyhedron's surface is made of quartic patches over a network");

  long used = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) used += mesh.outgoing(v) != no_index ? 1 : 0;
  const FairWeights weights = fair_weights(source.mode == Mode::fair ? source.frames : Frames::equal);
  JsonWriter json(1);
  json.object([&] {
    json.member("mode", enum_word(source.mode));
    json.member("mu", weights.curvature_jump);
    json.member("lam", weights.pair_distance);
    json.member("kappa", weights.tension);
    json.member("euler", used - long(mesh.edge_count()) + long(mesh.face_count()));
    json.member("energy", built->network->energy);
    json.member("control_names", quartic::control_names);
    json.object("tangents", [&] { write_tangents(json, source.polyhedron, *built->network); });
    json.array("faces", [&] {
      for (Index f = 0; f < mesh.face_count(); ++f) write_face(json, f, source.polyhedron, surface, patches);
    });
    json.array("patches", [&] {
      for (Index h = 0; h < mesh.half_edge_count(); ++h) write_patch(json, h, mesh, surface, patches);
    });
    json.member("sample_uvw", barycentric_samples);
    json.object("metrics", [&] { write_metrics(json, mesh, surface, patches); });
    if (source.mode == Mode::paper || source.mode == Mode::target)
      json.member("dif_max", largest_ring_residual(source, *patches));
  });
  return json.take() + "\n";
}

}  // namespace hariko
