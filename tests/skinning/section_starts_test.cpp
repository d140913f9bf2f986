// Starts of closed sections.

#include "core/skinning/sections/section_starts.hpp"

#include <cmath>
#include <numbers>

#include "core/analysis/measures.hpp"
#include "core/skinning/columns/knot_shift.hpp"
#include "core/skinning/columns/smooth.hpp"
#include "core/skinning/edit/add_section.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/sections/section_direction.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

using std::numbers::pi;

/// A circle across z that begins at an angle (degrees).
SkinSection circle(std::uint32_t id, double v, double z, int points, double radius, double begin) {
  SkinSection section;
  section.id = id;
  section.v = v;
  section.closed = true;
  for (int i = 0; i < points; ++i) {
    const double a = begin * pi / 180 + 2 * pi * i / points;
    section.points.push_back(
        {1000 * id + std::uint32_t(i), Vector3(radius * std::cos(a), radius * std::sin(a), z), false});
  }
  return section;
}

/// Circles of radius 10 at even heights up to 40.
Skin tube(const std::vector<double>& begins, int path_points = 4, int points = 12) {
  Skin skin;
  for (int i = 0; i < path_points; ++i) skin.path.points.push_back({0, 0, 40.0 * i / (path_points - 1)});
  const int last = int(begins.size()) - 1;
  for (int k = 0; k <= last; ++k)
    skin.sections.push_back(
        circle(std::uint32_t(k), double(k) / last, 40.0 * k / last, points, 10, begins[std::size_t(k)]));
  return skin;
}

double area_of(const Skin& skin) {
  const auto made = must(SkinSurfacer().surface(skin, Vector3::Zero()));
  EXPECT_TRUE(made->result.warnings.empty()) << to_string(made->result.warnings.front());
  const auto misses = section_misses(skin, made->result.mesh, made->surface);
  if (skin.method == SkinMethod::pleat)
    for (const SectionMiss& miss : misses) EXPECT_LT(miss.same_parameter, 1e-9);
  return measure(made->surface).area;
}

const SkinMethod methods[] = {SkinMethod::pleat, SkinMethod::smooth, SkinMethod::anchored};

TEST(SectionStarts, EqualCirclesAreACylinderWhereverTheyBegin) {
  for (const SkinMethod method : methods)
    for (const double begin : {0.0, 15.0, 60.0, 90.0, 170.0, 180.0, 10.0, -73.0})
      for (const int path : {2, 4, 7}) {
        SCOPED_TRACE(testing::Message() << int(method) << " begins at " << begin << ", path " << path);
        Skin skin = tube({0, begin}, path);
        skin.method = method;
        EXPECT_NEAR(area_of(skin), 2400.8, 0.1);
      }
}

TEST(SectionStarts, TheHourglassOfTheComplaintIsACylinder) {
  const auto read = must(read_skin_layout(data_text("two_circles_start_180.json")));
  for (const SkinMethod method : methods) {
    Skin skin = *read;
    skin.method = method;
    EXPECT_NEAR(area_of(skin), 2400.8, 0.1) << int(method);
  }
}

TEST(SectionStarts, SoDoesALongerTubeOfOtherCounts) {
  for (const SkinMethod method : methods)
    for (const int points : {8, 12, 20}) {
      Skin straight = tube({0, 0, 0, 0}, 4, points), skin = tube({0, 100, 33, -71}, 4, points);
      straight.method = skin.method = method;
      EXPECT_NEAR(area_of(skin), area_of(straight), 3e-4 * area_of(straight)) << int(method) << " " << points;
    }
}

TEST(SectionStarts, AreTheSameAtEveryScaleAndPlace) {
  for (const double scale : {1e-3, 1.0, 1e6})
    for (const double shift : {0.0, 1e6}) {
      Skin skin = tube({0, 25});
      change_positions(skin, [&](Vector3& p) { p = scale * (p + Vector3(shift, 0, 0)); });
      const auto plan = must(plan_skin(skin));
      // Curves of twelve points are circles up to that.
      EXPECT_NEAR(plan->strips[0].match.start, -25.0 / 360, 1e-7);
    }
}

TEST(SectionStarts, SectionsThatRunTheOtherWayAreTurned) {
  for (const double begin : {0.0, 90.0, 170.0}) {
    Skin skin = tube({0, begin, 2 * begin});
    for (const std::size_t k : {std::size_t(1), std::size_t(2)})
      std::reverse(skin.sections[k].points.begin(), skin.sections[k].points.end());
    EXPECT_NEAR(area_of(turn_sections(skin)), 2400.8, 0.1);
    // Sections that the designer turned stay.
    skin.sections[1].direction_chosen = true;
    EXPECT_EQ(turn_sections(skin).sections[1], skin.sections[1]);
  }
}

TEST(SectionStarts, AChosenStartStaysFirstWhenItsSectionIsTurned) {
  Skin skin = tube({0, 0});
  std::reverse(skin.sections[1].points.begin(), skin.sections[1].points.end());
  skin.sections[1].start_chosen = true;
  const SkinSection turned = turn_sections(skin).sections[1];
  EXPECT_EQ(turned.points.front(), skin.sections[1].points.front());
  EXPECT_EQ(turned.points[1], skin.sections[1].points.back());
}

TEST(SectionStarts, AClosedPathMatchesItsLastSectionToTheFirst) {
  const auto ring = [](const std::vector<double>& begins) {
    Skin skin;
    skin.path.closed = true;
    skin.frame = FrameMode::rotation_minimising;
    for (int i = 0; i < 12; ++i)
      skin.path.points.push_back(50 * Vector3(std::cos(pi * i / 6), std::sin(pi * i / 6), 0));
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const double v = double(k) / double(begins.size()), turn = 2 * pi * v;
      SkinSection section = circle(std::uint32_t(k), v, 0, 12, 10, begins[k]);
      const Vector3 centre = evaluate(skin.path, v).position, out(std::cos(turn), std::sin(turn), 0);
      for (SectionPoint& p : section.points)
        p.position = centre + p.position.x() * out + p.position.y() * Vector3::UnitZ();
      skin.sections.push_back(section);
    }
    return skin;
  };
  for (const SkinMethod method : methods) {
    Skin straight = ring({0, 0, 0, 0}), skin = ring({0, 130, 45, -20});
    straight.method = skin.method = method;
    straight.pleat.density = skin.pleat.density = 2;  // as many rows where lines twist as where they do not
    const double wanted = area_of(straight);
    EXPECT_NEAR(area_of(skin), wanted, 5e-4 * wanted) << int(method);
  }
}

TEST(SectionStarts, WhatTheDesignerChoseStays) {
  // A start: the hourglass that was drawn.
  Skin skin = tube({0, 60});
  skin.sections[1].start_chosen = true;
  const auto chosen = must(plan_skin(skin));
  EXPECT_EQ(chosen->strips[0].lines[3], (PointPair{3, 3}));
  EXPECT_EQ(chosen->strips[0].twist, 0);
  // Moving the seam chooses it.
  const auto moved = must(move_seam(tube({0, 15}), 1003));
  EXPECT_TRUE(moved->skin.sections[1].start_chosen);
  EXPECT_EQ(plan_skin(moved->skin)->strips[0].lines[0].b, plan_skin(moved->skin)->strips[0].lines[0].a);
  const auto found = must(set_start_chosen(moved->skin, 1, false));
  EXPECT_NEAR(area_of(found->skin), 2400.8, 0.1);
  // A link: its points stay on one line, in each method that knows links.
  for (const SkinMethod method : {SkinMethod::pleat, SkinMethod::anchored}) {
    Skin linked = tube({0, 15});
    linked.method = method;
    linked.links.push_back({5, 0, 1, {0}, {1002}, false, false});
    const auto plan = must(plan_skin(linked));
    EXPECT_EQ(plan->strips[0].twist, 0);
    EXPECT_NE(std::find(plan->strips[0].lines.begin(), plan->strips[0].lines.end(), PointPair{0, 2}),
              plan->strips[0].lines.end());
    if (method != SkinMethod::anchored) continue;
    const auto anchors = must(skin_anchors(linked, *plan));
    const VirtualSurface surface(linked, *plan, *anchors);
    const double at = surface.anchor_places()[0];
    EXPECT_NEAR(std::remainder(surface.parameter(0, at), 1.0), 0, 1e-12);
    EXPECT_NEAR(std::remainder(surface.parameter(1, at) - 2.0 / 12, 1.0), 0, 1e-12);
  }
}

TEST(SectionStarts, TheLeastDisplacementIsFoundAmongAll) {
  for_random(4401, 60, [](std::mt19937_64& rng) {
    const auto random_curve = [&] {
      SubdivisionCurve curve;
      curve.closed = true;
      const int n = uniform_int(rng, 3, 14);
      for (int i = 0; i < n; ++i) {
        const double a = 2 * pi * i / n;
        curve.points.push_back(Vector3(3 * std::cos(a), 2 * std::sin(a), 0) + random_vector(rng, 1.5));
      }
      return curve;
    };
    const SubdivisionCurve a = random_curve(), b = random_curve();
    const StartMatch found = nearest_start(a, b);
    constexpr int samples = 360;
    const auto displacement = [&](double start) {
      Vector3 gap = Vector3::Zero();
      double sum = 0;
      for (int i = 0; i < samples; ++i) {
        const double u = (i + 0.5) / samples;
        const Vector3 d = evaluate(a, u).position - evaluate(b, u + start).position;
        gap += d / samples, sum += d.squaredNorm() / samples;
      }
      return sum - gap.squaredNorm();
    };
    EXPECT_NEAR(found.displacement, displacement(found.start), 1e-3 * found.size);
    for (int s = 0; s < 200; ++s) EXPECT_GT(displacement(s / 200.0), found.displacement - 1e-3 * found.size);
  });
}

TEST(SectionStarts, RegularShapesBeginAtTheNearestOfEqualPlaces) {
  SubdivisionCurve square;
  square.closed = true;
  square.points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  square.sharp = {1, 1, 1, 1};
  EXPECT_NEAR(nearest_start(square, square).start, 0, 1e-12);
  SubdivisionCurve turned = square;
  std::rotate(turned.points.begin(), turned.points.begin() + 1, turned.points.end());
  EXPECT_NEAR(nearest_start(square, turned).start, -0.25, 1e-9);
  SubdivisionCurve point = square;
  for (Vector3& p : point.points) p = Vector3(3, 3, 3);
  EXPECT_EQ(nearest_start(square, point).start, 0);
}

TEST(SectionStarts, CornersMeetCornersInEveryMethod) {
  const auto square = [](std::uint32_t id, double v, int turn) {
    SkinSection section;
    section.id = id, section.v = v, section.closed = true;
    const Vector3 corners[] = {{10, 10, 0}, {-10, 10, 0}, {-10, -10, 0}, {10, -10, 0}};
    for (int i = 0; i < 4; ++i)
      section.points.push_back(
          {100 * id + std::uint32_t(i), corners[(i + turn) % 4] + Vector3(0, 0, 40 * v), true});
    return section;
  };
  for (const SkinMethod method : methods)
    for (int turn = 0; turn < 4; ++turn) {
      Skin skin;
      skin.path.points = {{0, 0, 0}, {0, 0, 20}, {0, 0, 40}};
      skin.sections = {square(0, 0, 0), square(1, 1, turn)};
      skin.method = method;
      skin.smooth.columns = 8;
      EXPECT_NEAR(area_of(skin), 80 * 40, 1e-6) << int(method) << " " << turn;
    }
}

TEST(SectionStarts, ASectionAddedToATubeStaysOnIt) {
  for (const SkinMethod method : methods) {
    Skin skin = tube({0, 25});
    skin.method = method;
    const auto edit = must(add_section(skin, 0.5));
    EXPECT_NEAR(area_of(edit->skin), 2400.8, 0.3) << int(method);
  }
}

TEST(KnotShift, KeepsControlPointsAndIsTheNearestCurve) {
  for_random(4402, 20, [](std::mt19937_64& rng) {
    std::vector<Vector3> points;
    for (int i = uniform_int(rng, 3, 15); i > 0; --i) points.push_back(random_vector(rng));
    const KnotShift shift(points);
    const int n = int(points.size());
    for (int i = -n; i < 2 * n; ++i)
      EXPECT_LT((shift.at(i) - points[std::size_t((i + n) % n)]).norm(), 1e-12);
    // The gap is orthogonal to every cubic B-spline on the shifted knots.
    const double x = uniform(rng, 0, 1);
    SubdivisionCurve own{points, true, {}}, moved{{}, true, {}};
    for (int i = 0; i < n; ++i) moved.points.push_back(shift.at(i + x));
    for (int i = 0; i < n; ++i) {
      SubdivisionCurve basis{std::vector<Vector3>(std::size_t(n), Vector3::Zero()), true, {}};
      basis.points[std::size_t(i)] = Vector3(1, 0, 0);
      Vector3 product = Vector3::Zero();
      constexpr int samples = 4000;
      for (int s = 0; s < samples; ++s) {
        const double u = (s + 0.5) / samples;
        product += evaluate(basis, u).position.x() / samples *
                   (evaluate(moved, u).position - evaluate(own, u + x / n).position);
      }
      EXPECT_LT(product.norm(), 1e-7);
    }
  });
}

}  // namespace
}  // namespace hariko::test
