#include "core/skinning/symmetric_edit.hpp"

#include <gtest/gtest.h>

#include "core/skinning/simple_skin.hpp"
#include "core/skinning/skin_messages.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace test;

/// How far each point is from the image of its partner.
double asymmetry(const Skin& skin, const MirrorPlane& plane) {
  double out = 0;
  for (const SkinSection& section : skin.sections) {
    const auto partner = mirror_partners(section, plane.point(), plane.normal());
    for (std::size_t i = 0; i < partner.size(); ++i)
      out = std::max(
          out, (section.points[i].position - plane.image(section.points[std::size_t(partner[i])].position))
                   .norm());
  }
  return out;
}

TEST(SymmetricEdit, FindsThePlane) {
  EXPECT_EQ(mirror_plane(arched_skin(6, 4, 1, 7)).axis, 1);
  for (const char* name : {"car_default", "car_edited"}) {
    const Skin skin = skin_input(name);
    const MirrorPlane plane = mirror_plane(skin);
    EXPECT_LT(asymmetry(skin, plane), 1e-9) << name;
  }
}

TEST(SymmetricEdit, BothHalvesFollow) {
  for_random(931, 30, [](std::mt19937_64& rng) {
    const Skin skin = arched_skin(6, 4, 1, uniform_int(rng, 3, 8));
    const MirrorPlane plane = mirror_plane(skin);
    const int k = uniform_int(rng, 0, 1), i = uniform_int(rng, 0, skin.sections[0].size() - 1);
    const SkinSection& section = skin.sections[std::size_t(k)];
    const SectionPoint& p = section.points[std::size_t(i)];
    const Vector3 to = p.position + random_vector(rng, 0.3);
    const auto moved = move_section_points(skin, std::vector{MovedPoint{p.id, to}}, plane);
    ASSERT_TRUE(moved.ok());
    EXPECT_LT(asymmetry(moved->skin, plane), 1e-12);
    const int partner = section.size() - 1 - i;
    const auto& now = moved->skin.sections[std::size_t(k)].points;
    EXPECT_LT((now[std::size_t(i)].position - (partner == i ? plane.foot(to) : to)).norm(), 1e-15);
    for (int j = 0; j < section.size(); ++j)
      if (j != i && j != partner) {
        EXPECT_EQ(now[std::size_t(j)], section.points[std::size_t(j)]);
      }
    const auto limit = move_limit_point(skin, p.id, to, plane);
    ASSERT_TRUE(limit.ok());
    EXPECT_LT(asymmetry(limit->skin, plane), 1e-12);
    const auto limits = limit_points(limit->skin.sections[std::size_t(k)].curve());
    EXPECT_LT((limits[std::size_t(i)] - (partner == i ? plane.foot(to) : to)).norm(), 1e-12);
    // Of two partners that both move the first one decides.
    const std::uint32_t other = section.points[std::size_t(partner)].id;
    const auto both =
        move_section_points(skin, std::vector{MovedPoint{p.id, to}, {other, to + Vector3(1, 1, 1)}}, plane);
    ASSERT_TRUE(both.ok());
    EXPECT_EQ(both->skin, moved->skin);
    EXPECT_EQ(move_section_points(skin, std::vector{MovedPoint{4711, to}}, plane).error().code, e_skin_index);
    EXPECT_EQ(move_limit_point(skin, 4711, to, plane).error().code, e_skin_index);
  });
}

TEST(SymmetricEdit, SectionsBecomeTheirOwnImages) {
  for_random(932, 20, [](std::mt19937_64& rng) {
    Skin skin = arched_skin(6, 4, 1, 6);
    const MirrorPlane plane = mirror_plane(skin);
    for (SkinSection& section : skin.sections)
      for (SectionPoint& p : section.points) p.position += random_vector(rng, 0.2);
    const auto all = make_symmetric(skin, {}, plane);
    ASSERT_TRUE(all.ok());
    EXPECT_LT(asymmetry(all->skin, plane), 1e-12);
    const auto one = make_symmetric(skin, std::vector<std::uint32_t>{1}, plane);
    ASSERT_TRUE(one.ok());
    EXPECT_EQ(one->skin.sections[0], skin.sections[0]);
    EXPECT_EQ(one->skin.sections[1], all->skin.sections[1]);
  });
}

}  // namespace
}  // namespace hariko
