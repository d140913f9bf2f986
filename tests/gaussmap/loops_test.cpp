// Loops resampled, drawn, with normals spread along them.

#include "core/gaussmap/outlines/drawn_loop.hpp"
#include "core/gaussmap/outlines/interpolate_normals.hpp"
#include "core/gaussmap/outlines/loop_curve.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "core/gaussmap/outlines/resample_loop.hpp"
#include "core/geometry/angles.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// An ellipse on the ellipsoid (2, 1.5, 1) at z = 0.4, uneven in every measure.
OutlineLoop uneven_ellipse(std::size_t count) {
  const Truth truth = ellipsoid({2, 1.5, 1});
  OutlineLoop loop;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = 2 * pi * double(i) / double(count), t = u + 0.3 * std::sin(u), r = std::sqrt(1 - 0.16);
    const Vector3 p(2 * r * std::cos(t), 1.5 * r * std::sin(t), 0.4);
    loop.points.push_back(p);
    loop.normals.push_back(Vector3(p.x() / 4, p.y() / 2.25, p.z()).normalized());
    loop.curvature.push_back(truth.curvature_of_normal(loop.normals.back()));
  }
  return loop;
}

struct LoopErrors {
  double point = 0, normal = 0, curvature = 0;
};
LoopErrors errors_on_ellipsoid(const OutlineLoop& loop) {
  const Truth truth = ellipsoid({2, 1.5, 1});
  LoopErrors out;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Truth::Foot foot = truth.foot(loop.points[i]);
    out.point =
        std::max({out.point, (foot.point - loop.points[i]).norm(), std::abs(loop.points[i].z() - 0.4)});
    out.normal = std::max(out.normal, angle_between(foot.normal, loop.normals[i]));
    out.curvature =
        std::max(out.curvature, std::abs(loop.curvature[i] / truth.curvature_of_normal(foot.normal) - 1));
  }
  return out;
}

std::pair<double, double> least_and_largest_turn(const OutlineLoop& loop) {
  double least = HUGE_VAL, largest = 0;
  for (std::size_t i = 0; i < loop.normals.size(); ++i) {
    const double turn = angle_between(loop.normals[i], loop.normals[(i + 1) % loop.normals.size()]);
    least = std::min(least, turn);
    largest = std::max(largest, turn);
  }
  return {least, largest};
}

TEST(ResampleLoop, IsUniformInTheTurningOfTheNormalsAndStaysOnTheCurve) {
  LoopErrors before;
  for (const std::size_t count : {24u, 48u, 96u}) {
    const OutlineLoop given = uneven_ellipse(count);
    const auto [rough_least, rough_largest] = least_and_largest_turn(given);
    EXPECT_GT(rough_largest, 1.5 * rough_least);
    const auto made = must(resample_loop(given, 40, LoopMeasure::gauss_arc));
    ASSERT_EQ(made->points.size(), 40u);
    EXPECT_EQ(made->points[0], given.points[0]);
    const auto [least, largest] = least_and_largest_turn(*made);
    EXPECT_LT(largest, 1.02 * least);
    const LoopErrors errors = errors_on_ellipsoid(*made);
    // Third order in the spacing, which halves each time.
    if (count > 24) {
      EXPECT_LT(errors.point, before.point / 6);
      EXPECT_LT(errors.normal, before.normal / 6);
      EXPECT_LT(errors.curvature, before.curvature / 6);
    }
    before = errors;
  }
  EXPECT_LT(before.point, 1e-5);
  EXPECT_LT(before.normal, 2e-5);
  EXPECT_LT(before.curvature, 1e-4);
}

TEST(ResampleLoop, ByArcLength) {
  const auto made = must(resample_loop(uneven_ellipse(64), 50, LoopMeasure::arc));
  double least = HUGE_VAL, largest = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    const double chord = (made->points[(i + 1) % 50] - made->points[i]).norm();
    least = std::min(least, chord);
    largest = std::max(largest, chord);
  }
  EXPECT_LT(largest, 1.005 * least);  // chords are shorter than arcs where the curve bends
}

TEST(ResampleLoop, AUniformLoopStaysAsItIs) {
  const OutlineLoop circle = sphere_cap(32).outline.loops[0];
  const auto made = must(resample_loop(circle, 32, LoopMeasure::gauss_arc));
  for (std::size_t i = 0; i < 32; ++i) {
    EXPECT_LE((made->points[i] - circle.points[i]).norm(), 1e-12);
    EXPECT_LE((made->normals[i] - circle.normals[i]).norm(), 1e-12);
    EXPECT_NEAR(made->curvature[i], circle.curvature[i], 1e-12);
  }
}

TEST(ResampleLoop, NormalsStayPerpendicularOnRandomLoops) {
  for_random(9410, 40, [](std::mt19937_64& rng) {
    // A closed curve in space with normals that turn about it at will.
    std::array<Vector3, 3> wave;
    for (Vector3& v : wave) v = random_vector(rng, 0.3);
    const int turns = uniform_int(rng, -1, 1);
    const std::size_t count = 40;
    OutlineLoop loop;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = 2 * pi * double(i) / double(count);
      loop.points.push_back(Vector3(std::cos(t), std::sin(t), 0) + std::cos(2 * t) * wave[0] +
                            std::sin(2 * t) * wave[1] + std::cos(3 * t) * wave[2] / 3);
    }
    const auto tangents = loop_tangents(loop.points);
    for (std::size_t i = 0; i < count; ++i) {
      const double t = 2 * pi * double(i) / double(count);
      const Vector3 a = Vector3(std::cos(t), std::sin(t), 0), b = Vector3::UnitZ();
      const Vector3 n = std::cos(turns * t) * b + std::sin(turns * t) * a;
      loop.normals.push_back((n - n.dot(tangents[i]) * tangents[i]).normalized());
      loop.curvature.push_back(std::cos(t));  // both signs
    }
    for (const LoopMeasure measure : {LoopMeasure::arc, LoopMeasure::gauss_arc}) {
      const auto made = must(resample_loop(loop, 96, measure));
      for (std::size_t i = 0; i < made->points.size(); ++i) {
        EXPECT_NEAR(made->normals[i].norm(), 1, 1e-12);
        EXPECT_LE(std::abs(made->curvature[i]), 1 + 1e-12);
      }
    }
    const LoopCurve curve(loop);
    for (std::size_t i = 0; i < count; ++i)
      for (const double x : {0.2, 0.5, 0.9}) {
        const auto place = curve.at(i, x);
        EXPECT_LE(std::abs(place.normal.dot(place.tangent)), 1e-12);
        const double step = 1e-5;
        const Vector3 chord = curve.at(i, x + step).point - curve.at(i, x - step).point;
        EXPECT_LE(angle_between(chord, place.tangent), 1e-6);
      }
  });
}

TEST(ResampleLoop, SaysWhatItCannotDo) {
  OutlineLoop flat;
  for (int i = 0; i < 8; ++i) {
    flat.points.emplace_back(std::cos(i * pi / 4), std::sin(i * pi / 4), 0);
    flat.normals.push_back(Vector3::UnitZ());
  }
  EXPECT_EQ(resample_loop(flat, 12, LoopMeasure::gauss_arc).error().code, e_same_normal);
  EXPECT_TRUE(resample_loop(flat, 12, LoopMeasure::arc).ok());
  flat.points[3] = flat.points[2];
  EXPECT_EQ(resample_loop(flat, 12, LoopMeasure::arc).error().code, e_same_point);
  EXPECT_EQ(with_point_after(flat, 1).error().code, e_same_point);
  flat.points.resize(3);
  flat.normals.resize(3);
  EXPECT_EQ(resample_loop(flat, 12, LoopMeasure::arc).error().code, e_outline_too_few);
}

TEST(ResampleLoop, OneMorePoint) {
  const OutlineLoop given = uneven_ellipse(48);
  for (const std::size_t place : {0u, 17u, 47u}) {
    const auto made = must(with_point_after(given, place));
    ASSERT_EQ(made->points.size(), 49u);
    const LoopErrors errors = errors_on_ellipsoid(*made);
    EXPECT_LT(errors.point, 1e-4);
    EXPECT_LT(errors.curvature, 1e-3);
    const double before = (made->points[place + 1] - given.points[place]).norm(),
                 after = (made->points[place + 1] - given.points[(place + 1) % 48]).norm();
    EXPECT_NEAR(before, after, 0.1 * before);
  }
  EXPECT_EQ(reversed(reversed(given)), given);
  EXPECT_EQ(reversed(given).points[1], given.points[46]);
}

TEST(SpreadNormals, OneNormalGoesRoundWithAFlatLoop) {
  std::vector<Vector3> points;
  for (int i = 0; i < 30; ++i) points.emplace_back(3 * std::cos(i * pi / 15), 2 * std::sin(i * pi / 15), 1);
  const double tilt = 0.4;
  const std::pair<std::size_t, Vector3> given[] = {{0, {std::sin(tilt), 0, std::cos(tilt)}}};
  const auto normals = spread_normals(points, given);
  const auto cone = tilted_normals(points, Vector3::UnitZ(), tilt);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE((normals[i] - cone[i]).norm(), 1e-12) << i;
    EXPECT_NEAR(normals[i].z(), std::cos(tilt), 1e-12);
    EXPECT_GT(normals[i].dot(Vector3(points[i].x(), points[i].y(), 0)), 0);
  }
  // None: the loop's own.
  for (const Vector3& normal : spread_normals(points, {}))
    EXPECT_LE((normal - Vector3::UnitZ()).norm(), 1e-12);
}

TEST(SpreadNormals, RunsThroughWhatIsGivenOnRandomLoops) {
  for_random(9420, 60, [](std::mt19937_64& rng) {
    const Vector3 a = random_vector(rng, 0.4), b = random_vector(rng, 0.4);
    const int count = uniform_int(rng, 12, 60);
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i) {
      const double t = 2 * pi * i / count;
      points.push_back(Vector3(std::cos(t), std::sin(t), 0) + std::cos(2 * t) * a + std::sin(2 * t) * b);
    }
    const auto tangents = loop_tangents(points);
    std::vector<std::pair<std::size_t, Vector3>> given;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (chance(rng, 0.15)) given.emplace_back(i, random_vector(rng, 2));
    const auto normals = spread_normals(points, given);
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(normals[i].norm(), 1, 1e-12);
      EXPECT_LE(std::abs(normals[i].dot(tangents[i])), 1e-12);
      largest = std::max(largest, angle_between(tangents[i], tangents[(i + 1) % points.size()]));
    }
    for (const auto& [i, normal] : given) {
      const Vector3 across = normal - normal.dot(tangents[i]) * tangents[i];
      if (across.norm() > 1e-6) {
        EXPECT_LE(angle_between(normals[i], across), 1e-9);
      }
    }
  });
}

TEST(SpreadNormals, TurnsTheShorterWayAndNoFurtherThanGiven) {
  std::vector<Vector3> points;
  for (int i = 0; i < 40; ++i) points.emplace_back(std::cos(i * pi / 20), std::sin(i * pi / 20), 0);
  const auto tilted = [&](std::size_t i, double tilt) {
    return std::pair{i, tilted_normals(points, Vector3::UnitZ(), tilt)[i]};
  };
  const std::pair<std::size_t, Vector3> given[] = {tilted(3, 0.2), tilted(11, 1.1), tilted(30, -0.5)};
  const auto normals = spread_normals(points, given);
  const auto tilt_of = [&](std::size_t i) { return std::atan2(normals[i].dot(points[i]), normals[i].z()); };
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_GE(tilt_of(i), -0.5 - 1e-9);
    EXPECT_LE(tilt_of(i), 1.1 + 1e-9);
  }
  for (std::size_t i = 3; i < 11; ++i) EXPECT_LT(tilt_of(i), tilt_of(i + 1) + 1e-12);
  for (std::size_t i = 11; i < 30; ++i) EXPECT_GT(tilt_of(i) + 1e-12, tilt_of(i + 1));
}

TEST(DrawnLoop, ACircleOfCornersBecomesADome) {
  std::vector<Vector3> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(std::cos(i * pi / 4), std::sin(i * pi / 4), 0);
  for (const bool backwards : {false, true}) {
    if (backwards) std::reverse(corners.begin() + 1, corners.end());
    const auto loop = must(drawn_loop(corners, {}));
    ASSERT_EQ(loop->points.size(), 32u);
    EXPECT_LE((loop->points[0] - corners[0]).norm(), 1e-12);
    EXPECT_GT(vector_area(loop->points).z(), 0);
    for (std::size_t i = 0; i < 32; ++i) {
      EXPECT_NEAR(loop->points[i].norm(), 1, 4e-3);
      EXPECT_NEAR(loop->normals[i].z(), std::sqrt(0.5), 1e-9);
      EXPECT_GT(loop->normals[i].dot(loop->points[i]), 0);
    }
    GaussOptions options = in_mode(GaussMode::umbilic);
    const auto points = must(control_points({{*loop}}, options));
    EXPECT_TRUE(points->messages.empty()) << to_string(points->messages[0]);
    // The sphere of radius sqrt 2 has these normals: its cap is sqrt 2 - 1 high.
    double top = 0;
    for (const Vector3& point : points->points) top = std::max(top, point.z());
    EXPECT_NEAR(top, std::sqrt(2) - 1, 0.01);
  }
}

TEST(DrawnLoop, AHoleAboveTheOuterLoopMakesABand) {
  std::vector<Vector3> low, high;
  for (int i = 0; i < 6; ++i) {
    const Vector3 out(std::cos(i * pi / 3), std::sin(i * pi / 3), 0);
    low.push_back(out);
    high.push_back(0.4 * out + 0.5 * Vector3::UnitZ());
  }
  DrawnLoop settings{.tilt = 1.2};
  const auto outer = must(drawn_loop(low, settings));
  settings.tilt = 0.4;
  settings.hole = true;
  const auto hole = must(drawn_loop(high, settings));
  EXPECT_LT(vector_area(hole->points).z(), 0);
  EXPECT_GT(hole->normals[0].x(), 0);  // away from the middle of the hole
  GaussOptions options = in_mode(GaussMode::umbilic);
  const auto points = must(control_points({{*outer, *hole}}, options));
  EXPECT_GT(points->points.size(), points->boundary_count);
}

TEST(DrawnLoop, SaysWhatItCannotUse) {
  const std::vector<Vector3> two{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(drawn_loop(two, {}).error().code, e_outline_too_few);
  const std::vector<Vector3> same{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto made = drawn_loop(same, {});
  EXPECT_EQ(made.error().code, e_same_point);
  EXPECT_EQ(made.error().element, element_of(VertexId{1}));
  const std::vector<Vector3> bad{{0, 0, 0}, {std::nan(""), 0, 0}, {0, 1, 0}};
  EXPECT_EQ(drawn_loop(bad, {}).error().code, e_outline_not_finite);
  const std::vector<Vector3> line{
      {0, 0, 0}, {1, 0, 0}, {2, 0, 0}};  // goes there and back: not of use, but no harm
  EXPECT_TRUE(drawn_loop(line, {}).ok() || !drawn_loop(line, {}).error().text.empty());
  DrawnLoop flat{.tilt = 0};
  const std::vector<Vector3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(drawn_loop(triangle, flat).ok());
}

}  // namespace
}  // namespace hariko::test
