// Sites spread evenly: the triangulation stays Delaunay inside its loops, and cells become alike.

#include "core/gaussmap/sphere/lloyd_relaxed_sites.hpp"

#include <Eigen/Geometry>
#include <map>

#include "core/gaussmap/sphere/delaunay_refinement.hpp"
#include "core/geometry/orientation.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace test;

SphereMesh inserted(const std::vector<std::vector<Vector3>>& loops) {
  auto begun = must(SiteInsertion::begin(loops));
  SiteInsertion insertion = std::move(begun).value();
  while (insertion.insert_next(0.6 * insertion.boundary_spacing())) {
  }
  return insertion.mesh();
}

std::vector<Vector3> wavy_loop(std::mt19937_64& rng, int count) {
  const double a = uniform(rng, 0, 0.15), b = uniform(rng, 0, 6), c = uniform(rng, 0.7, 1.3);
  std::vector<Vector3> out;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * pi * i / count, polar = c + a * std::cos(3 * t + b);
    out.emplace_back(std::sin(polar) * std::cos(t), std::sin(polar) * std::sin(t), std::cos(polar));
  }
  return out;
}

/// Root mean square of the distances of the inner sites from the middles of their cells, over the median arc.
double unevenness(const SphereMesh& mesh) {
  double sum = 0;
  for (Index i = mesh.boundary_count(); i < mesh.site_count(); ++i) {
    Vector3 middle = Vector3::Zero();
    const std::vector<Vector3> cell = mesh.cell(i);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Vector3 &a = cell[k], &b = cell[(k + 1) % cell.size()];
      middle += solid_angle(mesh.site(i), a, b) * (mesh.site(i) + a + b);
    }
    sum += (middle.normalized() - mesh.site(i)).squaredNorm();
  }
  return std::sqrt(sum / mesh.inner_count());
}

void expect_delaunay(const SphereMesh& mesh) {
  std::map<std::pair<Index, Index>, Index> opposite;
  for (const auto& [a, b, c] : mesh.triangles()) {
    EXPECT_GT(side_of_plane(Vector3::Zero(), mesh.site(a), mesh.site(b), mesh.site(c)), 0);
    opposite[{a, b}] = c;
    opposite[{b, c}] = a;
    opposite[{c, a}] = b;
  }
  for (const auto& [edge, corner] : opposite) {
    const auto other = opposite.find({edge.second, edge.first});
    if (other == opposite.end()) {
      EXPECT_EQ(mesh.next(edge.first), edge.second);
    } else {
      EXPECT_LE(side_of_plane(mesh.site(edge.first), mesh.site(edge.second), mesh.site(corner),
                              mesh.site(other->second)),
                0);
    }
  }
}

double total_angle(const SphereMesh& mesh) {
  double sum = 0;
  for (Index i = 0; i < mesh.site_count(); ++i) sum += mesh.solid_angle(i);
  return sum;
}

TEST(RelaxSites, CellsBecomeEvenAndTheLoopsStay) {
  for_random(9601, 4, [](std::mt19937_64& rng) {
    const SphereMesh before = inserted({wavy_loop(rng, 28)});
    const SphereMesh after = relaxed(before, 10);
    ASSERT_EQ(after.site_count(), before.site_count());
    ASSERT_EQ(after.triangles().size(), before.triangles().size());
    for (Index i = 0; i < before.boundary_count(); ++i) {
      EXPECT_EQ(after.site(i), before.site(i));
      EXPECT_EQ(after.next(i), before.next(i));
    }
    for (const Vector3& site : after.sites()) EXPECT_NEAR(site.norm(), 1, 1e-14);
    expect_delaunay(after);
    EXPECT_LT(unevenness(after), 0.4 * unevenness(before));
    EXPECT_NEAR(total_angle(after), total_angle(before), 1e-10);
    EXPECT_EQ(relaxed(before, 10).sites(), after.sites());
  });
}

TEST(RelaxSites, HolesStay) {
  std::vector<std::vector<Vector3>> loops;
  for (const OutlineLoop& loop : three_holes(Vector3::Ones(), 14, "").outline.loops)
    loops.push_back(loop.normals);
  const SphereMesh before = inserted(loops), after = relaxed(before, 10);
  expect_delaunay(after);
  EXPECT_NEAR(total_angle(after), total_angle(before), 1e-10);
  EXPECT_LT(unevenness(after), 0.4 * unevenness(before));
}

TEST(RelaxSites, NoRoundChangesNothing) {
  std::mt19937_64 rng(9602);
  const SphereMesh before = inserted({wavy_loop(rng, 20)}), after = relaxed(before, 0);
  EXPECT_EQ(after.sites(), before.sites());
  EXPECT_EQ(after.triangles(), before.triangles());
}

}  // namespace
}  // namespace hariko
