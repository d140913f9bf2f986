// Planes through vertices, edges and faces: closed curves round closed surfaces, and nothing beside them.

#include "core/drawing/plane_curves.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "core/drawing/section_set.hpp"
#include "core/surface/facets.hpp"
#include "core/surface/weld_patches.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

struct CutMesh {
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;

  double size() const {
    Eigen::AlignedBox3d box;
    for (const Vector3& p : positions) box.extend(p);
    return box.diagonal().norm();
  }
  DrawnSurface drawn() const {
    const std::vector<Element> sources(triangles.size());
    return {facet_surface(Vector3::Zero(), positions, triangles, sources)};
  }
  void add_quad(Index a, Index b, Index c, Index d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
};

/// Cube from 0 to 2, each face of n x n squares.
CutMesh cube_mesh(int n) {
  CutMesh out;
  std::map<std::array<int, 3>, Index> numbers;
  const auto number = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, Index(out.positions.size()));
    if (is_new) out.positions.push_back(2.0 / n * Vector3(at[0], at[1], at[2]));
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int level : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> at{};
            at[axis] = level;
            at[(axis + 1) % 3] = i + di;
            at[(axis + 2) % 3] = j + dj;
            return number(at);
          };
          if (level == 0)
            out.add_quad(corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0));
          else
            out.add_quad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
        }
  return out;
}

/// Sphere of circles of latitude with one vertex at each pole; its radius changes by up to `rough` of itself.
CutMesh ball_mesh(std::mt19937_64& rng, Index around, Index rows, double rough) {
  CutMesh out;
  const auto add = [&](double latitude, double longitude) {
    const double radius = 1 + test::uniform(rng, -rough, rough);
    out.positions.push_back(radius * Vector3(std::cos(latitude) * std::cos(longitude),
                                             std::cos(latitude) * std::sin(longitude), std::sin(latitude)));
  };
  for (Index j = 1; j < rows; ++j)
    for (Index i = 0; i < around; ++i)
      add(std::numbers::pi * (double(j) / rows - 0.5), 2 * std::numbers::pi * i / around);
  const auto south = Index(out.positions.size()), north = south + 1;
  add(-0.5 * std::numbers::pi, 0);
  add(0.5 * std::numbers::pi, 0);
  for (Index i = 0; i < around; ++i) {
    const Index next = (i + 1) % around, last = (rows - 2) * around;
    out.triangles.push_back({south, next, i});
    out.triangles.push_back({north, last + i, last + next});
    for (Index j = 0; j + 2 < rows; ++j)
      out.add_quad(j * around + i, j * around + next, (j + 1) * around + next, (j + 1) * around + i);
  }
  return out;
}

CutMesh torus_mesh(Index columns, Index rows) {
  CutMesh out;
  for (Index i = 0; i < columns; ++i)
    for (Index j = 0; j < rows; ++j) {
      const double u = 2 * std::numbers::pi * i / columns, v = 2 * std::numbers::pi * j / rows;
      const double ring = 3 + std::cos(v);
      out.positions.push_back({ring * std::cos(u), ring * std::sin(u), std::sin(v)});
      const Index i1 = (i + 1) % columns, j1 = (j + 1) % rows;
      out.add_quad(i * rows + j, i1 * rows + j, i1 * rows + j1, i * rows + j1);
    }
  return out;
}

/// Prism over a regular polygon, with lids of triangles round one corner.
CutMesh prism_mesh(Index corners) {
  CutMesh out;
  for (const double z : {0.0, 1.5})
    for (Index i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      out.positions.push_back({std::cos(angle), std::sin(angle), z});
    }
  for (Index i = 0; i < corners; ++i) {
    const Index next = (i + 1) % corners;
    out.add_quad(i, next, corners + next, corners + i);
    if (i == 0 || next == 0) continue;
    out.triangles.push_back({0, next, i});
    out.triangles.push_back({corners, corners + i, corners + next});
  }
  return out;
}

double length_of_points(const std::vector<Vector3>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

/// Curves of one plane; none where the plane meets nothing.
std::vector<SectionCurve> curves_across(const DrawnSurface& drawn, const Vector3& direction, double offset) {
  SectionPlanes planes;
  planes.direction = direction;
  planes.first = offset;
  planes.count = 1;
  auto set = section_set(std::span(&drawn, 1), planes);
  if (set.ok()) return std::move(set.value().curves);
  EXPECT_EQ(set.error().code, e_sections_empty);
  return {};
}

double whole_length(const std::vector<SectionCurve>& curves) {
  double length = 0;
  for (const SectionCurve& curve : curves) length += length_of_points(curve.points);
  return length;
}

/// Checks the curves of a closed surface, and their length against that of a plane a little below.
void expect_closed_curves(const DrawnSurface& drawn, const Vector3& direction, double offset, double size) {
  const std::vector<SectionCurve> curves = curves_across(drawn, direction, offset);
  for (const SectionCurve& curve : curves) {
    EXPECT_TRUE(curve.closed);
    EXPECT_EQ(curve.points.front(), curve.points.back());
    EXPECT_GE(length_of_points(curve.points), 1e-9 * size);
  }
  const double below = whole_length(curves_across(drawn, direction, offset - 1e-9 * size));
  EXPECT_NEAR(whole_length(curves), below, 1e-4 * size);
}

/// Cuts a closed mesh through a vertex, along an edge and in a face, all chosen at random.
void cut_at_random(std::mt19937_64& rng, const CutMesh& mesh) {
  const DrawnSurface drawn = mesh.drawn();
  const double size = mesh.size();
  const std::array<Index, 3>& triangle =
      mesh.triangles[std::size_t(test::uniform_int(rng, 0, int(mesh.triangles.size()) - 1))];
  const Vector3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]],
                &c = mesh.positions[triangle[2]];
  const Vector3 any = test::random_vector(rng).normalized();
  const Vector3 along = (b - a).cross(any).normalized(), face = (b - a).cross(c - a).normalized();
  for (const Vector3& direction : {any, along, face, Vector3(-face), Vector3(Vector3::UnitX()),
                                   Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ())})
    expect_closed_curves(drawn, direction, direction.dot(a), size);
}

TEST(PlaneCurves, PlanesThroughVerticesOfClosedMeshesCutClosedCurves) {
  test::for_random(20261128, 12, [](std::mt19937_64& rng) {
    cut_at_random(rng, cube_mesh(test::uniform_int(rng, 1, 4)));
    cut_at_random(rng, prism_mesh(Index(test::uniform_int(rng, 3, 12))));
    cut_at_random(rng,
                  torus_mesh(Index(test::uniform_int(rng, 3, 24)), Index(test::uniform_int(rng, 3, 12))));
    const auto around = Index(test::uniform_int(rng, 3, 24)), rows = Index(test::uniform_int(rng, 2, 16));
    cut_at_random(rng, ball_mesh(rng, around, rows, 0));
    cut_at_random(rng, ball_mesh(rng, around, rows, 0.3));
  });
}

TEST(PlaneCurves, MiddlePlanesOfACubeCutOneCurve) {
  test::for_random(20261129, 6, [](std::mt19937_64& rng) {
    // Anywhere, turned in any way: vertices lie in the plane within rounding.
    DrawnSurface drawn = cube_mesh(2).drawn();
    const Vector3 axis = test::random_vector(rng).normalized();
    drawn.transform.translate(test::random_vector(rng, 100)).rotate(Eigen::AngleAxisd(1.3, axis));
    const Vector3 middle = drawn.transform * Vector3(1, 1, 1);
    const auto cut = [&](const Vector3& local, double shift) {
      const Vector3 direction = (drawn.transform.linear() * local.normalized()).normalized();
      return curves_across(drawn, direction, direction.dot(middle) + shift);
    };
    for (const auto& [local, length] : {std::pair(Vector3(1, 0, 0), 8.0), std::pair(Vector3(0, -1, 0), 8.0),
                                        std::pair(Vector3(1, -1, 0), 4 + 4 * std::numbers::sqrt2),
                                        std::pair(Vector3(1, 1, 1), 6 * std::numbers::sqrt2)}) {
      const std::vector<SectionCurve> curves = cut(local, 0);
      ASSERT_EQ(curves.size(), 1U) << local.transpose();
      EXPECT_TRUE(curves[0].closed);
      EXPECT_NEAR(length_of_points(curves[0].points), length, 1e-9);
    }
    // A face in the plane has its border once, where the cube lies below it.
    const std::vector<SectionCurve> top = cut(Vector3::UnitZ(), 1);
    ASSERT_EQ(top.size(), 1U);
    EXPECT_NEAR(length_of_points(top[0].points), 8, 1e-9);
    EXPECT_TRUE(cut(Vector3::UnitZ(), -1).empty());
  });
}

TEST(PlaneCurves, FacetsWithoutCommonNodesAreJoinedWhereTheyHaveTheSamePositions) {
  const CutMesh cube = cube_mesh(3);
  CutMesh loose;
  for (const auto& triangle : cube.triangles) {
    const auto first = Index(loose.positions.size());
    for (const Index corner : triangle) loose.positions.push_back(cube.positions[corner]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  for (const double offset : {2.0 / 3, 0.9, 2.0}) {
    const std::vector<SectionCurve> curves = curves_across(loose.drawn(), Vector3::UnitY(), offset);
    ASSERT_EQ(curves.size(), 1U) << offset;
    EXPECT_TRUE(curves[0].closed);
    EXPECT_NEAR(length_of_points(curves[0].points), 8, 1e-9);
  }
}

TEST(PlaneCurves, CurvesOfOpenMeshesEndOnTheBorder) {
  // A bumpy net from (0, 0) to (n, n), cut through its vertices.
  test::for_random(20261130, 12, [](std::mt19937_64& rng) {
    const auto n = Index(test::uniform_int(rng, 2, 9));
    CutMesh net;
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i <= n; ++i) net.positions.push_back({double(i), double(j), test::uniform(rng)});
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i)
        net.add_quad(j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i);
    const DrawnSurface drawn = net.drawn();
    const Vector3 inner(1, 1, net.positions[n + 2].z());
    ASSERT_EQ(inner, net.positions[n + 2]);
    for (const Vector3& direction :
         {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(1, -1, 0), Vector3(1, 2, 0)}) {
      const Vector3 unit = direction.normalized();
      const std::vector<SectionCurve> curves = curves_across(drawn, unit, unit.dot(inner));
      ASSERT_EQ(curves.size(), 1U) << direction.transpose();
      EXPECT_FALSE(curves[0].closed);
      for (const Vector3& end : {curves[0].points.front(), curves[0].points.back()}) {
        const double inside = std::min({end.x(), end.y(), n - end.x(), n - end.y()});
        EXPECT_NEAR(inside, 0, 1e-9);
      }
    }
  });
}

/// Patch of four corners, counter-clockwise.
BezierPatch flat_patch(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return BezierPatch{1, 1, {a, b, d, c}, {}};
}

/// Box from -1 to 1 whose face at x = 1 is cut in two at y = `at`: two T-joints.
Surface box_with_joints(double at) {
  std::vector<BezierPatch> patches;
  const auto face = [&](const Vector3& normal, const Vector3& u, double begin, double end) {
    const Vector3 v = normal.cross(u);
    patches.push_back(flat_patch(normal + begin * u - v, normal + end * u - v, normal + end * u + v,
                                 normal + begin * u + v));
  };
  face(Vector3::UnitX(), Vector3::UnitY(), -1, at);
  face(Vector3::UnitX(), Vector3::UnitY(), at, 1);
  for (const Vector3& normal : {Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, -1, 0)})
    face(normal, Vector3::UnitZ(), -1, 1);
  for (const double side : {-1.0, 1.0}) face(side * Vector3::UnitZ(), Vector3::UnitX(), -1, 1);
  auto welded = test::must(weld_patches(Vector3::Zero(), patches));
  return std::move(welded).value();
}

TEST(PlaneCurves, CurvesGoOnThroughTJoints) {
  const double corner = 1.0 / 3;
  const Surface surface = box_with_joints(corner);
  ASSERT_TRUE(surface.boundary_sides().empty());
  const DrawnSurface drawn{surface};
  const double size = std::sqrt(12.0);
  for (const double y : {corner, corner + 1e-6, corner - 1e-4, 0.0, 0.5})
    expect_closed_curves(drawn, Vector3::UnitY(), y, size);
  test::for_random(20261201, 6, [&](std::mt19937_64& rng) {
    const Vector3 direction = test::random_vector(rng).normalized();
    // Through the joint, near it, and anywhere.
    for (const Vector3& through : {Vector3(1, corner, 1), Vector3(1, corner + 1e-3, 1), Vector3(0, 0, 0)}) {
      const double offset = direction.dot(through);
      expect_closed_curves(drawn, direction, offset, size);
      EXPECT_EQ(curves_across(drawn, direction, offset).size(), 1U);
    }
  });
}

/// Sphere of eight octants of bicubic patches, each with a side that has shrunk to a pole.
Surface ball_of_patches() {
  const double k = 4.0 / 3 * (std::numbers::sqrt2 - 1);
  const std::array<Vector2, 4> quarter{Vector2(1, 0), Vector2(1, k), Vector2(k, 1), Vector2(0, 1)};
  std::vector<BezierPatch> patches;
  for (const double pole : {1.0, -1.0})
    for (int turn = 0; turn < 4; ++turn) {
      BezierPatch patch{3, 3, {}, {}};
      for (const Vector2& meridian : quarter)
        for (Vector2 circle : quarter) {
          for (int i = 0; i < turn; ++i) circle = Vector2(-circle.y(), circle.x());
          patch.points.push_back({meridian.x() * circle.x(), meridian.x() * circle.y(), pole * meridian.y()});
        }
      patches.push_back(patch);
    }
  auto welded = test::must(weld_patches(Vector3::Zero(), patches));
  return std::move(welded).value();
}

TEST(PlaneCurves, PlanesThroughPolesAndSeamsOfPatchesCutOneCurve) {
  const DrawnSurface drawn{ball_of_patches()};
  const auto expect_circle = [&](const Vector3& direction, double offset) {
    const std::vector<SectionCurve> curves = curves_across(drawn, direction, offset);
    ASSERT_EQ(curves.size(), 1U) << direction.transpose() << " at " << offset;
    EXPECT_TRUE(curves[0].closed);
    // The patches are spheres to 3e-4.
    const double ring = std::sqrt(1 - offset * offset);
    EXPECT_NEAR(length_of_points(curves[0].points), 2 * std::numbers::pi * ring, 5e-3 / ring);
  };
  for (const Vector3& direction : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(0, 0, -1)})
    for (const double offset : {0.0, 1e-12, -1e-7, 0.6}) expect_circle(direction, offset);
  test::for_random(20261202, 6, [&](std::mt19937_64& rng) {
    const Vector3 direction = test::random_vector(rng).normalized();
    for (const double offset : {0.0, direction.z(), direction.x(), test::uniform(rng, -0.9, 0.9)})
      if (std::abs(offset) < 0.95) expect_circle(direction, offset);
  });
  // Octants that meet in three sides' corners, and the columns of a torus.
  const DrawnSurface octants{test::sphere(2)}, ring{test::torus(3, 1, 6, 4)};
  for (const Vector3& direction : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)})
    EXPECT_EQ(curves_across(octants, direction, 0).size(), 1U);
  for (const auto& [direction, count] :
       {std::pair(Vector3(1, 0, 0), 2U), std::pair(Vector3(0, 1, 0), 2U), std::pair(Vector3(0, 0, 1), 2U)}) {
    const std::vector<SectionCurve> curves = curves_across(ring, direction, 0);
    EXPECT_EQ(curves.size(), count);
    for (const SectionCurve& curve : curves) EXPECT_TRUE(curve.closed);
  }
}

}  // namespace
}  // namespace hariko
