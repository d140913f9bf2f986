#include "core/modeling/selection/select_similar.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/angles.hpp"
#include "core/geometry/polygon.hpp"
#include "core/modeling/selection/element_flags.hpp"

namespace hariko {
namespace {

/// Comparison of numbers: angles by their difference in half turns, others by ratio.
enum class Scale { ratio, angle };

/// Flags of all elements whose value is near that of a marked one.
std::vector<char> near_marked(const std::vector<double>& values, const std::vector<char>& marked,
                              double tolerance, Scale scale) {
  std::vector<double> wanted;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (marked[i]) wanted.push_back(values[i]);
  std::sort(wanted.begin(), wanted.end());
  const auto near = [&](double a, double b) {
    const double unit = scale == Scale::angle ? std::numbers::pi : std::max(std::abs(a), std::abs(b));
    return std::abs(a - b) <= tolerance * unit;
  };
  std::vector<char> out = marked;
  for (std::size_t i = 0; i < values.size(); ++i) {
    // Only the nearest wanted values above and below matter.
    const auto above = std::lower_bound(wanted.begin(), wanted.end(), values[i]);
    if (above != wanted.end() && near(values[i], *above)) out[i] = 1;
    if (above != wanted.begin() && near(values[i], *(above - 1))) out[i] = 1;
  }
  return out;
}

struct Plane {
  Vector3 normal, centre;
};

Plane plane_of(const Polyhedron& polyhedron, Index f) {
  const std::vector<Vector3> corners = polyhedron.corners(f);
  Vector3 centre = Vector3::Zero();
  for (const Vector3& p : corners) centre += p / static_cast<double>(corners.size());
  return {newell_normal(corners).stableNormalized(), centre};
}

double size_of(const Polyhedron& polyhedron) {
  Vector3 low = polyhedron.position(0), high = low;
  for (Index v = 1; v < polyhedron.vertex_count(); ++v) {
    low = low.cwiseMin(polyhedron.position(v));
    high = high.cwiseMax(polyhedron.position(v));
  }
  return (high - low).stableNorm();
}

bool is_sharp(const PolyhedronSource& source, Index e) {
  return source.polyhedron.topology().is_border_edge(e) ||
         source.shaping->crease.contains(source.polyhedron.edge_id(e));
}

double value_of(const PolyhedronSource& source, Index e, EdgeLikeness likeness) {
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Index h = mesh.half_edge_of_edge(e);
  switch (likeness) {
    case EdgeLikeness::length:
      return (polyhedron.position(mesh.target(h)) - polyhedron.position(mesh.origin(h))).stableNorm();
    case EdgeLikeness::tension:
      return source.shaping->beta.get_or(polyhedron.edge_id(e), 1);
    case EdgeLikeness::crease:
      return source.shaping->crease.contains(polyhedron.edge_id(e));
    case EdgeLikeness::fold:
      // A border edge has no fold; 100 is farther than the tolerance from every angle.
      if (mesh.is_border_edge(e)) return 100;
      return angle_between(plane_of(polyhedron, mesh.face(h)).normal,
                           plane_of(polyhedron, mesh.face(mesh.twin(h))).normal);
    case EdgeLikeness::place:
      return mesh.is_border_edge(e);
  }
  return 0;
}

}  // namespace

std::set<VertexId> similar_vertices(const PolyhedronSource& source, const std::set<VertexId>& vertices,
                                    VertexLikeness likeness, double tolerance) {
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<double> values(polyhedron.vertex_count(), 0);
  if (likeness == VertexLikeness::sharp_edges)
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      if (!is_sharp(source, e)) continue;
      const Index h = mesh.half_edge_of_edge(e);
      ++values[mesh.origin(h)];
      ++values[mesh.target(h)];
    }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (likeness == VertexLikeness::valence) values[v] = mesh.outgoing(v) == no_index ? 0 : mesh.valence(v);
    if (likeness == VertexLikeness::tension)
      values[v] = source.shaping->alpha.get_or(polyhedron.vertex_id(v), 0);
    if (likeness == VertexLikeness::place) values[v] = mesh.is_border_vertex(v);
  }
  ElementFlags flags(polyhedron, {vertices, {}, {}});
  flags.vertices = near_marked(values, flags.vertices, tolerance, Scale::ratio);
  return flags.to_set(polyhedron).vertices;
}

std::set<EdgeId> similar_edges(const PolyhedronSource& source, const std::set<EdgeId>& edges,
                               EdgeLikeness likeness, double tolerance) {
  const Polyhedron& polyhedron = source.polyhedron;
  std::vector<double> values(polyhedron.edge_count());
  for (Index e = 0; e < polyhedron.edge_count(); ++e) values[e] = value_of(source, e, likeness);
  ElementFlags flags(polyhedron, {{}, edges, {}});
  const Scale scale = likeness == EdgeLikeness::fold ? Scale::angle : Scale::ratio;
  flags.edges = near_marked(values, flags.edges, tolerance, scale);
  return flags.to_set(polyhedron).edges;
}

std::set<FaceId> similar_faces(const PolyhedronSource& source, const std::set<FaceId>& faces,
                               FaceLikeness likeness, double tolerance) {
  const Polyhedron& polyhedron = source.polyhedron;
  ElementFlags flags(polyhedron, {{}, {}, faces});
  if (likeness == FaceLikeness::side_count || likeness == FaceLikeness::area) {
    std::vector<double> values(polyhedron.face_count());
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      values[f] = likeness == FaceLikeness::side_count
                      ? polyhedron.topology().side_count(f)
                      : newell_normal(polyhedron.corners(f)).stableNorm() / 2;
    flags.faces = near_marked(values, flags.faces, tolerance, Scale::ratio);
    return flags.to_set(polyhedron).faces;
  }
  std::vector<Plane> wanted;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (flags.faces[f]) wanted.push_back(plane_of(polyhedron, f));
  const double reach = tolerance * size_of(polyhedron);
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (flags.faces[f]) continue;
    const Plane plane = plane_of(polyhedron, f);
    flags.faces[f] = std::any_of(wanted.begin(), wanted.end(), [&](const Plane& other) {
      if (angle_between(plane.normal, other.normal) > tolerance * std::numbers::pi) return false;
      return likeness == FaceLikeness::normal ||
             std::abs(other.normal.dot(plane.centre - other.centre)) <= reach;
    });
  }
  return flags.to_set(polyhedron).faces;
}

}  // namespace hariko
