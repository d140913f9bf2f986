// Frames of a drag take what did not change from the frame before: every one of them is, bit for bit, the one
// that is made from nothing. HARIKO_REPEAT_SCALE makes more random scenes.

#include "core/base/equal_bits.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

constexpr int frames_of_a_drag = 50;

/// Frame of a drag, from what the frames before left where there is a memory.
BallField field_of_frame(const EnvelopeInput& input, BallMemory* memory, Quality quality = Quality::drag,
                         const CancelToken& cancel = {}) {
  const EnvelopedScene scene = enveloped_scene(input);
  return ball_field(scene.input.solids, ball_settings(input.settings, solids_size(scene.input.solids)),
                    scene.origin, scene.mirror, quality, cancel, memory);
}

void expect_same_field(const BallField& kept, const BallField& cold) {
  const std::array<int, 3> size = cold.field.size();
  ASSERT_EQ(kept.field.size(), size);
  EXPECT_TRUE(equal_bits(kept.field.corner(), cold.field.corner()));
  std::size_t differing = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        differing += !equal_bits(kept.field.weight(i, j, k), cold.field.weight(i, j, k));
  ASSERT_EQ(differing, 0U) << "of " << cold.lattice.nodes << " coefficients";
  EXPECT_EQ(kept.pinches, cold.pinches);
  EXPECT_EQ(kept.lattice.evaluated, cold.lattice.evaluated);
  EXPECT_EQ(kept.lattice.crease, cold.lattice.crease);
  EXPECT_LE(kept.lattice.searched, cold.lattice.searched);
}

/// Small steps as of a mouse, mostly; turns, stretches, and jumps.
void move_a_solid(std::mt19937_64& rng, double size, std::vector<Solid>& solids) {
  Solid& solid = solids[std::size_t(uniform_int(rng, 0, int(solids.size()) - 1))];
  switch (uniform_int(rng, 0, 9)) {
    case 0:
      solid.position += random_vector(rng, 0.2 * size);
      break;
    case 1:
      solid.scale[uniform_int(rng, 0, 2)] *= uniform(rng, 0.9, 1.1);
      break;
    case 2:
    case 3:
      solid.rotation += random_vector(rng, 5);
      break;
    default:
      solid.position += random_vector(rng, 0.006 * size);
  }
}

/// Drags solids, and compares every frame with one that is made from nothing. Lengths are parts of the
/// scene's size; a radius of 0 is the hull.
void check_frames(EnvelopeInput input, double rounding, double radius, std::mt19937_64& rng) {
  const double size = solids_size(input.solids);
  input.settings.method = EnvelopeMethod::ball;
  input.settings.rounding = rounding * size;
  input.settings.ball_radius.reset();
  if (radius > 0) input.settings.ball_radius = radius * size;
  BallMemory memory;
  for (int frame = 0; frame < frames_of_a_drag; ++frame) {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const BallField kept = field_of_frame(input, &memory), cold = field_of_frame(input, nullptr);
    ASSERT_NO_FATAL_FAILURE(expect_same_field(kept, cold));
    if (frame == 20) field_of_frame(input, &memory, Quality::final);  // as where a drag pauses
    move_a_solid(rng, size, input.solids);
  }
}

/// Changes of all kinds that come between two frames without an end of the drag: by undo, by other views.
void change_something(std::mt19937_64& rng, double size, EnvelopeInput& input) {
  EnvelopeSettings& settings = input.settings;
  std::vector<Solid>& solids = input.solids;
  Solid& one = solids[std::size_t(uniform_int(rng, 0, int(solids.size()) - 1))];
  switch (uniform_int(rng, 0, 10)) {
    case 0:
      solids.push_back(one);
      solids.back().position += random_vector(rng, 0.2 * size);
      solids.back().id = std::uint32_t(1000 + rng() % 1000000);
      break;
    case 1:
      if (solids.size() > 3) solids.erase(solids.begin() + uniform_int(rng, 0, int(solids.size()) - 1));
      break;
    case 2:
      std::swap(one, solids.back());
      break;
    case 3:
      settings.clearance = settings.clearance > 0 ? 0 : 0.01 * size;
      break;
    case 4:
      settings.on_faces = !settings.on_faces;
      break;
    case 5:
      settings.symmetry = settings.symmetry == SymmetryPlane::none ? SymmetryPlane::x : SymmetryPlane::none;
      break;
    case 6:
      one.pulls.empty() ? one.pulls.push_back({Vector3(0, 0, 0.8), 0.3 * size}) : one.pulls.clear();
      break;
    case 7:
      solids.push_back(bridge_between(solids[0], solids[1], 0.05 * size));
      solids.back().id = std::uint32_t(1000 + rng() % 1000000);
      if (chance(rng, 0.5)) solids.back().bridge->ball_radius = uniform(rng, 0.1, 0.5) * size;
      break;
    case 8:
      one.roundness = one.roundness ? std::nullopt : std::optional(0.5);
      break;
    case 9:
      settings.ball_radius = uniform(rng, 0.15, 0.4) * size;
      break;
    default:
      move_a_solid(rng, size, solids);
  }
}

Solid wall_at(const Vector3& size, const Vector3& at, std::uint32_t id) {
  Solid out;
  out.size = size;
  out.position = at;
  out.id = id;
  return out;
}

/// Two boxes that make a corner, and a small ball far from them.
EnvelopeInput corner_and_ball() {
  Solid ball;
  ball.kind = SolidKind::sphere;
  ball.radius = 0.3;
  ball.position = {4, 0, 0};
  ball.id = 2;
  return ball_scene({wall_at({2, 2, 0.5}, {0, 0, 0}, 0), wall_at({0.5, 2, 2}, {-0.75, 0, 0.75}, 1), ball},
                    0.12, 0.5);
}

GrownUnion grown_by_a_little(const std::vector<Solid>& solids) {
  std::vector<GrownSolid> out;
  for (const Solid& solid : solids) out.push_back({SolidShape(solid, Vector3::Zero()), 0.02});
  return GrownUnion(std::move(out));
}

}  // namespace

TEST(KeptFrames, ResultsHoldWhereOnlySolidsOutOfTheirReachMove) {
  constexpr double accuracy = 5e-5, margin = 1e-5;
  int held = 0, reached = 0;
  for_random(10, 20, [&](std::mt19937_64& rng) {
    std::vector<Solid> solids = random_scene(rng).solids;
    for (Solid& solid : solids)
      if (chance(rng, 0.2)) solid.scale = {uniform(rng, 0.5, 2), uniform(rng, 0.5, 2), 1};
    const GrownUnion before = grown_by_a_little(solids);
    const auto moved = Index(uniform_int(rng, 0, int(solids.size()) - 1));
    solids[moved].position += random_vector(rng, chance(rng, 0.5) ? 0.05 : 1);
    solids[moved].rotation += random_vector(rng, 20);
    const GrownUnion now = grown_by_a_little(solids);
    const double radius = log_uniform(rng, 0.1, 3);
    const Closing old_ball(before, radius, accuracy), new_ball(now, radius, accuracy);
    for (int k = 0; k < 100; ++k) {
      const Vector3 at = solids[0].position + random_vector(rng, 2.5);
      const Vector3 start = at + random_vector(rng, radius);
      ClosingReach reach;
      const Vector3* const from = k % 2 == 0 ? nullptr : &start;
      const ClosedDistance was = old_ball.at(at, from, &reach);
      EXPECT_TRUE(equal_bits(was, old_ball.at(at, from))) << "the reach does not matter";
      const double within = reach.reach + margin;
      if (moved == reach.blocker || !before.is_beyond(moved, reach.about, within) ||
          !now.is_beyond(moved, reach.about, within)) {
        ++reached;
        continue;
      }
      ++held;
      ASSERT_TRUE(equal_bits(new_ball.at(at, from), was)) << at.transpose();
    }
  });
  EXPECT_GT(held, reached / 10);
  EXPECT_GT(reached, 0);
}

TEST(KeptFrames, ReachIsTheSmallestBallThatHoldsBoth) {
  for_random(15, 50, [](std::mt19937_64& rng) {
    const Vector3 one = random_vector(rng), other = random_vector(rng);
    const double radius = uniform(rng, -1, 2), radius_of_other = uniform(rng, -1, 2);
    const double way = (other - one).norm();
    ClosingReach reach;
    reach.include(one, radius);
    EXPECT_TRUE(equal_bits(reach.about, one) && equal_bits(reach.reach, radius));
    reach.include(other, radius_of_other);
    EXPECT_GE(reach.reach + 1e-12, (one - reach.about).norm() + radius);
    EXPECT_GE(reach.reach + 1e-12, (other - reach.about).norm() + radius_of_other);
    EXPECT_NEAR(reach.reach, std::max({radius, radius_of_other, 0.5 * (way + radius + radius_of_other)}),
                1e-12);
  });
}

TEST(KeptFrames, AreThoseMadeFromNothingWithLooseAndTightBalls) {
  for_random(11, 1, [&](std::mt19937_64& rng) {
    for (const double radius : {0.15, 0.3, 1.0, 0.0}) {
      SCOPED_TRACE("radius " + std::to_string(radius));
      check_frames(golden_scene("four"), 0.05, radius, rng);
    }
    check_frames(golden_scene("ten"), 0.05, 0.2, rng);
  });
}

TEST(KeptFrames, AreThoseMadeFromNothingInSlots) {
  // A ball of 0.75 R fits between the walls, one of 1.33 R does not.
  const EnvelopeInput trough{{wall_at({2, 1.9, 0.2}, {0, 0, 0.1}, 0), wall_at({2, 0.2, 2}, {0, 0.85, 1}, 1),
                              wall_at({2, 0.2, 2}, {0, -0.85, 1}, 2)},
                             {}};
  for_random(12, 1, [&](std::mt19937_64& rng) { check_frames(trough, 0.04, 0.17, rng); });
}

TEST(KeptFrames, AreThoseMadeFromNothingWithImagesAndPulls) {
  for_random(13, 1, [&](std::mt19937_64& rng) {
    EnvelopeInput input = golden_scene("four");
    input.settings.symmetry = SymmetryPlane::x;
    check_frames(input, 0.05, 0.3, rng);
    input = golden_scene("four");
    input.solids[0].pulls = {{Vector3(0, 0, 1), 0.5}};
    check_frames(input, 0.05, 0.3, rng);
  });
}

TEST(KeptFrames, AreThoseMadeFromNothingForRandomScenes) {
  for_random(14, 2, [&](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    for (Solid& solid : input.solids)
      if (chance(rng, 0.1)) solid.scale = {uniform(rng, 0.5, 2), uniform(rng, 0.5, 2), 1};
    check_frames(input, 0.05, log_uniform(rng, 0.15, 1), rng);
  });
}

TEST(KeptFrames, AreThoseMadeFromNothingWhateverChanges) {
  std::size_t searched = 0, evaluated = 0;
  for_random(16, 3, [&](std::mt19937_64& rng) {
    EnvelopeInput input = golden_scene("four");
    for (std::uint32_t i = 0; i < input.solids.size(); ++i) input.solids[i].id = i;
    const double size = solids_size(input.solids);
    input.settings.method = EnvelopeMethod::ball;
    input.settings.rounding = 0.06 * size;
    input.settings.ball_radius = 0.25 * size;
    BallMemory memory;
    for (int frame = 0; frame < frames_of_a_drag; ++frame) {
      SCOPED_TRACE("frame " + std::to_string(frame));
      const BallField kept = field_of_frame(input, &memory), cold = field_of_frame(input, nullptr);
      ASSERT_NO_FATAL_FAILURE(expect_same_field(kept, cold));
      searched += kept.lattice.searched;
      evaluated += kept.lattice.evaluated;
      if (frame % 2 == 0)
        change_something(rng, size, input);
      else
        move_a_solid(rng, size, input.solids);
    }
  });
  EXPECT_LT(searched, evaluated) << "something is kept";
}

TEST(KeptFrames, LeadToTheSameSurface) {
  EnvelopeInput input = corner_and_ball();
  EnvelopeSurfacer surfacer;
  for (int frame = 0; frame < 8; ++frame) {
    const auto kept = surfacer.rebuild(input, Quality::drag);
    const auto cold = EnvelopeSurfacer().rebuild(input, Quality::drag);
    ASSERT_TRUE(kept.ok() && cold.ok());
    EXPECT_EQ(kept->cage->quads, cold->cage->quads);
    ASSERT_EQ(kept->cage->positions.size(), cold->cage->positions.size());
    for (std::size_t v = 0; v < kept->cage->positions.size(); ++v)
      ASSERT_TRUE(equal_bits(kept->cage->positions[v], cold->cage->positions[v])) << v;
    input.solids[2].position.x() -= 0.3;
  }
}

TEST(KeptFrames, AreSearchedWhereTheMovedSolidIsInReachAlone) {
  EnvelopeInput input = corner_and_ball();
  BallMemory memory;
  const BallField first = field_of_frame(input, &memory);
  EXPECT_GT(first.lattice.crease, 0U);
  EXPECT_EQ(first.lattice.searched, first.lattice.evaluated);
  EXPECT_EQ(field_of_frame(input, &memory).lattice.searched, 0U) << "nothing moved";
  for (int step = 0; step < 5; ++step) {
    input.solids[2].position.y() += 0.02;
    const BallField now = field_of_frame(input, &memory);
    EXPECT_GT(now.lattice.searched, 0U);
    EXPECT_LT(2 * now.lattice.searched, now.lattice.evaluated);
  }
  input.settings.rounding *= 1.01;
  const BallField other = field_of_frame(input, &memory);
  EXPECT_EQ(other.lattice.searched, other.lattice.evaluated) << "another lattice";
}

TEST(KeptFrames, ThatWereCancelledLeaveNothing) {
  EnvelopeInput input = corner_and_ball();
  BallMemory memory;
  field_of_frame(input, &memory);
  input.solids[2].position.x() -= 2.5;
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  field_of_frame(input, &memory, Quality::drag, cancel);
  const BallField after = field_of_frame(input, &memory);
  EXPECT_EQ(after.lattice.searched, after.lattice.evaluated);
  expect_same_field(after, field_of_frame(input, nullptr));
}

}  // namespace hariko::test
