// Control points of patches over facets: what is cut, what is sampled, what is bounded.

#include "core/approximation/net_distance.hpp"

#include "tests/approximation/surfaces.hpp"

namespace hariko::test {
namespace {

BezierPatch any_patch(std::mt19937_64& rng, bool rational) {
  BezierPatch patch;
  patch.degree_s = uniform_int(rng, 1, 6);
  patch.degree_t = uniform_int(rng, 1, 6);
  for (int j = 0; j <= patch.degree_t; ++j)
    for (int i = 0; i <= patch.degree_s; ++i) {
      patch.points.push_back(Vector3(double(i) / patch.degree_s, double(j) / patch.degree_t, 0) +
                             0.2 * random_vector(rng));
      if (rational) patch.weights.push_back(uniform(rng, 0.5, 2));
    }
  return patch;
}

/// A mesh of one facet over a random triangle of parameters.
ParameterMesh one_facet(std::mt19937_64& rng, const SurfaceSampler& sampler) {
  ParameterMesh mesh;
  ParameterFacet facet;
  const Vector2 at(uniform(rng, 0.2, 0.6), uniform(rng, 0.2, 0.6));
  facet.parameter = {Vector2(at + Vector2(uniform(rng, -0.2, 0), uniform(rng, -0.2, 0))),
                     Vector2(at + Vector2(uniform(rng, 0.1, 0.4), uniform(rng, -0.1, 0.1))),
                     Vector2(at + Vector2(uniform(rng, -0.1, 0.1), uniform(rng, 0.1, 0.4)))};
  for (Index c = 0; c < 3; ++c) {
    mesh.positions.push_back(sampler.position(0, facet.parameter[c]));
    facet.vertex[c] = c;
  }
  mesh.add_facet(facet);
  return mesh;
}

TEST(NetDistance, HalvesAreThePatchOverThem) {
  for_random(5100, 40, [](std::mt19937_64& rng) {
    const Surface surface = weld_patches(Vector3::Zero(), {any_patch(rng, false)}).value();
    const SurfaceSampler sampler(surface);
    ParameterMesh mesh = one_facet(rng, sampler);
    FacetNets nets(sampler);
    nets.make(mesh, 0);
    for (int cut = 0; cut < 6; ++cut) {
      const auto f = Index(uniform_int(rng, 0, int(mesh.facets.size()) - 1));
      const auto side = Index(uniform_int(rng, 0, 2));
      const Index h = 3 * f + side, other = mesh.twin[h];
      const double t = uniform(rng, 0.2, 0.8);
      const auto fraction = [&](Index half_edge) {
        return mesh.from(half_edge) < mesh.to(half_edge) ? t : 1 - t;
      };
      const double own = fraction(h), theirs = other == no_index ? 0 : fraction(other);
      const ParameterLine line = mesh.canonical_line(h);
      const auto made = mesh.split(h, t, sampler.position(0, line.at(t)));
      nets.split(mesh, made.facets[0], made.facets[1], int(side), own);
      if (other != no_index) nets.split(mesh, made.facets[2], made.facets[3], int(other % 3), theirs);
    }
    for (Index f = 0; f < mesh.facets.size(); ++f) {
      const FacetNet net = nets.of(0, f);
      ASSERT_NE(net.shape, nullptr);
      EXPECT_LT(net.radius, 1e-8);
      std::array<Vector3, TriangleNet::max_count> room;
      const FacetNet fresh = nets.made(mesh.facets[f], room);
      for (std::size_t k = 0; k < net.shape->count(); ++k)
        EXPECT_LT((net.points[k] - fresh.points[k]).norm(), net.radius + fresh.radius + 1e-12);
      std::array<Vector3, TriangleNet::sample_count> points;
      net.shape->samples(net.points, points);
      for (int s = 0; s < 3; ++s)
        for (int i = 0; i < 3; ++i) {
          const auto& w = mesh.facets[f].parameter;
          const Vector2 at =
              w[std::size_t(s)] + double(i + 1) / 4 * (w[std::size_t(s + 1) % 3] - w[std::size_t(s)]);
          EXPECT_LT((points[std::size_t(3 * s + i)] - sampler.position(0, at)).norm(), 1e-9);
        }
    }
  });
}

TEST(NetDistance, BoundsHoldAndAreTight) {
  for_random(5200, 40, [](std::mt19937_64& rng) {
    const Surface surface = weld_patches(Vector3::Zero(), {any_patch(rng, false)}).value();
    const SurfaceSampler sampler(surface);
    const ParameterMesh mesh = one_facet(rng, sampler);
    std::array<Vector3, TriangleNet::max_count> room;
    const FacetNet net = FacetNets(sampler).made(mesh.facets[0], room);
    const NetDistance::Sides sides{0, NetDistance::no_side, 2};
    NetDistance distance(mesh.corners(0), net, sides);
    const ClosedTriangle triangle(mesh.corners(0));
    double truth = 0;
    constexpr int density = 40;
    for (int j = 0; j <= density; ++j)
      for (int i = 0; i + j <= density; ++i) {
        const Vector3 p = sampler.position(
            0, at_barycentric(mesh.facets[0].parameter, double(i) / density, double(j) / density));
        truth = std::max(truth, triangle.distance(p));
        const auto c = mesh.corners(0);
        if (j == 0) truth = std::max(truth, std::sqrt(squared_distance_to_segment(p, c[0], c[1])));
        if (i == 0) truth = std::max(truth, std::sqrt(squared_distance_to_segment(p, c[2], c[0])));
      }
    const auto range = distance.measure();
    EXPECT_GE(range.bound, truth * (1 - 1e-9));
    EXPECT_LE(range.bound, 1.03 * truth);
    EXPECT_LE(range.sampled, range.bound);
    EXPECT_LE(distance.sampled(), range.bound);
    EXPECT_GE(distance.sampled(), 0.6 * truth);
    // The decision: certain where it says yes, and no only where the truth is near the tolerance or beyond.
    // It cuts two levels less than the measure, whose bound is 3% off at most: the gap is four times that.
    for (const double factor : {0.5, 0.9, 1.15, 1.5, 3.0}) {
      const double bound = distance.decide(factor * truth);
      const bool within = bound <= factor * truth;
      EXPECT_EQ(within, factor > 1) << factor;
      EXPECT_TRUE(!within || bound >= truth * (1 - 1e-9)) << factor;
    }
  });
}

TEST(NetDistance, OnlyPolynomialsHaveNets) {
  std::mt19937_64 rng(5300);
  const Surface rational = weld_patches(Vector3::Zero(), {any_patch(rng, true)}).value();
  EXPECT_EQ(polynomial_degree(rational.patches(), 0), 0);
  const SurfaceSampler sampler(rational);
  const ParameterMesh mesh = one_facet(rng, sampler);
  FacetNets nets(sampler);
  EXPECT_FALSE(nets.possible(mesh.facets[0]));
  nets.make(mesh, 0);
  EXPECT_EQ(nets.of(0, 0).shape, nullptr);
}

}  // namespace
}  // namespace hariko::test
