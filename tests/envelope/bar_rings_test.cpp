// Waists on a field's cage: rings round the bars through gaps.

#include "core/envelope/bar_rings.hpp"

#include <algorithm>
#include <set>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/envelope/field_envelope.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

/// A box and a ball with a gap that a bar bridges.
EnvelopeInput solids_with_gap(double gap) {
  EnvelopeInput input;
  Solid box, ball;
  box.size = {1, 0.8, 0.6};
  ball.kind = SolidKind::sphere;
  ball.radius = 0.45;
  ball.position = {0.95 + gap, 0, 0};
  ball.id = 1;
  input.solids = {box, ball};
  input.settings.tightness = 1;
  input.settings.method = EnvelopeMethod::field;
  return input;
}

/// Mean distance of a pair's handles from their middle.
double girth(const EnvelopeSurface& made, const SolidPair& pair) {
  Vector3 middle = Vector3::Zero();
  double count = 0;
  for (const EnvelopeBridge& bridge : made.handles.bridges)
    if (bridge.solids == pair) middle += bridge.middle, count += 1;
  middle /= count;
  double out = 0;
  for (const EnvelopeBridge& bridge : made.handles.bridges)
    if (bridge.solids == pair) out += (bridge.middle - middle).norm() / count;
  return out;
}

}  // namespace

TEST(BarRings, EveryGapHasHandlesRoundItsBarOnTheSurface) {
  for (EnvelopeInput input : {solids_with_gap(0.3), golden_scene("ring6")}) {
    SCOPED_TRACE(input.solids.size());
    input.settings.method = EnvelopeMethod::field;
    const auto made = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(made.ok());
    EXPECT_TRUE(made->warnings.empty());
    std::set<SolidPair> pairs;
    for (const EnvelopeBridge& bridge : made->handles.bridges) {
      pairs.insert(bridge.solids);
      EXPECT_NEAR(bridge.outward.norm(), 1, 1e-12);
      EXPECT_GT(bridge.outward.dot(bridge.way), 0.5 * bridge.way.norm());
    }
    EXPECT_EQ(pairs.size(), input.solids.size() == 2 ? 1U : 6U);
    EXPECT_GE(made->handles.bridges.size(), 4 * pairs.size());
  }
}

TEST(BarRings, TheGirthFollowsTheFactorOfThePair) {
  for (const double gap : {0.15, 0.3, 0.6}) {
    SCOPED_TRACE(gap);
    EnvelopeInput input = solids_with_gap(gap);
    const auto usual = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(usual.ok());
    const SolidPair pair{0, 1};
    const double natural = girth(*usual, pair);
    double before = 0;
    for (const double factor : {0.3, 0.5, 0.75, 0.95, 1.05, 1.2, 1.5, 2.0}) {
      SCOPED_TRACE(factor);
      input.settings.waists.set(pair, factor);
      const auto made = EnvelopeSurfacer().rebuild(input);
      ASSERT_TRUE(made.ok());
      EXPECT_EQ(made->route, EnvelopeRoute::field);
      EXPECT_TRUE(made->enclosed);
      EXPECT_TRUE(made->warnings.empty());
      EXPECT_EQ(made->components, 1);
      EXPECT_LE(continuity(made->surface).largest_normal_jump.value(), 1e-10);
      const double now = girth(*made, pair) / natural;
      EXPECT_GT(now, before);
      before = now;
      // What the solids leave room for: surfaces are pushed out, never in.
      EXPECT_GE(now, factor * (1 - 1e-9));
      if (gap == 0.6 || factor > 1) {
        EXPECT_LE(now, 1.02 * factor);
      }
    }
  }
}

TEST(BarRings, ARingAsThickAsItIsHardlyChangesTheSurface) {
  for (const double gap : {0.15, 0.3, 0.6}) {
    SCOPED_TRACE(gap);
    EnvelopeInput input = solids_with_gap(gap);
    const auto usual = EnvelopeSurfacer().rebuild(input);
    input.settings.waists.set({0, 1}, 1 + 1e-6);
    const auto ringed = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(usual.ok() && ringed.ok());
    EXPECT_GE(ringed->cage->face_count(), usual->cage->face_count());
    const double volume = measure(usual->surface).volume.value(),
                 other = measure(ringed->surface).volume.value();
    EXPECT_NEAR(other / volume, 1, 0.01);
  }
}

TEST(BarRings, ABarWithoutARingSaysSo) {
  // Bars run into each other where gaps meet; which of them have rings shows by their handles.
  EnvelopeInput input = golden_scene("ten");
  input.settings.method = EnvelopeMethod::field;
  input.settings.tightness = 1;
  const EnvelopedScene scene = enveloped_scene(input);
  std::set<SolidPair> bars, with_handles;
  for (const FieldCluster& cluster : field_scene(input, scene.placed, scene.origin).clusters)
    for (const FieldBar& bar : cluster.bars) bars.insert(bar.solids);
  // Of the bars only: the common waist is that of notches, too.
  for (const SolidPair& pair : bars) input.settings.waists.set(pair, 0.6);
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok());
  for (const EnvelopeBridge& bridge : made->handles.bridges) with_handles.insert(bridge.solids);
  const auto ringed =
      std::ranges::count_if(bars, [&](const SolidPair& p) { return with_handles.contains(p); });
  ASSERT_LT(std::size_t(ringed), bars.size());
  EXPECT_TRUE(warned(*made, w_waist_limited));
}

TEST(BarRings, NoTwoRingsShareAFace) {
  const EnvelopeInput input = solids_with_gap(0.3);
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok());
  std::vector<PlacedSolid> placed = place_solids(input);
  for (PlacedSolid& solid : placed) solid.centre -= made->origin;
  std::vector<FieldBar> bars = field_scene(input, placed, made->origin).clusters.at(0).bars;
  ASSERT_EQ(bars.size(), 1U);
  bars.push_back(bars[0]);
  EXPECT_EQ(bar_rings(bars, *made->cage, made->surface).size(), 1U);
}

TEST(BarRings, TheCommonWaistDoesTheSame) {
  EnvelopeInput one = solids_with_gap(0.6), other = one;
  one.settings.waists.set({0, 1}, 0.5);
  other.settings.waist = 0.25;
  const auto by_factor = EnvelopeSurfacer().rebuild(one), by_waist = EnvelopeSurfacer().rebuild(other);
  ASSERT_TRUE(by_factor.ok() && by_waist.ok());
  EXPECT_EQ(by_factor->cage->positions(), by_waist->cage->positions());
}

TEST(BarRings, HandlesGoTheWayThatIsTold) {
  EnvelopeInput input = solids_with_gap(0.6);
  for (const double factor : {0.8, 1.6}) {
    SCOPED_TRACE(factor);
    constexpr double step = 0.01;
    input.settings.waists.set({0, 1}, factor);
    const auto before = EnvelopeSurfacer().rebuild(input);
    input.settings.waists.set({0, 1}, factor + step);
    const auto after = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(before.ok() && after.ok());
    ASSERT_EQ(before->handles.bridges.size(), after->handles.bridges.size());
    for (std::size_t i = 0; i < before->handles.bridges.size(); ++i) {
      const Vector3 gone = after->handles.bridges[i].middle - before->handles.bridges[i].middle;
      EXPECT_LE((gone - step * before->handles.bridges[i].way).norm(), 0.2 * gone.norm());
    }
  }
}

TEST(BarRings, SymmetricScenesStaySymmetric) {
  EnvelopeInput input = solids_with_gap(0.6);
  input.solids[1].position += Vector3(0, 0.1, 0);
  input.settings.symmetry = SymmetryPlane::z;
  for (const double factor : {0.6, 1.4}) {
    SCOPED_TRACE(factor);
    input.settings.waists.set({0, 1}, factor);
    const auto made = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(made.ok());
    EXPECT_TRUE(made->symmetric);
    EXPECT_TRUE(made->enclosed);
    EXPECT_TRUE(made->warnings.empty());
  }
}

TEST(BarRings, DraggingDrawsThemInToo) {
  EnvelopeInput input = solids_with_gap(0.6);
  EnvelopeSurfacer surfacer;
  const auto before = surfacer.rebuild(input);
  input.settings.waists.set({0, 1}, 0.5);
  const auto dragged = surfacer.rebuild(input, Quality::drag);
  const auto after = surfacer.rebuild(input);
  ASSERT_TRUE(before.ok() && dragged.ok() && after.ok());
  EXPECT_NEAR(girth(*dragged, {0, 1}), 0.5 * girth(*before, {0, 1}), 0.02);
  EXPECT_EQ(dragged->cage->face_count(), after->cage->face_count());
}

TEST(BarRings, TheRingOfSixKeepsItsHoleAndItsFaces) {
  EnvelopeInput input = golden_scene("ring6");
  const auto usual = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(usual.ok());
  for (const double waist : {0.3, 0.8}) {
    SCOPED_TRACE(waist);
    input.settings.waist = waist;
    const auto made = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(made->tunnels, 1);
    EXPECT_TRUE(made->enclosed);
    EXPECT_EQ(made->folds, 0U);
    std::set<SolidPair> pairs;
    for (const EnvelopeBridge& bridge : made->handles.bridges) pairs.insert(bridge.solids);
    EXPECT_EQ(pairs.size(), 6U);
    for (const SolidPair& pair : pairs) {
      if (waist > 0.5) {
        EXPECT_GT(girth(*made, pair), girth(*usual, pair));
      } else {
        EXPECT_LT(girth(*made, pair), girth(*usual, pair));
      }
    }
  }
}

}  // namespace hariko::test
