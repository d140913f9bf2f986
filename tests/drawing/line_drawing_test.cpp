#include "core/drawing/line_drawing.hpp"

#include <map>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/surface/facets.hpp"
#include "core/surface/weld_patches.hpp"
#include "tests/drawing/drawing_views.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko {

namespace {

using test::view_along;

DrawnSurface placed(Surface surface, const Vector3& at, double scale = 1) {
  DrawnSurface out{std::move(surface)};
  out.transform.translate(at).scale(scale);
  return out;
}

std::vector<PageLine> strokes_of(std::span<const DrawnSurface> surfaces, const DrawingView& view,
                                 bool hidden = false) {
  LineDrawingSettings settings;
  settings.hidden = hidden;
  auto drawing = draw_lines(surfaces, view, settings);
  if (!drawing) ADD_FAILURE() << to_string(drawing.error());
  return drawing ? std::move(drawing).value().lines : std::vector<PageLine>{};
}

double length_of(const PageLine& stroke) {
  double length = 0;
  for (std::size_t i = 1; i < stroke.points.size(); ++i)
    length += (stroke.points[i] - stroke.points[i - 1]).norm();
  return length;
}

/// Lengths on the page, by kind; hidden ones second.
std::map<LineKind, std::array<double, 2>> lengths_of(const std::vector<PageLine>& strokes) {
  std::map<LineKind, std::array<double, 2>> out;
  for (const PageLine& stroke : strokes) out[stroke.kind][stroke.hidden ? 1 : 0] += length_of(stroke);
  return out;
}

/// Six flat squares with sides of 2, looking outwards.
Surface box_of_patches() {
  std::vector<BezierPatch> patches;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      BezierPatch patch{1, 1, {}, {}};
      for (const double t : {-1.0, 1.0})
        for (const double s : {-1.0, 1.0}) {
          Vector3 p;
          p[axis] = side;
          p[(axis + 1) % 3] = side > 0 ? s : t;
          p[(axis + 2) % 3] = side > 0 ? t : s;
          patch.points.push_back(p);
        }
      patches.push_back(patch);
    }
  auto welded = test::must(weld_patches(Vector3::Zero(), patches));
  return std::move(welded).value();
}

Surface box_of_facets() {
  std::vector<Vector3> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  const std::vector<std::array<Index, 3>> triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                                       {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                       {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return facet_surface(Vector3::Zero(), corners, triangles, std::vector<Element>(12));
}

/// Lengths of that box's twelve edges on the page: sum of those seen from a direction with three negative
/// components, and of the three that meet in the far corner.
std::array<double, 2> box_edges(const DrawingView& view) {
  std::array<double, 2> out{0, 0};
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 4; ++k) {
      Vector3 a;
      a[axis] = -1;
      a[(axis + 1) % 3] = k & 1 ? 1 : -1;
      a[(axis + 2) % 3] = k & 2 ? 1 : -1;
      Vector3 b = a;
      b[axis] = 1;
      const double length = (view.project(b) - view.project(a)).head<2>().norm();
      out[k == 0 ? 1 : 0] += length;
    }
  return out;
}

}  // namespace

TEST(LineDrawing, ASphereIsACircle) {
  test::for_random(1, 6, [](std::mt19937_64& rng) {
    const double radius = test::log_uniform(rng, 1e-2, 1e4);
    const bool orthographic = test::chance(rng, 0.5);
    const double distance = radius * test::uniform(rng, 2, 10);
    const Vector3 centre = test::random_vector(rng, 1e3 * radius);
    const DrawingView view = view_along(test::random_vector(rng), centre, distance, 3 * radius, orthographic);
    const DrawnSurface sphere = placed(test::sphere(radius), centre);
    const std::vector<PageLine> strokes = strokes_of(std::span(&sphere, 1), view);
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_EQ(strokes[0].kind, LineKind::silhouette);
    EXPECT_EQ(strokes[0].points.front(), strokes[0].points.back());
    const double wanted =
        view.focal * (orthographic ? radius : radius / std::sqrt(distance * distance - radius * radius));
    for (const Vector2& p : strokes[0].points) EXPECT_NEAR((p - Vector2(400, 300)).norm(), wanted, 1e-4);
    EXPECT_NEAR(length_of(strokes[0]), 2 * std::numbers::pi * wanted, 1e-3 * wanted);
  });
}

TEST(LineDrawing, TheNearerSphereHidesTheOther) {
  // The second disc lies a radius to the side of the first on the page, and behind it.
  // Its silhouettes run along sides of patches, where rounding alone decides which patch they are on.
  const DrawingView view = view_along(Vector3::UnitY(), Vector3::Zero(), 10, 6, true);
  const DrawnSurface two[] = {placed(test::sphere(1), Vector3::Zero()),
                              placed(test::sphere(1), 3 * view.forward + view.right)};
  const std::vector<PageLine> strokes = strokes_of(two, view, true);
  const double radius = view.focal;
  const Vector2 near(400, 300), far(400 + radius, 300);
  double hidden = 0, visible = 0;
  for (const PageLine& stroke : strokes) {
    (stroke.hidden ? hidden : visible) += length_of(stroke);
    for (const Vector2& p : stroke.points)
      if (stroke.hidden) {
        EXPECT_NEAR((p - far).norm(), radius, 0.05);
        EXPECT_LE((p - near).norm(), radius + 0.1);
      } else if (std::abs((p - near).norm() - radius) > 0.05) {
        EXPECT_NEAR((p - far).norm(), radius, 0.05);
        EXPECT_GE((p - near).norm(), radius - 0.1);
      }
  }
  // A third of the far circle is inside of the near one.
  EXPECT_NEAR(hidden, 2 * std::numbers::pi * radius / 3, 1);
  EXPECT_NEAR(visible + hidden, 4 * std::numbers::pi * radius, 1);
}

TEST(LineDrawing, LinesOfATorusAreWhereTheyShouldBeAndHiddenWhereItHidesThem) {
  // Seen in parallel, the silhouette lies at the small radius from the ellipse of the middle circle.
  const double large = 2, small = 0.6;
  test::for_random(3, 5, [&](std::mt19937_64& rng) {
    const DrawingView view = view_along(test::random_vector(rng), Vector3::Zero(), 20, 7, true);
    const DrawnSurface torus = placed(test::torus(large, small, 6, 5), Vector3::Zero());
    int checked = 0;
    double wrong = 0, all = 0;
    for (const PageLine& stroke : strokes_of(std::span(&torus, 1), view, true)) {
      ASSERT_EQ(stroke.kind, LineKind::silhouette);
      for (std::size_t i = 1; i < stroke.points.size(); ++i) {
        const Vector2 page = 0.5 * (stroke.points[i - 1] + stroke.points[i]);
        const Vector2 at((page.x() - 400) / view.focal, (300 - page.y()) / view.focal);
        // The place of the middle circle that the silhouette belongs to: the distance is stationary there.
        bool found = false, seen = false;
        constexpr int steps = 2000;
        const auto place = [&](int k) -> Vector3 {
          const double angle = 2 * std::numbers::pi * k / steps;
          return large * Vector3(std::cos(angle), std::sin(angle), 0);
        };
        const auto offset = [&](int k) -> Vector2 {
          return at - Vector2(place(k).dot(view.right), place(k).dot(view.up));
        };
        for (int k = 0; k < steps; ++k) {
          const double before = offset(k - 1).norm(), here = offset(k).norm(), after = offset(k + 1).norm();
          if ((here - before) * (after - here) > 0 || std::abs(here - small) > 0.003) continue;
          found = true;
          const Vector2 out = offset(k).normalized();
          const Vector3 start = place(k) + small * (out.x() * view.right + out.y() * view.up);
          bool blocked = false;
          for (double t = 0.02; t < 8 && !blocked; t += 0.01) {
            const Vector3 p = start - t * view.forward;
            blocked = std::hypot(std::hypot(p.x(), p.y()) - large, p.z()) < small - 0.002;
          }
          seen = seen || !blocked;
        }
        EXPECT_TRUE(found) << at.transpose();
        const double length = (stroke.points[i] - stroke.points[i - 1]).norm();
        all += length;
        if (seen == stroke.hidden) wrong += length;
        ++checked;
      }
    }
    EXPECT_GT(checked, 40);
    // The places where it starts to be hidden are known to about a unit of the page.
    EXPECT_LE(wrong, 0.02 * all);
  });
}

TEST(LineDrawing, ABoxShowsNineEdgesAndHidesThree) {
  for (const bool facets : {false, true})
    for (const bool orthographic : {false, true}) {
      SCOPED_TRACE(std::string(facets ? "facets" : "patches") + (orthographic ? ", orthographic" : ""));
      const DrawingView view = view_along({-1, -2, -1.3}, Vector3::Zero(), 12, 5, orthographic);
      const DrawnSurface box = placed(facets ? box_of_facets() : box_of_patches(), Vector3::Zero());
      const auto lengths = lengths_of(strokes_of(std::span(&box, 1), view, true));
      double visible = 0, hidden = 0;
      for (const auto& [kind, length] : lengths) visible += length[0], hidden += length[1];
      const std::array<double, 2> wanted = box_edges(view);
      EXPECT_NEAR(visible, wanted[0], 2);
      EXPECT_NEAR(hidden, wanted[1], 2);
      // Six edges are its outline; all others are seen from both sides, or from none.
      ASSERT_EQ(lengths.count(LineKind::silhouette), 1U);
      EXPECT_EQ(lengths.at(LineKind::silhouette)[1], 0);
      EXPECT_NEAR(lengths.at(LineKind::silhouette)[0] + lengths.at(LineKind::crease)[0], wanted[0], 2);
      EXPECT_NEAR(lengths.at(LineKind::crease)[1], wanted[1], 2);
    }
}

TEST(LineDrawing, ASectionShowsItsLineAndWhatLiesInside) {
  DrawingView view = view_along({-1, 0, 0}, Vector3::Zero(), 10, 3, true);
  view.section = Eigen::Hyperplane<double, 3>(Vector3::UnitX(), -0.6);  // keeps x below 0.6
  const DrawnSurface sphere = placed(test::sphere(1), Vector3::Zero());
  const auto strokes = strokes_of(std::span(&sphere, 1), view);
  bool cut = false;
  for (const PageLine& stroke : strokes) {
    if (stroke.kind != LineKind::section) continue;
    cut = true;
    for (const Vector2& p : stroke.points)
      EXPECT_NEAR((p - Vector2(400, 300)).norm(), 0.8 * view.focal, 1e-3);
  }
  EXPECT_TRUE(cut);
  // From the side the cap is gone.
  DrawingView side = view_along({0, 1, 0}, Vector3::Zero(), 10, 3, true);
  side.section = view.section;
  for (const PageLine& stroke : strokes_of(std::span(&sphere, 1), side))
    for (const Vector2& p : stroke.points) {
      // Lines lie in the plane through the middle that faces the viewer.
      const double x = (p.x() - 400) * side.right.x() + (300 - p.y()) * side.up.x();
      EXPECT_LE(x, 0.6 * side.focal + 0.01);
    }
}

TEST(LineDrawing, SizeAndPlaceDoNotMatter) {
  const auto drawing = [](double scale, const Vector3& at) {
    DrawingView view = view_along({1, 2, -1}, at, 10 * scale, 7 * scale, false);
    test::AnalyticOptions options;
    const DrawnSurface torus = placed(test::torus(2, 0.6, 6, 5, options), at, scale);
    return lengths_of(strokes_of(std::span(&torus, 1), view, true))[LineKind::silhouette];
  };
  const auto plain = drawing(1, Vector3::Zero());
  for (const double scale : {1e-3, 1e6}) {
    const auto other = drawing(scale, Vector3::Zero());
    EXPECT_NEAR(other[0], plain[0], 1);
    EXPECT_NEAR(other[1], plain[1], 1);
  }
  const auto moved = drawing(1, Vector3(1e6, -1e6, 1e6));
  EXPECT_NEAR(moved[0], plain[0], 3);
  EXPECT_NEAR(moved[1], plain[1], 3);
}

TEST(LineDrawing, IsTheSameOnAnyNumberOfThreads) {
  const DrawingView view = view_along({1, 2, -1}, Vector3::Zero(), 10, 7, false);
  const DrawnSurface torus = placed(test::torus(2, 0.6, 6, 5), Vector3::Zero());
  const auto many = strokes_of(std::span(&torus, 1), view, true);
  const ParallelLimit limit(1);
  const auto one = strokes_of(std::span(&torus, 1), view, true);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].points, many[i].points);
}

TEST(LineDrawing, OnlyTheKindsAskedForAreDrawn) {
  const DrawingView view = view_along({-1, -2, -1.3}, Vector3::Zero(), 12, 5, false);
  const DrawnSurface two[] = {placed(box_of_patches(), Vector3::Zero()),
                              placed(test::sphere(0.5), Vector3(0, 0, 1.8))};
  const auto all = lengths_of(strokes_of(two, view));
  ASSERT_EQ(all.size(), 2U);
  for (const auto& [kind, length] : all) {
    LineDrawingSettings settings;
    settings.kinds = {kind};
    const auto drawing = test::must(draw_lines(two, view, settings));
    const auto found = lengths_of(drawing->lines);
    ASSERT_EQ(found.size(), 1U) << to_string(kind);
    EXPECT_EQ(found.begin()->first, kind);
    EXPECT_DOUBLE_EQ(found.begin()->second[0], length[0]);
    EXPECT_EQ(line_kind_from(to_string(kind)), kind);
  }
  LineDrawingSettings none;
  none.kinds = {LineKind::section};
  EXPECT_EQ(draw_lines(two, view, none).error().code, e_drawing_empty);
  EXPECT_FALSE(line_kind_from("outline"));
}

TEST(LineDrawing, ThePageCutsLinesOffAndChangesNothingOnIt) {
  // The page of a closer view is the middle of that of a wider one.
  test::for_random(7, 4, [](std::mt19937_64& rng) {
    const bool orthographic = test::chance(rng, 0.5);
    const Vector3 direction = test::random_vector(rng);
    DrawingView wide = view_along(direction, Vector3::Zero(), 10, 7, orthographic);
    DrawingView close = wide;
    close.width = 300;
    close.height = 200;
    const DrawnSurface two[] = {placed(test::torus(2, 0.6, 6, 5), Vector3::Zero()),
                                placed(box_of_facets(), Vector3(0.3, 0.1, 0.2), 0.7)};
    const Vector2 shift((wide.width - close.width) / 2, (wide.height - close.height) / 2);
    std::array<double, 2> inside{0, 0}, found{0, 0};
    const auto measure = [](const PageLine& stroke, const Vector2& by, std::array<double, 2>& sum) {
      // Lengths of the parts well inside of the closer page.
      for (std::size_t i = 1; i < stroke.points.size(); ++i)
        for (int k = 0; k < 100; ++k) {
          const Vector2 step = stroke.points[i] - stroke.points[i - 1];
          const Vector2 p = stroke.points[i - 1] + (k + 0.5) / 100 * step - by;
          if (p.x() > 5 && p.x() < 295 && p.y() > 5 && p.y() < 195)
            sum[stroke.hidden ? 1 : 0] += step.norm() / 100;
        }
    };
    for (const PageLine& stroke : strokes_of(two, wide, true)) measure(stroke, shift, inside);
    for (const PageLine& stroke : strokes_of(two, close, true)) {
      measure(stroke, Vector2::Zero(), found);
      for (const Vector2& p : stroke.points) {
        EXPECT_GE(p.x(), -page_margin - 1e-6);
        EXPECT_LE(p.x(), close.width + page_margin + 1e-6);
        EXPECT_GE(p.y(), -page_margin - 1e-6);
        EXPECT_LE(p.y(), close.height + page_margin + 1e-6);
      }
    }
    EXPECT_GT(inside[0], 100);
    EXPECT_NEAR(found[0], inside[0], 0.01 * (inside[0] + inside[1]) + 3);
    EXPECT_NEAR(found[1], inside[1], 0.01 * (inside[0] + inside[1]) + 3);
  });
}

TEST(LineDrawing, WhatReachesBehindTheEyeHidesAndIsCutOff) {
  // The eye is inside of a long beam and looks along it to a sphere beyond its far end, which is closed.
  DrawingView view = view_along(Vector3::UnitY(), Vector3(0, 10, 0), 10, 6, false);
  view.near_plane = 0.1;
  DrawnSurface beam{box_of_facets()};
  beam.transform.scale(Vector3(1, 8, 1));
  const DrawnSurface two[] = {beam, placed(test::sphere(0.9), Vector3(0, 20, 0))};
  double visible = 0, hidden = 0;
  for (const PageLine& stroke : strokes_of(two, view, true)) {
    (stroke.hidden ? hidden : visible) += length_of(stroke);
    for (const Vector2& p : stroke.points) EXPECT_TRUE(p.allFinite());
    // The four edges that begin behind the eye run from beside the page to the end of the beam.
    if (stroke.hidden) continue;
    for (const Vector2& p : stroke.points) EXPECT_GE((p - Vector2(400, 300)).norm(), view.focal / 8 - 1e-6);
  }
  const double sphere = 2 * std::numbers::pi * view.focal * 0.9 / std::sqrt(400 - 0.81);
  EXPECT_NEAR(hidden, sphere, 2) << "the end of the beam hides the sphere and nothing else is hidden";
  EXPECT_GT(visible, 8 * view.focal / 8) << "the end of the beam";
}

TEST(LineDrawing, TellsHowFarItIs) {
  const DrawnSurface sphere = placed(test::sphere(1), Vector3::Zero());
  const Progress progress = Progress::make();
  const DrawingView view = view_along(Vector3::UnitY(), Vector3::Zero(), 10, 6, false);
  ASSERT_TRUE(draw_lines(std::span(&sphere, 1), view, {}, {}, progress).ok());
  EXPECT_EQ(progress.fraction(), 1);
}

TEST(LineDrawing, WhatLiesBehindTheEyeIsNotDrawn) {
  const DrawnSurface sphere = placed(test::sphere(1), Vector3(0, -20, 0));
  const DrawingView view = view_along(Vector3::UnitY(), Vector3::Zero(), 10, 6, false);
  test::must_fail(draw_lines(std::span(&sphere, 1), view, {}), e_drawing_empty);
  EXPECT_EQ(draw_lines({}, view, {}).error().code, e_drawing_empty);
}

TEST(LineDrawing, CanBeCancelled) {
  const DrawnSurface sphere = placed(test::sphere(1), Vector3::Zero());
  const DrawingView view = view_along(Vector3::UnitY(), Vector3::Zero(), 10, 6, false);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  test::must_fail(draw_lines(std::span(&sphere, 1), view, {}, cancel), e_cancelled);
}

}  // namespace hariko
