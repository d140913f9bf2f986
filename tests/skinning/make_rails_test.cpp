#include "core/skinning/sections/make_rails.hpp"

#include <string>

#include "core/skinning/columns/simple_skin.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/skin_messages.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

/// Largest distance between points of the sections of two skins.
double moved(const Skin& a, const Skin& b, bool ends) {
  double out = 0;
  for (std::size_t k = 0; k < a.sections.size(); ++k)
    for (int i = 0; i < a.sections[k].size(); ++i)
      if (ends == (i == 0 || i == a.sections[k].size() - 1))
        out = std::max(out, (a.sections[k].points[std::size_t(i)].position -
                             b.sections[k].points[std::size_t(i)].position)
                                .norm());
  return out;
}

TEST(MakeRails, SectionsEndOnThem) {
  for (const std::string name : {"fig5", "fig6a", "car_default", "merge_split", "arches"}) {
    SCOPED_TRACE(name);
    const Skin skin = name == "arches" ? arched_skin(6, 4, 1, 7) : skin_input(name);
    const auto edit = must(make_rails(skin));
    ASSERT_TRUE(edit->skin.second_rail.has_value());
    EXPECT_EQ(edit->skin.path.size(), edit->skin.second_rail->size());
    const auto plan = must(plan_skin(edit->skin));
    EXPECT_EQ(plan->frames.mode(), FrameMode::two_rail);
    for (const SkinSection& section : edit->skin.sections) {
      EXPECT_LT((section.points.front().position - plan->frames.position(section.v)).norm(), 1e-12);
      EXPECT_LT((section.points.back().position - plan->frames.rail(section.v)).norm(), 1e-12);
    }
    EXPECT_EQ(moved(edit->skin, skin, false), 0);
    EXPECT_DOUBLE_EQ(moved(edit->skin, skin, true), edit->deviation);
    // Inputs are four to eight wide.
    EXPECT_LT(edit->deviation, 0.05);
    EXPECT_TRUE(evaluate_skin(edit->skin).ok());
    // Another frame, and back: the rails are kept.
    Skin parallel = edit->skin;
    parallel.frame = FrameMode::translate;
    EXPECT_EQ(make_rails(parallel)->skin, edit->skin);
  }
}

TEST(MakeRails, TheSurfaceIsBetweenThem) {
  const auto edit = must(make_rails(arched_skin(6, 4, 1, 7)));
  const Skin& skin = edit->skin;
  const auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  const auto& patches = *subdivision_patches(made->surface);
  for (const auto& row : made->result.mesh.representative[0]) {
    EXPECT_LT(nearest_point(skin.path, patches.limit_position(row.front())).distance, 1e-9);
    EXPECT_LT(nearest_point(*skin.second_rail, patches.limit_position(row.back())).distance, 1e-9);
  }
}

TEST(MakeRails, ClosedSectionsAreRefused) {
  for (const char* name : {"tube", "ring"}) {
    must_fail(make_rails(skin_input(name)), e_rail);
  }
}

}  // namespace
}  // namespace hariko::test
