#include "core/skinning/columns/column_cache.hpp"

#include "core/skinning/columns/column_parameters.hpp"
#include "core/skinning/columns/simple_skin.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

SubdivisionCurve random_curve(std::mt19937_64& rng, bool closed) {
  SubdivisionCurve curve;
  curve.closed = closed;
  const int n = uniform_int(rng, 4, 7);
  for (int i = 0; i < n; ++i) curve.points.push_back(Vector3(i, 0, 0) + random_vector(rng, 0.8));
  return curve;
}

TEST(ColumnCache, RemembersWhatItFoundAndNothingElse) {
  for_random(911, 4, [](std::mt19937_64& rng) {
    const bool closed = chance(rng, 0.5);
    std::vector<ColumnCache::Search> searches{{3, {random_curve(rng, closed)}},
                                              {8, {random_curve(rng, closed), random_curve(rng, closed)}}};
    SkinWork work;
    work.progress = Progress::make();
    ColumnCache memory;
    const auto found = memory.parameters(searches, 6, work);
    EXPECT_EQ(work.progress.fraction(), 1);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(found[i], optimised_parameters(searches[i].curves, 6)) << "others than without a memory";
    // Known ones need no search: one that is cancelled from the beginning finds none.
    SkinWork cancelled;
    cancelled.cancel = CancelToken::make();
    cancelled.cancel.cancel();
    EXPECT_EQ(memory.parameters(searches, 6, cancelled), found);
    EXPECT_NE(memory.parameters(searches, 7, cancelled)[0].size(), found[0].size());
    // While something moves its columns stay, and so do those of the others.
    EXPECT_EQ(memory.parameters(searches, 6, {}), found);
    auto moved = searches;
    moved[0].curves[0].points[1] += Vector3(0.1, 0.3, 0);
    SkinWork moving;
    moving.moving = true;
    EXPECT_EQ(memory.parameters(moved, 6, moving), found);
    const auto final = memory.parameters(moved, 6, {});
    EXPECT_EQ(final[0], optimised_parameters(moved[0].curves, 6));
    EXPECT_EQ(final[1], found[1]);
  });
}

TEST(ColumnCache, ADragKeepsColumnsUntilItRests) {
  Skin skin = arched_skin(6, 4, 1, 7);
  skin.method = SkinMethod::smooth;
  for (const ColumnParameters parameters : {ColumnParameters::per_section, ColumnParameters::shared}) {
    skin.smooth.parameters = parameters;
    SkinSurfacer surfacer;
    const auto first = must(surfacer.surface(skin, Vector3::Zero()));
    Skin moved = skin;
    moved.sections[0].points[3].position += Vector3(0, 0.4, 0.8);
    SkinWork drag;
    drag.moving = true;
    const auto during = must(surfacer.surface(moved, Vector3::Zero(), drag));
    EXPECT_EQ(during->result.mesh.parameters, first->result.mesh.parameters);
    const auto rested = must(surfacer.surface(moved, Vector3::Zero())),
               fresh = must(SkinSurfacer().surface(moved, Vector3::Zero()));
    EXPECT_EQ(rested->result.mesh.parameters, fresh->result.mesh.parameters);
    EXPECT_NE(rested->result.mesh.parameters, first->result.mesh.parameters);
  }
}

}  // namespace
}  // namespace hariko::test
