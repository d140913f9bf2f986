// Meshes with as few facets as the optimiser finds.

#include <gtest/gtest.h>

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
  const auto made = approximate(surface, options);
  ASSERT_TRUE(made.ok());
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
    const auto made = approximate(surface, options);
    ASSERT_TRUE(made.ok());
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
  const auto made = approximate(golden_surface("wave"), options);
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(made->reached());
  EXPECT_LE(made->distance.bound, 0.05);
  EXPECT_LE(made->normal_angle.largest, 0.3);
  EXPECT_LE(made->longest_edge, 1.2);
}

TEST(OptimisedMesh, CanBeCancelled) {
  MeshOptions options;
  options.criteria.distance = 0.01;
  options.optimise = true;
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  const auto made = approximate(golden_surface("wave"), options, cancel);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, e_cancelled);
}

}  // namespace
}  // namespace hariko
