// Random outlines, most of them bad: a result or a refusal, whatever the mode, density and step.

#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/gaussmap/sphere/gauss_sphere.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// Loops on an ellipsoid that lack some of their points, with noise on the normals of half of them.
Outline rough_outline(std::mt19937_64& rng) {
  const Truth truth = ellipsoid({uniform(rng, 0.5, 3), uniform(rng, 0.5, 3), uniform(rng, 0.5, 3)});
  Outline out;
  const std::size_t count = 1 + rng() % 3;
  for (std::size_t l = 0; l < count; ++l) {
    const double angle = count == 1 ? uniform(rng, 0.2, 2.2) : uniform(rng, 0.1, 0.7);
    const OutlineLoop whole = circle_of_normals(truth, random_vector(rng), angle, 6 + rng() % 30, count > 1);
    const double noise = rng() % 2 ? 0 : uniform(rng, 0, 0.03);
    OutlineLoop& loop = out.loops.emplace_back();
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
      if (rng() % 5 == 0) continue;
      loop.points.push_back(whole.points[i]);
      loop.normals.push_back(whole.normals[i] + random_vector(rng, noise));
      loop.curvature.push_back(whole.curvature[i]);
    }
  }
  return out;
}

TEST(RandomOutlines, AreFilledOrRefused) {
  int filled = 0, refused = 0;
  for_random(9603, 80, [&](std::mt19937_64& rng) {
    const Outline outline = rough_outline(rng);
    OutlineSettings settings;
    settings.mode = static_cast<GaussMode>(rng() % 4);
    settings.radius = uniform(rng, 0.25, 1.2);
    settings.most_points = 1 + static_cast<Index>(rng() % 300);
    const auto step = rng() % 2 ? std::optional(static_cast<Index>(rng() % 40)) : std::nullopt;
    const GaussSphere sphere = gauss_sphere(outline, settings, step);
    EXPECT_NE(sphere.error.has_value(), sphere.points.has_value());
    if (sphere.error) {
      ++refused;
      EXPECT_EQ(sphere.error->severity, Severity::error);
      return;
    }
    ++filled;
    for (const Vector3& point : sphere.points->points) ASSERT_TRUE(point.allFinite());
    for (const Vector3& normal : sphere.points->normals) EXPECT_NEAR(normal.norm(), 1, 1e-12);
    const auto polyhedron = must(outline_polyhedron(*sphere.points));
    EXPECT_EQ(polyhedron->polyhedron.vertex_count(), sphere.points->points.size());
    EXPECT_EQ(polyhedron->shaping.pin.size(), sphere.points->points.size());
    for (Index i = 0; sphere.mesh && i < sphere.mesh->site_count(); ++i) tangent_facet(sphere, i);
  });
  EXPECT_GT(filled, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace hariko::test
