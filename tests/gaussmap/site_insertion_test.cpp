#include "core/gaussmap/sphere/delaunay_refinement.hpp"

#include "core/geometry/angles.hpp"
#include "core/geometry/orientation.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// A wavy circle round a random axis, the image inside.
std::vector<Vector3> wavy_loop(std::mt19937_64& rng, std::size_t count, double angle, double waves) {
  const Vector3 axis = test::random_vector(rng).normalized(), u = axis.unitOrthogonal(), w = axis.cross(u);
  const double phase = uniform(rng, 0, 6);
  std::vector<Vector3> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2 * test::pi * double(i) / double(count);
    const double polar = angle * (1 + waves * std::cos(3 * t + phase));
    out.push_back(std::cos(polar) * axis + std::sin(polar) * (std::cos(t) * u + std::sin(t) * w));
  }
  return out;
}

void expect_delaunay_inside(const SphereMesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles())
    for (const Vector3& site : mesh.sites())
      EXPECT_LE(side_of_plane(mesh.site(a), mesh.site(b), mesh.site(c), site), 0)
          << "a site in a triangle's circle";
}

/// Solid angle of the image, by the Gauss-Bonnet theorem for the geodesic polygons of the loops, modulo 4 pi.
double image_area(const SphereMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles())
    area += solid_angle(mesh.site(a), mesh.site(b), mesh.site(c));
  return area;
}
double area_by_angles(const SphereMesh& mesh, int loops) {
  double turning = 0;
  for (Index i = 0; i < mesh.boundary_count(); ++i) {
    const Vector3 &n = mesh.site(i), in = n - mesh.site(mesh.previous(i)), out = mesh.site(mesh.next(i)) - n;
    const Vector3 u = in - in.dot(n) * n, v = out - out.dot(n) * n;
    turning += std::atan2(n.dot(u.cross(v)), u.dot(v));
  }
  return 2 * test::pi * (2 - loops) - turning;
}

TEST(SiteInsertion, IsDelaunayInsideOfRandomLoopsAndKeepsTheirEdges) {
  test::for_random(9201, 12, [](std::mt19937_64& rng) {
    const auto loop = wavy_loop(rng, std::size_t(test::uniform_int(rng, 12, 40)), uniform(rng, 0.4, 2), 0.1);
    auto begun = test::must(SiteInsertion::begin({loop}));
    SiteInsertion insertion = std::move(begun).value();
    const double smallest = 0.6 * insertion.boundary_spacing();
    for (int i = 0; i < 200 && insertion.insert_next(smallest); ++i) {
    }
    const SphereMesh mesh = insertion.mesh();
    expect_delaunay_inside(mesh);
    for (Index i = 0; i < mesh.boundary_count(); ++i) {
      EXPECT_EQ(mesh.ring(i).neighbours.front(), mesh.next(i));
      EXPECT_EQ(mesh.ring(i).neighbours.back(), mesh.previous(i));
    }
    // A disc: V - E + F = 1
    EXPECT_EQ(mesh.triangles().size(), 2 * mesh.site_count() - mesh.boundary_count() - 2);
  });
}

TEST(SiteInsertion, CellsPartitionTheImage) {
  for (const auto& [name, loops] :
       {std::pair{"sphere_cap", 1}, {"ellipsoid_cap", 1}, {"sphere_band", 2}, {"three_holes", 3}}) {
    SCOPED_TRACE(name);
    auto begun = test::must(SiteInsertion::begin(unit_normals(golden_outline(name))));
    SiteInsertion insertion = std::move(begun).value();
    for (int i = 0; i < 60 && insertion.insert_next(0.6 * insertion.boundary_spacing()); ++i) {
    }
    const SphereMesh mesh = insertion.mesh();
    double cells = 0;
    for (Index i = 0; i < mesh.site_count(); ++i) cells += mesh.solid_angle(i);
    EXPECT_NEAR(cells, image_area(mesh), 1e-12);
    EXPECT_NEAR(cells, area_by_angles(mesh, loops), 1e-10);
  }
}

TEST(SiteInsertion, EachSiteIsTheCentreOfTheLargestEmptyCircle) {
  auto begun = SiteInsertion::begin(unit_normals(golden_outline("three_holes")));
  ASSERT_TRUE(begun);
  SiteInsertion insertion = std::move(begun).value();
  double before = 10;
  for (int i = 0; i < 100; ++i) {
    const double radius = insertion.largest_radius();
    const SphereMesh mesh = insertion.mesh();
    if (!insertion.insert_next(0.6 * insertion.boundary_spacing())) break;
    const Vector3 site = insertion.mesh().sites().back();
    double nearest = 10;
    for (const Vector3& other : mesh.sites()) nearest = std::min(nearest, angle_between(site, other));
    EXPECT_NEAR(nearest, radius, 1e-12);
    EXPECT_LE(radius, before + 1e-12);
    before = radius;
  }
}

TEST(SiteInsertion, SitesKeepTheirDistance) {
  test::for_random(9202, 6, [](std::mt19937_64& rng) {
    const auto loop = wavy_loop(rng, 24, uniform(rng, 0.4, 1.5), 0.05);
    auto begun = SiteInsertion::begin({loop});
    ASSERT_TRUE(begun);
    SiteInsertion insertion = std::move(begun).value();
    const double smallest = 0.6 * insertion.boundary_spacing();
    int count = 0;
    while (insertion.insert_next(smallest)) ASSERT_LT(++count, 5000) << "insertion does not end";
    const SphereMesh mesh = insertion.mesh();
    for (Index i = mesh.boundary_count(); i < mesh.site_count(); ++i)
      for (Index k = 0; k < i; ++k)
        EXPECT_GE(angle_between(mesh.site(i), mesh.site(k)), smallest * (1 - 1e-9));
  });
}

TEST(SiteInsertion, MissingEdgesAndLeaksAreNamed) {
  // A coarse loop between two dense ones that come close to its arcs from both sides.
  const test::Truth sphere = test::ellipsoid(Vector3::Ones());
  const auto circle = [&](double angle, std::size_t count, bool clockwise) {
    return test::circle_of_normals(sphere, Vector3::UnitZ(), angle, count, clockwise).normals;
  };
  const auto coarse =
      SiteInsertion::begin({circle(0.55, 48, false), circle(0.5, 8, true), circle(0.42, 48, false)});
  test::must_fail(coarse, e_boundary_edge);
  EXPECT_NE(coarse.error().text.find("of loop"), std::string::npos) << coarse.error().text;
  // The band's upper loop turned the wrong way: the image is on both sides of it.
  const auto leak = SiteInsertion::begin({circle(1.4, 24, false), circle(0.7, 18, false)});
  test::must_fail(leak, e_image_leak);
  EXPECT_EQ(leak.error().element.kind, Element::Kind::vertex);
  EXPECT_NE(leak.error().text.find("point"), std::string::npos) << leak.error().text;
}

}  // namespace
}  // namespace hariko::test
