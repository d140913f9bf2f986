#include "app/commands/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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

/// Side factor of the construction: f_n = 1 / (4 sin^2(pi / n)).
double side_factor(Index sides) {
  const double sine = std::sin(std::numbers::pi / sides);
  return 1 / (4 * sine * sine);
}

/// Sums of y . R and |y|^2 over the edges of one ring; the edges alternate in sign.
class RingSum {
 public:
  /// Adds an edge. `left` and `right`: inner points beside the edge; a_left + a_right = 1; `x_left` and
  /// `x_right`: side factors of the patches' faces.
  void add(const Vector3& centre, const Vector3& left, double a_left, const Vector3& right, double x_left,
           double x_right) {
    const double y = sign_ * (1 / x_left + 1 / x_right);
    sum_ += y * (a_left * (left - centre) + (1 - a_left) * (right - centre));
    square_ += y * y;
    sign_ = -sign_;
  }
  double residual() const { return square_ > 0 ? sum_.norm() / std::sqrt(square_) : 0; }

 private:
  Vector3 sum_ = Vector3::Zero();
  double square_ = 0, sign_ = 1;
};

double centre_residual(const HalfEdgeMesh& mesh, const QuarticPatchSet& patches, Index f) {
  if (mesh.side_count(f) % 2 != 0) return 0;
  RingSum sum;
  for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
    const auto& left = patches.patch(h).control;
    const auto& right = patches.patch(mesh.previous(h)).control;
    sum.add(left[quartic::d400], left[quartic::d211w], 0.5, right[quartic::d211v], 1, 1);
  }
  return sum.residual();
}

double vertex_residual(const HalfEdgeMesh& mesh, const QuarticPatchSet& patches, Index v) {
  RingSum sum;
  for (const Index h : mesh.fan_corners(v)) {
    const auto& after = patches.patch(h).control;
    const auto& before = patches.patch(mesh.twin(h)).control;
    const auto& next = patches.patch(mesh.previous(h)).control;
    const Vector3 centre = after[quartic::d040];
    const double left = side_factor(mesh.side_count(mesh.face(h)));
    const double right = side_factor(mesh.side_count(mesh.face(mesh.twin(h))));
    sum.add(centre, after[quartic::d121u], right / (left + right), before[quartic::d112u], left, right);
    sum.add(centre, next[quartic::d112v], 0.5, after[quartic::d121w], left, left);
  }
  return sum.residual();
}

/// Largest |y . R| / |y| over all even rings: those round split points of faces with an even number of sides
/// and round inner vertices without creases. y is the left null vector of the ring's conditions, R their
/// right-hand sides relative to the ring's centre. Zero means that ordinary quartics would suffice. `patches`
/// are those of `source`, one for each half-edge. O(half-edges).
double largest_ring_residual(const PolyhedronSource& source, const QuarticPatchSet& patches) {
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  std::vector<char> open(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.outgoing(v) == no_index || mesh.is_border_vertex(v)) open[v] = 1;
  for (const auto& [id, sharp] : source.shaping->crease)
    for (const VertexId end : {id.low, id.high})
      if (const Index v = source.polyhedron.find(end); v != no_index) open[v] = 1;

  double largest = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    largest = std::max(largest, centre_residual(mesh, patches, f));
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!open[v]) largest = std::max(largest, vertex_residual(mesh, patches, v));
  return largest;
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
