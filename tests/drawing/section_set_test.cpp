// Sections of spheres, tori and facets: circles of the right radius with teeth of the right length.

#include "core/drawing/section_set.hpp"

#include <cmath>
#include <numbers>

#include "core/drawing/write_section_set.hpp"
#include "core/surface/facets.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

DrawnSurface moved(Surface surface, const Vector3& at, double scale) {
  DrawnSurface out{std::move(surface)};
  out.transform.translate(at).scale(scale);
  return out;
}

/// Triangles of a cylinder about z without lids, from z = 0 to a height.
Surface cylinder_of_facets(double radius, double height, Index around, Index rows) {
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      positions.push_back({radius * std::cos(angle), radius * std::sin(angle), height * j / rows});
    }
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < around; ++i) {
      const Index a = j * around + i, b = j * around + (i + 1) % around;
      triangles.push_back({a, b, b + around});
      triangles.push_back({a, b + around, a + around});
    }
  const std::vector<Element> sources(triangles.size());
  return facet_surface(Vector3::Zero(), positions, std::move(triangles), sources);
}

double length_of_curve(const SectionCurve& curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    length += (curve.points[i] - curve.points[i - 1]).norm();
  return length;
}

TEST(SectionSet, PlanesCutASphereInCirclesWithTheirOwnCurvature) {
  test::for_random(20261127, 6, [](std::mt19937_64& rng) {
    const auto real = [&](double low, double high) { return test::uniform(rng, low, high); };
    const double radius = real(0.5, 20), scale = real(0.2, 3);
    const Vector3 centre(real(-50, 50), real(-50, 50), real(-50, 50));
    const Vector3 direction = Vector3(real(-1, 1), real(-1, 1), real(0.1, 1)).normalized();
    const double r = radius * scale;
    SectionPlanes planes;
    planes.direction = direction;
    planes.count = 5;
    planes.spacing = 0.35 * r;
    planes.first = direction.dot(centre) - 0.7 * r;
    const DrawnSurface drawn = moved(test::sphere(radius), centre, scale);
    const auto set = test::must(section_set(std::span(&drawn, 1), planes));
    ASSERT_EQ(set->curves.size(), 5U);
    for (const SectionCurve& curve : set->curves) {
      const double height = planes.offset(curve.plane) - direction.dot(centre);
      const double ring = std::sqrt(r * r - height * height);
      const Vector3 middle = centre + height * direction;
      EXPECT_TRUE(curve.closed);
      EXPECT_NEAR(length_of_curve(curve), 2 * std::numbers::pi * ring, 2e-3 * r);
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        EXPECT_NEAR(direction.dot(curve.points[i]), planes.offset(curve.plane), 1e-7 * r);
        EXPECT_NEAR((curve.points[i] - middle).norm(), ring, 1e-7 * r);
        const Vector3 outwards = (curve.points[i] - middle) / ring;
        EXPECT_LT((curve.teeth[i] - outwards / ring).norm(), 1e-4 / ring);
      }
    }
    // The outermost circles are the smallest: cos of asin 0.7.
    EXPECT_NEAR(set->greatest, 1 / (r * std::sqrt(1 - 0.49)), 1e-4 / r);
  });
}

TEST(SectionSet, ThePlaneAcrossATorusCutsItsTubeTwice) {
  const DrawnSurface drawn = moved(test::torus(3, 1, 6, 5), Vector3::Zero(), 1);
  SectionPlanes planes;
  planes.direction = Vector3::UnitX();
  planes.count = 1;
  planes.first = 0;
  const auto set = test::must(section_set(std::span(&drawn, 1), planes));
  ASSERT_EQ(set->curves.size(), 2U);
  for (const SectionCurve& curve : set->curves) {
    EXPECT_NEAR(length_of_curve(curve), 2 * std::numbers::pi, 1e-3);
    for (const Vector3& tooth : curve.teeth) EXPECT_NEAR(tooth.norm(), 1, 1e-5);
  }
}

TEST(SectionSet, ScansHaveTheCurvatureOfTheirFacets) {
  const double radius = 4;
  const DrawnSurface drawn = moved(cylinder_of_facets(radius, 10, 180, 7), Vector3(1, 2, 3), 1);
  SectionPlanes planes;
  planes.direction = Vector3::UnitZ();
  planes.first = 4.3;
  planes.spacing = 2.5;
  planes.count = 3;
  const auto set = test::must(section_set(std::span(&drawn, 1), planes));
  ASSERT_EQ(set->curves.size(), 3U);
  for (const SectionCurve& curve : set->curves) {
    EXPECT_TRUE(curve.closed);
    EXPECT_NEAR(length_of_curve(curve), 2 * std::numbers::pi * radius, 0.01);
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const Vector3 outwards = (curve.points[i] - Vector3(1, 2, curve.points[i].z())).normalized();
      EXPECT_NEAR(curve.teeth[i].dot(outwards), 1 / radius, 0.03 / radius);
    }
  }
  // Along the axis: straight, open curves, without teeth.
  planes.direction = Vector3::UnitX();
  planes.first = 1 + 0.3;
  planes.count = 1;
  const auto straight = test::must(section_set(std::span(&drawn, 1), planes));
  ASSERT_EQ(straight->curves.size(), 2U);
  for (const SectionCurve& curve : straight->curves) {
    EXPECT_FALSE(curve.closed);
    EXPECT_NEAR(length_of_curve(curve), 10, 1e-6);
    for (const Vector3& tooth : curve.teeth) EXPECT_LT(tooth.norm(), 1e-5);
  }
}

TEST(SectionSet, CombsOfAllObjectsHaveOneScale) {
  const std::vector<DrawnSurface> drawn{moved(test::sphere(1), Vector3(-10, 0, 0), 1),
                                        moved(test::sphere(1), Vector3(10, 0, 0), 4)};
  SectionPlanes planes;
  planes.direction = Vector3::UnitZ();
  planes.first = 0;
  planes.count = 1;
  const auto set = test::must(section_set(drawn, planes));
  ASSERT_EQ(set->curves.size(), 2U);
  const double length = tooth_length(*set, 1);
  ASSERT_GT(length, 0);
  EXPECT_NEAR(tooth_length(*set, 2.5), 2.5 * length, 1e-12);
  EXPECT_LE(length * set->greatest, 0.15 * set->size * (1 + 1e-9));
  for (const SectionCurve& curve : set->curves) {
    const double radius = curve.surface == 0 ? 1 : 4;
    const CombShape comb = comb_shape(curve, set->size, length);
    const double steps = 2 * std::numbers::pi * radius / (set->size / 150);
    EXPECT_NEAR(double(comb.teeth.size()), steps, 3) << "teeth at equal steps of the arc length";
    EXPECT_EQ(comb.tips.size(), curve.points.size());
    for (const auto& [foot, tip] : comb.teeth)
      EXPECT_NEAR((tip - foot).norm(), length / radius, 1e-3 * length);
    for (std::size_t i = 1; i < comb.teeth.size(); ++i)
      EXPECT_NEAR((comb.teeth[i][0] - comb.teeth[i - 1][0]).norm(),
                  2 * std::numbers::pi * radius / double(comb.teeth.size() - 1), 0.02 * radius);
  }
}

TEST(SectionSet, PlanesAreSpreadOverTheBox) {
  const Eigen::AlignedBox3d box(Vector3(1, 2, 3), Vector3(11, 4, 9));
  const SectionPlanes planes = spread_planes(Vector3::UnitX(), 5, box);
  EXPECT_DOUBLE_EQ(planes.spacing, 2);
  EXPECT_DOUBLE_EQ(planes.offset(0), 2);
  EXPECT_DOUBLE_EQ(planes.offset(4), 10);
  for (const Vector3& direction : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(0, 0, -1)}) {
    const Matrix3 axes = section_axes(direction);
    EXPECT_NEAR(axes.determinant(), 1, 1e-12);
    EXPECT_EQ(Vector3(axes.col(2)), direction);
    EXPECT_TRUE(axes(2, 1) > 0.5 || axes(1, 1) > 0.5) << "upright";
  }
}

TEST(SectionSet, WhatCannotBeCutIsSaid) {
  const DrawnSurface drawn = moved(test::sphere(1), Vector3::Zero(), 1);
  SectionPlanes planes{.first = 5, .count = 3};
  EXPECT_EQ(section_set(std::span(&drawn, 1), planes).error().code, e_sections_empty);
  planes.count = 0;
  EXPECT_EQ(section_set(std::span(&drawn, 1), planes).error().code, e_sections_planes);
  planes.count = 2;
  planes.spacing = 0;
  EXPECT_EQ(section_set(std::span(&drawn, 1), planes).error().code, e_sections_planes);
  planes = {};
  planes.direction = {1, 1, 0};
  EXPECT_EQ(section_set(std::span(&drawn, 1), planes).error().code, e_sections_planes);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(section_set(std::span(&drawn, 1), {}, cancel).error().code, e_cancelled);
}

TEST(SectionSet, FilesAreAtFullSizeInMillimetres) {
  // A sphere 2 cm across in a document of centimetres: its great circle is 20 mm wide.
  const DrawnSurface drawn = moved(test::sphere(1), Vector3(3, 4, 5), 1);
  SectionPlanes planes;
  planes.direction = Vector3::UnitZ();
  planes.first = 5;
  planes.count = 1;
  const auto set = test::must(section_set(std::span(&drawn, 1), planes));
  const std::string svg = write_sections_svg(*set, {false, 1}, 10);
  EXPECT_NE(svg.find("width=\"30mm\" height=\"30mm\""), std::string::npos) << svg.substr(0, 300);
  EXPECT_NE(svg.find("id=\"section-1\""), std::string::npos);
  EXPECT_EQ(svg.find("comb-1"), std::string::npos);
  EXPECT_NE(write_sections_svg(*set, {true, 1}, 10).find("id=\"comb-1\""), std::string::npos);
  const std::string dxf = write_sections_dxf(*set, {false, 1}, 10);
  EXPECT_NE(dxf.find("0\nPOLYLINE\n8\nSECTION_1\n"), std::string::npos);
  EXPECT_NE(dxf.find("70\n9\n"), std::string::npos) << "closed, in space";
  // x between 20 and 40, z = 50 everywhere.
  double low = 1e9, high = -1e9;
  for (std::size_t at = dxf.find("VERTEX"); at != std::string::npos; at = dxf.find("VERTEX", at + 1)) {
    const std::size_t x = dxf.find("\n10\n", at) + 4, z = dxf.find("\n30\n", at) + 4;
    low = std::min(low, std::stod(dxf.substr(x)));
    high = std::max(high, std::stod(dxf.substr(x)));
    EXPECT_NEAR(std::stod(dxf.substr(z)), 50, 1e-6);
  }
  EXPECT_NEAR(low, 20, 0.01);
  EXPECT_NEAR(high, 40, 0.01);
}

}  // namespace
}  // namespace hariko
