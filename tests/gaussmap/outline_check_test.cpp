#include "core/gaussmap/outlines/outline_check.hpp"

#include "core/gaussmap/sphere/arc_crossings.hpp"
#include "core/gaussmap/sphere/spherical_delaunay.hpp"
#include "core/geometry/angles.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

std::vector<std::string> codes(const std::vector<Message>& messages) {
  std::vector<std::string> out;
  for (const Message& message : messages) out.emplace_back(message.code.name);
  return out;
}

/// The outline has this message, which names the point in its text and as its element.
void expect_message(const Outline& outline, Code code, const std::string& named, Index number,
                    GaussMode mode = GaussMode::curvature) {
  SCOPED_TRACE(code.name);
  for (const Message& message : check_outline(outline, mode)) {
    if (!(message.code == code)) continue;
    EXPECT_NE(message.text.find(named), std::string::npos) << message.text;
    EXPECT_EQ(message.element, element_of(VertexId{number}));
    EXPECT_FALSE(message.remedy.empty());
    EXPECT_EQ(message.severity == Severity::error, code.name[0] == 'E');
    return;
  }
  ADD_FAILURE() << "no such message";
}

TEST(OutlineCheck, GoodOutlinesPass) {
  for (const auto* name :
       {"sphere_cap", "ellipsoid_cap", "paraboloid", "sphere_band", "three_holes", "ell_three_holes"})
    for (const GaussMode mode : {GaussMode::curvature, GaussMode::umbilic, GaussMode::paper})
      EXPECT_EQ(codes(check_outline(golden_outline(name), mode)), std::vector<std::string>{}) << name;
  for (const auto* name : {"catenoid", "saddle"})
    for (const GaussMode mode : {GaussMode::curvature, GaussMode::umbilic, GaussMode::position})
      EXPECT_EQ(codes(check_outline(golden_outline(name), mode)), std::vector<std::string>{}) << name;
}

TEST(OutlineCheck, BadCasesOfTheSpecification) {
  EXPECT_EQ(codes(check_outline(golden_outline("bad_inward"), GaussMode::curvature)),
            std::vector<std::string>{"E_NOT_CONVEX"});
  const auto wrong = codes(check_outline(golden_outline("bad_normal"), GaussMode::curvature));
  EXPECT_TRUE(std::count(wrong.begin(), wrong.end(), "E_COARSE"));
  EXPECT_TRUE(std::count(wrong.begin(), wrong.end(), "E_IMAGE_SELF_X"));
  const auto eight = codes(check_outline(golden_outline("bad_figure8"), GaussMode::curvature));
  EXPECT_TRUE(std::count(eight.begin(), eight.end(), "E_IMAGE_SELF_X"));
}

TEST(OutlineCheck, NamesThePointThatIsWrong) {
  const Outline good = golden_outline("sphere_cap"), band = golden_outline("sphere_band");
  const double inf = std::numeric_limits<double>::infinity();

  Outline bad = band;
  bad.loops[1].points.resize(3);
  bad.loops[1].normals.resize(3);
  bad.loops[1].curvature.resize(3);
  expect_message(bad, e_outline_too_few, "Loop 1 has 3", 20);
  expect_message({}, e_outline_too_few, "no loop", 0);

  bad = band;
  bad.loops[1].points[2].y() = inf;
  expect_message(bad, e_outline_not_finite, "point 2 of loop 1", 22);
  bad = good;
  bad.loops[0].normals[5].z() = std::nan("");
  expect_message(bad, e_outline_not_finite, "point 5", 5);
  bad = good;
  bad.loops[0].curvature[6] = inf;
  expect_message(bad, e_outline_not_finite, "point 6", 6);
  bad = good;
  bad.loops[0].points[7] *= 1e200;
  expect_message(bad, e_outline_not_finite, "too large", 0);

  bad = good;
  bad.loops[0].points[9] = bad.loops[0].points[8] + Vector3(1e-10, 0, 0);
  expect_message(bad, e_same_point, "point 8", 8);
  bad = good;
  bad.loops[0].normals[4].setZero();
  expect_message(bad, e_zero_normal, "point 4", 4);

  bad = good;
  bad.loops[0].normals[11] = 3 * bad.loops[0].normals[10];
  expect_message(bad, e_same_normal, "point 10", 10);
  bad = good;
  bad.loops[0].normals[12] = Vector3(0.1, 0, -1);
  expect_message(bad, e_coarse_normals, "point", 11);
}

TEST(OutlineCheck, NamesTheArcsThatCross) {
  // Two neighbours in the wrong order: the arcs to the one and from the other cross.
  Outline bad = test::sphere_band(32).outline;
  OutlineLoop& loop = bad.loops[1];
  std::swap(loop.points[5], loop.points[6]);
  std::swap(loop.normals[5], loop.normals[6]);
  expect_message(bad, e_image_crosses,
                 "the arc from point 4 of loop 1 crosses the arc from point 6 of loop 1", 36,
                 GaussMode::umbilic);
  bool crosses = false;
  for (const Message& message : check_outline(bad, GaussMode::position))
    crosses = crosses || message.code == e_image_crosses;
  EXPECT_FALSE(crosses);  // the mode that needs no simple image
}

TEST(OutlineCheck, UnevenTurning) {
  const test::Truth sphere = test::ellipsoid(Vector3::Ones());
  OutlineLoop loop = test::circle_of_normals(sphere, Vector3::UnitZ(), 1, 64, false);
  for (auto* list : {&loop.points, &loop.normals}) list->erase(list->begin() + 20, list->begin() + 27);
  loop.curvature.resize(loop.points.size());
  expect_message({{loop}}, w_uneven_normals, "point 19", 19);
}

TEST(OutlineCheck, SlantedNormals) {
  Outline bad = golden_outline("sphere_cap");
  const auto tilt = [&](std::size_t i, double degrees) {
    OutlineLoop& loop = bad.loops[0];
    const Vector3 along = (loop.points[i + 1] - loop.points[i - 1]).normalized();
    loop.normals[i] += std::tan(degrees * test::pi / 180) * along;
  };
  tilt(5, 3);
  tilt(9, 4);
  expect_message(bad, w_normal_tangent, "point 9", 9);
  expect_message(bad, w_normal_tangent, "1 other point", 9);
  tilt(12, 14);
  expect_message(bad, e_normal_tangent, "point 12", 12);
}

TEST(OutlineCheck, Curvature) {
  const Outline band = golden_outline("sphere_band");
  Outline bad = band;
  bad.loops[1].curvature.clear();
  expect_message(bad, e_no_curvature, "Loop 1", 20);
  EXPECT_TRUE(check_outline(bad, GaussMode::umbilic).empty());
  bad = band;
  bad.loops[1].curvature[3] = 0;
  expect_message(bad, e_zero_curvature, "point 3 of loop 1", 23);
  bad = band;
  bad.loops[1].curvature[4] = -1;
  expect_message(bad, e_mixed_curvature, "point 4 of loop 1", 24);
  expect_message(golden_outline("saddle"), e_negative_curvature, "point 0", 0, GaussMode::paper);
}

TEST(OutlineCheck, ConvexityHasTwoLimits) {
  const Outline good = golden_outline("sphere_cap");
  for (const auto& [share, code] : {std::pair{1e-2, e_not_convex}, {1e-5, w_not_convex}}) {
    Outline bad = good;
    // Point 6 goes out through the tangent plane of its neighbour.
    const OutlineLoop& loop = good.loops[0];
    const double room = loop.normals[5].dot(loop.points[5] - loop.points[6]);
    bad.loops[0].points[6] +=
        (room + share * good.size()) / loop.normals[5].dot(loop.normals[6]) * loop.normals[6];
    bool found = false;
    for (const Message& message : check_outline(bad, GaussMode::curvature)) {
      if (!(message.code == code)) continue;
      found = true;
      EXPECT_NE(message.text.find("cuts off point 6"), std::string::npos) << message.text;
      // The plane is that of the point before or after.
      const Index plane = message.text.find("plane of point 5 ") != std::string::npos ? 5 : 7;
      EXPECT_EQ(message.element, element_of(VertexId{plane}));
    }
    EXPECT_TRUE(found) << code.name;
  }
}

TEST(OutlineCheck, CrossingArcsAreFoundAsByTryingAllPairs) {
  test::for_random(9301, 60, [](std::mt19937_64& rng) {
    // A random walk on the sphere, closed.
    std::vector<Vector3> loop{test::random_vector(rng).normalized()};
    const int count = test::uniform_int(rng, 4, 30);
    const double step = test::uniform(rng, 0.05, 0.5);
    for (int i = 1; i < count; ++i)
      loop.push_back((loop.back() + test::random_vector(rng, step)).normalized());
    if (angle_between(loop.front(), loop.back()) > 1.4) return;
    const auto n = Index(loop.size());
    std::optional<std::pair<Index, Index>> expected;
    for (Index i = 0; i < n && !expected; ++i)
      for (Index j = i + 2; j < n && !expected; ++j) {
        if (i == 0 && j == n - 1) continue;
        // Arcs cross where their circles meet and each one's ends lie on different sides of that point.
        const Vector3 &a = loop[i], &b = loop[i + 1], &c = loop[j], &d = loop[(j + 1) % n];
        for (const double sign : {1.0, -1.0}) {
          const Vector3 x = sign * a.cross(b).cross(c.cross(d)).normalized();
          const auto on = [&](const Vector3& u, const Vector3& v) {
            return std::abs(angle_between(u, x) + angle_between(x, v) - angle_between(u, v)) < 1e-9;
          };
          if (on(a, b) && on(c, d)) expected = std::pair{i, j};
        }
      }
    EXPECT_EQ(crossing_arcs({loop}), expected);
  });
}

}  // namespace
}  // namespace hariko::test
