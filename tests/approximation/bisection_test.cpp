// Counts and guarantees of refinement on the reference surfaces.

#include "core/approximation/approximate.hpp"
#include "core/approximation/refinement/facet_error.hpp"
#include "core/base/parallel.hpp"
#include "tests/approximation/checker.hpp"
#include "tests/approximation/meshes.hpp"
#include "tests/approximation/surfaces.hpp"

namespace hariko {
namespace {

using namespace test;

struct Count {
  const char* surface;
  int midpoint, gauss;
};
void PrintTo(const Count& count, std::ostream* out) {
  *out << count.surface;
}

class Reference : public ::testing::TestWithParam<Count> {};

TEST_P(Reference, CountsByDistance) {
  const auto& [name, midpoint, gauss] = GetParam();
  const Surface surface = golden_surface(name);
  EXPECT_NEAR(double(mesh_of(surface, by_distance(0.01)).mesh.triangles.size()), midpoint, 0.03 * midpoint);
  EXPECT_NEAR(double(mesh_of(surface, by_distance(0.01, SplitRule::gauss)).mesh.triangles.size()), gauss,
              0.03 * gauss);
}

TEST_P(Reference, EveryRuleKeepsTheTolerance) {
  const Surface surface = golden_surface(GetParam().surface);
  for (const SplitRule rule :
       {SplitRule::midpoint, SplitRule::gauss, SplitRule::curvature, SplitRule::halving})
    for (const Propagation propagation : {Propagation::longest_path, Propagation::direct}) {
      SCOPED_TRACE(testing::Message() << "rule " << int(rule) << ", propagation " << int(propagation));
      MeshOptions options = by_distance(0.02, rule);
      options.propagation = propagation;
      const MeshApproximation mesh = mesh_of(surface, options);
      EXPECT_TRUE(mesh.reached());
      EXPECT_TRUE(mesh.distance.certified);
      EXPECT_LE(mesh.distance.largest, mesh.distance.bound);
      EXPECT_LE(mesh.distance.bound, 0.02);
      if (propagation == Propagation::direct || rule == SplitRule::curvature) continue;
      const MeshCheck check = check_mesh(surface, mesh.mesh, 80, 0.02);
      expect_sound(check, false);
      expect_close(check, 0.02);
    }
}

TEST_P(Reference, QuarterOfTheToleranceNeedsFourTimesTheFacets) {
  const Surface surface = golden_surface(GetParam().surface);
  const double coarse = double(mesh_of(surface, by_distance(0.01)).mesh.triangles.size());
  const double fine = double(mesh_of(surface, by_distance(0.0025)).mesh.triangles.size());
  EXPECT_GE(fine / coarse, 3.8);
  EXPECT_LE(fine / coarse, 4.6);
}

TEST_P(Reference, ScaleAndReversalKeepTheCount) {
  const auto patches = golden_patches(GetParam().surface);
  const std::size_t count =
      mesh_of(golden_surface(GetParam().surface), by_distance(0.01)).mesh.triangles.size();
  std::vector<BezierPatch> large, back;
  for (const BezierPatch& patch : patches) {
    large.push_back(scaled(patch, 1000));
    back.push_back(reversed(patch));
  }
  const Surface scaled_surface = weld_patches(Vector3::Zero(), large).value();
  EXPECT_EQ(mesh_of(scaled_surface, by_distance(10)).mesh.triangles.size(), count);
  const Surface reversed_surface = weld_patches(Vector3::Zero(), back).value();
  const MeshApproximation mesh = mesh_of(reversed_surface, by_distance(0.01));
  EXPECT_NEAR(double(mesh.mesh.triangles.size()), double(count), 0.03 * double(count));
  expect_sound(check_mesh(reversed_surface, mesh.mesh, 30, 0.01), false);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Reference,
                         ::testing::Values(Count{"dome", 344, 324}, Count{"saddle", 440, 352},
                                           Count{"wave", 644, 694}, Count{"quarterpipe", 476, 54},
                                           Count{"fender", 525, 574}, Count{"ridge", 332, 340},
                                           Count{"quintic", 514, 541}, Count{"pair", 984, 1074}));

TEST(Bisection, CountsByAngle) {
  const std::tuple<const char*, int, int> cases[] = {{"dome", 96, 108},
                                                     {"saddle", 272, 336},
                                                     {"fender", 291, 261},
                                                     {"quarterpipe", 368, 54},
                                                     {"wave", 608, 845}};
  for (const auto& [name, midpoint, gauss] : cases) {
    SCOPED_TRACE(name);
    const Surface surface = golden_surface(name);
    MeshOptions options;
    options.criteria.normal_angle = 10 * degrees;
    for (const auto& [rule, count] : {std::pair{SplitRule::midpoint, midpoint}, {SplitRule::gauss, gauss}}) {
      options.split = rule;
      const MeshApproximation mesh = mesh_of(surface, options);
      EXPECT_NEAR(double(mesh.mesh.triangles.size()), count, 0.03 * count);
      EXPECT_LE(mesh.normal_angle.largest, 10 * degrees);
    }
  }
}

TEST(Bisection, CurvatureRuleOnTheWave) {
  const std::size_t count =
      mesh_of(golden_surface("wave"), by_distance(0.01, SplitRule::curvature)).mesh.triangles.size();
  EXPECT_NEAR(double(count), 366, 0.03 * 366);
}

TEST(Bisection, TheMeshDoesNotDependOnWhatIsReported) {
  for (const char* name : {"dome", "wave", "pair"}) {
    SCOPED_TRACE(name);
    const Surface surface = golden_surface(name);
    MeshOptions options = by_distance(0.01);
    const MeshApproximation reported = mesh_of(surface, options);
    options.report = MeshReport::none;
    const MeshApproximation alone = mesh_of(surface, options);
    EXPECT_EQ(alone.mesh.positions, reported.mesh.positions);
    EXPECT_EQ(alone.mesh.triangles, reported.mesh.triangles);
    EXPECT_EQ(alone.parts.size(), reported.parts.size());
    EXPECT_EQ(alone.longest_edge, reported.longest_edge);
    EXPECT_EQ(alone.smallest_angle, reported.smallest_angle);
    EXPECT_TRUE(alone.mesh.normals.empty() && alone.mesh.normal_triangles.empty());
    EXPECT_FALSE(alone.distance.measured || alone.fold_angle.measured);
    EXPECT_TRUE(reported.distance.measured && reported.fold_angle.measured);
  }
}

TEST(Bisection, FoldAngleIsNotDeceivedByAMiddleInThePlane) {
  for (const char* name : {"saddle", "quarterpipe", "wave"}) {
    SCOPED_TRACE(name);
    MeshOptions options;
    options.criteria.fold_angle = 10 * degrees;
    options.report = MeshReport::all;
    const Surface surface = golden_surface(name);
    const MeshApproximation mesh = mesh_of(surface, options);
    EXPECT_TRUE(mesh.reached());
    EXPECT_GT(mesh.mesh.triangles.size(), 20U);
    EXPECT_LE(mesh.fold_angle.largest, 10 * degrees * (1 + 1e-6));
    EXPECT_LE(mesh.distance.largest, 0.1);
    // By the check's own normals.
    std::map<std::pair<Index, Index>, Vector3> first;
    const auto& p = mesh.mesh.positions;
    double worst = 0;
    for (const auto& t : mesh.mesh.triangles) {
      const Vector3 normal = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = std::minmax(t[k], t[(k + 1) % 3]);
        const auto [at, fresh] = first.try_emplace(edge, normal);
        if (!fresh) worst = std::max(worst, std::acos(std::clamp(at->second.dot(normal), -1.0, 1.0)));
      }
    }
    EXPECT_LE(worst, 10 * degrees * (1 + 1e-6));
  }
}

TEST(Bisection, FlatPatchIsTwoFacetsUnderEveryCriterion) {
  BezierPatch flat;
  flat.degree_s = flat.degree_t = 1;
  flat.points = {{0, 0, 0}, {3, 0, 1}, {0, 2, 0}, {3, 2, 1}};
  const Surface surface = weld_patches(Vector3::Zero(), {flat}).value();
  MeshOptions options;
  options.criteria.distance = 1e-4;
  options.criteria.normal_angle = options.criteria.fold_angle = 0.01;
  options.criteria.luminance = 0.001;
  for (const SplitRule rule :
       {SplitRule::midpoint, SplitRule::gauss, SplitRule::curvature, SplitRule::halving}) {
    options.split = rule;
    EXPECT_EQ(mesh_of(surface, options).mesh.triangles.size(), 2U);
  }
  options.criteria = {};
  options.criteria.max_edge = 0.5;
  const MeshApproximation mesh = mesh_of(surface, options);
  EXPECT_LE(mesh.longest_edge, 0.5);
  EXPECT_GT(mesh.mesh.triangles.size(), 50U);
}

TEST(Bisection, CombinedCriteriaAllHold) {
  const Surface surface = golden_surface("wave");
  MeshOptions options = by_distance(0.01);
  options.criteria.normal_angle = 15 * degrees;
  options.criteria.max_edge = 0.6;
  options.criteria.luminance = 0.2;
  const MeshApproximation mesh = mesh_of(surface, options);
  EXPECT_TRUE(mesh.reached());
  EXPECT_LE(mesh.distance.bound, 0.01);
  EXPECT_LE(mesh.normal_angle.largest, 15 * degrees);
  EXPECT_LE(mesh.longest_edge, 0.6);
  EXPECT_LE(mesh.luminance.largest, 0.2);
}

TEST(Bisection, FlatShadingNeedsMoreFacetsThanGouraud) {
  const Surface surface = golden_surface("dome");
  MeshOptions options = by_distance(0.2);
  options.criteria.luminance = 0.05;
  const std::size_t gouraud = mesh_of(surface, options).mesh.triangles.size();
  options.criteria.luminance_model.shading = LuminanceModel::Shading::flat;
  const MeshApproximation flat = mesh_of(surface, options);
  EXPECT_GT(flat.mesh.triangles.size(), 2 * gouraud);
  EXPECT_LE(flat.luminance.largest, 0.05);
}

TEST(Bisection, SameMeshOnAnyNumberOfThreads) {
  const Surface surface = golden_surface("pair");
  std::vector<MeshApproximation> made;
  for (const int threads : {1, 2, 4}) {
    const ParallelLimit limit(threads);
    made.push_back(mesh_of(surface, by_distance(0.002)));
  }
  for (const MeshApproximation& other : made) {
    EXPECT_EQ(other.mesh.positions, made[0].mesh.positions);
    EXPECT_EQ(other.mesh.triangles, made[0].mesh.triangles);
    EXPECT_EQ(other.distance.facets, made[0].distance.facets);
  }
}

TEST(Bisection, ManyFacetsKeepTheToleranceAsFewDo) {
  // Above a hundred thousand the nets of good facets are given back, and facets come in another order.
  const Surface surface = golden_surface("fender");
  const std::size_t few = mesh_of(surface, by_distance(0.01 / 64)).mesh.triangles.size();
  std::vector<MeshApproximation> made;
  for (const int threads : {1, 3}) {
    const ParallelLimit limit(threads);
    made.push_back(mesh_of(surface, by_distance(0.01 / 256)));
  }
  const MeshApproximation& mesh = made[0];
  EXPECT_GT(mesh.mesh.triangles.size(), 110'000U);
  EXPECT_NEAR(double(mesh.mesh.triangles.size()), 4.0 * double(few), 0.03 * 4.0 * double(few));
  EXPECT_TRUE(mesh.reached());
  EXPECT_TRUE(mesh.distance.certified);
  EXPECT_LE(mesh.distance.bound, 0.01 / 256);
  EXPECT_LE(mesh.distance.largest, mesh.distance.bound);
  EXPECT_EQ(made[1].mesh.positions, mesh.mesh.positions);
  EXPECT_EQ(made[1].mesh.triangles, mesh.mesh.triangles);
  EXPECT_EQ(made[1].distance.facets, mesh.distance.facets);
  // Reports of single facets are what their surface shows.
  const SurfaceSampler sampler(surface);
  MeshCriteria criteria;
  criteria.distance = 0.01 / 256;
  const FacetErrors errors(sampler, criteria);
  ParameterMesh parts;
  parts.positions = mesh.mesh.positions;
  parts.facets = mesh.parts;
  parts.twin.assign(3 * parts.facets.size(), 0);  // no borders: those are compared with more
  for (Index f = 0; f < parts.facets.size(); f += 97) {
    const double best = errors.measured_distance(parts, f).sampled, noted = double(mesh.distance.facets[f]);
    EXPECT_GE(noted, 0.85 * best - 1e-12) << f;
  }
}

TEST(Bisection, RemovingAFacetIsSeenAsThreeCracks) {
  const Surface surface = golden_surface("pair");
  MeshApproximation mesh = mesh_of(surface, by_distance(0.01));
  // A facet without a border vertex.
  std::vector<int> uses(mesh.mesh.positions.size(), 0);
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& t : mesh.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
  for (const auto& [edge, count] : edges)
    if (count == 1) uses[edge.first] = uses[edge.second] = 1;
  const auto inner = std::find_if(mesh.mesh.triangles.begin(), mesh.mesh.triangles.end(),
                                  [&](const auto& t) { return !uses[t[0]] && !uses[t[1]] && !uses[t[2]]; });
  ASSERT_NE(inner, mesh.mesh.triangles.end());
  mesh.mesh.triangles.erase(inner);
  EXPECT_EQ(check_mesh(surface, mesh.mesh, 10, 0.01).cracks, 3U);
}

TEST(Bisection, LimitAndCancel) {
  const Surface surface = golden_surface("wave");
  MeshOptions options = by_distance(0.001);
  options.facet_limit = 500;
  const MeshApproximation mesh = mesh_of(surface, options);
  EXPECT_LE(mesh.mesh.triangles.size(), 500U);
  ASSERT_EQ(mesh.warnings.size(), 1U);
  EXPECT_EQ(mesh.warnings[0].code, w_mesh_limit);
  expect_sound(check_mesh(surface, mesh.mesh, 20, 0.1), false);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  must_fail(approximate(surface, by_distance(0.001), cancel), e_cancelled);
  const Progress progress = Progress::make();
  EXPECT_TRUE(approximate(surface, by_distance(0.01), {}, progress).ok());
  EXPECT_DOUBLE_EQ(progress.fraction(), 1);
}

TEST(Bisection, Messages) {
  const Surface surface = golden_surface("dome");
  const auto refused = [&](const MeshOptions& options) {
    const auto made = approximate(surface, options);
    return made.ok() ? Code{"none"} : made.error().code;
  };
  EXPECT_EQ(refused({}), e_mesh_nothing);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-9})
    EXPECT_EQ(refused(by_distance(bad)), e_mesh_tolerance);
  MeshOptions angle;
  angle.criteria.normal_angle = 2;
  EXPECT_EQ(refused(angle), e_mesh_tolerance);
  const auto empty = approximate(weld_patches(Vector3::Zero(), {}).value(), by_distance(0.1));
  must_fail(empty, e_mesh_nothing);
  BezierPatch point;
  point.degree_s = point.degree_t = 1;
  point.points.assign(4, Vector3(1, 2, 3));
  must_fail(approximate(weld_patches(Vector3::Zero(), {point}).value(), by_distance(0.1)), e_mesh_surface);
  point.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const auto line = approximate(weld_patches(Vector3::Zero(), {point}).value(), by_distance(0.1));
  EXPECT_TRUE(!line.ok() || !line->mesh.triangles.empty());
}

}  // namespace
}  // namespace hariko
