// Drags of one solid in fifty steps: the surface goes no farther than the solid, and a frame's surface is the
// final one. The short version drags in two scenes; HARIKO_REPEAT_SCALE=5 drags in ten.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "tests/envelope/ball_measures.hpp"

namespace hariko::test {

namespace {

constexpr int ball_drag_steps = 50;
constexpr double ball_drag_step = 0.005;  ///< part of the scene's size
constexpr double kept_shape = 1e-3;       ///< part of the size: by less than this the lattice moves a surface

/// Point of a surface, and its distance from another one.
struct FarPoint {
  double way = 0;
  Vector3 at = Vector3::Zero();  ///< relative to the origin of the other one
};

/// Point of a surface that is farthest from another one's field's zero. Ways up to `enough` are value over
/// slope; longer ones end at the foot along the gradient, or at the nearest of the other surface's points.
FarPoint farthest_point(const BallEnvelope& from, const BallEnvelope& to, double enough) {
  const Vector3 shift = from.surface.origin() - to.surface.origin();
  const double longest = to.tolerance / patch_tolerance;
  const std::vector<Vector3> others = grid_points(to.surface, 4);
  FarPoint out;
  for (const Vector3& p : grid_points(from.surface, 4)) {
    const Vector3 at = p + shift;
    const FieldPoint found = to.field.at(at);
    double way = std::abs(found.value) / found.gradient.norm();
    if (!(way <= enough)) {
      const Vector3 foot = projected(to.field, at, 12, longest);
      const bool is_foot = std::abs(to.field.value(foot)) <= 1e-6 * longest;
      way = is_foot ? (foot - at).norm() : 1e300;
      for (const Vector3& q : others) way = std::min(way, (q - at).norm());
    }
    if (way > out.way) out = {way, at};
  }
  return out;
}

/// Whether smaller balls reach deeper than larger ones about a place, as far as lattices see a slot.
bool is_by_a_slot(const EnvelopeInput& input, const Vector3& at) {
  const EnvelopedScene scene = enveloped_scene(input);
  const BallSettings ball = ball_settings(input.settings, solids_size(scene.input.solids));
  KnownSolids known;
  std::vector<GrownSolid> grown;
  for (std::size_t i = 0; i < scene.input.solids.size(); ++i)
    grown.push_back(
        known.grown(i, scene.input.solids[i], scene.origin, ball.sigma, ball.on_faces, room_outside(ball)));
  const GrownUnion all(std::move(grown));
  const double accuracy = 1e-3 * ball.sigma, step = 2 * lattice_spacing(ball.sigma, drag_passes);
  const Closing usual(all, ball.radius, accuracy), smaller(all, 0.75 * ball.radius, accuracy),
      larger(all, 1.33 * ball.radius, accuracy);
  for (int c = 0; c < 125; ++c) {
    const Vector3 x = at + step * Vector3(c % 5 - 2, c / 5 % 5 - 2, c / 25 - 2);
    if (slot_test(smaller, larger, ball.radius, x, usual.at(x)).share > 0) return true;
  }
  return false;
}

/// Surface of a frame, with its solids.
struct DragFrame {
  EnvelopeInput input;
  BallEnvelope made;
};

bool is_same_topology(const BallEnvelope& a, const BallEnvelope& b) {
  return a.topology.components == b.topology.components && a.topology.tunnels == b.topology.tunnels &&
         a.pinches == b.pinches;
}

struct DragMoves {
  int events = 0;                ///< steps where topology, pinches or a slot change
  double steady = 0, event = 0;  ///< largest moves of the surface, over the size
};

/// Adds the surface's move in one step.
void add_step(const DragFrame& before, const DragFrame& now, double size, DragMoves& moves) {
  const double enough = (ball_drag_step + kept_shape) * size;
  const FarPoint forwards = farthest_point(before.made, now.made, enough);
  const FarPoint back = farthest_point(now.made, before.made, enough);
  const double way = std::max(forwards.way, back.way);
  const bool fits =
      forwards.way <= enough + deviation_of(before.made) && back.way <= enough + deviation_of(now.made);
  const Vector3 shift = now.made.surface.origin() - before.made.surface.origin();
  const auto by_a_slot = [&](const FarPoint& in_now, const FarPoint& in_before) {
    return is_by_a_slot(now.input, in_now.at) || is_by_a_slot(before.input, in_before.at) ||
           is_by_a_slot(now.input, in_before.at - shift) || is_by_a_slot(before.input, in_now.at + shift);
  };
  const bool event = !is_same_topology(before.made, now.made) || (!fits && by_a_slot(forwards, back));
  moves.events += event;
  double& largest = event ? moves.event : moves.steady;
  largest = std::max(largest, way / size);
  if (event) {
    EXPECT_LE(way, 0.05 * size);
  } else {
    EXPECT_TRUE(fits) << "the surface goes " << way / size << " of the size, patches deviate by "
                      << std::max(deviation_of(before.made), deviation_of(now.made)) / size;
  }
}

DragMoves dragged(EnvelopeInput input) {
  const double size = solids_size(input.solids);
  const Vector3 step = ball_drag_step * size * Vector3(0.8, 0.36, 0.48);
  BallMemory memory;
  DragMoves out;
  DragFrame before{input, made_ball(input, Quality::drag, &memory)};
  for (int k = 1; k <= ball_drag_steps; ++k) {
    SCOPED_TRACE(testing::Message() << "step " << k);
    input.solids[1].position += step;
    DragFrame now{input, made_ball(input, Quality::drag, &memory)};
    add_step(before, now, size, out);
    before = std::move(now);
  }
  return out;
}

}  // namespace

TEST(BallDrags, TheSurfaceGoesNoFartherThanTheSolid) {
  const char* const scenes[] = {"four",  "ten", "ell", "car",   "camera",
                                "dryer", "you", "tee", "ring6", "two_touch"};
  const std::size_t count = std::min(std::size(scenes), std::size_t(repetitions(2)));
  for (std::size_t k = 0; k < count; ++k) {
    SCOPED_TRACE(scenes[k]);
    const DragMoves found = dragged(with_ball(golden_scene(scenes[k]), 0.3, 0.035));
    std::cout << scenes[k] << ": steps of " << ball_drag_step << " of the size, largest move " << found.steady
              << "; " << found.events << " events, largest move " << found.event << "\n";
    EXPECT_LT(2 * found.events, ball_drag_steps);
  }
}

TEST(BallDrags, FramesHaveTheFinalShape) {
  for (const char* const name : {"four", "ten"}) {
    const EnvelopeInput scene = with_ball(golden_scene(name), 0.3, 0.035);
    const double size = solids_size(scene.solids);
    double largest = 0;
    for_random(3602, 3, [&](std::mt19937_64& rng) {
      EnvelopeInput input = scene;
      input.solids[1].position += random_vector(rng, 0.1 * size);
      const BallEnvelope frame = made_ball(input, Quality::drag), last = made_ball(input);
      EXPECT_EQ(frame.topology.components, last.topology.components) << name;
      EXPECT_EQ(frame.topology.tunnels, last.topology.tunnels) << name;
      const double enough = kept_shape * size + deviation_of(frame) + deviation_of(last);
      const double way =
          std::max(farthest_point(frame, last, enough).way, farthest_point(last, frame, enough).way);
      EXPECT_LE(way, enough) << name;
      largest = std::max(largest, way / size);
    });
    std::cout << name << ": a frame and the final surface are " << largest << " of the size apart\n";
  }
}

}  // namespace hariko::test
