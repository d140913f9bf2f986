#include "app/commands/evaluation.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/commands/ring_residual.hpp"
#include "app/commands/vector_json.hpp"
#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/modeling/surface_input.hpp"
#include "core/patching/fair_elements.hpp"
#include "core/patching/quartic_patch.hpp"

namespace hariko {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::array<double, 3>, 5> samples{
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.6, 0.3, 0.1}, {0.1, 0.2, 0.7}}};

const char* mode_name(Mode mode) {
  return mode == Mode::paper ? "paper" : mode == Mode::target ? "target" : mode == Mode::g2 ? "g2" : "fair";
}

Json tangents_json(const Polyhedron& polyhedron, const Network& network) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  Json out = Json::object();
  const auto name = [&](Index a, Index b) {
    return std::to_string(polyhedron.vertex_id(a).value) + "-" +
           std::to_string(polyhedron.vertex_id(b).value);
  };
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index a = mesh.origin(h), b = mesh.target(h);
    out[name(a, b)] = vector_json(network.start[h]);
    if (mesh.twin(h) == no_index) out[name(b, a)] = vector_json(network.end[h]);
  }
  return out;
}

/// Degree elevation gives D310 = (V0 + 3 V1) / 4 from the cubic's points, so the tangents can be read off.
Vector3 tangent_from(const Vector3& end, const Vector3& beside) {
  return 4.0 / 3 * (beside - end);
}

/// Control points are those of extended quartics: mode G2 has none, and says the points at the centres only.
Json faces_json(const Polyhedron& polyhedron, const Surface& surface, const QuarticPatchSet* quartics) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  Json out = Json::array();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Json vertices = Json::array(), at_centre = Json::array(), at_vertex = Json::array();
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      vertices.push_back(polyhedron.vertex_id(mesh.origin(h)).value);
      if (!quartics) continue;
      const auto& d = quartics->patch(h).control;
      at_centre.push_back(vector_json(tangent_from(d[quartic::d400], d[quartic::d310])));
      at_vertex.push_back(vector_json(tangent_from(d[quartic::d040], d[quartic::d130])));
    }
    const Vector3 centre =
        surface.origin() +
        surface.patches().evaluate(mesh.face_begin(f), Vector2(0, 0), Order::first).position;
    Json face = {{"vertices", vertices}, {"O", vector_json(centre)}};
    if (quartics) {
      face["Y"] = at_centre;
      face["split_tangents"] = at_vertex;
    }
    out.push_back(face);
  }
  return out;
}

Json patches_json(const HalfEdgeMesh& mesh, const Surface& surface, const QuarticPatchSet* quartics) {
  Json out = Json::array();
  const Vector3& origin = surface.origin();
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    Json control = Json::array(), points = Json::array(), normals = Json::array();
    if (quartics)
      for (const Vector3& d : quartics->patch(h).control) control.push_back(vector_json(origin + d));
    for (const auto& uvw : samples) {
      const Vector2 parameter(uvw[1], uvw[2]);
      points.push_back(vector_json(origin + surface.patches().evaluate(h, parameter, Order::first).position));
      normals.push_back(vector_json(surface.normal(h, parameter)));
    }
    Json patch = {{"face", mesh.face(h)}, {"side", h - mesh.face_begin(mesh.face(h))}};
    if (quartics) patch["D"] = control;
    patch["points"] = points;
    patch["normals"] = normals;
    out.push_back(patch);
  }
  return out;
}

/// Sum of D^T K_n D over the patches: thin-plate energy in the regular charts of mode FAIR.
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

Json metrics_json(const HalfEdgeMesh& mesh, const Surface& surface, const QuarticPatchSet* quartics) {
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
  Json out = {{"area", measures.area}, {"bend", measures.bending}};
  if (quartics) out["tp"] = plate_energy(mesh, *quartics);
  out["g1"] = report.largest_normal_jump.value_or(0.0);
  out["gap"] = report.largest_gap;
  out["jump_rms_rel"] = report.rms_curvature_jump.value_or(0.0);
  out["jump_max_rel"] = largest / norm;
  out["jump_poly"] = poly.root() / norm;
  out["jump_split"] = split.root() / norm;
  return out;
}

}  // namespace

Result<std::string> evaluation_json(const PolyhedronSource& half) {
  const auto whole = baked(half);
  if (!whole) return whole.error();
  const PolyhedronSource& source = *whole;
  const auto built = PolyhedronSurfacer().rebuild(surface_input(source).value());
  if (!built.ok()) return built.error();
  const Surface& surface = built->surface;
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  const auto* patches = dynamic_cast<const QuarticPatchSet*>(&surface.patches());
  HARIKO_ASSERT((patches || source.mode == Mode::g2) && built->network,
                "a polyhedron's surface is made of quartic patches over a network");

  long used = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) used += mesh.outgoing(v) != no_index ? 1 : 0;
  const FairWeights weights;
  Json names = Json::array(), uvw = Json::array();
  for (const char* name : quartic::control_names) names.push_back(name);
  for (const auto& sample : samples) uvw.push_back(sample);
  Json out = {{"mode", mode_name(source.mode)},
              {"mu", weights.curvature_jump},
              {"lam", weights.pair_distance},
              {"kappa", weights.tension},
              {"euler", used - long(mesh.edge_count()) + long(mesh.face_count())},
              {"energy", built->network->energy},
              {"control_names", names},
              {"tangents", tangents_json(source.polyhedron, *built->network)},
              {"faces", faces_json(source.polyhedron, surface, patches)},
              {"patches", patches_json(mesh, surface, patches)},
              {"sample_uvw", uvw},
              {"metrics", metrics_json(mesh, surface, patches)}};
  if (source.mode == Mode::g2) out["round"] = built->report.round;
  if (source.mode == Mode::paper || source.mode == Mode::target)
    out["dif_max"] = largest_ring_residual(source, *patches);
  return out.dump(1) + "\n";
}

}  // namespace hariko
