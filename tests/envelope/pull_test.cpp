// Pulls: the ball's surface passes through places chosen by hand, and still contains the solids.

#include <Eigen/Geometry>

#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

Solid pulled_ball(const Vector3& at, double radius, std::uint32_t id = 0) {
  Solid out{.kind = SolidKind::sphere};
  out.radius = radius;
  out.position = at;
  out.id = id;
  return out;
}

double pulled_value(const EnvelopeInput& input, const BallEnvelope& made, const Vector3& point) {
  return made.field.value(point - enveloped_scene(input).origin);
}

}  // namespace

TEST(Pulls, OutwardsTheSurfacePassesThroughThePlace) {
  for (const double size : {1e-3, 1.0, 1e6}) {
    EnvelopeInput input = ball_scene({pulled_ball(Vector3::Zero(), size)}, 0.05 * size, 0.5 * size);
    const BallEnvelope plain = made_ball(input);
    for (const double way : {0.2, 0.6, 1.2}) {
      const Vector3 place = (1.04 + way) * size * Vector3(0.6, 0, 0.8);
      input.solids[0].pulls = {{place, 0.5 * size}};
      const BallEnvelope made = made_ball(input);
      EXPECT_NEAR(pulled_value(input, made, place), 0, 1e-6 * size);
      EXPECT_EQ(made.topology.components, 1);
      EXPECT_EQ(made.topology.tunnels, 0);
      EXPECT_EQ(made.folds, 0U);
      EXPECT_EQ(made.coarse, 0U);
      EXPECT_TRUE(made.contains_solids());
      if (way > 1) continue;
      EXPECT_NEAR(pulled_value(input, plain, place), way * size, 0.1 * size)
          << "it moves as far as it is pulled";
      // The other side stays.
      for (const Vector3& far : {Vector3(-1, 0, -0.2), Vector3(-0.7, 0.8, 0)})
        EXPECT_NEAR(pulled_value(input, made, size * far), pulled_value(input, plain, size * far),
                    1e-9 * size);
    }
  }
}

TEST(Pulls, InwardsTheSurfaceGoesToThePlaceOrToTheSolids) {
  EnvelopeInput input =
      ball_scene({pulled_ball({-1.3, 0, 0}, 1, 0), pulled_ball({1.3, 0, 0}, 1, 1)}, 0.05, {});
  const BallEnvelope hull = made_ball(input);
  const Vector3 place(0, 0, 0.8);
  EXPECT_LT(pulled_value(input, hull, place), -0.2);
  input.solids[0].pulls = {{own_place(input.solids[0], place), 0.8}};
  const BallEnvelope made = made_ball(input);
  EXPECT_NEAR(pulled_value(input, made, place), 0, 0.1 * 0.05);
  EXPECT_EQ(made.folds, 0U);
  EXPECT_TRUE(made.contains_solids());
  // A place inside of a solid: as far as the solid.
  input.solids[0].pulls = {{Vector3(0, 0, 0.5), 1}};
  const BallEnvelope stopped = made_ball(input);
  EXPECT_TRUE(stopped.contains_solids());
  EXPECT_LT(pulled_value(input, stopped, {-1.3, 0, 1}), 0);
}

TEST(Pulls, SeveralPlacesAreMetAtOnce) {
  EnvelopeInput input = ball_scene({pulled_ball(Vector3::Zero(), 1)}, 0.03, 0.5);
  const std::vector<Vector3> places{{0, 0, 1.3}, {0.3, 0, 1.25}, {-0.2, 0.3, 1.4}, {1.2, 0, 0}};
  for (const Vector3& place : places) input.solids[0].pulls.push_back({place, 0.6});
  input.solids[0].pulls.push_back(input.solids[0].pulls[0]);  // twice the same
  const BallEnvelope made = made_ball(input);
  for (const Vector3& place : places) EXPECT_NEAR(pulled_value(input, made, place), 0, 1e-6);
  EXPECT_TRUE(made.contains_solids());
}

TEST(Pulls, MoveAndTurnWithTheirSolid) {
  Solid solid = pulled_ball(Vector3::Zero(), 0.7);
  solid.kind = SolidKind::capsule;
  solid.length = 1.5;
  solid.pulls = {{{0.9, 0.2, 0.4}, 0.5}};
  EnvelopeInput input = ball_scene({solid}, 0.04, 0.5);
  const BallEnvelope before = made_ball(input);
  const Vector3 probe(0.85, 0.3, 0.1);
  const double value = pulled_value(input, before, placed(input.solids[0], probe));
  input.solids[0].position = {3, -2, 5};
  input.solids[0].rotation = {30, 40, -70};
  const BallEnvelope after = made_ball(input);
  EXPECT_NEAR(pulled_value(input, after, placed(input.solids[0], input.solids[0].pulls[0].place)), 0, 1e-6);
  // The lattice does not turn along.
  EXPECT_NEAR(pulled_value(input, after, placed(input.solids[0], probe)), value, 0.02 * 0.04);
}

TEST(Pulls, AreMirroredWithTheSolids) {
  for (const bool own_image : {false, true}) {
    const Vector3 at(own_image ? 0 : 1.1, 0.2, 0);
    Solid solid = pulled_ball(at, 0.8);
    solid.rotation = {10, 20, 30};
    solid.pulls = {{own_place(solid, Vector3(at.x() + 0.6, 0.3, 0.9)), 0.5}};
    EnvelopeInput input = ball_scene({solid}, 0.04, 0.5);
    input.settings.symmetry = SymmetryPlane::x;
    const BallEnvelope made = made_ball(input);
    for (const Vector3& p : {Vector3(at.x() + 0.6, 0.3, 0.9), Vector3(0.3, 0.1, 0.8), Vector3(1.7, 0.5, 0.2)})
      EXPECT_NEAR(pulled_value(input, made, p), pulled_value(input, made, {-p.x(), p.y(), p.z()}), 1e-12);
    EXPECT_NEAR(pulled_value(input, made, {-at.x() - 0.6, 0.3, 0.9}), 0, 1e-6);
  }
}

TEST(Pulls, RandomOnesLeaveTheSolidsInside) {
  for_random(9100, 3, [](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    choose_ball(input);
    for (Solid& solid : input.solids) {
      const Eigen::AlignedBox3d box = box_of(solid);
      for (int k = uniform_int(rng, 0, 2); k > 0; --k)
        solid.pulls.push_back(
            {own_place(solid, box.center() + random_vector(rng, 0.6 * box.diagonal().norm())),
             uniform(rng, 0.2, 1) * box.diagonal().norm()});
    }
    const EnvelopeSurface made = envelope_of(input);
    std::vector<SolidShape> shapes;
    for (const Solid& solid : input.solids) shapes.emplace_back(solid, made.origin);
    const double size = solids_size(input.solids);
    const EnclosureReport judged =
        check_enclosure(made.surface, shapes, {.spacing = 2e-3 * size}, 1e-5 * size);
    // The report's claim holds.
    if (made.enclosed) {
      EXPECT_EQ(judged.outside, 0U);
    }
    if (made.coarse == 0) {
      EXPECT_TRUE(made.enclosed);
      EXPECT_EQ(made.folds, 0U);
    }
    EXPECT_TRUE(made.surface.boundary_sides().empty());
  });
}

TEST(Pulls, MistakesNameTheSolid) {
  EnvelopeInput input = ball_scene({pulled_ball(Vector3::Zero(), 1)}, 0.03, 0.5);
  const auto refused = [&](std::vector<Pull> pulls) {
    input.solids[0].pulls = std::move(pulls);
    const auto checked = check_envelope(input);
    return checked ? std::string() : std::string(checked.error().code.name);
  };
  EXPECT_EQ(refused({{{0, 0, 1.5}, 0.3}}), "");
  EXPECT_EQ(refused({{{0, 0, 1.5}, 0}}), "E_SOLID_SIZE");
  EXPECT_EQ(refused({{{0, 0, 9}, 0.3}}), "E_SOLID_PULL");
  EXPECT_EQ(refused({{{0, 0, std::nan("")}, 0.3}}), "E_SOLID_PULL");
  EXPECT_EQ(refused(std::vector<Pull>(max_pulls + 1, Pull{{0, 0, 1.5}, 0.3})), "E_SOLID_PULL");
  input.solids[0].pulls = {{{0, 0, 1.5}, 0.3}};
  input.settings.method = EnvelopeMethod::network;
  const EnvelopeSurface made = envelope_of(input);
  EXPECT_TRUE(std::ranges::any_of(made.warnings, [](const Message& w) { return w.code == w_pulls_unused; }));
}

}  // namespace hariko::test
