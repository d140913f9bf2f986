#include <cmath>

#include "core/base/solvers/small_solver.hpp"
#include "core/envelope/network/hull_cage.hpp"
#include "core/geometry/tolerant_hull.hpp"

namespace hariko {

namespace {

constexpr std::uint32_t ring_sides = 8;  ///< corners of the rings of round solids
constexpr double solid_hull_tolerance = 1e-9;

/// Cuboctahedron of radius 1 with a hexagon at its equator.
std::vector<Vector3> ball_vertices(bool mirrored) {
  std::vector<Vector3> out;
  const double z = std::sqrt(2.0 / 3), r = 1 / std::sqrt(3.0), up = mirrored ? -1 : 1;
  add_polygon(out, 6, 1, 0);
  add_polygon(out, 3, r, up * z, 0.25);
  add_polygon(out, 3, r, -up * z, 0.75);
  return out;
}

void set_frame(NetworkSolid& solid, const Matrix3& rotation, const Vector3& half) {
  solid.to_world = rotation * half.asDiagonal();
  solid.to_unit = half.cwiseInverse().asDiagonal() * rotation.transpose();
}

/// Sets the frame in which the vertices have unit covariance.
void set_polyhedron(NetworkSolid& solid, const Solid& authored, const Matrix3& rotation, double clearance) {
  std::vector<Vector3> points = authored.points;
  for (Vector3& p : points) p = p.cwiseProduct(authored.scale);
  Vector3 low = points[0], high = points[0];
  for (const Vector3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double size = (high - low).norm();
  const TolerantHull hull = tolerant_hull(points, solid_hull_tolerance * size);
  Vector3 centroid = Vector3::Zero(), mean = Vector3::Zero();
  double volume = 0;
  const Vector3 middle = 0.5 * (low + high);
  for (const auto& t : hull.triangles) {
    const Vector3 a = points[t[0]] - middle, b = points[t[1]] - middle, c = points[t[2]] - middle;
    const double v = a.dot(b.cross(c)) / 6;
    volume += v;
    centroid += v * (a + b + c) / 4;
  }
  centroid = middle + centroid / volume;
  for (const Index v : hull.vertices) mean += points[v] / double(hull.vertices.size());
  Matrix3 covariance = Matrix3::Zero();
  for (const Index v : hull.vertices)
    covariance += (points[v] - mean) * (points[v] - mean).transpose() / double(hull.vertices.size());
  const SymmetricAxes principal = symmetric_axes(covariance);
  Matrix3 axes = principal.vectors;
  if (axes.determinant() < 0) axes.col(0) *= -1;
  const Vector3 half = principal.values.cwiseMax(1e-18 * size * size).cwiseSqrt();
  for (const Index v : hull.vertices)
    solid.unit_vertices.push_back(
        half.cwiseInverse().cwiseProduct(axes.transpose() * (points[v] - centroid)));
  solid.centre = authored.position + rotation * centroid;
  set_frame(solid, rotation * axes, half + Vector3::Constant(clearance));
}

void set_shape(NetworkSolid& solid, const Solid& s, const Matrix3& rotation, double clearance, bool second) {
  std::vector<Vector3>& u = solid.unit_vertices;
  Vector3 q = Vector3::Constant(s.radius);
  switch (s.kind) {
    case SolidKind::box:
      q = s.size / 2;
      for (int k = 0; k < 8; ++k) u.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
      break;
    case SolidKind::sphere:
    case SolidKind::capsule:
      u = ball_vertices(second);
      solid.roundness = 1;
      break;
    case SolidKind::cylinder:
    case SolidKind::prism: {
      const std::uint32_t n = s.kind == SolidKind::cylinder ? ring_sides : s.sides;
      q.z() = s.height / 2;
      add_polygon(u, n, 1, -1);
      add_polygon(u, n, 1, 1);
      break;
    }
    case SolidKind::cone:
    case SolidKind::pyramid: {
      const bool cone = s.kind == SolidKind::cone;
      q.z() = s.height / 2;
      add_polygon(u, cone ? ring_sides : s.sides, 1, -0.5, cone ? 0.5 : 0);
      u.emplace_back(0, 0, 1.5);
      break;
    }
    case SolidKind::torus: {
      const double h = std::sqrt(0.5) * s.tube / s.radius;
      add_polygon(u, ring_sides, 1 + h, -h);
      add_polygon(u, ring_sides, 1 + h, h);
      break;
    }
    case SolidKind::polyhedron:
      set_polyhedron(solid, s, rotation, clearance);
      return;
  }
  set_frame(solid, rotation, s.scale.cwiseProduct(q) + Vector3::Constant(clearance));
}

}  // namespace

std::vector<NetworkSolid> network_solids(const EnvelopeInput& input, const Vector3& origin) {
  std::vector<NetworkSolid> out;
  for (Index k = 0; k < input.solids.size(); ++k) {
    const Solid& authored = input.solids[k];
    const Matrix3 rotation = solid_rotation(authored.rotation);
    const int parts = authored.kind == SolidKind::capsule ? 2 : 1;
    for (int part = 0; part < parts; ++part) {
      NetworkSolid solid;
      solid.owner = k;
      solid.roundness = authored.roundness.value_or(input.settings.roundness);
      solid.centre = authored.position;
      if (parts == 2) {
        const double along = (part == 0 ? -0.5 : 0.5) * authored.length * authored.scale.z();
        solid.centre += rotation * Vector3(0, 0, along);
      }
      set_shape(solid, authored, rotation, input.settings.clearance, part == 1);
      solid.centre -= origin;
      out.push_back(std::move(solid));
    }
  }
  return out;
}

double network_size(const std::vector<NetworkSolid>& solids) {
  Eigen::AlignedBox3d box;
  for (const NetworkSolid& solid : solids)
    for (const Vector3& u : solid.unit_vertices) box.extend(solid.world(u));
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace hariko
