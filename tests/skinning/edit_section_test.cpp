#include "core/skinning/edit/edit_section.hpp"

#include <Eigen/Geometry>

#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/skin_messages.hpp"
#include "tests/skinning/random_skins.hpp"
#include "tests/skinning/skin_inputs.hpp"

namespace hariko {
namespace {

using namespace test;
using Ids = std::vector<std::uint32_t>;

double distance(const Skin& a, const Skin& b) {
  double out = 0;
  EXPECT_EQ(a.sections.size(), b.sections.size());
  for (std::size_t k = 0; k < a.sections.size(); ++k) {
    EXPECT_EQ(a.sections[k].points.size(), b.sections[k].points.size());
    for (std::size_t i = 0; i < a.sections[k].points.size(); ++i) {
      const SectionPoint &p = a.sections[k].points[i], &q = b.sections[k].points[i];
      EXPECT_EQ(p.id, q.id);
      out = std::max(out, (p.position - q.position).norm());
    }
  }
  return out;
}

double curve_distance(const SubdivisionCurve& a, const SubdivisionCurve& b) {
  double out = 0;
  for (int i = 0; i <= 200; ++i)
    out = std::max(out, nearest_point(b, evaluate(a, i / 200.0).position).distance);
  return out;
}

const SkinSection& any_section(std::mt19937_64& rng, const Skin& skin) {
  return skin.sections[std::size_t(uniform_int(rng, 0, skin.section_count() - 1))];
}

bool contains(const Ids& ids, std::uint32_t id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool refers_to(const Skin& skin, std::uint32_t id) {
  const auto in = [&](const Ids& ids) { return contains(ids, id); };
  for (const SkinLink& link : skin.links)
    if (in(link.a) || in(link.b)) return true;
  for (const SkinMerge& merge : skin.merges)
    if (in(merge.members) || merge.target == id) return true;
  return false;
}

/// Whether a point of a merge is joined to a point beside its target, too: then a point that is put beside it
/// belongs to the merge and would cross that link.
bool merges_are_linked_elsewhere(const Skin& skin) {
  for (const SkinMerge& merge : skin.merges)
    for (const SkinLink& link : skin.links) {
      if (link.first != merge.first || link.second != merge.second) continue;
      const bool a = merge.side == StripSide::a;
      const Ids &own = a ? link.a : link.b, &other = a ? link.b : link.a;
      for (const std::uint32_t id : merge.members)
        if (contains(own, id) && !contains(other, merge.target)) return true;
    }
  return false;
}

TEST(EditSection, AnInsertedPointKeepsTheCurveAndEveryCorrespondence) {
  for_random(801, 60, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    ASSERT_TRUE(plan_skin(skin).ok());
    const SkinSection& section = any_section(rng, skin);
    const SubdivisionCurve curve = section.curve();
    const int span = uniform_int(rng, 0, curve.spans() - 1);
    const auto edit = must(insert_section_point(skin, section.id, span));
    ASSERT_TRUE(plan_skin(edit->skin).ok());
    EXPECT_TRUE(edit->lost.empty() || merges_are_linked_elsewhere(skin));
    const SkinSection& now = edit->skin.sections[std::size_t(skin.find_section(section.id))];
    ASSERT_EQ(now.size(), section.size() + 1);
    EXPECT_EQ(now.points[std::size_t(span) + 1].id, edit->points.at(0));
    const auto before = limit_points(curve), after = limit_points(now.curve());
    for (int i = 0; i < section.size(); ++i)
      EXPECT_LT(
          (after[std::size_t(find_point(now, section.points[std::size_t(i)].id))] - before[std::size_t(i)])
              .norm(),
          1e-12);
    EXPECT_LE(curve_distance(curve, now.curve()), 1.1 * edit->deviation + 1e-9);
    // Taking it out again gives the skin back.
    const auto back = must(delete_section_points(edit->skin, edit->points));
    EXPECT_LT(distance(back->skin, skin), 1e-12);
    EXPECT_EQ(back->skin.links, skin.links);
    EXPECT_EQ(back->skin.merges, skin.merges);
  });
}

TEST(EditSection, RefiningChangesNoCurve) {
  int with_loss = 0;
  for_random(802, 30, [&](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const SkinSection& section = any_section(rng, skin);
    const auto edit = must(refine_section(skin, section.id));
    ASSERT_TRUE(plan_skin(edit->skin).ok());
    EXPECT_EQ(edit->notes.empty(), edit->lost.empty());
    with_loss += !edit->lost.empty();
    EXPECT_TRUE(edit->lost.empty() || merges_are_linked_elsewhere(skin));
    const SkinSection& now = edit->skin.sections[std::size_t(skin.find_section(section.id))];
    EXPECT_EQ(now.curve().spans(), 2 * section.curve().spans());
    for (int i = 0; i <= 50; ++i)
      EXPECT_LT(
          (evaluate(now.curve(), i / 50.0).position - evaluate(section.curve(), i / 50.0).position).norm(),
          1e-12);
    for (const SectionPoint& p : section.points) EXPECT_GE(find_point(now, p.id), 0);
  });
  EXPECT_LE(with_loss, repetitions(30) / 30);
}

TEST(EditSection, DeletedPointsTakeTheirCorrespondencesAlongAndSaySo) {
  for_random(803, 60, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const SkinSection& section = any_section(rng, skin);
    const SubdivisionCurve curve = section.curve();
    const std::uint32_t id = section.points[std::size_t(uniform_int(rng, 0, section.size() - 1))].id;
    const auto edit = delete_section_points(skin, Ids{id});
    if (section.size() <= (section.closed ? 3 : 2)) {
      must_fail(edit, e_few_points);
      return;
    }
    ASSERT_TRUE(edit.ok()) << to_string(edit.error());
    ASSERT_TRUE(plan_skin(edit->skin).ok());
    EXPECT_FALSE(refers_to(edit->skin, id));
    EXPECT_EQ(edit->skin.links.size() + edit->skin.merges.size() + edit->lost.size(),
              skin.links.size() + skin.merges.size());
    EXPECT_EQ(edit->notes.empty(), edit->lost.empty());
    const SkinSection& now = edit->skin.sections[std::size_t(skin.find_section(section.id))];
    const auto before = limit_points(curve), after = limit_points(now.curve());
    for (int i = 0; i < now.size(); ++i)
      EXPECT_LT(
          (after[std::size_t(i)] - before[std::size_t(find_point(section, now.points[std::size_t(i)].id))])
              .norm(),
          1e-12);
  });
}

TEST(EditSection, ALimitPointMovesAlone) {
  for_random(804, 30, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const SkinSection& section = any_section(rng, skin);
    const int i = uniform_int(rng, 0, section.size() - 1);
    const Vector3 goal = section.points[std::size_t(i)].position + random_vector(rng, 0.5);
    const auto edit = must(move_limit_point(skin, section.points[std::size_t(i)].id, goal));
    auto wanted = limit_points(section.curve());
    wanted[std::size_t(i)] = goal;
    const auto got = limit_points(edit->skin.sections[std::size_t(skin.find_section(section.id))].curve());
    for (std::size_t p = 0; p < wanted.size(); ++p) EXPECT_LT((got[p] - wanted[p]).norm(), 1e-12);
  });
}

TEST(EditSection, DirectionAndSeam) {
  for_random(805, 40, [](std::mt19937_64& rng) {
    const Skin skin = random_skin(rng);
    const SkinSection& section = any_section(rng, skin);
    const auto flipped = must(flip_section(skin, section.id));
    ASSERT_TRUE(plan_skin(flipped->skin).ok());
    EXPECT_TRUE(flipped->skin.sections[std::size_t(skin.find_section(section.id))].direction_chosen);
    EXPECT_EQ(flipped->notes.empty(), flipped->lost.empty());
    EXPECT_EQ(distance(flip_section(flipped->skin, section.id)->skin, skin), 0);
    const int i = uniform_int(rng, 0, section.size() - 1);
    const auto seam = move_seam(skin, section.points[std::size_t(i)].id);
    EXPECT_EQ(seam.ok(), section.closed);
    if (!seam) return;
    const SkinSection& now = seam->skin.sections[std::size_t(skin.find_section(section.id))];
    EXPECT_EQ(now.points[0].id, section.points[std::size_t(i)].id);
    EXPECT_TRUE(seam->lost.empty()) << "a seam crosses nothing";
    const auto back = move_seam(seam->skin, section.points[0].id);
    Skin chosen = skin;
    chosen.sections[std::size_t(skin.find_section(section.id))].start_chosen = true;
    EXPECT_EQ(back->skin, chosen);
  });
}

TEST(EditSection, AnchorsKeepTheirPlacesOnTheCurve) {
  for_random(806, 40, [](std::mt19937_64& rng) {
    Skin skin = random_skin(rng);
    skin.links.clear(), skin.merges.clear();
    skin.method = SkinMethod::anchored;
    std::vector<double> row;
    for (int k = 0; k < skin.section_count(); ++k) row.push_back(uniform(rng, 0.2, 0.8));
    skin.smooth.anchors = {row};
    const int k = uniform_int(rng, 0, skin.section_count() - 1);
    const SkinSection& section = skin.sections[std::size_t(k)];
    const auto place = [&](const Skin& s) {
      return evaluate(s.sections[std::size_t(k)].curve(), s.smooth.anchors[0][std::size_t(k)]).position;
    };
    const auto flipped = must(flip_section(skin, section.id));
    EXPECT_LT((place(flipped->skin) - place(skin)).norm(), 1e-12);
    if (section.closed) {
      const auto seam = move_seam(skin, section.points[2].id);
      EXPECT_LT((place(seam->skin) - place(skin)).norm(), 1e-12);
    }
    const auto inserted =
        must(insert_section_point(skin, section.id, uniform_int(rng, 0, section.curve().spans() - 1)));
    // On a bow of the curve equal parameters are a little apart along it.
    EXPECT_LT((place(inserted->skin) - place(skin)).norm(), 0.3);
    const auto back = delete_section_points(inserted->skin, inserted->points);
    EXPECT_NEAR(back->skin.smooth.anchors[0][std::size_t(k)], row[std::size_t(k)], 1e-12);
  });
}

TEST(EditSection, MirrorsAndSymmetry) {
  for_random(807, 12, [](std::mt19937_64& rng) {
    Skin skin = random_skin(rng);
    const Vector3 at = random_vector(rng, 2), normal = random_vector(rng) + Vector3(0, 0, 1.5);
    const Skin mirror = mirrored(skin, at, normal);
    EXPECT_LT(distance(mirrored(mirror, at, normal), skin), 1e-12);
    const auto a = must(evaluate_skin(skin)), b = must(evaluate_skin(mirror));
    const auto &p = a->mesh.control.mesh.positions, &q = b->mesh.control.mesh.positions;
    ASSERT_EQ(p.size(), q.size());
    const Vector3 unit = normal.normalized();
    double largest = 0;
    for (std::size_t v = 0; v < p.size(); ++v)
      largest = std::max(largest, (p[v] - 2 * unit.dot(p[v] - at) * unit - q[v]).norm());
    // Turning frames are interpolated between samples.
    EXPECT_LT(largest, a->plan.frames.mode() == FrameMode::translate ? 1e-9 : 1e-3);
    const SkinSection& section = any_section(rng, skin);
    Vector3 centre = Vector3::Zero();
    for (const SectionPoint& point : section.points) centre += point.position / section.size();
    const Vector3 across = section.points.back().position - section.points.front().position;
    const auto even = must(make_symmetric(skin, section.id, centre, across));
    const SkinSection& now = even->skin.sections[std::size_t(skin.find_section(section.id))];
    const auto partner = mirror_partners(now, centre, across);
    const Vector3 u = across.normalized();
    for (int i = 0; i < now.size(); ++i) {
      const Vector3 image = now.points[std::size_t(partner[std::size_t(i)])].position;
      EXPECT_LT((now.points[std::size_t(i)].position - (image - 2 * u.dot(image - centre) * u)).norm(),
                1e-12);
    }
  });
}

TEST(EditSection, WhatWouldBreakASkinIsRefused) {
  const Skin rails = skin_input("tworail");
  const auto off =
      move_section_points(rails, std::vector{MovedPoint{rails.sections[0].points[0].id, Vector3(0, -2, 0)}});
  must_fail(off, e_rail);
  // A skin that is broken may be edited.
  Skin broken = skin_input("fig6a");
  broken.sections.pop_back();
  const std::uint32_t id = broken.sections[0].points[0].id;
  EXPECT_TRUE(set_sharp(broken, Ids{id}, true).ok());
  EXPECT_EQ(set_sharp(broken, Ids{999}, true).error().code, e_skin_index);
  EXPECT_EQ(insert_section_point(broken, broken.sections[0].id, 99).error().code, e_skin_index);
  EXPECT_EQ(flip_section(broken, 99).error().code, e_skin_index);
  const Skin tube = skin_input("tube");
  EXPECT_FALSE(set_closed(tube, false)->skin.sections[0].closed);
  EXPECT_EQ(set_closed(set_closed(tube, false)->skin, true)->skin, tube);
}

}  // namespace
}  // namespace hariko
