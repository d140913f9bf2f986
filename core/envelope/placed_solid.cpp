#include "core/envelope/placed_solid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/small_solver.hpp"
#include "core/envelope/convex_hull.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int ring_sides = 8;       ///< corners of the rings of round solids
constexpr int rim_points = 48;      ///< test points on the rims of cylinders and cones
constexpr int side_points = 8;      ///< test points round the sides of cones, below the tip
constexpr int points_of_edge = 9;   ///< test points between the ends of an edge
constexpr int spread_points = 64;   ///< test points spread over a surface
constexpr int straight_lines = 16;  ///< of a cone from the tip to the rim, of a capsule between its balls
constexpr double solid_hull_tolerance = 1e-9;

void add_ring(std::vector<Vector3>& out, int count, double radius, double z, double phase) {
  for (int k = 0; k < count; ++k) {
    const double a = 2 * pi * (k + phase) / count;
    out.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
  }
}

/// A cuboctahedron of radius 1, a hexagon round its waist.
std::vector<Vector3> ball_vertices(bool mirrored) {
  std::vector<Vector3> out;
  const double z = std::sqrt(2.0 / 3), r = 1 / std::sqrt(3.0), up = mirrored ? -1 : 1;
  add_ring(out, 6, 1, 0, 0);
  add_ring(out, 3, r, up * z, 0.25);
  add_ring(out, 3, r, -up * z, 0.75);
  return out;
}

std::vector<HalfSpace> half_spaces_of(std::span<const Vector3> points) {
  std::vector<HalfSpace> out;
  for (const auto& t : convex_hull(points, solid_hull_tolerance).triangles) {
    const Vector3 n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).stableNormalized();
    const double offset = n.dot(points[t[0]]);
    const bool known = std::any_of(out.begin(), out.end(), [&](const HalfSpace& h) {
      return (h.normal - n).squaredNorm() < 1e-16 && std::abs(h.offset - offset) < 1e-8;
    });
    if (!known) out.push_back({n, offset});
  }
  return out;
}

/// Edges of the hull that are not inside of a face.
std::vector<std::array<Index, 2>> edges_of(std::span<const Vector3> points) {
  std::map<std::pair<Index, Index>, Vector3> normals;
  std::vector<std::array<Index, 2>> out;
  for (const auto& t : convex_hull(points, solid_hull_tolerance).triangles) {
    const Vector3 n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).stableNormalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      const auto [at, fresh] = normals.try_emplace(std::minmax(a, b), n);
      if (!fresh && at->second.dot(n) < 1 - 1e-12) out.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

void set_frame(PlacedSolid& solid, const Matrix3& rotation, const Vector3& half) {
  solid.to_world = rotation * half.asDiagonal();
  solid.to_unit = half.cwiseInverse().asDiagonal() * rotation.transpose();
  solid.least_stretch = half.minCoeff();
}

/// Frame in which the vertices have unit covariance.
void set_polyhedron(PlacedSolid& solid, const Solid& authored, const Matrix3& rotation, double clearance) {
  std::vector<Vector3> points = authored.points;
  for (Vector3& p : points) p = p.cwiseProduct(authored.scale);
  Vector3 low = points[0], high = points[0];
  for (const Vector3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double size = (high - low).norm();
  const ConvexHull hull = convex_hull(points, solid_hull_tolerance * size);
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
  // The half spaces are of the frame without clearance, so its boundary is the polyhedron's moved outwards.
  set_frame(solid, rotation * axes, half + Vector3::Constant(clearance));
}

void set_shape(PlacedSolid& solid, const Solid& s, const Matrix3& rotation, double clearance) {
  using Shape = PlacedSolid::Shape;
  std::vector<Vector3>& u = solid.unit_vertices;
  Vector3 q = Vector3::Constant(s.radius);
  switch (s.kind) {
    case SolidKind::box:
      q = s.size / 2;
      for (int k = 0; k < 8; ++k) u.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
      break;
    case SolidKind::sphere:
    case SolidKind::capsule:
      u = ball_vertices(solid.part == 1);
      solid.shape_ = Shape::ball;
      solid.roundness = 1;
      break;
    case SolidKind::cylinder:
    case SolidKind::prism: {
      const int n = s.kind == SolidKind::cylinder ? ring_sides : int(s.sides);
      q.z() = s.height / 2;
      add_ring(u, n, 1, -1, 0);
      add_ring(u, n, 1, 1, 0);
      if (s.kind == SolidKind::cylinder) solid.shape_ = Shape::cylinder;
      break;
    }
    case SolidKind::cone:
    case SolidKind::pyramid: {
      const bool cone = s.kind == SolidKind::cone;
      q.z() = s.height / 2;
      add_ring(u, cone ? ring_sides : int(s.sides), 1, -0.5, cone ? 0.5 : 0);
      u.emplace_back(0, 0, 1.5);
      if (cone) solid.shape_ = Shape::cone;
      break;
    }
    case SolidKind::torus: {
      solid.tube_ = s.tube / s.radius;
      const double h = std::sqrt(0.5) * solid.tube_;
      add_ring(u, ring_sides, 1 + h, -h, 0);
      add_ring(u, ring_sides, 1 + h, h, 0);
      solid.shape_ = Shape::torus;
      break;
    }
    case SolidKind::polyhedron:
      set_polyhedron(solid, s, rotation, clearance);
      return;
  }
  set_frame(solid, rotation, s.scale.cwiseProduct(q) + Vector3::Constant(clearance));
}

void add_test_points(PlacedSolid& solid) {
  std::vector<Vector3>& out = solid.test_points;
  const auto add = [&](const Vector3& unit) { out.push_back(solid.world(unit)); };
  using Shape = PlacedSolid::Shape;
  if (solid.shape_ == Shape::half_spaces) {
    for (const Vector3& u : solid.unit_vertices) add(u);
    for (const SharpCurve& edge : solid.sharp_curves())
      for (int k = 1; k <= points_of_edge; ++k) out.push_back(edge.at(double(k) / (points_of_edge + 1)));
  }
  std::vector<Vector3> rim;
  if (solid.shape_ == Shape::cylinder) {
    add_ring(rim, rim_points, 1, -1, 0);
    add_ring(rim, rim_points, 1, 1, 0);
  } else if (solid.shape_ == Shape::cone) {
    add_ring(rim, rim_points, 1, -0.5, 0);
    rim.emplace_back(0, 0, 1.5);
    // A surface may reach over the tip and yet cut the side below it.
    for (const double down : {0.04, 0.1, 0.2, 0.4, 0.7})
      add_ring(rim, side_points, down, 1.5 - 2 * down, 0.5);
  }
  for (const Vector3& u : rim) add(u);
  for (const Vector3& p : solid.surface_points(spread_points)) out.push_back(p);
}

}  // namespace

double PlacedSolid::inside(const Vector3& x) const {
  switch (shape_) {
    case Shape::ball:
      return 1 - x.norm();
    case Shape::cylinder:
      return std::min(1 - std::hypot(x.x(), x.y()), 1 - std::abs(x.z()));
    case Shape::cone:
      // Side and base as lengths: the side falls by one from the axis to the rim while it goes two up.
      return std::min(((1.5 - x.z()) / 2 - std::hypot(x.x(), x.y())) / std::sqrt(1.25), x.z() + 0.5);
    case Shape::torus:
      return tube_ - std::hypot(std::hypot(x.x(), x.y()) - 1, x.z());
    default: {
      if (kind == SolidKind::box) return 1 - x.cwiseAbs().maxCoeff();
      double least = 1e300;
      for (const HalfSpace& h : half_spaces_) least = std::min(least, h.offset - h.normal.dot(x));
      return least;
    }
  }
}

double PlacedSolid::depth_with_body(const Vector3& point) const {
  const double own = depth(point);
  if (own > 0 || body.isZero()) return own;
  const Vector3 unit = to_unit * (point - centre);
  if (unit.z() < 0 || unit.z() > (to_unit * body).z()) return own;
  return (1 - std::hypot(unit.x(), unit.y())) * least_stretch;
}

double PlacedSolid::level(const Vector3& point) const {
  const Vector3 unit = to_unit * (point - centre);
  double out = inside(unit);
  if (!body.isZero() && unit.z() >= 0 && unit.z() <= (to_unit * body).z())
    out = std::max(out, 1 - std::hypot(unit.x(), unit.y()));
  return out * least_stretch;
}

std::vector<Vector3> PlacedSolid::surface_points(int count) const {
  std::vector<Vector3> out;
  for (const Vector3& d : spread_directions(count)) {
    if (shape_ == Shape::torus) {
      // Spread round both circles instead: rays from the centre miss most of a torus.
      const double a = std::atan2(d.y(), d.x()), b = std::asin(std::clamp(d.z(), -1.0, 1.0)) * 2;
      const double r = 1 + tube_ * std::cos(b);
      out.push_back(world({r * std::cos(a), r * std::sin(a), tube_ * std::sin(b)}));
      continue;
    }
    // Every function is concave along the ray and positive at the centroid.
    double low = 0, high = 1;
    while (inside(high * d) > 0 && high < 1e6) high *= 2;
    for (int round = 0; round < 52; ++round) {
      const double middle = 0.5 * (low + high);
      (inside(middle * d) > 0 ? low : high) = middle;
    }
    out.push_back(world(low * d));
  }
  return out;
}

Vector3 SharpCurve::at(double share) const {
  if (!across) return base + share * along;
  const double turn = 2 * pi * share;
  return base + std::cos(turn) * along + std::sin(turn) * *across;
}

double SharpCurve::length() const {
  return across ? 2 * pi * std::max(along.norm(), across->norm()) : along.norm();
}

std::vector<SharpCurve> PlacedSolid::sharp_curves() const {
  std::vector<SharpCurve> out;
  std::vector<Vector3> ring;
  const auto rim = [&](double z) {
    out.push_back({world({0, 0, z}), to_world.col(0), Vector3(to_world.col(1))});
  };
  switch (shape_) {
    case Shape::half_spaces:
      for (const auto& [a, b] : edges_of(unit_vertices)) {
        const Vector3 begin = world(unit_vertices[a]);
        out.push_back({begin, world(unit_vertices[b]) - begin, {}});
      }
      break;
    case Shape::cylinder:
      rim(-1);
      rim(1);
      break;
    case Shape::cone: {
      rim(-0.5);
      const Vector3 tip = world({0, 0, 1.5});
      add_ring(ring, straight_lines, 1, -0.5, 0.5);
      for (const Vector3& foot : ring) out.push_back({tip, world(foot) - tip, {}});
      break;
    }
    case Shape::ball:
      if (body.isZero()) break;
      add_ring(ring, straight_lines, 1, 0, 0);
      for (const Vector3& u : ring) out.push_back({world(u), body, {}});
      break;
    case Shape::torus:
      break;
  }
  return out;
}

std::vector<Vector3> spread_directions(int count) {
  std::vector<Vector3> out;
  const double turn = pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(std::max(0.0, 1 - z * z));
    out.emplace_back(r * std::cos(turn * k), r * std::sin(turn * k), z);
  }
  return out;
}

std::vector<PlacedSolid> place_solids(const EnvelopeInput& input) {
  std::vector<PlacedSolid> out;
  for (std::size_t k = 0; k < input.solids.size(); ++k) {
    const Solid& authored = input.solids[k];
    const Matrix3 rotation = solid_rotation(authored.rotation);
    const std::uint32_t parts = authored.kind == SolidKind::capsule ? 2 : 1;
    for (std::uint32_t part = 0; part < parts; ++part) {
      PlacedSolid solid;
      solid.owner = Index(k);
      solid.id = authored.id;
      solid.part = part;
      solid.kind = authored.kind;
      solid.rotation = rotation;
      solid.roundness = authored.roundness.value_or(input.settings.roundness);
      solid.centre = authored.position;
      if (parts == 2) {
        const double along = (part == 0 ? -0.5 : 0.5) * authored.length * authored.scale.z();
        solid.centre += rotation * Vector3(0, 0, along);
        if (part == 0) solid.body = rotation * Vector3(0, 0, -2 * along);
      }
      set_shape(solid, authored, rotation, input.settings.clearance);
      if (solid.shape_ == PlacedSolid::Shape::half_spaces && solid.kind != SolidKind::box)
        solid.half_spaces_ = half_spaces_of(solid.unit_vertices);
      double largest = solid.shape_ == PlacedSolid::Shape::torus ? 1 + solid.tube_ : 0;
      for (const Vector3& u : solid.unit_vertices) largest = std::max(largest, (solid.to_world * u).norm());
      if (solid.shape_ == PlacedSolid::Shape::cylinder || solid.shape_ == PlacedSolid::Shape::cone ||
          solid.shape_ == PlacedSolid::Shape::ball || solid.shape_ == PlacedSolid::Shape::torus)
        largest = std::max(largest, 1.5 * (1 + solid.tube_) * solid.to_world.colwise().norm().norm());
      solid.reach = largest * (1 + 1e-9);
      add_test_points(solid);
      out.push_back(std::move(solid));
    }
  }
  return out;
}

}  // namespace hariko
