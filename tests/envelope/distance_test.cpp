// Distances to solids with their gradients, and the search for the nearest sample.

#include <Eigen/Geometry>

#include "core/envelope/sample_tree.hpp"
#include "core/envelope/solid_distance.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

/// Not unit where the distance has a kink within the step.
Vector3 differences(const SolidDistance& solid, const Vector3& point, double step) {
  Vector3 out;
  for (int i = 0; i < 3; ++i) {
    const Vector3 h = step * Vector3::Unit(i);
    out[i] = (solid(point + h) - solid(point - h)) / (2 * step);
  }
  return out;
}

}  // namespace

TEST(SolidDistance, TheGradientIsThatOfDifferences) {
  int compared = 0, kinks = 0;
  for_random(41, 12, [&](std::mt19937_64& rng) {
    EnvelopeInput scene = random_scene(rng);
    for (Solid& solid : scene.solids) {
      if (chance(rng, 0.4))
        solid.scale = {log_uniform(rng, 0.5, 2), log_uniform(rng, 0.5, 2), log_uniform(rng, 0.5, 2)};
      const SolidDistance distance(solid, uniform(rng, 0, 0.1), Vector3::Zero());
      const double step = 1e-6 * distance.reach();
      for (int k = 0; k < 40; ++k) {
        const Vector3 p = distance.centre() + random_vector(rng, 1.5 * distance.reach());
        const Vector3 gradient = distance.gradient(p);
        EXPECT_NEAR(gradient.norm(), 1, 1e-12);
        const Vector3 wanted = differences(distance, p, step);
        if (std::abs(wanted.norm() - 1) > 1e-4) {
          ++kinks;
          continue;
        }
        ++compared;
        EXPECT_LT((gradient - wanted).norm(), 1e-3) << int(solid.kind);
      }
    }
  });
  EXPECT_GT(compared, 100 * kinks);
}

TEST(SolidDistance, WhereFacesAreEquallyNearTheGradientLiesBetweenThem) {
  const SolidDistance box({.size = {2, 2, 4}}, 0, Vector3::Zero());
  EXPECT_LT((box.gradient({0.5, -0.5, 0.3}) - Vector3(1, -1, 0).normalized()).norm(), 1e-12);
  EXPECT_TRUE(box.gradient({0, 0, 0}).isZero(0));
  const SolidDistance prism({.kind = SolidKind::prism, .radius = 1, .height = 4, .sides = 4}, 0,
                            Vector3::Zero());
  // The edge at (1, 0) from inside.
  EXPECT_LT((prism.gradient({0.7, 0, 0}) - Vector3::UnitX()).norm(), 1e-9);
  const SolidDistance cylinder({.kind = SolidKind::cylinder, .radius = 1, .height = 2}, 0, Vector3::Zero());
  EXPECT_LT((cylinder.gradient({0, 0.8, 0.8}) - Vector3(0, 1, 1).normalized()).norm(), 1e-12);
}

TEST(SolidDistance, TheNearestOfManyIsTheFirstWithTheLeastDistance) {
  for_random(43, 12, [](std::mt19937_64& rng) {
    std::vector<SolidDistance> solids;
    for (const Solid& solid : random_scene(rng).solids)
      for (int twice = 0; twice < 2; ++twice)
        solids.emplace_back(solid, uniform(rng, 0, 0.1), Vector3::Zero());
    for (int k = 0; k < 40; ++k) {
      const Vector3 p = random_vector(rng, 5);
      std::vector<double> distances;
      for (const SolidDistance& solid : solids) distances.push_back(solid(p));
      const auto least = std::ranges::min_element(distances);
      EXPECT_EQ(nearest_solid(solids, p), std::pair(Index(least - distances.begin()), *least));
    }
  });
  EXPECT_EQ(nearest_solid({}, Vector3::Zero()), std::pair(Index(0), 1e300));
}

TEST(UnionField, OnOneSideOfABallAllValuesAreOnThatSide) {
  std::map<int, int> counts;
  for_random(44, 12, [&](std::mt19937_64& rng) {
    const std::vector<Solid> scene = random_scene(rng).solids;
    std::vector<SolidDistance> solids;
    for (const Solid& solid : scene) solids.emplace_back(solid, 0, Vector3::Zero());
    UnionField::Factors factors;
    if (solids.size() > 1) factors[{0, 1}] = 2;
    const UnionField field(solids, log_uniform(rng, 0.02, 0.5), factors);
    for (int k = 0; k < 200; ++k) {
      const SolidDistance& near = solids[std::size_t(k) % solids.size()];
      const Vector3 centre = near.centre() + random_vector(rng, near.reach());
      const double radius = log_uniform(rng, 0.02, 1) * near.reach();
      const double above = chance(rng, 0.5) ? 0 : log_uniform(rng, 0.01, 0.5);
      const int side = field.side(centre, radius, above);
      ++counts[side];
      for (int j = 0; side != 0 && j < 20; ++j) {
        // As many near the rim as inside.
        Vector3 way = random_vector(rng, radius);
        if (j % 2 == 0 || way.norm() > radius) way = radius * way.stableNormalized();
        EXPECT_TRUE(side < 0 ? field(centre + way) < 0 : field(centre + way) >= above);
      }
    }
  });
  EXPECT_GT(counts[-1], 10);
  EXPECT_GT(counts[1], 10);
}

TEST(SampleTree, FindsWhatComparingEverythingFinds) {
  for_random(42, 30, [](std::mt19937_64& rng) {
    const std::size_t per_patch = std::size_t(uniform_int(rng, 1, 28));
    std::vector<Vector3> positions;
    for (int p = uniform_int(rng, 1, 60); p > 0; --p) {
      const Vector3 centre = random_vector(rng, 3);
      // Some samples are shared, as those of seams are.
      for (std::size_t i = 0; i < per_patch; ++i)
        positions.push_back(!positions.empty() && chance(rng, 0.2)
                                ? positions[std::size_t(uniform_int(rng, 0, int(positions.size()) - 1))]
                                : Vector3(centre + random_vector(rng, 0.5)));
    }
    const SampleTree tree(positions, per_patch);
    for (int k = 0; k < 40; ++k) {
      const Vector3 z = random_vector(rng, 4);
      std::size_t best = 0;
      for (std::size_t i = 1; i < positions.size(); ++i)
        if ((positions[i] - z).squaredNorm() < (positions[best] - z).squaredNorm()) best = i;
      EXPECT_EQ(tree.nearest(z), best);
      // All patches with a sample within the radius are visited, none twice.
      const double radius = uniform(rng, 0, 2);
      std::vector<int> visits(positions.size() / per_patch, 0);
      tree.visit([&](const Vector3& centre, double r) { return (centre - z).norm() > r + radius; },
                 [&](Index p) { ++visits[p]; });
      for (std::size_t i = 0; i < positions.size(); ++i)
        if ((positions[i] - z).norm() <= radius) {
          EXPECT_EQ(visits[i / per_patch], 1);
        }
      EXPECT_LE(*std::max_element(visits.begin(), visits.end()), 1);
    }
  });
}

}  // namespace hariko::test
