// Solids, their messages, hulls and winding numbers.

#include <Eigen/Geometry>

#include "core/envelope/solid_shape.hpp"
#include "core/geometry/tolerant_hull.hpp"
#include "core/geometry/winding_tree.hpp"
#include "core/surface/tessellation.hpp"
#include "tests/envelope/envelope_scenes.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko::test {

namespace {

void expect_code(const EnvelopeInput& input, Code code, const std::string& words) {
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code.name, code.name);
  EXPECT_NE(made.error().text.find(words), std::string::npos) << made.error().text;
  EXPECT_FALSE(made.error().remedy.empty());
}

EnvelopeInput one(Solid solid) {
  EnvelopeInput out;
  out.solids = {Solid{}, std::move(solid)};
  out.solids[1].id = 1;
  return out;
}

}  // namespace

TEST(Solids, BadOnesAreNamed) {
  expect_code({}, e_no_solids, "no solids");
  EnvelopeInput many;
  many.solids.resize(201);
  expect_code(many, e_too_many_solids, "201");
  Solid s;
  s.size.y() = 0;
  expect_code(one(s), e_solid_size, "Solid 1 (box): size");
  s = {};
  s.scale.z() = -1;
  expect_code(one(s), e_solid_size, "scale");
  s = {.kind = SolidKind::sphere, .radius = std::nan("")};
  expect_code(one(s), e_solid_size, "radius");
  s = {.kind = SolidKind::cylinder, .height = 1e300};
  expect_code(one(s), e_solid_size, "height");
  s = {.kind = SolidKind::prism, .sides = 2};
  expect_code(one(s), e_solid_sides, "sides");
  s = {.kind = SolidKind::torus, .radius = 0.2, .tube = 0.2};
  expect_code(one(s), e_solid_tube, "tube");
  s = {.kind = SolidKind::polyhedron, .points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  expect_code(one(s), e_solid_points, "vertices");
  s.points.push_back({1, 1, 0});
  expect_code(one(s), e_solid_flat, "plane");
  s.points[3].z() = INFINITY;
  expect_code(one(s), e_solid_points, "finite");
  s = {};
  s.position.x() = INFINITY;
  expect_code(one(s), e_solid_place, "position");
  s = {};
  s.roundness = 0;
  expect_code(one(s), e_envelope_setting, "roundness");
  for (const auto& [change, name] :
       std::initializer_list<std::pair<void (*)(EnvelopeSettings&), const char*>>{
           {[](EnvelopeSettings& e) { e.roundness = 1.5; }, "roundness"},
           {[](EnvelopeSettings& e) { e.clearance = -1; }, "clearance"},
           {[](EnvelopeSettings& e) { e.ball_radius = 0; }, "ball_radius"},
           {[](EnvelopeSettings& e) { e.method = EnvelopeMethod::ball; }, "rounding"}}) {
    EnvelopeInput input = one({});
    change(input.settings);
    expect_code(input, e_envelope_setting, name);
  }
}

TEST(Solids, ScenesWithMistakesSayWhere) {
  const auto unknown = read_scene(R"({"primitives": [{"type": "box"}, {"type": "ball"}]})");
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().text.find("primitives[1].type"), std::string::npos) << unknown.error().text;
  const auto bad = read_scene(R"({"primitives": [{"type": "sphere", "radius": -1}]})");
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().code.name, e_solid_size.name);
  EXPECT_NE(bad.error().text.find("Solid 0 (sphere): radius"), std::string::npos);
  EXPECT_FALSE(read_scene("{").ok());
}

TEST(Solids, MissingRoundnessIsOneHalfAndAnglesTurnRoundXFirst) {
  const auto scene = must(read_scene(R"({"primitives": [{"type": "box", "rotation": [90, 0, 90]}]})"));
  EXPECT_EQ(scene->settings.roundness, 0.5);
  const Matrix3 r = solid_rotation(scene->solids[0].rotation);
  EXPECT_LT((r * Vector3(0, 1, 0) - Vector3(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((r * Vector3(1, 0, 0) - Vector3(0, 1, 0)).norm(), 1e-12);
}

TEST(Solids, ScenesGetTheBallButForWhatWasANetwork) {
  const auto method = [](const std::string& members) {
    const auto scene =
        must(read_scene("{\"primitives\": [{\"type\": \"box\", \"size\": [2, 2, 1]}]" + members + "}"));
    return scene->settings;
  };
  EXPECT_EQ(method("").method, EnvelopeMethod::ball);
  EXPECT_NEAR(method("").rounding, 0.06, 1e-12);
  EXPECT_FALSE(method("").converted.method);
  EXPECT_EQ(method(R"(, "tightness": 0)").method, EnvelopeMethod::network);
  EXPECT_EQ(method(R"(, "tightness": 0.4)").method, EnvelopeMethod::ball);
  EXPECT_TRUE(method(R"(, "tightness": 0.4)").converted.method);
  EXPECT_EQ(method(R"(, "method": "network", "tightness": 1)").method, EnvelopeMethod::network);
  EXPECT_EQ(method(R"(, "method": "network", "tightness": 1)").converted.lost, "tightness");
  EXPECT_EQ(method(R"(, "tightness": 0, "waist": 0.5)").converted.lost, "") << "as usual";
  EXPECT_EQ(
      method(R"(, "tightness": 1, "waist": 0.2, "surface": "fair", "waists": [[0, 1, 2]])").converted.lost,
      "waist, surface, waists");
  EXPECT_EQ(method(R"(, "method": "ball", "rounding": 0.1, "waist": 0.2)").converted.lost, "")
      << "it meant nothing";
  EXPECT_EQ(method(R"(, "rounding": 0.25, "ball_radius": 3)").rounding, 0.25);
  EXPECT_EQ(method(R"(, "rounding": 0.25, "ball_radius": 3)").ball_radius, 3);
  EXPECT_FALSE(method(R"(, "ball_radius": "hull")").ball_radius.has_value());
  EXPECT_FALSE(read_scene(R"({"primitives": [{"type": "box"}], "ball_radius": -1})").ok());
}

TEST(Solids, BoxesHoldTheSolids) {
  for_random(17, 50, [](std::mt19937_64& rng) {
    const EnvelopeInput input = random_scene(rng);
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Solid& solid : input.solids) boxes.push_back(box_of(solid));
    for (std::size_t k = 0; k < input.solids.size(); ++k) {
      const SolidShape shape(input.solids[k], Vector3::Zero());
      Eigen::AlignedBox3d tight;
      for (const Vector3& point : shape.surface_points(400)) {
        EXPECT_LT(boxes[k].exteriorDistance(point), 1e-9 * shape.reach());
        EXPECT_NEAR(shape.distance(point), 0, 1e-9 * shape.reach());
        tight.extend(point);
      }
      EXPECT_LT(boxes[k].sizes().maxCoeff(), 2.5 * tight.sizes().maxCoeff());
    }
  });
}

TEST(ConvexHulls, HoldAllPointsAndHaveCornersOnly) {
  for_random(12, 40, [](std::mt19937_64& rng) {
    std::vector<Vector3> points;
    const bool grid = chance(rng, 0.5);
    const int count = uniform_int(rng, 4, 120);
    for (int i = 0; i < count; ++i)
      points.push_back(grid ? Vector3(uniform_int(rng, 0, 3), uniform_int(rng, 0, 3), uniform_int(rng, 0, 3))
                            : random_vector(rng));
    const TolerantHull hull = tolerant_hull(points, 1e-9);
    std::map<std::pair<Index, Index>, int> edges;
    for (const auto& t : hull.triangles) {
      const Vector3 n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).normalized();
      for (const Vector3& p : points) EXPECT_LT((p - points[t[0]]).dot(n), 1e-8);
      for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [edge, uses] : edges) {
      EXPECT_EQ(uses, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    if (!hull.triangles.empty()) {
      EXPECT_EQ(long(hull.vertices.size()) - long(edges.size() / 2) + long(hull.triangles.size()), 2);
    }
    // A corner of a grid is no mean of two other points of it.
    if (!grid) return;
    for (const Index v : hull.vertices)
      for (const Vector3& p : points)
        for (const Vector3& q : points)
          EXPECT_FALSE(((p + q) / 2 - points[v]).norm() < 1e-12 && p != q) << points[v].transpose();
  });
}

TEST(WindingNumbers, SayInsideOfASphereAndHowFar) {
  const Surface surface = sphere(2);
  const TriangleMesh mesh = tessellate(surface, 24);
  const WindingTree tree(mesh.positions, mesh.triangles);
  for_random(13, 200, [&](std::mt19937_64& rng) {
    const Vector3 p = random_vector(rng, 3);
    if (std::abs(p.norm() - 2) < 0.02) return;
    EXPECT_NEAR(tree.winding(p), p.norm() < 2 ? 1 : 0, 0.02);
    const double distance = tree.nearest(p).distance;
    EXPECT_NEAR(distance, std::abs(p.norm() - 2), 0.01);
    EXPECT_TRUE(tree.is_clear(p, 0.999 * distance));
    EXPECT_FALSE(tree.is_clear(p, 1.001 * distance));
  });
}

}  // namespace hariko::test
