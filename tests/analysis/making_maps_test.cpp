// Maps of making, on shapes whose drafts, radii and walls are known.

#include "core/analysis/making_maps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/surface/facets.hpp"
#include "core/surface/surface_triangles.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko {
namespace {

constexpr double a_degree = std::numbers::pi / 180;
const double sizes[] = {1e-3, 1.0, 1e6};

std::vector<Index> all_patches(const Surface& surface) {
  std::vector<Index> out(surface.patch_count());
  std::iota(out.begin(), out.end(), Index{0});
  return out;
}

TriangleTree tree_of(const Surface& surface, int density) {
  const SurfaceTriangles parts = surface_triangles(surface, density);
  return {parts.positions, parts.triangles};
}

std::vector<float> drafts(const Surface& surface, const Vector3& pull, const TriangleTree* hiding,
                          int density = 4) {
  const GridPattern pattern{surface.domain(), density};
  std::vector<float> out(std::size_t(pattern.point_count()) * surface.patch_count());
  draft_values(surface, pull, hiding, all_patches(surface), pattern, out);
  return out;
}

std::vector<float> thicknesses(const Surface& surface, const TriangleTree& walls, double scale, int density) {
  const GridPattern pattern{surface.domain(), density};
  std::vector<float> out(std::size_t(pattern.point_count()) * surface.patch_count());
  thickness_values(surface, walls, scale, all_patches(surface), pattern, out);
  return out;
}

/// The side of a cone round z that gets narrower upward, without its ends.
Surface cone_side(double half_angle, double size) {
  constexpr Index columns = 8;
  std::vector<test::PatchFormula> formulas;
  std::vector<Index> nodes;
  const double slope = std::tan(half_angle);
  for (Index i = 0; i < columns; ++i) {
    for (const Index node : {i, (i + 1) % columns, columns + (i + 1) % columns, columns + i})
      nodes.push_back(node);
    const double step = 2 * std::numbers::pi / columns;
    formulas.push_back([=](double s, double t) {
      const double u = step * (i + s), radius = size * (2 - t * slope), turn = size * step;
      const double c = std::cos(u), w = std::sin(u);
      PatchPoint p;
      p.position = Vector3(radius * c, radius * w, size * t);
      p.ds = step * radius * Vector3(-w, c, 0);
      p.dt = size * Vector3(-slope * c, -slope * w, 1);
      p.dss = -step * step * radius * Vector3(c, w, 0);
      p.dst = turn * slope * Vector3(w, -c, 0);
      return p;
    });
  }
  return test::make_surface(Domain::square, std::move(formulas), nodes);
}

/// Boxes as facets about an origin, each looking outward, or inward where it bounds a hollow.
class FacetBoxes {
 public:
  void add(const Vector3& low, const Vector3& high, bool hollow = false) {
    const auto first = static_cast<Index>(positions_.size());
    for (int k = 0; k < 8; ++k)
      positions_.emplace_back(k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(),
                              k & 4 ? high.z() : low.z());
    for (const auto& [a, b, c, d] : std::initializer_list<std::array<Index, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      add_triangle(first + a, first + b, first + c, hollow);
      add_triangle(first + a, first + c, first + d, hollow);
    }
  }
  Surface surface(const Vector3& origin = Vector3::Zero()) const {
    return facet_surface(origin, positions_, triangles_, std::vector<Element>(triangles_.size()));
  }

 private:
  void add_triangle(Index a, Index b, Index c, bool hollow) {
    triangles_.push_back({a, hollow ? c : b, hollow ? b : c});
  }
  std::vector<Vector3> positions_;
  std::vector<std::array<Index, 3>> triangles_;
};

TEST(MakingMaps, DraftOfAConeIsItsHalfAngle) {
  for (const double size : sizes)
    for (const double angle : {0.5, 3.0, 20.0, 60.0}) {
      SCOPED_TRACE(size * angle);
      const Surface cone = cone_side(angle * a_degree, size);
      const TriangleTree hiding = tree_of(cone, 16);
      for (const float draft : drafts(cone, {0, 0, 1}, &hiding)) EXPECT_NEAR(draft, angle, 1e-5);
      for (const float draft : drafts(cone, {0, 0, 7e5}, nullptr)) EXPECT_NEAR(draft, angle, 1e-5);
      // From below all of it is undercut by the same angle.
      for (const float draft : drafts(cone, {0, 0, -1}, &hiding)) EXPECT_NEAR(draft, -angle, 1e-5);
    }
}

TEST(MakingMaps, WallsThatWaverAboutTheUprightAreUpright) {
  const Surface cone = cone_side(0.03 * a_degree, 1);
  for (const double way : {1.0, -1.0})
    for (const float draft : drafts(cone, {0, 0, way}, nullptr)) EXPECT_EQ(draft, 0.0F);
}

TEST(MakingMaps, DraftIsTheLatitudeOfASphere) {
  const Surface ball = test::sphere(2);
  const TriangleTree hiding = tree_of(ball, 12);
  const GridPattern pattern{Domain::triangle, 4};
  const auto patches = all_patches(ball);
  std::vector<Vector3> at(std::size_t(pattern.point_count()) * patches.size()), normals(at.size());
  ball.patches().evaluate_grid(patches, pattern, at, normals);
  const auto found = drafts(ball, {0, 0, 1}, &hiding);
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], std::asin(at[i].z() / 2) / a_degree, 1e-4) << at[i].transpose();
}

/// A slab above another one hides the middle of the lower one, although all of it looks up.
TEST(MakingMaps, WhatIsHiddenAlongThePullIsAnUndercut) {
  for (const double size : sizes) {
    SCOPED_TRACE(size);
    FacetBoxes boxes;
    boxes.add(size * Vector3(0, 0, 0), size * Vector3(9, 9, 1));
    boxes.add(size * Vector3(3, 3, 2), size * Vector3(6, 6, 3));
    const Surface both = boxes.surface();
    const TriangleTree hiding = tree_of(both, 1);
    const int density = 9;
    const GridPattern pattern{Domain::triangle, density};
    const std::vector<Index> top{2, 3};  // top of the lower slab
    std::vector<float> found(std::size_t(pattern.point_count()) * 2);
    draft_values(both, {0, 0, 1}, &hiding, top, pattern, found);
    std::vector<Vector3> at(found.size()), normals(found.size());
    both.patches().evaluate_grid(top, pattern, at, normals);
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double x = at[i].x() / size, y = at[i].y() / size;
      ASSERT_NEAR(at[i].z(), size, 1e-9 * size);
      if (std::min({std::abs(x - 3), std::abs(x - 6), std::abs(y - 3), std::abs(y - 6)}) < 0.1) continue;
      const bool under = x > 3 && x < 6 && y > 3 && y < 6;
      EXPECT_NEAR(found[i], under ? -90 : 90, 1e-4) << x << " " << y;
      hidden += under ? 1 : 0;
    }
    EXPECT_GT(hidden, 3U);
    // The signs alone do not know.
    draft_values(both, {0, 0, 1}, nullptr, top, pattern, found);
    for (const float draft : found) EXPECT_NEAR(draft, 90, 1e-4);
  }
}

TEST(MakingMaps, UprightWallsAndTheGroundAtTheirFootAreNotHidden) {
  FacetBoxes boxes;
  boxes.add({0, 0, 0}, {2, 2, 5});
  const Surface box = boxes.surface();
  const TriangleTree hiding = tree_of(box, 1);
  for (const float draft : drafts(box, {0, 0, 1}, &hiding)) {
    const bool known = std::abs(draft) < 1e-4 || std::abs(std::abs(draft) - 90) < 1e-4;
    EXPECT_TRUE(known) << draft;
    EXPECT_FALSE(draft < 0 && draft > -89) << "an upright wall is an undercut: " << draft;
  }
}

TEST(MakingMaps, SmallestRadiusOfSphereTorusAndPlane) {
  for (const double size : sizes) {
    SCOPED_TRACE(size);
    const GridPattern pattern{Domain::triangle, 4};
    const Surface ball = test::sphere(2 * size);
    std::vector<float> values(std::size_t(pattern.point_count()) * ball.patch_count());
    radius_values(ball, 1, all_patches(ball), pattern, values);
    for (const float radius : values) EXPECT_NEAR(radius, 2 * size, 1e-5 * size);
    radius_values(ball, 2.5, all_patches(ball), pattern, values);
    for (const float radius : values) EXPECT_NEAR(radius, 5 * size, 1e-5 * size);
    const Surface ring = test::torus(3 * size, size, 6, 4);
    const GridPattern squares{Domain::square, 4};
    values.resize(std::size_t(squares.point_count()) * ring.patch_count());
    radius_values(ring, 1, all_patches(ring), squares, values);
    for (const float radius : values) EXPECT_NEAR(radius, size, 1e-5 * size) << "the tube's";
  }
  const Surface flat = test::height_field(1, 1, [](Index, Index) { return test::plane(0.3, 0.2); });
  const GridPattern squares{Domain::square, 3};
  std::vector<float> values(std::size_t(squares.point_count()));
  radius_values(flat, 1, all_patches(flat), squares, values);
  for (const float radius : values) EXPECT_TRUE(std::isinf(radius) && radius > 0);
}

/// A box of 6 x 6 x 6 with a hollow of 4 x 4 x 4 in its middle: its walls are 1 thick.
TEST(MakingMaps, WallsOfABoxShell) {
  for (const double size : sizes)
    for (const double moved : {0.0, 1e6}) {
      SCOPED_TRACE(std::to_string(size) + " " + std::to_string(moved));
      // Far away with an origin of its own, as documents have it, and with all digits in the positions.
      const Vector3 shift = moved * Vector3(1, -1, 1);
      for (const bool own_origin : {true, false}) {
        if (!own_origin && size < 1) continue;  // no digits are left
        FacetBoxes boxes;
        const Vector3 at = own_origin ? Vector3(Vector3::Zero()) : shift;
        boxes.add(at, at + Vector3::Constant(6 * size));
        boxes.add(at + Vector3::Constant(size), at + Vector3::Constant(5 * size), true);
        const Surface shell = boxes.surface(own_origin ? shift : Vector3(Vector3::Zero()));
        ASSERT_TRUE(is_closed(shell));
        const TriangleTree walls = tree_of(shell, 1);
        const int density = 12;
        const GridPattern pattern{Domain::triangle, density};
        const auto patches = all_patches(shell);
        std::vector<Vector3> positions(std::size_t(pattern.point_count()) * patches.size()),
            normals(positions.size());
        shell.patches().evaluate_grid(patches, pattern, positions, normals);
        const auto found = thicknesses(shell, walls, 1, density);
        std::size_t thin = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
          // Across from the hollow, measured from outside; from inside every ray ends on the outer box.
          const bool outer = i < found.size() / 2;
          int within = 0;
          for (int axis = 0; axis < 3; ++axis) {
            const double x = (positions[i] - at)[axis] / size;
            within += std::abs(normals[i][axis]) < 0.5 && x > 1.01 && x < 4.99 ? 1 : 0;
          }
          if (outer && within < 2) continue;
          EXPECT_NEAR(found[i], size, 2e-6 * size);
          ++thin;
        }
        EXPECT_GT(thin, 500U);
      }
    }
}

TEST(MakingMaps, WallsThroughTheSolidAreAsThickAsTheBox) {
  FacetBoxes boxes;
  boxes.add({0, 0, 0}, {2, 3, 4});
  const Surface box = boxes.surface();
  const TriangleTree walls = tree_of(box, 1);
  const std::vector<Index> bottom{0, 1};
  const GridPattern pattern{Domain::triangle, 6};
  std::vector<float> found(std::size_t(pattern.point_count()) * 2);
  // Corners and edges included, where the ray runs along walls.
  thickness_values(box, walls, 1, bottom, pattern, found);
  for (const float wall : found) EXPECT_NEAR(wall, 4, 1e-6);
  thickness_values(box, walls, 25.4, bottom, pattern, found);
  for (const float wall : found) EXPECT_NEAR(wall, 4 * 25.4, 1e-4);
}

/// Spheres of radius 3 and 2 about one middle, the inner one looking inward, as facets.
TEST(MakingMaps, WallsBetweenTwoSpheresAsFacets) {
  const SurfaceTriangles outer = surface_triangles(test::sphere(3), 24),
                         inner = surface_triangles(test::sphere(2), 24);
  std::vector<Vector3> positions = outer.positions;
  std::vector<std::array<Index, 3>> triangles = outer.triangles;
  const auto first = static_cast<Index>(positions.size());
  positions.insert(positions.end(), inner.positions.begin(), inner.positions.end());
  for (const auto& [a, b, c] : inner.triangles) triangles.push_back({first + a, first + c, first + b});
  const Surface shell =
      facet_surface(Vector3::Zero(), positions, triangles, std::vector<Element>(triangles.size()));
  const TriangleTree walls(positions, triangles);
  // Facets are off by their arrows and lean at their corners, by less than 0.01 together.
  for (const float wall : thicknesses(shell, walls, 1, 2)) EXPECT_NEAR(wall, 1, 0.015);
}

TEST(MakingMaps, ASphereIsAsThickAsItsDiameter) {
  for (const double size : sizes) {
    const Surface ball = test::sphere(size);
    const TriangleTree walls = tree_of(ball, 32);
    for (const float wall : thicknesses(ball, walls, 1, 8)) EXPECT_NEAR(wall, 2 * size, 2e-3 * size);
  }
}

TEST(MakingMaps, AWedgeThinsOutToNothing) {
  // A prism over the triangle (0, 0), (4, 0), (4, 1) in x and z: its slope ends in an edge at x = 0.
  const std::vector<Vector3> positions{{0, 0, 0}, {4, 0, 0}, {4, 0, 1}, {0, 2, 0}, {4, 2, 0}, {4, 2, 1}};
  const std::vector<std::array<Index, 3>> triangles{{0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3},
                                                    {1, 4, 5}, {1, 5, 2}, {0, 1, 2}, {3, 5, 4}};
  const Surface wedge = facet_surface(Vector3::Zero(), positions, triangles, std::vector<Element>(8));
  ASSERT_TRUE(is_closed(wedge));
  const TriangleTree walls(positions, triangles);
  const std::vector<Index> bottom{0, 1};
  const GridPattern pattern{Domain::triangle, 8};
  std::vector<float> found(std::size_t(pattern.point_count()) * 2);
  thickness_values(wedge, walls, 1, bottom, pattern, found);
  std::vector<Vector3> at(found.size()), normals(found.size());
  wedge.patches().evaluate_grid(bottom, pattern, at, normals);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], at[i].x() / 4, 1e-6);
}

TEST(MakingMaps, OpenSurfacesLeaveHolesInTheirThickness) {
  const Surface flat = test::height_field(1, 1, [](Index, Index) { return test::plane(); });
  const TriangleTree walls = tree_of(flat, 4);
  for (const float wall : thicknesses(flat, walls, 1, 4)) EXPECT_TRUE(std::isnan(wall));
}

TEST(MakingMaps, DoNotDependOnHowPatchesAreGrouped) {
  const Surface ring = test::torus(3, 1, 6, 4);
  const TriangleTree tree = tree_of(ring, 8);
  const GridPattern pattern{Domain::square, 3};
  const auto count = std::size_t(pattern.point_count());
  const auto walls = thicknesses(ring, tree, 1, 3), tilts = drafts(ring, {0.2, 0, 1}, &tree, 3);
  for (Index p = 0; p < ring.patch_count(); ++p) {
    std::vector<float> one(count);
    const Index patch[] = {p};
    thickness_values(ring, tree, 1, patch, pattern, one);
    EXPECT_TRUE(std::equal(one.begin(), one.end(), walls.begin() + std::ptrdiff_t(p * count)));
    draft_values(ring, {0.2, 0, 1}, &tree, patch, pattern, one);
    EXPECT_TRUE(std::equal(one.begin(), one.end(), tilts.begin() + std::ptrdiff_t(p * count)));
  }
}

}  // namespace
}  // namespace hariko
