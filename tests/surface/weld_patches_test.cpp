// Loose patches are found to be neighbours however they are written and wherever they lie.

#include "core/surface/weld_patches.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

constexpr int cells = 24;  ///< along each side of the net

/// Flat patches of degree 1 to 3 over a net of squares in the plane across `axis`, in any order and written
/// from any corner, either side up. In such a plane one coordinate of all points is the same.
std::vector<BezierPatch> flat_net(int axis, std::mt19937_64& rng) {
  std::vector<BezierPatch> patches;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      BezierPatch patch;
      patch.degree_s = patch.degree_t = 1 + int(rng() % 3);
      const auto turns = rng() % 4;
      for (int j = 0; j <= patch.degree_t; ++j)
        for (int i = 0; i <= patch.degree_s; ++i) {
          double s = double(i) / patch.degree_s, t = double(j) / patch.degree_t;
          for (std::size_t k = 0; k < turns; ++k) std::tie(s, t) = std::pair(1 - t, s);
          Vector3 point = Vector3::Constant(0.75);
          point[(axis + 1) % 3] = x + s;
          point[(axis + 2) % 3] = y + t;
          patch.points.push_back(point);
        }
      patches.push_back(rng() % 2 ? flipped(patch) : patch);
    }
  std::shuffle(patches.begin(), patches.end(), rng);
  return patches;
}

TEST(WeldPatches, NetsInPlanesAcrossTheAxes) {
  test::for_random(20261122, 3, [](std::mt19937_64& rng) {
    for (int axis = 0; axis < 3; ++axis) {
      const Surface surface = weld_patches(Vector3::Zero(), flat_net(axis, rng)).value();
      EXPECT_EQ(surface.seams().size(), 2U * cells * (cells - 1)) << "axis " << axis;
      EXPECT_EQ(surface.boundary_sides().size(), 4U * cells);
      EXPECT_EQ(surface.node_count(), Index((cells + 1) * (cells + 1)));
      for (const Seam& seam : surface.seams()) EXPECT_EQ(seam.intended, Continuity::g1);
      const Vector3 outside = surface.normal(0, {0.5, 0.5});
      EXPECT_NEAR(std::abs(outside[axis]), 1, 1e-12);
      for (Index k = 0; k < surface.patch_count(); ++k)
        EXPECT_LE((surface.normal(k, {0.3, 0.6}) - outside).norm(), 1e-12) << "patch " << k;
    }
  });
}

/// The part s0 .. s1, t0 .. t1 of z = x (2 - x) over 0 .. 2, 0 .. 1, whose sides bulge between their ends, at
/// a place.
BezierPatch arch(double s0, double s1, double t0, double t1, const Vector3& place) {
  BezierPatch out;
  out.degree_s = 2;
  out.degree_t = 1;
  const double from = 2 * s0, to = 2 * s1;
  for (const double t : {t0, t1}) {
    out.points.push_back(place + Vector3(from, t, from * (2 - from)));
    out.points.push_back(place + Vector3((from + to) / 2, t, from + to - from * to));
    out.points.push_back(place + Vector3(to, t, to * (2 - to)));
  }
  return out;
}

TEST(WeldPatches, SidesInPartsMeetWholeOnesWhereverTheyBulge) {
  // Near zero, and where numbers are rounded to 1e-10.
  for (const Vector3& place : {Vector3(0, 0, 0), Vector3(1e6, -2e6, 3e5)}) {
    std::vector<BezierPatch> patches{arch(0, 1, 0, 1, place)};
    double before = 0;
    for (const double at : {0.03125, 0.0625, 0.125, 0.25, 0.4375, 0.5625, 0.75, 1.0}) {
      patches.push_back(arch(before, at, 1, 2, place));
      before = at;
    }
    const Surface surface = weld_patches(Vector3::Zero(), patches).value();
    EXPECT_EQ(surface.seams().size(), 8U + 7U);
    // The whole one's other sides, the ends of the parts, and their sides beyond.
    EXPECT_EQ(surface.boundary_sides().size(), 3U + 2U + 8U);
    for (const Seam& seam : surface.seams()) {
      if (seam.first.patch != 0) continue;
      // Parts begin at the parameters at which they were cut, to the last bit.
      EXPECT_EQ(seam.first_begin * 32, std::round(seam.first_begin * 32));
    }
  }
}

/// As files of IGES in any unit have them: each number by itself.
TEST(WeldPatches, NumbersOfNineDigitsAreEnough) {
  test::for_random(1109, 200, [](std::mt19937_64& rng) {
    const Matrix3 turn =
        Eigen::AngleAxisd(test::uniform(rng, 0, 3), test::random_vector(rng).normalized()).toRotationMatrix();
    const double unit = test::log_uniform(rng, 1e-3, 1e3);
    const auto nine_digits = [](double x) {
      const double last = std::pow(10.0, std::floor(std::log10(std::abs(x))) - 8);
      return x == 0 ? 0 : std::round(x / last) * last;
    };
    std::vector<BezierPatch> patches{arch(0, 1, 0, 1, Vector3::Zero())};
    double before = 0;
    for (const double at : {0.25, 0.375, 1.0}) {
      patches.push_back(arch(before, at, 1, 2, Vector3::Zero()));
      before = at;
    }
    for (BezierPatch& patch : patches)
      for (Vector3& point : patch.points) point = (unit * (turn * point)).unaryExpr(nine_digits);
    const Surface surface = weld_patches(Vector3::Zero(), patches).value();
    EXPECT_EQ(surface.seams().size(), 3U + 2U);
    EXPECT_EQ(surface.boundary_sides().size(), 3U + 2U + 3U);
  });
}

/// A part of the flat square, with a parameter along x that begins slowly: x is its cube.
BezierPatch slow(double from, double to, double y0, double y1) {
  BezierPatch out;
  out.degree_s = 3;
  out.degree_t = 1;
  for (const double y : {y0, y1})
    for (int i = 0; i <= 3; ++i) {
      double x = 1;  // the polar form of the cube
      for (int k = 0; k < 3; ++k) x *= k < i ? to : from;
      out.points.emplace_back(x, y, 0);
    }
  return out;
}

/// As in a file of eleven digits: a point is moved by less than the tolerance, where the parameter of the
/// place is another by far.
TEST(WeldPatches, PartsMeetWholeSidesThatBeginSlowly) {
  std::vector<BezierPatch> patches{slow(0, 1, 0, 1), slow(0, 0.3, 1, 2), slow(0.3, 0.7, 1, 2),
                                   slow(0.7, 1, 1, 2)};
  patches[1].points[0].x() += 1e-10;
  patches[3].points[3].x() -= 1e-10;
  const Surface surface = weld_patches(Vector3::Zero(), patches).value();
  EXPECT_EQ(surface.seams().size(), 3U + 2U);
  EXPECT_EQ(surface.boundary_sides().size(), 3U + 2U + 3U);
}

/// A square from (x, y) of these sizes.
BezierPatch square(double x, double y, double width, double height) {
  BezierPatch patch{1, 1, {}, {}};
  for (const double t : {0.0, 1.0})
    for (const double s : {0.0, 1.0}) patch.points.emplace_back(x + s * width, y + t * height, 0);
  return patch;
}

/// Flat patches of the sides of a cube of edge 1 with its least corner at a place, which look outwards.
std::vector<BezierPatch> cube_of_patches(const Vector3& place) {
  std::vector<BezierPatch> out;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) {
      BezierPatch patch;
      patch.degree_s = patch.degree_t = 1;
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
          Vector3 point = place;
          point[axis] += far ? 1 : 0;
          point[(axis + 1) % 3] += far ? i : j;
          point[(axis + 2) % 3] += far ? j : i;
          patch.points.push_back(point);
        }
      out.push_back(std::move(patch));
    }
  return out;
}

TEST(WeldPatches, BodiesThatTouchAlongAnEdgeStayClosedInAnyOrder) {
  test::for_random(20261127, 40, [](std::mt19937_64& rng) {
    std::vector<BezierPatch> patches = cube_of_patches(Vector3::Zero());
    for (BezierPatch& patch : cube_of_patches({1, 1, 0})) patches.push_back(std::move(patch));
    std::shuffle(patches.begin(), patches.end(), rng);
    const Surface surface = weld_patches(Vector3::Zero(), patches).value();
    EXPECT_TRUE(surface.boundary_sides().empty());
    EXPECT_EQ(surface.seams().size(), 24U);
    for (Index k = 0; k < surface.patch_count(); ++k) {
      const BezierPatch& given = patches[k];
      const Vector3 outwards =
          (given.points[1] - given.points[0]).cross(given.points[2] - given.points[0]).normalized();
      EXPECT_NEAR(surface.normal(k, {0.5, 0.5}).dot(outwards), 1, 1e-12) << "patch " << k << " is flipped";
    }
  });
}

TEST(WeldPatches, TJointsAreFoundHoweverManySidesAreFree) {
  // Each group is a square beside two halves.
  constexpr int groups = 800;
  std::vector<BezierPatch> patches;
  for (int k = 0; k < groups; ++k) {
    const double x = 3 * (k % 30), y = 3 * (k / 30);
    patches.push_back(square(x, y, 1, 1));
    patches.push_back(square(x + 1, y, 1, 0.5));
    patches.push_back(square(x + 1, y + 0.5, 1, 0.5));
  }
  const auto surface = test::must(weld_patches(Vector3::Zero(), patches));
  EXPECT_EQ(surface->seams().size(), 3U * groups);
  // The same groups one by one.
  const auto one = weld_patches(Vector3::Zero(), {patches.begin(), patches.begin() + 3});
  EXPECT_EQ(one->seams().size(), 3U);
}

}  // namespace
}  // namespace hariko
