#include "core/modeling/objects/primitives.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/geometry/polygon.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {
namespace {

std::optional<Message> bad_length(const char* name, double length) {
  if (length >= min_primitive_length && length <= max_primitive_length) return std::nullopt;
  return make_error(e_primitive_size, std::string("The ") + name + " is not a positive length.",
                    "Give a length from 1e-9 to 1e9.");
}

std::optional<Message> bad_count(const char* name, int count, int low, int high) {
  if (count >= low && count <= high) return std::nullopt;
  return make_error(e_primitive_count,
                    std::string("The number of ") + name + " is " + std::to_string(count) + ".",
                    "Use " + std::to_string(low) + " to " + std::to_string(high) + ".");
}

/// First error of several checks.
template <class... Checks>
std::optional<Message> first_fault(const Checks&... checks) {
  std::optional<Message> found;
  ((found ? void() : void(found = checks)), ...);
  return found;
}

/// Point i of n on the unit circle, counter-clockwise from +y: reduced to one eighth of a turn in integer
/// arithmetic, so that mirror images have equal coordinates. (Point 0 on the y axis keeps every n symmetric
/// across x = 0.)
Vector2 circle_point(int i, int n) {
  int part = 4 * (((i % n) + n) % n);  // in units of 1 / (4 n) turn
  const bool below = part > 2 * n;
  if (below) part = 4 * n - part;
  const bool left = part > n;
  if (left) part = 2 * n - part;
  const bool steep = 2 * part > n;
  if (steep) part = n - part;
  const double angle = 2 * std::numbers::pi * part / (4.0 * n);
  double x = std::cos(angle), y = std::sin(angle);
  if (steep) std::swap(x, y);
  if (left) x = -x;
  if (below) y = -y;
  return {y == 0 ? 0.0 : -y, x};
}

void put_on_ground(PolygonMesh& mesh, Placement placement) {
  if (placement == Placement::centred) return;
  double lowest = mesh.positions.front().z();
  for (const Vector3& p : mesh.positions) lowest = std::min(lowest, p.z());
  for (Vector3& p : mesh.positions) p.z() -= lowest;
}

/// Surface of a box of nx x ny x nz unit cells as quads; position(i, j, k) places the lattice points.
template <class Position>
PolygonMesh lattice_box(const std::array<int, 3>& n, Position&& position) {
  PolygonMesh mesh;
  std::map<std::array<int, 3>, Index> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [it, fresh] = vertices.try_emplace(at, static_cast<Index>(mesh.positions.size()));
    if (fresh) mesh.positions.push_back(position(at));
    return it->second;
  };
  for (const std::size_t axis : {2, 1, 0}) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool far : {false, true})
      for (int j = 0; j < n[v]; ++j)
        for (int i = 0; i < n[u]; ++i) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> at{};
            at[axis] = far ? n[axis] : 0;
            at[u] = i + di;
            at[v] = j + dj;
            return vertex(at);
          };
          // u, v, axis are right-handed: counter-clockwise in (u, v) faces +axis.
          if (far)
            mesh.add_face({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
          else
            mesh.add_face({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
        }
  }
  return mesh;
}

/// Fraction -1 .. 1 of i in n, exactly symmetric.
double lattice_fraction(int i, int n) {
  return static_cast<double>(2 * i - n) / n;
}

/// Faces of a convex solid with the given vertices: all planes through vertices with none outside. For the
/// few vertices of a Platonic solid a search is shorter than tables, and cannot hold a wrong entry.
PolygonMesh convex_hull_of_few(std::vector<Vector3> positions) {
  PolygonMesh mesh;
  mesh.positions = std::move(positions);
  const auto count = static_cast<Index>(mesh.positions.size());
  for (Index a = 0; a < count; ++a)
    for (Index b = a + 1; b < count; ++b)
      for (Index c = a + 1; c < count; ++c) {
        if (c == b) continue;
        const Vector3& origin = mesh.positions[a];
        const Vector3 normal = area_vector(origin, mesh.positions[b], mesh.positions[c]).normalized();
        std::vector<Index> on;
        bool outside = false;
        for (Index v = 0; v < count && !outside; ++v) {
          const double height = normal.dot(mesh.positions[v] - origin);
          outside = height > 1e-9;
          if (height > -1e-9) on.push_back(v);
        }
        // Each face is accepted once: from its two lowest vertices that start it.
        if (outside || on[0] != a || on[1] != std::min(b, c)) continue;
        Vector3 centre = Vector3::Zero();
        for (const Index v : on) centre += mesh.positions[v] / static_cast<double>(on.size());
        const Vector3 x = (origin - centre).normalized(), y = normal.cross(x);
        const auto angle = [&](Index v) {
          const Vector3 d = mesh.positions[v] - centre;
          const double turn = std::atan2(y.dot(d), x.dot(d));
          return v == a ? 0.0 : (turn < 0 ? turn + 2 * std::numbers::pi : turn);
        };
        std::sort(on.begin(), on.end(), [&](Index p, Index q) { return angle(p) < angle(q); });
        bool known = false;
        for (std::size_t f = 0; f < mesh.face_count() && !known; ++f)
          known = std::equal(on.begin(), on.end(), mesh.face(f).begin(), mesh.face(f).end());
        if (!known) mesh.add_face(on);
      }
  return mesh;
}

/// Vertices on the unit sphere, symmetric across x = 0.
std::vector<Vector3> platonic_vertices(PlatonicSolid solid) {
  const double golden = std::numbers::phi;
  std::vector<Vector3> out;
  const auto cyclic = [&](double a, double b) {  // (0, +-a, +-b) and its cyclic permutations
    for (int shift = 0; shift < 3; ++shift)
      for (const double s : {-1.0, 1.0})
        for (const double t : {-1.0, 1.0}) {
          Vector3 p = Vector3::Zero();
          p[(shift + 1) % 3] = s * a;
          p[(shift + 2) % 3] = t * b;
          out.push_back(p);
        }
  };
  const auto cube = [&] {
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0}) out.emplace_back(x, y, z);
  };
  switch (solid) {
    case PlatonicSolid::tetrahedron:
      for (int i = 0; i < 3; ++i) {
        const Vector2 foot = circle_point(i, 3) * (2 * std::numbers::sqrt2 / 3);
        out.emplace_back(foot.x(), foot.y(), -1.0 / 3);
      }
      out.emplace_back(0, 0, 1);
      break;
    case PlatonicSolid::cube:
      cube();
      break;
    case PlatonicSolid::octahedron:
      for (int axis = 0; axis < 3; ++axis)
        for (const double s : {-1.0, 1.0}) out.push_back(s * Vector3::Unit(axis));
      break;
    case PlatonicSolid::dodecahedron:
      cube();
      cyclic(1 / golden, golden);
      break;
    case PlatonicSolid::icosahedron:
      cyclic(1, golden);
      break;
  }
  const double length = out.back().norm();
  for (Vector3& p : out) p /= length;
  return out;
}

/// Turns a solid so that a face which crosses the plane x = 0 symmetrically lies at the bottom. The turn is
/// about the x axis, so the symmetry across x = 0 stays exact. False when the solid has no such face.
bool rest_on_face(PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<Vector3> corners;
    for (const Index v : mesh.face(f)) corners.push_back(mesh.positions[v]);
    const Vector3 normal = newell_normal(corners).normalized();
    if (std::abs(normal.x()) > 1e-9 || normal.z() > 1e-9) continue;
    // (y, z) of the normal goes to (0, -1).
    const double c = -normal.z(), s = -normal.y();
    if (std::abs(s) > 1e-9)
      for (Vector3& p : mesh.positions) p = {p.x(), c * p.y() - s * p.z(), s * p.y() + c * p.z()};
    // Makes the foot level to the last bit.
    const double level = mesh.positions[mesh.face(f)[0]].z();
    for (const Index v : mesh.face(f)) mesh.positions[v].z() = level;
    return true;
  }
  return false;
}

PolygonMesh icosphere(int level) {
  PolygonMesh mesh = convex_hull_of_few(platonic_vertices(PlatonicSolid::icosahedron));
  for (int step = 0; step < level; ++step) {
    PolygonMesh finer;
    finer.positions = mesh.positions;
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [it, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<Index>(finer.positions.size()));
      if (fresh) finer.positions.push_back((mesh.positions[a] + mesh.positions[b]).normalized());
      return it->second;
    };
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const Index a = mesh.face(f)[0], b = mesh.face(f)[1], c = mesh.face(f)[2];
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.add_face({a, ab, ca});
      finer.add_face({b, bc, ab});
      finer.add_face({c, ca, bc});
      finer.add_face({ab, bc, ca});
    }
    mesh = std::move(finer);
  }
  return mesh;
}

void scale(PolygonMesh& mesh, double factor) {
  for (Vector3& p : mesh.positions) p *= factor;
}

}  // namespace

Result<PolygonMesh> make_primitive(const BoxShape& shape) {
  if (auto fault = first_fault(bad_length("width", shape.size.x()), bad_length("depth", shape.size.y()),
                               bad_length("height", shape.size.z()),
                               bad_count("segments along x", shape.segments[0], 1, max_box_segments),
                               bad_count("segments along y", shape.segments[1], 1, max_box_segments),
                               bad_count("segments along z", shape.segments[2], 1, max_box_segments)))
    return *std::move(fault);
  PolygonMesh mesh = lattice_box(shape.segments, [&](const std::array<int, 3>& at) {
    return Vector3(shape.size.x() / 2 * lattice_fraction(at[0], shape.segments[0]),
                   shape.size.y() / 2 * lattice_fraction(at[1], shape.segments[1]),
                   shape.size.z() / 2 * lattice_fraction(at[2], shape.segments[2]));
  });
  put_on_ground(mesh, shape.placement);
  return mesh;
}

Result<PolygonMesh> make_primitive(const PrismShape& shape) {
  if (auto fault = first_fault(bad_length("radius", shape.radius), bad_length("height", shape.height),
                               bad_count("sides", shape.sides, 3, max_primitive_sides)))
    return *std::move(fault);
  const int n = shape.sides;
  PolygonMesh mesh;
  for (const double z : {-shape.height / 2, shape.height / 2})
    for (int i = 0; i < n; ++i) {
      const Vector2 p = shape.radius * circle_point(i, n);
      mesh.positions.emplace_back(p.x(), p.y(), z);
    }
  const auto at = [n](int ring, int i) { return static_cast<Index>(ring * n + i % n); };
  std::vector<Index> bottom, top;
  for (int i = 0; i < n; ++i) {
    bottom.push_back(at(0, n - 1 - i));
    top.push_back(at(1, i));
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  for (int i = 0; i < n; ++i) mesh.add_face({at(0, i), at(0, i + 1), at(1, i + 1), at(1, i)});
  put_on_ground(mesh, shape.placement);
  return mesh;
}

Result<PolygonMesh> make_primitive(const PyramidShape& shape) {
  if (auto fault = first_fault(bad_length("radius", shape.radius), bad_length("height", shape.height),
                               bad_count("sides", shape.sides, 3, max_primitive_sides)))
    return *std::move(fault);
  const int n = shape.sides;
  PolygonMesh mesh;
  std::vector<Index> base;
  for (int i = 0; i < n; ++i) {
    const Vector2 p = shape.radius * circle_point(i, n);
    mesh.positions.emplace_back(p.x(), p.y(), -shape.height / 2);
    base.push_back(static_cast<Index>(n - 1 - i));
  }
  mesh.positions.emplace_back(0, 0, shape.height / 2);
  mesh.add_face(base);
  for (int i = 0; i < n; ++i)
    mesh.add_face({static_cast<Index>(i), static_cast<Index>((i + 1) % n), static_cast<Index>(n)});
  put_on_ground(mesh, shape.placement);
  return mesh;
}

Result<PolygonMesh> make_primitive(const PlatonicShape& shape) {
  if (auto fault = bad_length("radius", shape.radius)) return *std::move(fault);
  PolygonMesh mesh = convex_hull_of_few(platonic_vertices(shape.solid));
  if (shape.placement == Placement::on_ground && !rest_on_face(mesh)) {
    // The octahedron's faces look into the octants: after an eighth of a turn two of them look along y.
    const double c = std::numbers::sqrt2 / 2;
    for (Vector3& p : mesh.positions) p = {c * (p.x() - p.y()), c * (p.x() + p.y()), p.z()};
    const bool rests = rest_on_face(mesh);
    HARIKO_ASSERT(rests, "every Platonic solid can rest on a face");
  }
  scale(mesh, shape.radius);
  put_on_ground(mesh, shape.placement);
  return mesh;
}

Result<PolygonMesh> make_primitive(const TorusShape& shape) {
  if (auto fault = first_fault(bad_length("ring radius", shape.ring_radius),
                               bad_length("tube radius", shape.tube_radius),
                               bad_count("segments", shape.segments, 3, max_grid_segments),
                               bad_count("sides", shape.sides, 3, max_grid_segments)))
    return *std::move(fault);
  if (!(shape.tube_radius < shape.ring_radius))
    return make_error(e_primitive_size, "The tube is too thick: it would close the hole of the torus.",
                      "Make the tube radius smaller than the ring radius.");
  PolygonMesh mesh;
  for (int i = 0; i < shape.segments; ++i)
    for (int j = 0; j < shape.sides; ++j) {
      const Vector2 around = circle_point(i, shape.segments);
      // A quarter turn makes the first side of the tube point outwards.
      const Vector2 tube = circle_point(j, shape.sides);
      const double radius = shape.ring_radius + shape.tube_radius * tube.y();
      mesh.positions.emplace_back(radius * around.x(), radius * around.y(), -shape.tube_radius * tube.x());
    }
  const auto at = [&](int i, int j) {
    return static_cast<Index>((i % shape.segments) * shape.sides + j % shape.sides);
  };
  for (int i = 0; i < shape.segments; ++i)
    for (int j = 0; j < shape.sides; ++j)
      mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  put_on_ground(mesh, shape.placement);
  return mesh;
}

Result<PolygonMesh> make_primitive(const PlaneShape& shape) {
  if (auto fault = first_fault(bad_length("width", shape.width), bad_length("depth", shape.depth),
                               bad_count("columns", shape.columns, 1, max_grid_segments),
                               bad_count("rows", shape.rows, 1, max_grid_segments)))
    return *std::move(fault);
  PolygonMesh mesh;
  for (int j = 0; j <= shape.rows; ++j)
    for (int i = 0; i <= shape.columns; ++i)
      mesh.positions.emplace_back(shape.width / 2 * lattice_fraction(i, shape.columns),
                                  shape.depth / 2 * lattice_fraction(j, shape.rows), 0.0);
  const auto at = [&](int i, int j) { return static_cast<Index>(j * (shape.columns + 1) + i); };
  for (int j = 0; j < shape.rows; ++j)
    for (int i = 0; i < shape.columns; ++i)
      mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

Result<PolygonMesh> make_primitive(const SphereCageShape& shape) {
  if (auto fault = first_fault(bad_length("radius", shape.radius),
                               bad_count("segments", shape.segments, 1, max_sphere_segments)))
    return *std::move(fault);
  const int n = shape.segments;
  PolygonMesh mesh = lattice_box({n, n, n}, [&](const std::array<int, 3>& at) {
    // Equal angles instead of equal lengths make the quads nearly equal.
    const auto stretched = [n](int i) {
      const double t = lattice_fraction(i, n);
      return std::abs(t) == 1 ? t : std::tan(std::numbers::pi / 4 * t);
    };
    return Vector3(shape.radius * Vector3(stretched(at[0]), stretched(at[1]), stretched(at[2])).normalized());
  });
  put_on_ground(mesh, shape.placement);
  return mesh;
}

Result<PolygonMesh> make_primitive(const IcosphereShape& shape) {
  if (auto fault = first_fault(bad_length("radius", shape.radius),
                               bad_count("levels", shape.level, 0, max_icosphere_level)))
    return *std::move(fault);
  PolygonMesh mesh = icosphere(shape.level);
  scale(mesh, shape.radius);
  put_on_ground(mesh, shape.placement);
  return mesh;
}

}  // namespace hariko
