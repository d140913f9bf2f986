#include "core/document/object_box.hpp"

#include <gtest/gtest.h>

#include "core/document/edits/edit_objects.hpp"

namespace hariko {
namespace {

TEST(ObjectBox, OfASkinHoldsItsSecondRailAndReferences) {
  Skin skin;
  skin.path.points = {{0, 0, 0}, {0, 0, 1}};
  skin.second_rail.emplace();
  skin.second_rail->points = {{50, 0, 0}, {50, 0, 1}};
  SkinSection section;
  section.points = {{0, Vector3(0, 1, 0), false}};
  skin.sections.push_back(section);
  // Every position counts, whichever it is.
  int positions = 0;
  change_positions(skin, [&](Vector3& p) { p.y() = ++positions; });
  const auto added = add_object({}, "skin", Source(SkinSource{skin, {}}));
  ASSERT_TRUE(added.ok());
  const Eigen::AlignedBox3d box = world_box(*added->document.objects[0]);
  EXPECT_EQ(box.max().x(), 50);
  EXPECT_EQ(box.min().y(), 1);
  EXPECT_EQ(box.max().y(), positions);
}

}  // namespace
}  // namespace hariko
