// Networks of curves over the hull: patches and enclosure against the measured numbers and the invariants.

#include <Eigen/Geometry>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "tests/envelope/envelope_scenes.hpp"
#include "tests/envelope/network_invariants.hpp"

namespace hariko::test {

namespace {

void check_invariants(const EnvelopeSurface& made, const EnvelopeInput& input) {
  ASSERT_TRUE(made.network);
  const CurveNetwork& network = *made.network;
  EXPECT_EQ(
      long(network.cage.vertices.size()) - long(network.curves.size()) + long(network.cage.faces.size()), 2);
  for (const NetworkCurve& curve : network.curves)
    for (const Homogeneous& point : curve.ribbon.curve) EXPECT_GT(point.w(), 0.5);
  const ContinuityReport report = continuity(made.surface);
  EXPECT_LE(report.largest_normal_jump.value() * degrees, 1e-4);
  EXPECT_LE(report.largest_gap, 0);
  EXPECT_TRUE(made.surface.boundary_sides().empty());
  check_vertices(network, network_solids(input, made.origin));
}

struct Expected {
  const char* name;
  std::size_t vertices, edges, faces, primitive, patches;
};

}  // namespace

TEST(EnvelopeNetwork, SingleAndPairedSolidsHaveTheMeasuredNetworks) {
  for (const Expected& expected : {Expected{"box", 8, 12, 6, 6, 6},
                                   {"box_round", 8, 12, 6, 6, 6},
                                   {"slab", 8, 12, 6, 6, 6},
                                   {"sphere", 12, 24, 14, 14, 30},
                                   {"tetra", 4, 6, 4, 4, 12},
                                   {"cylinder", 16, 24, 10, 10, 24},
                                   {"cone", 9, 16, 9, 9, 32},
                                   {"capsule", 18, 36, 20, 14, 36},
                                   {"torus", 16, 24, 10, 10, 24},
                                   {"hexprism", 12, 18, 8, 8, 18},
                                   {"two_touch", 8, 12, 6, 2, 6},
                                   {"two_apart", 8, 12, 6, 2, 6},
                                   {"inner", 8, 12, 6, 6, 6},
                                   {"ell", 10, 15, 7, 3, 15}}) {
    SCOPED_TRACE(expected.name);
    const EnvelopeInput input = golden_scene(expected.name);
    const auto made = must(EnvelopeSurfacer().rebuild(input));
    const NetworkCage& cage = made->network->cage;
    EXPECT_EQ(cage.vertices.size(), expected.vertices);
    EXPECT_EQ(made->network->curves.size(), expected.edges);
    EXPECT_EQ(cage.faces.size(), expected.faces);
    EXPECT_EQ(std::count_if(cage.faces.begin(), cage.faces.end(),
                            [](const auto& f) { return f.solid != no_index; }),
              long(expected.primitive));
    EXPECT_EQ(made->network->patches.size(), expected.patches);
    check_invariants(*made, input);
    // Rims and balls reach out between the corners that stand for them.
    const SolidKind kind = input.solids[0].kind;
    const bool round = kind == SolidKind::sphere || kind == SolidKind::cylinder || kind == SolidKind::cone ||
                       kind == SolidKind::capsule || kind == SolidKind::torus;
    EXPECT_EQ(made->enclosed, !round);
    EXPECT_LE(made->check->worst, (round ? 0.04 : 1e-4) * made->diagonal);
    EXPECT_EQ(made->folds, 0U);
    EXPECT_EQ(made->warnings.size(), round ? 1U : 0U);
  }
}

TEST(EnvelopeNetwork, SaysWhatItDoesNotContainAndOffersTheBall) {
  int missed = 0;
  for (const char* name : {"four", "four_boxes", "ten_boxes", "camera", "dryer"}) {
    SCOPED_TRACE(name);
    const EnvelopeInput input = golden_scene(name);
    const EnvelopeSurface made = envelope_of(input);
    check_invariants(made, input);
    ASSERT_TRUE(made.check);
    EXPECT_EQ(made.enclosed, made.check->worst <= 1e-4 * made.diagonal);
    EXPECT_EQ(warned(made, w_not_enclosed), !made.enclosed);
    EXPECT_EQ(warned(made, w_envelope_fold), made.folds > 0);
    missed += !made.enclosed;
    for (const Message& message : made.warnings)
      EXPECT_NE(message.remedy.find("ball"), std::string::npos) << to_string(message);
  }
  EXPECT_GT(missed, 0) << "nothing is tested";
}

TEST(EnvelopeNetwork, AUnitBoxHasTheMeasuredValues) {
  EnvelopeInput input = golden_scene("box");
  auto made = must(EnvelopeSurfacer().rebuild(input));
  const CurveNetwork& network = *made->network;
  bool found = false;
  for (Index a = 0; a < 8; ++a)
    for (Index b = 0; b < 8; ++b) {
      const Vector3 pa = network.cage.vertices[a].position + made->origin,
                    pb = network.cage.vertices[b].position + made->origin;
      if ((pa - Vector3(-0.5, -0.5, -0.5)).norm() > 1e-12 || (pb - Vector3(-0.5, -0.5, 0.5)).norm() > 1e-12)
        continue;
      found = true;
      const RibbonCurve curve = network.ribbon(a, b);
      EXPECT_LT((cartesian(curve.curve[1]) + made->origin - Vector3(-0.57753, -0.57753, -0.34495)).norm(),
                1e-5);
      EXPECT_NEAR(curve.curve[1].w(), 0.8777, 5e-5);
      EXPECT_LT((curve.middle() + made->origin - Vector3(-0.5562, -0.5562, 0)).norm(), 1e-4);
    }
  EXPECT_TRUE(found);
  const auto& patches = made->surface.patches();
  double lowest = 0;
  for (Index p = 0; p < made->surface.patch_count(); ++p)
    lowest = std::min(lowest,
                      patches.evaluate(p, Vector2(0.5, 0.5), Order::first).position.z() + made->origin.z());
  EXPECT_NEAR(lowest, -0.664439, 1e-6);
  input.settings.roundness = 1;
  made = EnvelopeSurfacer().rebuild(input);
  // Edges are arcs round the centroid.
  for (const NetworkCurve& curve : made->network->curves)
    EXPECT_NEAR((curve.ribbon.middle() + made->origin).norm(), std::sqrt(0.75), 1e-12);
  lowest = 0;
  for (Index p = 0; p < made->surface.patch_count(); ++p)
    lowest =
        std::min(lowest, made->surface.patches().evaluate(p, Vector2(0.5, 0.5), Order::first).position.z());
  EXPECT_NEAR(lowest, -0.85075, 1e-5);
}

TEST(EnvelopeNetwork, TwoBoxesApartHaveTheMeasuredBridge) {
  const auto made = must(EnvelopeSurfacer().rebuild(golden_scene("two_apart")));
  double nearest = 1;
  for (Index p = 0; p < made->surface.patch_count(); ++p) {
    const Vector3 q =
        made->surface.patches().evaluate(p, Vector2(0.5, 0.5), Order::first).position + made->origin;
    nearest = std::min(nearest, (q - Vector3(1.1, 0, -0.845323)).norm());
  }
  EXPECT_LT(nearest, 1e-6);
}

TEST(EnvelopeNetwork, ThinRingsAndDiscsAreNotFlat) {
  for (const double thickness : {0.3, 0.1, 0.02, 0.001})
    for (const SolidKind kind : {SolidKind::torus, SolidKind::cylinder, SolidKind::box, SolidKind::prism}) {
      Solid solid;
      solid.kind = kind;
      solid.radius = 1;
      solid.tube = thickness / 2;
      solid.height = thickness;
      solid.size = {2, 1.5, thickness};
      solid.rotation = {20, 50, -30};
      EnvelopeInput input;
      input.solids = {solid};
      const EnvelopeSurface made = envelope_of(input);
      ASSERT_TRUE(made.network) << name_of(kind) << " " << thickness;
      EXPECT_TRUE(made.surface.boundary_sides().empty());
    }
}

TEST(EnvelopeNetwork, ABallIsNearlyABall) {
  const auto made = must(EnvelopeSurfacer().rebuild(golden_scene("sphere")));
  EXPECT_NEAR(measure(made->surface).volume.value(), 4 * std::numbers::pi / 3, 0.02);
}

TEST(EnvelopeNetwork, APolyhedronThatIsNotConvexIsReplacedByItsHullAndSaysSo) {
  EnvelopeInput input;
  Solid solid{.kind = SolidKind::polyhedron};
  solid.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  input.solids = {solid};
  const auto says = [&] {
    const auto made = EnvelopeSurfacer().rebuild(input);
    return made.ok() && std::any_of(made->warnings.begin(), made->warnings.end(),
                                    [](const Message& m) { return m.code == w_solid_hull; });
  };
  EXPECT_FALSE(says());
  input.solids[0].points.push_back(0.5 * (solid.points[0] + solid.points[1]));  // on an edge
  EXPECT_FALSE(says());
  input.solids[0].points[4] = {0.1, 0.05, 0};
  EXPECT_TRUE(says());
}

TEST(EnvelopeNetwork, AChordThroughTheCentreLeavesInTheTangentPlane) {
  CageVertex vertex;
  vertex.radial = Vector3(0.5, -0.3, 0.8).normalized();
  vertex.normal = (vertex.radial + Vector3(0.2, 0.1, 0)).normalized();
  const Vector3 chord = -1.7 * vertex.radial;
  const Vector3 wanted = (chord - chord.dot(vertex.normal) * vertex.normal).normalized();
  EXPECT_LT((vertex.tangent(chord) - wanted).norm(), 1e-12);
  vertex.normal = vertex.radial;
  EXPECT_TRUE(vertex.tangent(chord).isZero(0));
}

// Antipodal corners of a small solid may be neighbours on the hull of a random scene.
TEST(EnvelopeNetwork, ScenesWithNeedlesThroughASolidAreSmoothAtTheirVertices) {
  for (const std::uint64_t seed : {86, 87}) {
    std::mt19937_64 rng(seed);
    EnvelopeInput input = random_scene(rng);
    input.settings.method = EnvelopeMethod::network;
    const EnvelopeSurface made = envelope_of(input);
    ASSERT_TRUE(made.network);
    check_vertices(*made.network, network_solids(input, made.origin));
  }
}

}  // namespace hariko::test
