#include "core/skinning/edit/edit_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/skinning/columns/smooth.hpp"
#include "core/skinning/edit/add_section.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/skin_messages.hpp"
#include "tests/skinning/random_skins.hpp"
#include "tests/skinning/skin_inputs.hpp"

namespace hariko::test {
namespace {

double largest_move(const Skin& a, const Skin& b) {
  double out = 0;
  for (std::size_t k = 0; k < a.sections.size(); ++k)
    for (std::size_t i = 0; i < a.sections[k].points.size(); ++i)
      out = std::max(out, (a.sections[k].points[i].position - b.sections[k].points[i].position).norm());
  return out;
}

TEST(EditPath, ASectionSlidesWithItsFrame) {
  for_random(811, 40, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const int k = uniform_int(rng, 0, skin.section_count() - 1);
    const SkinSection& section = skin.sections[std::size_t(k)];
    const double v = section.v + uniform(rng, -0.09, 0.09);
    const auto edit = slide_section(skin, section.id, v);
    if (!skin.path.closed && (k == 0 || k + 1 == skin.section_count())) {
      must_fail(edit, e_section_range);
      return;
    }
    ASSERT_TRUE(edit.ok()) << to_string(edit.error());
    const auto before = plan_skin(skin), after = plan_skin(edit->skin);
    ASSERT_TRUE(after.ok());
    EXPECT_EQ(edit->skin.links, skin.links);
    EXPECT_EQ(edit->skin.merges, skin.merges);
    for (int s = 0; s < skin.section_count(); ++s) {
      const int now = edit->skin.find_section(skin.sections[std::size_t(s)].id);
      for (std::size_t i = 0; i < before->offsets[std::size_t(s)].size(); ++i)
        EXPECT_LT((before->offsets[std::size_t(s)][i] - after->offsets[std::size_t(now)][i]).norm(), 1e-11);
    }
    const auto back = must(slide_section(edit->skin, section.id, section.v));
    EXPECT_LT(largest_move(back->skin, skin), 1e-11);
    EXPECT_EQ(slide_section(skin, section.id, section.v + 0.6).error().code, e_section_order);
  });
}

TEST(EditPath, TheReferenceOfACarriedSectionIsOnThePath) {
  for_random(817, 40, [](std::mt19937_64& rng) {
    Skin skin = random_skin(rng);
    if (skin.path.closed || skin.section_count() < 3) return;
    const Skin plain = skin;
    SkinSection& section = skin.sections[1];
    const Vector3 beside = random_vector(rng, 0.5);
    section.reference = evaluate(skin.path, section.v).position + beside;
    const double v = section.v + uniform(rng, -0.09, 0.09);
    for (const bool slides : {true, false}) {
      const auto carry = [&](const Skin& s) {
        const MovedPathPoint moved{PathCurve::path, 1, skin.path.points[1] + Vector3(0, 0, 0.3)};
        return slides ? slide_section(s, section.id, v) : move_path_points(s, std::array{moved});
      };
      const auto edit = must(carry(skin)), without = must(carry(plain));
      const SkinSection &now = edit->skin.sections[1], &other = without->skin.sections[1];
      EXPECT_LT((*now.reference - evaluate(edit->skin.path, now.v).position).norm(), 1e-12);
      // Carried as without a reference, and moved by as much as the reference was beside the path.
      const auto after = must(plan_skin(edit->skin)), as = must(plan_skin(without->skin));
      const Vector3 moved = after->offsets[1][0] - as->offsets[1][0];
      EXPECT_NEAR(moved.norm(), beside.norm(), 1e-11);
      for (std::size_t i = 0; i < now.points.size(); ++i)
        EXPECT_LT((after->offsets[1][i] - as->offsets[1][i] - moved).norm(), 1e-11);
      EXPECT_FALSE(other.reference.has_value());
      // Once it is on the path, it stays there.
      const auto again = must(carry(edit->skin));
      EXPECT_LT(largest_move(again->skin, edit->skin), 1e-11);
    }
    // A section that stays in space while its path becomes another one is no longer tied to a point of it.
    const auto refined = must(refine_path(skin));
    EXPECT_FALSE(refined->skin.sections[1].reference.has_value());
  });
}

TEST(EditPath, SectionsAreCarriedByThePath) {
  for_random(812, 40, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    std::vector<MovedPathPoint> all;
    const Vector3 shift = random_vector(rng, 5);
    for (int i = 0; i < skin.path.size(); ++i)
      all.push_back({PathCurve::path, i, skin.path.points[std::size_t(i)] + shift});
    const auto moved = must(move_path_points(skin, all));
    for (std::size_t k = 0; k < skin.sections.size(); ++k)
      for (std::size_t i = 0; i < skin.sections[k].points.size(); ++i)
        EXPECT_LT(
            (moved->skin.sections[k].points[i].position - skin.sections[k].points[i].position - shift).norm(),
            1e-10);
    // A small move turns nothing by much, wherever frames begin.
    const int i = uniform_int(rng, 0, skin.path.size() - 1);
    const auto nudged = move_path_points(
        skin, std::vector{MovedPathPoint{PathCurve::path, i,
                                         skin.path.points[std::size_t(i)] + random_vector(rng, 1e-4)}});
    ASSERT_TRUE(nudged.ok());
    EXPECT_LT(largest_move(nudged->skin, skin), 0.01);
    // Offsets in the frames are the same up to one turn about the path.
    const auto bent = move_path_points(
        skin, std::vector{MovedPathPoint{PathCurve::path, i,
                                         skin.path.points[std::size_t(i)] + random_vector(rng, 1)}});
    ASSERT_TRUE(bent.ok());
    const auto before = plan_skin(skin), after = plan_skin(bent->skin);
    if (before->frames.mode() != after->frames.mode()) return;
    for (std::size_t k = 0; k < skin.sections.size(); ++k)
      for (std::size_t p = 0; p < skin.sections[k].points.size(); ++p) {
        const Vector3 d = before->offsets[k][p], e = after->offsets[k][p];
        EXPECT_NEAR(d.z(), e.z(), 1e-10);
        EXPECT_NEAR(d.norm(), e.norm(), 1e-10);
      }
  });
}

TEST(EditPath, PointsComeAndGoWithoutMovingSections) {
  for_random(813, 40, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const int span = uniform_int(rng, 0, skin.path.spans() - 1);
    const auto edit = must(insert_path_point(skin, span));
    EXPECT_EQ(largest_move(edit->skin, skin), 0);
    for (std::size_t k = 0; k < skin.sections.size(); ++k) {
      const Vector3 place = evaluate(edit->skin.path, edit->skin.sections[k].v).position;
      EXPECT_LT(nearest_point(skin.path, place).distance, edit->deviation + 0.05);
    }
    const auto back = must(delete_path_point(edit->skin, span + 1));
    EXPECT_EQ(largest_move(back->skin, skin), 0);
    for (int i = 0; i < skin.path.size(); ++i)
      EXPECT_LT((back->skin.path.points[std::size_t(i)] - skin.path.points[std::size_t(i)]).norm(), 1e-12);
    for (std::size_t k = 0; k < skin.sections.size(); ++k)
      EXPECT_NEAR(back->skin.sections[k].v, skin.sections[k].v, 1e-12);
    const auto fine = must(refine_path(skin));
    EXPECT_EQ(fine->skin.sections, skin.sections);
    for (int i = 0; i <= 40; ++i)
      EXPECT_LT(
          (evaluate(fine->skin.path, i / 40.0).position - evaluate(skin.path, i / 40.0).position).norm(),
          1e-12);
  });
}

TEST(EditPath, EndsAndLimits) {
  const Skin car = skin_input("car_default");
  EXPECT_EQ(delete_path_point(car, 99).error().code, e_skin_index);
  Skin two = skin_input("fig5");
  two.path.points = {two.path.points.front(), two.path.points.back()};
  EXPECT_EQ(delete_path_point(two, 0).error().code, e_path_short);
  // The section at an end that goes follows to the new end.
  const Skin fig5 = skin_input("fig5");
  const auto shorter = must(delete_path_point(fig5, 0));
  const Vector3 shift = evaluate(shorter->skin.path, 0).position - evaluate(fig5.path, 0).position;
  EXPECT_LT(
      (shorter->skin.sections[0].points[0].position - fig5.sections[0].points[0].position - shift).norm(),
      1e-12);
  EXPECT_EQ(shorter->skin.sections[1], fig5.sections[1]);
  // Rails are edited together, and sections stay on them.
  const Skin rails = skin_input("tworail");
  for (const auto& edit : {insert_path_point(rails, 1), delete_path_point(rails, 2), refine_path(rails)}) {
    ASSERT_TRUE(edit.ok()) << to_string(edit.error());
    EXPECT_EQ(edit->skin.path.size(), edit->skin.second_rail->size());
    EXPECT_TRUE(plan_skin(edit->skin).ok());
  }
  const auto bent =
      move_path_points(rails, std::vector{MovedPathPoint{PathCurve::second_rail, 2, Vector3(2, 2, 0.8)}});
  ASSERT_TRUE(bent.ok()) << to_string(bent.error());
  EXPECT_TRUE(set_path_sharp(car, PathCurve::path, 3, true)->skin.path.is_sharp(3));
  EXPECT_EQ(set_path_sharp(set_path_sharp(car, PathCurve::path, 3, true)->skin, PathCurve::path, 3, false)
                ->skin.path,
            car.path);
}

TEST(AddSection, LiesOnTheVirtualSurface) {
  // Pleats lie on the virtual surface, too, where counts are equal and sections are translated.
  for (const char* configuration : {"pleat_paper", "smooth_12_9_uniform_linear"}) {
    Skin skin = skin_input("fig5");
    set_options(skin, configuration);
    const auto plan = plan_skin(skin);
    const VirtualSurface wanted(skin, *plan);
    for (const double v : {0.2, 0.5, 0.77}) {
      const auto edit = must(add_section(skin, v));
      ASSERT_EQ(edit->skin.section_count(), 3);
      const SkinSection& section = edit->skin.sections[1];
      EXPECT_EQ(section.v, v);
      ASSERT_EQ(section.size(), 11);
      for (int i = 0; i <= 50; ++i)
        EXPECT_LT((evaluate(section.curve(), i / 50.0).position - wanted.point(i / 50.0, v)).norm(), 1e-12);
    }
    EXPECT_EQ(add_section(skin, 0).error().code, e_section_range);
    EXPECT_EQ(add_section(add_section(skin, 0.5)->skin, 0.5).error().code, e_section_order);
  }
}

TEST(AddSection, DividesMergesWhereTheyHappen) {
  const Skin skin = skin_input("fig9_interior");
  const SkinMerge& old = skin.merges.at(0);
  const int members = int(old.members.size());
  const auto before = must(add_section(skin, old.v / 2));
  EXPECT_EQ(before->skin.sections[1].size(), skin.sections[0].size());
  ASSERT_EQ(before->skin.merges.size(), 1U);
  EXPECT_EQ(before->skin.merges[0].first, before->skin.sections[1].id);
  EXPECT_EQ(int(before->skin.merges[0].members.size()), members);
  EXPECT_NEAR(before->skin.merges[0].v, (old.v - old.v / 2) / (1 - old.v / 2), 1e-12);
  EXPECT_TRUE(before->lost.empty());
  const auto after = must(add_section(skin, (old.v + 1) / 2));
  EXPECT_EQ(after->skin.sections[1].size(), skin.sections[0].size() - members + 1);
  ASSERT_EQ(after->skin.merges.size(), 1U);
  EXPECT_EQ(after->skin.merges[0].second, after->skin.sections[1].id);
  EXPECT_NEAR(after->skin.merges[0].v, old.v / ((old.v + 1) / 2), 1e-12);
  const auto at = must(add_section(skin, old.v));
  EXPECT_TRUE(at->skin.merges.empty());
  EXPECT_EQ(at->skin.links.size(), 1U);
  EXPECT_EQ(at->skin.sections[1].size(), skin.sections[0].size() - members + 1);
}

TEST(AddSection, KeepsTheSurfaceAndAllCorrespondences) {
  int divided = 0, with_loss = 0;
  for_random(821, 40, [&](std::mt19937_64& rng) {
    Skin skin = random_skin(rng);
    skin.method = chance(rng, 0.7) ? SkinMethod::pleat : SkinMethod::smooth;
    if (skin.method == SkinMethod::smooth) skin.merges.clear();
    const double v = uniform(rng, 0.02, 0.98);
    const auto edit = add_section(skin, v);
    if (!edit) {
      // Chains of links that a smooth surface cannot follow, either, or a place where no section can be.
      const auto made = SkinSurfacer().surface(skin, Vector3::Zero());
      EXPECT_TRUE(made.ok() ? edit.error().code == e_section_order || edit.error().code == e_few_points ||
                                  edit.error().code == e_control_mesh
                            : edit.error().code == made.error().code)
          << to_string(edit.error());
      return;
    }
    ASSERT_TRUE(plan_skin(edit->skin).ok());
    // Rarely two merges would share a line of the new section: one of them goes, and a note says so.
    EXPECT_EQ(edit->lost.empty(), edit->notes.empty());
    with_loss += !edit->lost.empty();
    EXPECT_EQ(edit->skin.section_count(), skin.section_count() + 1);
    divided += edit->skin.merges != skin.merges;
    for (const SkinSection& old : skin.sections)
      EXPECT_EQ(edit->skin.sections[std::size_t(edit->skin.find_section(old.id))], old);
    if (skin.method != SkinMethod::pleat) return;
    // Its points are points of the surface.
    const auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
    const auto again = must(SkinSurfacer().surface(edit->skin, Vector3::Zero()));
    const int k = edit->skin.find_section(skin.free_section_id());
    const auto points = limit_points(edit->skin.sections[std::size_t(k)].curve());
    double farthest = 0, spacing = 0;
    const auto sample = [&](Index patch, int s, int t) -> Vector3 {
      return made->surface.patches().evaluate(patch, {s / 8.0, t / 8.0}, Order::first).position;
    };
    for (Index patch = 0; patch < made->surface.patch_count(); ++patch)
      for (int s = 0; s < 8; ++s)
        for (int t = 0; t < 8; ++t)
          spacing = std::max(spacing, (sample(patch, s, t) - sample(patch, s + 1, t + 1)).norm());
    for (const Vector3& p : points) {
      double nearest = 1e9;
      for (Index patch = 0; patch < made->surface.patch_count(); ++patch)
        for (int s = 0; s <= 8; ++s)
          for (int t = 0; t <= 8; ++t) nearest = std::min(nearest, (sample(patch, s, t) - p).norm());
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LT(farthest, spacing) << "no point of the surface is farther from all samples";
  });
  EXPECT_GT(divided, 2);
  EXPECT_LE(with_loss, repetitions(40) / 50);
}

TEST(AddSection, DrawnAndDeletedSections) {
  for_random(822, 30, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const double v = uniform(rng, 0.05, 0.95);
    for (const SkinSection& section : skin.sections)
      if (std::abs(section.v - v) < 1e-3) return;
    std::vector<Vector3> points;
    const Vector3 place = evaluate(skin.path, v).position;
    for (int i = 0; i < 5; ++i) points.push_back(place + random_vector(rng, 1));
    const auto drawn = must(draw_section(skin, v, points, skin.sections[0].closed));
    const std::uint32_t id = skin.free_section_id();
    EXPECT_EQ(drawn->notes.empty(), drawn->lost.empty());
    const auto deleted = must(delete_section(drawn->skin, id));
    EXPECT_EQ(deleted->skin.sections, skin.sections);
    EXPECT_TRUE(deleted->lost.empty()) << "nothing had been drawn there";
    if (skin.section_count() == 2) {
      EXPECT_EQ(delete_section(skin, skin.sections[0].id).error().code, e_few_sections);
    }
    // An end takes its part of the path along.
    if (skin.path.closed || skin.section_count() < 3) return;
    const auto trimmed = must(delete_section(skin, skin.sections[0].id));
    EXPECT_EQ(trimmed->skin.sections[0].points, skin.sections[1].points);
    EXPECT_LT(
        (evaluate(trimmed->skin.path, 0).position - evaluate(skin.path, skin.sections[1].v).position).norm(),
        1e-12);
    EXPECT_LT(trimmed->deviation, 0.5);
  });
}

TEST(EditPath, ClosingCarriesSectionsAndOpeningLeavesThemWhereTheyAre) {
  for_random(818, 40, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const bool closing = !skin.path.closed;
    const auto edit = set_path_closed(skin, closing);
    if (closing && skin.path.size() < 3) {
      must_fail(edit, e_path_short);
      return;
    }
    // A path that runs back over itself may have a cusp.
    if (!edit) {
      EXPECT_EQ(edit.error().code, e_path_cusp);
      return;
    }
    EXPECT_EQ(edit->skin.path.closed, closing);
    EXPECT_EQ(edit->skin.section_count(), skin.section_count());
    ASSERT_TRUE(plan_skin(edit->skin).ok());
    for (std::size_t k = 0; k < skin.sections.size(); ++k) {
      const SkinSection &before = skin.sections[k], &after = edit->skin.sections[k];
      ASSERT_EQ(before.id, after.id);
      const Vector3 was = evaluate(skin.path, before.v).position,
                    is = evaluate(edit->skin.path, after.v).position;
      for (std::size_t i = 0; i < before.points.size(); ++i) {
        // Closing: as far from the path as before. Opening: in the same place.
        if (closing)
          EXPECT_NEAR((after.points[i].position - is).norm(), (before.points[i].position - was).norm(),
                      1e-10);
        else
          EXPECT_EQ(after.points[i].position, before.points[i].position);
      }
    }
    if (!closing) {
      EXPECT_EQ(edit->skin.sections.front().v, 0);
      EXPECT_EQ(edit->skin.sections.back().v, 1);
      const auto beyond = [&](const auto& entry) { return entry.first == skin.sections.back().id; };
      EXPECT_TRUE(std::none_of(edit->skin.links.begin(), edit->skin.links.end(), beyond));
      EXPECT_TRUE(std::none_of(edit->skin.merges.begin(), edit->skin.merges.end(), beyond));
      EXPECT_LT(
          (evaluate(edit->skin.path, 0).position - evaluate(skin.path, skin.sections.front().v).position)
              .norm(),
          1e-12);
    }
    EXPECT_EQ(set_path_closed(edit->skin, closing)->skin, edit->skin) << "nothing is left to do";
  });
}

TEST(EditPath, EndsInOnePlaceBecomeOne) {
  Skin skin;
  for (int i = 0; i < 7; ++i) {
    const double a = 2 * 3.14159265358979 * (i % 6) / 6;
    skin.path.points.push_back({5 * std::cos(a), 5 * std::sin(a), 0});
  }
  skin.frame = FrameMode::rotation_minimising;
  std::uint32_t id = 0;
  for (const double v : {0.0, 0.5, 1.0}) {
    SkinSection section;
    section.id = std::uint32_t(skin.sections.size());
    section.v = v;
    const CurvePoint at = evaluate(skin.path, v);
    for (int i = -1; i <= 1; ++i)
      section.points.push_back(
          {id++, at.position + i * Vector3::UnitZ().cross(at.first).normalized(), false});
    skin.sections.push_back(section);
  }
  const auto edit = must(set_path_closed(skin, true));
  EXPECT_EQ(edit->skin.path.size(), 6);
  ASSERT_EQ(edit->skin.section_count(), 2);
  EXPECT_EQ(edit->skin.sections[1].v, 0.5);
  skin.sections.erase(skin.sections.begin() + 1);
  EXPECT_EQ(set_path_closed(skin, true).error().code, e_few_sections);
}

}  // namespace
}  // namespace hariko::test
