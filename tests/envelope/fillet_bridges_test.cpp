// The waist between solids that touch, on a field's cage.

#include "core/envelope/fillet_bridges.hpp"

#include <algorithm>
#include <set>

#include "core/analysis/measures.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

double volume_of(const EnvelopeSurface& made) {
  return *measure(made.surface).volume;
}

}  // namespace

TEST(FilletBridges, EveryNotchHasHandles) {
  for (const auto& [name, pairs] :
       {std::pair("camera", std::set<SolidPair>{{0, 1}, {0, 2}}),
        std::pair("dryer", std::set<SolidPair>{{0, 1}}), std::pair("tee", std::set<SolidPair>{{0, 1}}),
        std::pair("ell_tight", std::set<SolidPair>{{0, 1}})}) {
    SCOPED_TRACE(name);
    const EnvelopeSurface made = envelope_of(golden_field_scene(name));
    std::set<SolidPair> found;
    for (const EnvelopeBridge& bridge : made.handles.bridges) {
      found.insert(bridge.solids);
      EXPECT_NEAR(bridge.outward.norm(), 1, 1e-12);
      EXPECT_GT(bridge.way.dot(bridge.outward), 0);
      EXPECT_LT(bridge.way.norm(), made.diagonal);
    }
    EXPECT_EQ(found, pairs);
  }
}

TEST(FilletBridges, NotchesFillWithTheWaist) {
  for (const char* name : {"camera", "dryer", "tee"}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_field_scene(name);
    double before = 0;
    for (const double waist : {0.2, 0.5, 0.75, 1.0}) {
      SCOPED_TRACE(waist);
      input.settings.waist = waist;
      const EnvelopeSurface made = envelope_of(input);
      EXPECT_TRUE(made.enclosed);
      EXPECT_EQ(made.folds, 0U);
      const double volume = volume_of(made);
      // Below the usual waist the cage's own cells are wider than the fillet.
      EXPECT_GT(volume, waist > 0.5 ? 1.005 * before : 0.999 * before);
      before = volume;
    }
  }
}

TEST(FilletBridges, AFactorActsInItsOwnNotchTheWayThatIsTold) {
  const EnvelopeInput input = golden_field_scene("camera");
  const EnvelopeSurface plain = envelope_of(input);
  for (const SolidPair pair : {SolidPair{0, 1}, SolidPair{0, 2}}) {
    SCOPED_TRACE(pair.high);
    const SolidPair other{0, pair.high == 1 ? 2U : 1U};
    EnvelopeInput wider = input;
    wider.settings.waists.set(pair, 1.5);
    const EnvelopeSurface made = envelope_of(wider);
    EXPECT_GT(volume_of(made), volume_of(plain));
    // How far the notch's handles went, along the way of the nearest one before.
    double own = 0, count = 0;
    for (const EnvelopeBridge& bridge : plain.handles.bridges) {
      const auto gone = [&](const EnvelopeSurface& to) {
        double least = 1e300;
        Vector3 step = Vector3::Zero();
        for (Index v = 0; v < to.cage->vertex_count(); ++v)
          if (const Vector3 way = to.cage->position(v) - bridge.middle; way.norm() < least)
            least = way.norm(), step = way;
        return step.dot(bridge.way) / bridge.way.squaredNorm();
      };
      if (bridge.solids == other) {
        EXPECT_NEAR(gone(made), 0, 0.5);
      }
      if (bridge.solids == pair) own += gone(made) / 0.5, count += 1;
    }
    ASSERT_GT(count, 0);
    EXPECT_GT(own / count, 0.25);
    EXPECT_LT(own / count, 1.5);
  }
}

TEST(FilletBridges, TheBaseServesAsLongAsNoFilletChanges) {
  // A bar's waist is followed on the finished cage, a fillet's is part of it.
  EnvelopeInput input = golden_field_scene("two_apart");
  const EnvelopedScene scene = enveloped_scene(input);
  const auto bars = field_base(scene.input, scene.placed, scene.origin, Quality::drag);
  ASSERT_TRUE(bars.ok());
  ASSERT_FALSE(bars->scene.clusters.front().bars.empty());
  EnvelopeInput thinner = scene.input;
  thinner.settings.waist = 0.2;
  EXPECT_TRUE(suits(*bars, thinner));

  input = golden_field_scene("camera");
  const EnvelopedScene touching = enveloped_scene(input);
  const auto fillets = field_base(touching.input, touching.placed, touching.origin, Quality::drag);
  ASSERT_TRUE(fillets.ok());
  EXPECT_TRUE(suits(*fillets, touching.input));
  thinner = touching.input;
  thinner.settings.waists.set({0, 1}, 0.4);
  EXPECT_FALSE(suits(*fillets, thinner));

  // So a drag of either ends where a cold start does.
  for (const char* name : {"two_apart", "camera"}) {
    SCOPED_TRACE(name);
    input = golden_field_scene(name);
    EnvelopeSurfacer surfacer;
    ASSERT_TRUE(surfacer.rebuild(input).ok());
    for (const double waist : {0.6, 0.8}) {
      input.settings.waist = waist;
      ASSERT_TRUE(surfacer.rebuild(input, Quality::drag).ok());
    }
    const auto warm = surfacer.rebuild(input);
    ASSERT_TRUE(warm.ok());
    EXPECT_EQ(volume_of(*warm), volume_of(envelope_of(input)));
  }
}

}  // namespace hariko::test
