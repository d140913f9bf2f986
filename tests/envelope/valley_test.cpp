// Networks that follow notches: counts of the measured scenes, invariants, the ladder, the automatic choice.

#include <Eigen/Geometry>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/envelope/cage_frames.hpp"
#include "core/envelope/loop_mesh.hpp"
#include "core/envelope/loop_pieces.hpp"
#include "core/envelope/valley_path.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

struct ExpectedValley {
  const char* name;
  std::size_t vertices, edges, faces, primitive, patches;
  std::map<std::size_t, int> sides;
  double volume;  ///< over that of the hull of the solids, where it was measured
};

double hull_volume(const EnvelopeInput& input) {
  std::vector<Vector3> points;
  for (const PlacedSolid& solid : place_solids(input)) {
    points.insert(points.end(), solid.test_points.begin(), solid.test_points.end());
    const std::vector<Vector3> more = solid.surface_points(2000);
    points.insert(points.end(), more.begin(), more.end());
  }
  double out = 0;
  for (const auto& t : convex_hull(points, 1e-9).triangles)
    out += points[t[0]].dot(points[t[1]].cross(points[t[2]])) / 6;
  return out;
}

void check_network(const EnvelopeSurface& made) {
  ASSERT_TRUE(made.network);
  const CurveNetwork& network = *made.network;
  EXPECT_EQ(
      long(network.cage.vertices.size()) - long(network.curves.size()) + long(network.cage.faces.size()), 2);
  EXPECT_GT(network.least_weight(), 0.5);
  const ContinuityReport report = continuity(made.surface);
  EXPECT_LE(report.largest_normal_jump.value() * degrees, 1e-4);
  EXPECT_LE(report.largest_gap, 0);
  EXPECT_TRUE(made.surface.boundary_sides().empty());
  EXPECT_EQ(made.folds, 0U);
  EXPECT_TRUE(made.enclosed);
  ASSERT_TRUE(made.check);
  EXPECT_LE(made.check->worst, 1e-4 * made.diagonal);
  for (const NetworkCurve& curve : network.curves)
    for (const auto& [v, ribbon] :
         {std::pair{curve.low, curve.ribbon}, std::pair{curve.high, curve.ribbon.reversed()}})
      EXPECT_NEAR(ribbon.start_derivative().stableNormalized().dot(network.cage.vertices[v].normal), 0, 1e-9);
}

}  // namespace

TEST(ValleyNetwork, ConcaveArrangementsHaveTheMeasuredNetworks) {
  for (const ExpectedValley& expected :
       {ExpectedValley{"ell_tight", 12, 20, 10, 3, 10, {{4, 10}}, 1.170},
        {"tee", 16, 30, 16, 4, 24, {{3, 4}, {4, 12}}, 0.969},
        {"you", 16, 28, 14, 3, 14, {{4, 14}}, 1.073},
        {"car", 16, 28, 14, 6, 14, {{4, 14}}, 1.310},
        {"dryer", 24, 43, 21, 7, 59, {{3, 8}, {4, 9}, {5, 2}, {8, 2}}, 1.021},
        {"bottle", 39, 75, 38, 16, 57, {{3, 6}, {4, 31}, {8, 1}}, 1.077}}) {
    SCOPED_TRACE(expected.name);
    EnvelopeInput input = golden_scene(expected.name);
    input.settings.method = EnvelopeMethod::network;
    const auto made = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    EXPECT_EQ(made->route, EnvelopeRoute::valleys);
    EXPECT_EQ(made->level, 0);
    EXPECT_TRUE(made->warnings.empty());
    check_network(*made);
    const NetworkCage& cage = made->network->cage;
    EXPECT_EQ(cage.vertices.size(), expected.vertices);
    EXPECT_EQ(made->network->curves.size(), expected.edges);
    EXPECT_EQ(cage.faces.size(), expected.faces);
    EXPECT_EQ(made->network->patches.size(), expected.patches);
    std::map<std::size_t, int> sides;
    for (const CageFace& face : cage.faces) ++sides[face.loop.size()];
    EXPECT_EQ(sides, expected.sides);
    EXPECT_EQ(std::count_if(cage.faces.begin(), cage.faces.end(),
                            [](const auto& f) { return f.solid != no_index; }),
              long(expected.primitive));
    EXPECT_NEAR(*measure(made->surface).volume / hull_volume(input), expected.volume, 0.05 * expected.volume);
  }
}

TEST(ValleyNetwork, ARingOfBoxesIsDentedFromBothSides) {
  EnvelopeInput input = golden_scene("ring6");
  input.settings.method = EnvelopeMethod::network;
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->route, EnvelopeRoute::valleys);
  EXPECT_EQ(made->level, 0);
  check_network(*made);
  EXPECT_EQ(made->network->cage.vertices.size(), 38U);
  EXPECT_EQ(made->network->curves.size(), 66U);
  EXPECT_EQ(made->network->cage.faces.size(), 30U);
}

TEST(ValleyNetwork, TheWaySinksWithTheTightness) {
  EnvelopeInput input = golden_scene("ell_tight");
  double last = 1e300;
  for (const double tightness : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    input.settings.tightness = tightness;
    const auto made = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(made.ok());
    check_network(*made);
    const double volume = *measure(made->surface).volume;
    EXPECT_LT(volume, last);
    last = volume;
  }
}

TEST(ValleyNetwork, TheAutomaticChoiceKnowsHolesPartsAndCrowds) {
  const auto route = [](EnvelopeInput input) {
    Vector3 origin = Vector3::Zero();
    return envelope_route(input, place_solids(input), origin);
  };
  EXPECT_EQ(route(golden_scene("ell_tight")), EnvelopeRoute::valleys);
  EXPECT_EQ(route(golden_scene("you")), EnvelopeRoute::valleys);
  EXPECT_EQ(route(golden_scene("ring6")), EnvelopeRoute::field);
  EXPECT_EQ(route(golden_scene("four_tight")), EnvelopeRoute::field);
  EXPECT_EQ(route(golden_scene("four")), EnvelopeRoute::hull);
  EnvelopeInput input = golden_scene("torus");
  input.settings.tightness = 1;
  EXPECT_EQ(route(input), EnvelopeRoute::field);
  input = golden_scene("two_apart");
  input.settings.tightness = 1;
  input.solids[1].position.x() = 4;
  EXPECT_EQ(route(input), EnvelopeRoute::field);
  // Three bars round a hole.
  input = {};
  for (std::uint32_t k = 0; k < 3; ++k) {
    Solid bar;
    bar.size = {4, 0.4, 0.4};
    const double a = 2.0943951023931953 * k;
    bar.position = {std::sin(a), -std::cos(a), 0};
    bar.rotation = {0, 0, 120.0 * k};
    bar.id = k;
    input.solids.push_back(bar);
  }
  input.settings.tightness = 1;
  EXPECT_EQ(route(input), EnvelopeRoute::field);
  input.settings.method = EnvelopeMethod::network;
  EXPECT_EQ(route(input), EnvelopeRoute::valleys);
}

TEST(ValleyNetwork, TheAutomaticChoiceTakesNetworksWithoutTips) {
  for (const auto& [name, route] : {std::pair{"ell_tight", EnvelopeRoute::valleys},
                                    {"you", EnvelopeRoute::valleys},
                                    {"car", EnvelopeRoute::valleys},
                                    {"tee", EnvelopeRoute::field},
                                    {"dryer", EnvelopeRoute::field}}) {
    SCOPED_TRACE(name);
    const auto made = EnvelopeSurfacer().rebuild(golden_scene(name));
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(made->route, route);
    EXPECT_TRUE(made->warnings.empty());
    EXPECT_EQ(made->network != nullptr, route == EnvelopeRoute::valleys);
  }
}

TEST(ValleyNetwork, ACageThatCannotBeFollowedByCurvesIsFollowedByAField) {
  const auto made = EnvelopeSurfacer().rebuild(golden_scene("camera"));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->route, EnvelopeRoute::field);
  EXPECT_TRUE(made->cage);
  EXPECT_TRUE(made->enclosed);
}

TEST(ValleyNetwork, DragsStayOnTheValleysAndFinalResultsDoNotDependOnThem) {
  EnvelopeInput input = golden_scene("car");
  EnvelopeSurfacer warm, cold;
  ASSERT_TRUE(warm.rebuild(input).ok());
  for (int step = 0; step < 6; ++step) {
    input.solids[1].position.x() += 0.02;
    const auto made = warm.rebuild(input, Quality::drag);
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(made->route, EnvelopeRoute::valleys);
    EXPECT_EQ(made->network->cage.vertices.size(), 16U);
  }
  const auto a = warm.rebuild(input), b = cold.rebuild(input);
  ASSERT_TRUE(a.ok() && b.ok());
  ASSERT_EQ(a->surface.patch_count(), b->surface.patch_count());
  for (Index p = 0; p < a->surface.patch_count(); ++p)
    EXPECT_EQ(a->surface.patches().evaluate(p, Vector2(0.3, 0.4), Order::first).position,
              b->surface.patches().evaluate(p, Vector2(0.3, 0.4), Order::first).position);
}

TEST(ValleyPath, AWayEndsWhereTheSolidsTouch) {
  for_random(21, 20, [](std::mt19937_64& rng) {
    // Two boxes along the axes that make a step.
    EnvelopeInput input;
    input.solids.resize(2);
    const double height = uniform(rng, 0.5, 2), width = uniform(rng, 0.3, 0.8);
    input.solids[0].size = {4, 1, 1};
    input.solids[1].size = {width, 1, height};
    input.solids[1].position = {0, 0, 0.5 + height / 2};
    input.solids[1].id = 1;
    const GrownSolids solids(input, place_solids(input), Vector3::Zero());
    const ValleyPath path = valley_path(solids, 0, 1, {2, 0.5, 0.5}, {width / 2, 0.5, 0.5 + height}, 5);
    EXPECT_EQ(path.stop, ValleyPath::Stop::landed);
    // Gradients are differences over 1e-6 of the solids' sizes.
    EXPECT_LT((path.points.back() - Vector3(width / 2, 0.5, 0.5)).norm(), 1e-5);
    for (const Vector3& p : path.points)
      EXPECT_NEAR(solids.distance(0, p), solids.distance(1, p), 1e-3 * height);
    double length = 0;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      length += (path.points[i + 1] - path.points[i]).norm();
    EXPECT_NEAR(length, path.length, 1e-12);
    EXPECT_LT((along(path, 1).first - path.points.back()).norm(), 1e-12);
    EXPECT_LT((along(path, 0).first - path.points.front()).norm(), 1e-12);
  });
}

TEST(ValleyPath, ASlotIsNothingToSinkInto) {
  EnvelopeInput input;
  input.solids.resize(2);
  input.solids[1].position = {1.4, 0, 0};
  input.solids[1].id = 1;
  const GrownSolids solids(input, place_solids(input), Vector3::Zero());
  const ValleyPath path = valley_path(solids, 0, 1, {0.5, 0.5, 0.5}, {0.9, 0.5, 0.5}, 3);
  EXPECT_EQ(path.stop, ValleyPath::Stop::open);
  EXPECT_EQ(path.points.size(), 1U);
}

TEST(LoopPieces, AnLIsCutIntoTwoQuadsAndAQuadIsNot) {
  const auto any = [](Index, Index) { return true; };
  const std::vector<Vector3> ell{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  const auto pieces = cheapest_pieces(ell, Vector3::UnitZ(), any);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].size(), 4U);
  EXPECT_EQ(pieces[1].size(), 4U);
  const std::vector<Vector3> quad{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(cheapest_pieces(quad, Vector3::UnitZ(), any).size(), 1U);
  EXPECT_NEAR(piece_cost(quad, Vector3::UnitZ()), 0, 1e-12);
  // A diagonal that is not allowed is not taken.
  const auto barred = cheapest_pieces(ell, Vector3::UnitZ(), [](Index, Index) { return false; });
  EXPECT_EQ(barred.size(), 1U);
}

TEST(LoopPieces, PiecesCoverTheLoop) {
  for_random(22, 60, [](std::mt19937_64& rng) {
    std::vector<Vector3> loop;
    const int n = uniform_int(rng, 4, 13);
    for (int k = 0; k < n; ++k) {
      const double a = 6.283185307179586 * k / n, r = uniform(rng, 0.4, 1.5);
      loop.emplace_back(r * std::cos(a), r * std::sin(a), uniform(rng, -0.2, 0.2));
    }
    const auto pieces = cheapest_pieces(loop, Vector3::UnitZ(), [](Index, Index) { return true; });
    std::map<std::pair<Index, Index>, int> edges;
    std::size_t corners = 0;
    for (const auto& piece : pieces) {
      corners += piece.size();
      for (std::size_t i = 0; i < piece.size(); ++i) ++edges[{piece[i], piece[(i + 1) % piece.size()]}];
    }
    EXPECT_EQ(corners, loop.size() + 2 * (pieces.size() - 1));
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      const bool side = (edge.first + 1) % Index(n) == edge.second;
      EXPECT_NE(side, edges.contains({edge.second, edge.first}));
    }
  });
}

TEST(LoopMesh, OnlyClosedManifoldsOfGenusZeroAreSpheres) {
  const Vector3 up = Vector3::UnitZ();
  const CageLoops tetra{{{0, 1, 2}, up}, {{0, 2, 3}, up}, {{0, 3, 1}, up}, {{1, 3, 2}, up}};
  EXPECT_TRUE(is_sphere(tetra));
  CageLoops open = tetra;
  open.pop_back();
  EXPECT_FALSE(is_sphere(open));
  CageLoops flipped = tetra;
  std::swap(flipped[0].corners[1], flipped[0].corners[2]);
  EXPECT_FALSE(is_sphere(flipped));
  // A corner of two faces only.
  CageLoops flat = tetra;
  flat[0].corners = {0, 4, 1, 2};
  flat[2].corners = {0, 3, 1, 4};
  EXPECT_FALSE(is_sphere(flat));
  EXPECT_FALSE(is_sphere(collapsed(tetra, 0, 1)));
}

TEST(CageFrames, TheMaximinNormalSeesAllNormals) {
  for_random(23, 60, [](std::mt19937_64& rng) {
    // Normals that some direction sees: the best one sees them at least as well, up to the search's step.
    const Vector3 seen = random_vector(rng).normalized();
    std::vector<Vector3> normals;
    const int count = uniform_int(rng, 3, 7);
    while (int(normals.size()) < count) {
      const Vector3 m = random_vector(rng).normalized();
      if (m.dot(seen) > 0.2) normals.push_back(m);
    }
    double reached = 1, wanted = 1;
    const Vector3 best = maximin_normal(normals);
    for (const Vector3& m : normals)
      reached = std::min(reached, m.dot(best)), wanted = std::min(wanted, m.dot(seen));
    EXPECT_NEAR(best.norm(), 1, 1e-12);
    EXPECT_GT(reached, 0);
    EXPECT_GT(reached, wanted - 0.05);
  });
}

}  // namespace hariko::test
