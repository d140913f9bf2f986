// Meshes with as few facets as the optimiser finds.

#include <atomic>
#include <numbers>
#include <thread>

#include "core/approximation/approximate.hpp"
#include "tests/approximation/checker.hpp"
#include "tests/approximation/surfaces.hpp"

namespace hariko {
namespace {

using namespace test;

struct Most {
  const char* surface;
  std::size_t facets;
};
void PrintTo(const Most& most, std::ostream* out) {
  *out << most.surface;
}

class Optimised : public ::testing::TestWithParam<Most> {};

TEST_P(Optimised, FewFacetsWithinTheTolerance) {
  // Two seconds each: the others are for long runs.
  const std::string name = GetParam().surface;
  if (repetitions(1) == 1 && name != "quarterpipe" && name != "ridge" && name != "wave")
    GTEST_SKIP() << "set HARIKO_REPEAT_SCALE to 2 or more";
  const Surface surface = golden_surface(name);
  MeshOptions options;
  options.criteria.distance = 0.01;
  options.optimise = true;
  const auto made = must(approximate(surface, options));
  EXPECT_TRUE(made->reached());
  EXPECT_TRUE(made->distance.certified);
  EXPECT_LE(made->distance.bound, 0.01);
  EXPECT_LE(made->mesh.triangles.size(), GetParam().facets);
  const MeshCheck check = check_mesh(surface, made->mesh, 100, 0.01);
  expect_sound(check, false);
  expect_close(check, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Optimised,
                         ::testing::Values(Most{"dome", 198}, Most{"saddle", 200}, Most{"wave", 258},
                                           Most{"quarterpipe", 18}, Most{"fender", 358}, Most{"ridge", 172},
                                           Most{"quintic", 258}, Most{"pair", 460}));

TEST(OptimisedMesh, ClosedSurfacesStayClosed) {
  for (const bool sphere : {true, false}) {
    const Surface surface =
        weld_patches(Vector3::Zero(), sphere ? rational_sphere(1) : teapot_like()).value();
    const double tolerance = sphere ? 0.03 : 0.1;
    MeshOptions options;
    options.criteria.distance = tolerance;
    const std::size_t plain = approximate(surface, options)->mesh.triangles.size();
    options.optimise = true;
    const auto made = must(approximate(surface, options));
    EXPECT_TRUE(made->reached());
    EXPECT_LE(double(made->mesh.triangles.size()), (sphere ? 0.75 : 1.0) * double(plain));
    const MeshCheck check = check_mesh(surface, made->mesh, 24, tolerance);
    expect_sound(check, true);
    expect_close(check, tolerance);
  }
}

TEST(OptimisedMesh, AllCriteriaHold) {
  MeshOptions options;
  options.criteria.distance = 0.05;
  options.criteria.normal_angle = 0.3;
  options.criteria.max_edge = 1.2;
  options.optimise = true;
  const auto made = must(approximate(golden_surface("wave"), options));
  EXPECT_TRUE(made->reached());
  EXPECT_LE(made->distance.bound, 0.05);
  EXPECT_LE(made->normal_angle.largest, 0.3);
  EXPECT_LE(made->longest_edge, 1.2);
}

TEST(OptimisedMesh, FoldsDoNotMakeItRunAway) {
  // Cutting needles again and again does not lower their folds: the search once never came to an end here.
  std::vector<std::pair<const char*, double>> cases{{"quarterpipe", 6.0}};
  if (repetitions(1) > 1) cases = {{"quarterpipe", 0.5}, {"wave", 10.0}, {"wave", 0.5}};
  for (const auto& [name, angle] : cases) {
    SCOPED_TRACE(name);
    const Surface surface = golden_surface(name);
    MeshOptions options;
    options.criteria.fold_angle = angle * std::numbers::pi / 180;
    const std::size_t plain = approximate(surface, options)->mesh.triangles.size();
    options.optimise = true;
    const auto made = must(approximate(surface, options));
    EXPECT_TRUE(made->reached());
    EXPECT_LE(made->fold_angle.largest, *options.criteria.fold_angle * (1 + 1e-6));
    EXPECT_LT(made->mesh.triangles.size(), plain);
    expect_sound(check_mesh(surface, made->mesh, 30, 0.5), false);
  }
}

TEST(BalancedMesh, TheSurfacePassesThroughTheMiddle) {
  // The specification's number is for the fine tolerance, which takes half a minute.
  const bool fine = repetitions(1) > 1;
  const double tolerance = fine ? 0.01 : 0.08;
  const Surface surface = golden_surface("dome");
  MeshOptions options;
  options.criteria.distance = tolerance;
  options.optimise = true;
  const auto optimised = approximate(surface, options);
  options.balanced = true;
  const auto made = must(approximate(surface, options));
  EXPECT_TRUE(made->reached());
  EXPECT_TRUE(made->distance.certified);
  EXPECT_LE(made->distance.bound, tolerance);
  EXPECT_LT(double(made->mesh.triangles.size()), 0.8 * double(optimised->mesh.triangles.size()));
  if (fine) {
    EXPECT_LE(made->mesh.triangles.size(), 110U);
  }
  const MeshCheck check = check_mesh(surface, made->mesh, fine ? 100 : 40, tolerance);
  expect_sound(check, false);
  expect_close(check, tolerance);
}

TEST(BalancedMesh, OnlyWhereTheSurfaceBendsOneWay) {
  for (const char* name : {"saddle", "quarterpipe"}) {
    const Surface surface = golden_surface(name);
    MeshOptions options;
    options.criteria.distance = 0.05;
    options.balanced = true;
    const auto made = must(approximate(surface, options));
    ASSERT_FALSE(made->warnings.empty());
    EXPECT_EQ(made->warnings[0].code, w_mesh_balanced);
    EXPECT_LE(made->distance.bound, 0.05);
  }
  // Nor under other criteria.
  MeshOptions options;
  options.criteria.distance = 0.1;
  options.criteria.normal_angle = 0.3;
  options.balanced = true;
  const auto made = must(approximate(golden_surface("dome"), options));
  EXPECT_FALSE(made->warnings.empty());
  EXPECT_LE(made->normal_angle.largest, 0.3);
}

TEST(BalancedMesh, ProgressNeverRunsBackwards) {
  for (const char* name : {"saddle", "dome"}) {
    MeshOptions options;
    options.criteria.distance = 0.08;
    options.balanced = true;
    const Progress progress = Progress::make();
    std::atomic<bool> done = false;
    double reached = -1;
    bool backwards = false;
    std::thread watcher([&] {
      while (!done) {
        const double now = progress.fraction();
        backwards = backwards || now < reached;
        reached = now;
        std::this_thread::yield();
      }
    });
    const auto made = approximate(golden_surface(name), options, {}, progress);
    done = true;
    watcher.join();
    ASSERT_TRUE(made.ok());
    EXPECT_FALSE(backwards) << name;
    EXPECT_GT(progress.fraction(), 0.8);
  }
}

TEST(OptimisedMesh, CanBeCancelled) {
  MeshOptions options;
  options.criteria.distance = 0.01;
  options.optimise = true;
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  must_fail(approximate(golden_surface("wave"), options, cancel), e_cancelled);
}

}  // namespace
}  // namespace hariko
