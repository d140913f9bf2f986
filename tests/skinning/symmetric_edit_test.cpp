#include "core/skinning/edit/symmetric_edit.hpp"

#include <numbers>
#include <set>

#include "core/skinning/columns/simple_skin.hpp"
#include "core/skinning/skin_messages.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// Largest distance of a point from the image of its partner.
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
    const auto moved = must(move_section_points(skin, std::vector{MovedPoint{p.id, to}}, plane));
    EXPECT_LT(asymmetry(moved->skin, plane), 1e-12);
    const int partner = section.size() - 1 - i;
    const auto& now = moved->skin.sections[std::size_t(k)].points;
    EXPECT_LT((now[std::size_t(i)].position - (partner == i ? plane.foot(to) : to)).norm(), 1e-15);
    for (int j = 0; j < section.size(); ++j)
      if (j != i && j != partner) {
        EXPECT_EQ(now[std::size_t(j)], section.points[std::size_t(j)]);
      }
    const auto limit = must(move_limit_point(skin, p.id, to, plane));
    EXPECT_LT(asymmetry(limit->skin, plane), 1e-12);
    const auto limits = limit_points(limit->skin.sections[std::size_t(k)].curve());
    EXPECT_LT((limits[std::size_t(i)] - (partner == i ? plane.foot(to) : to)).norm(), 1e-12);
    // The first of two partners that both move decides.
    const std::uint32_t other = section.points[std::size_t(partner)].id;
    const auto both =
        move_section_points(skin, std::vector{MovedPoint{p.id, to}, {other, to + Vector3(1, 1, 1)}}, plane);
    ASSERT_TRUE(both.ok());
    EXPECT_EQ(both->skin, moved->skin);
    EXPECT_EQ(move_section_points(skin, std::vector{MovedPoint{4711, to}}, plane).error().code, e_skin_index);
    EXPECT_EQ(move_limit_point(skin, 4711, to, plane).error().code, e_skin_index);
  });
}

TEST(SymmetricEdit, TheSkinsOwnPlaneIsTaken) {
  Skin skin = arched_skin(6, 4, 1, 7);
  skin.mirror = MirrorPlane{2, 0.25};
  EXPECT_EQ(mirror_plane(skin), (MirrorPlane{2, 0.25}));
  for (Vector3& p : skin.path.points) p += Vector3(1, 2, 3);
  EXPECT_EQ(mirror_plane(skin, 1), (MirrorPlane{1, 2}));
  EXPECT_EQ(mirror_plane(skin, 2), (MirrorPlane{2, 3}));
}

/// A tube of two rounded sections about y = 0, whose points have partners.
Skin symmetric_tube(int points) {
  Skin skin = arched_skin(6, 4, 1, 3);
  std::uint32_t id = 0;
  for (SkinSection& section : skin.sections) {
    const double x = section.points[0].position.x();
    section.closed = true;
    section.points.clear();
    for (int i = 0; i < points; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / points;
      section.points.push_back({id++, Vector3(x, 2 * std::sin(angle), std::cos(angle)), false});
    }
  }
  return skin;
}

TEST(SymmetricEdit, PointsComeAndGoOnBothHalves) {
  for_random(933, 30, [](std::mt19937_64& rng) {
    const bool closed = chance(rng, 0.5);
    const Skin skin =
        closed ? symmetric_tube(uniform_int(rng, 4, 9)) : arched_skin(6, 4, 1, uniform_int(rng, 4, 8));
    const MirrorPlane plane{1, 0};
    ASSERT_LT(asymmetry(skin, plane), 1e-12);
    const SkinSection& section = skin.sections[1];
    const int span = uniform_int(rng, 0, section.curve().spans() - 1);
    const auto inserted = must(insert_section_point(skin, section.id, span, plane));
    EXPECT_LT(asymmetry(inserted->skin, plane), 1e-9);
    EXPECT_EQ(inserted->skin.sections[1].size(), section.size() + int(inserted->points.size()));
    EXPECT_EQ(inserted->skin.sections[0], skin.sections[0]);
    // The curve still passes through where it did at every old point.
    const auto before = limit_points(section.curve()),
               after = limit_points(inserted->skin.sections[1].curve());
    for (int i = 0; i < section.size(); ++i) {
      const int j = find_point(inserted->skin.sections[1], section.points[std::size_t(i)].id);
      EXPECT_LT((before[std::size_t(i)] - after[std::size_t(j)]).norm(), 1e-9);
    }
    // In the span of the plane there is one new point, and it is in it.
    if (inserted->points.size() == 1) {
      const SkinSection& now = inserted->skin.sections[1];
      EXPECT_NEAR(now.points[std::size_t(find_point(now, inserted->points[0]))].position.y(), 0, 1e-9);
    } else {
      const auto pair = with_partners(inserted->skin, std::vector{inserted->points[0]}, plane);
      EXPECT_EQ(std::set(pair.begin(), pair.end()),
                std::set(inserted->points.begin(), inserted->points.end()));
    }
    // Deletion takes it away again, from both halves.
    const auto both = with_partners(inserted->skin, std::vector{inserted->points[0]}, plane);
    EXPECT_EQ(both.size(), inserted->points.size());
    const auto deleted = must(delete_section_points(inserted->skin, both));
    EXPECT_EQ(deleted->skin.sections[1].size(), section.size());
    EXPECT_LT(asymmetry(deleted->skin, plane), 1e-9);
  });
  const Skin skin = arched_skin(6, 4, 1, 7);
  EXPECT_EQ(insert_section_point(skin, 4711, 0, MirrorPlane{}).error().code, e_skin_index);
  EXPECT_EQ(insert_section_point(skin, skin.sections[0].id, 6, MirrorPlane{}).error().code, e_skin_index);
  EXPECT_EQ(with_partners(skin, std::vector<std::uint32_t>{4711}, MirrorPlane{}),
            std::vector<std::uint32_t>{4711});
}

TEST(SymmetricEdit, SectionsBecomeTheirOwnImages) {
  for_random(932, 20, [](std::mt19937_64& rng) {
    Skin skin = arched_skin(6, 4, 1, 6);
    const MirrorPlane plane = mirror_plane(skin);
    for (SkinSection& section : skin.sections)
      for (SectionPoint& p : section.points) p.position += random_vector(rng, 0.2);
    const auto all = must(make_symmetric(skin, {}, plane));
    EXPECT_LT(asymmetry(all->skin, plane), 1e-12);
    const auto one = must(make_symmetric(skin, std::vector<std::uint32_t>{1}, plane));
    EXPECT_EQ(one->skin.sections[0], skin.sections[0]);
    EXPECT_EQ(one->skin.sections[1], all->skin.sections[1]);
  });
}

}  // namespace
}  // namespace hariko::test
