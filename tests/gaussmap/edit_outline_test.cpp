#include "core/gaussmap/outlines/edit_outline.hpp"

#include "core/gaussmap/outlines/interpolate_normals.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "core/geometry/angles.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

double slant(const OutlineLoop& loop, std::size_t i) {
  return std::abs(loop.normals[i].normalized().dot(loop_tangents(loop.points)[i]));
}

TEST(EditOutline, NormalsTurnWithTheLoop) {
  for_random(9450, 30, [](std::mt19937_64& rng) {
    const Outline band = sphere_band(32).outline;
    const auto moved = Index(uniform_int(rng, 0, 55));
    const OutlinePoint at = outline_point(band, moved);
    const Vector3 to = band.loops[at.loop].points[at.place] + random_vector(rng, 0.05);
    const Outline out = with_points(band, std::array{moved}, std::array{to});
    EXPECT_EQ(out.loops[at.loop].points[at.place], to);
    const std::size_t count = band.loops[at.loop].points.size();
    for (std::size_t l = 0; l < 2; ++l)
      for (std::size_t i = 0; i < band.loops[l].points.size(); ++i) {
        EXPECT_LE(slant(out.loops[l], i), 1e-9);
        EXPECT_NEAR(out.loops[l].normals[i].norm(), 1, 1e-12);
        const bool near = l == at.loop && (i == (at.place + 1) % count || (i + 1) % count == at.place);
        if (!near) {
          EXPECT_EQ(out.loops[l].normals[i], band.loops[l].normals[i]);
        }
      }
  });
}

TEST(EditOutline, TiltingGoesAwayFromTheSurface) {
  const Outline cap = sphere_cap(24).outline;
  const Outline out = tilted(cap, {0, 5, 6}, 0.2);
  for (std::size_t i = 0; i < 24; ++i) {
    const Vector3 &before = cap.loops[0].normals[i], &after = out.loops[0].normals[i];
    if (i != 0 && i != 5 && i != 6) {
      EXPECT_EQ(before, after);
      continue;
    }
    EXPECT_NEAR(angle_between(before, after), 0.2, 1e-12);
    EXPECT_LT(after.z(), before.z());  // the cap is above its rim
    EXPECT_LE(slant(out.loops[0], i), 1e-12);
  }
}

TEST(EditOutline, SpreadsALoopFromTheGivenPoints) {
  Outline band = sphere_band(32).outline;
  const Outline before = band;
  for (std::size_t i = 0; i < 32; ++i)
    if (i % 8 != 0) band.loops[0].normals[i] = Vector3::UnitZ();
  const Outline out = with_spread_normals(band, {0, 8, 16, 24});
  for (std::size_t i = 0; i < 32; ++i)
    EXPECT_LE((out.loops[0].normals[i] - before.loops[0].normals[i]).norm(), 1e-9);
  EXPECT_EQ(out.loops[1], before.loops[1]);
}

TEST(EditOutline, PointsComeAndGo) {
  const Outline band = sphere_band(16).outline;  // 16 and 12
  const auto more = must(with_point_after(band, 20));
  EXPECT_EQ(more->loops[0], band.loops[0]);
  EXPECT_EQ(more->loops[1].points.size(), 13u);
  EXPECT_EQ(more->loops[1].points[4], band.loops[1].points[4]);
  const auto back = must(without_points(*more, {21}));
  EXPECT_EQ(*back, band);
  std::set<Index> second = whole_loops(band, {17});
  EXPECT_EQ(second.size(), 12u);
  EXPECT_EQ(*second.begin(), 16u);
  const auto one = must(without_points(band, {17, 18, 19, 20, 21, 22, 23, 24, 25}));
  ASSERT_EQ(one->loops.size(), 1u);
  EXPECT_EQ(one->loops[0], band.loops[0]);
  EXPECT_EQ(with_loop(*one, band.loops[1]), band);
  OutlineLoop bare = band.loops[1];
  bare.curvature.clear();
  for (const OutlineLoop& loop : with_loop(*one, bare).loops) EXPECT_TRUE(loop.curvature.empty());
  EXPECT_EQ(without_points(*one, whole_loops(*one, {0})).error().code, e_outline_too_few);
}

TEST(EditOutline, DistancesGoRoundTheLoopTheShorterWay) {
  const Outline band = sphere_band(16).outline;  // 16 and 12
  const auto distances = distances_along(band, {3, 12});
  ASSERT_EQ(distances.size(), 28u);
  const double step = (band.loops[0].points[1] - band.loops[0].points[0]).norm();
  const std::array<int, 16> steps{3, 2, 1, 0, 1, 2, 3, 4, 4, 3, 2, 1, 0, 1, 2, 3};
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(distances[i], steps[i] * step, 1e-12) << i;
  for (std::size_t i = 16; i < 28; ++i) EXPECT_EQ(distances[i], HUGE_VAL);
}

TEST(EditOutline, ResamplesAllLoopsAndNamesThePointThatIsWrong) {
  Outline band = sphere_band(16).outline;
  const auto made = must(resampled(band, 20, LoopMeasure::gauss_arc));
  EXPECT_EQ(made->point_count(), 40u);
  band.loops[1].points[3] = band.loops[1].points[2];
  const auto bad = resampled(band, 20, LoopMeasure::arc);
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().element, element_of(VertexId{18}));
  EXPECT_EQ(with_point_after(band, 17).error().element, element_of(VertexId{18}));
}

TEST(EditOutline, InsideOutIsTheSameSurfaceFromBehind) {
  const Outline saddle = golden_outline("saddle");
  const Outline behind = turned_inside_out(saddle);
  EXPECT_EQ(turned_inside_out(behind), saddle);
  GaussOptions options = in_mode(GaussMode::position);
  const auto front = must(control_points(saddle, options)), back = must(control_points(behind, options));
  const Truth truth = test::saddle_truth();
  for (const Vector3& point : back->points) EXPECT_LE((truth.foot(point).point - point).norm(), 5e-3);
}

}  // namespace
}  // namespace hariko::test
