// Messages of the solvers and of their results: outlines that bring them about.

#include <algorithm>

#include "core/gaussmap/bending_fill.hpp"
#include "core/gaussmap/outlines/outline_settings.hpp"
#include "core/gaussmap/sphere/delaunay_refinement.hpp"
#include "core/geometry/triangle.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// The error names a point of the outline, in its text and as its element: the number of that point.
Index expect_error(const Outline& outline, const GaussOptions& options, Code code) {
  SCOPED_TRACE(code.name);
  const auto made = control_points(outline, options);
  if (made.ok()) {
    ADD_FAILURE() << "no error";
    return 0;
  }
  const Message& error = made.error();
  EXPECT_EQ(error.code, code) << to_string(error);
  EXPECT_FALSE(error.remedy.empty());
  EXPECT_EQ(error.element.kind, Element::Kind::vertex) << to_string(error);
  const auto number = Index(error.element.id);
  if (number >= outline.point_count()) {
    ADD_FAILURE() << "no point " << number;
    return 0;
  }
  EXPECT_NE(error.text.find(to_string(outline, outline_point(outline, number))), std::string::npos)
      << error.text;
  return number;
}

/// The first message of that code.
const Message* find_message(const ControlPoints& points, Code code) {
  for (const Message& message : points.messages)
    if (message.code == code) return &message;
  return nullptr;
}

Outline scaled_curvature(Outline outline, const std::function<double(const Vector3&)>& factor) {
  for (OutlineLoop& loop : outline.loops)
    for (std::size_t i = 0; i < loop.curvature.size(); ++i) loop.curvature[i] *= factor(loop.normals[i]);
  return outline;
}

TEST(GaussMessages, CurvatureThatPullsTheSurfaceFarAway) {
  // A millionth of the sphere's curvature asks for a million times its radius across the outline.
  const Outline flat = scaled_curvature(sphere_cap(32).outline, [](const Vector3&) { return 1e-6; });
  expect_error(flat, in_mode(GaussMode::curvature), e_diverged);
  // Without the curvature the same outline has a surface.
  EXPECT_TRUE(control_points(flat, in_mode(GaussMode::umbilic)).ok());
}

TEST(GaussMessages, ALoopThatIsALine) {
  Outline line{{{}}};
  for (const double x : {0., 1., 2., 3., 2.5, 1.5, 0.5}) {
    line.loops[0].points.emplace_back(x, 0, 0);
    line.loops[0].normals.push_back(Vector3::UnitZ());
  }
  const auto points = must(control_points(line, in_mode(GaussMode::position)));
  const Message* message = find_message(*points, w_flipped);
  ASSERT_TRUE(message);  // faces without an area have no outer side
  // The faces that it counts, and a corner of the first of them.
  int count = 0;
  Index first = 0;
  for (const auto& [a, b, c] : points->triangles) {
    const Vector3 area = area_vector(points->points[a], points->points[b], points->points[c]);
    if (area.dot(points->normals[a] + points->normals[b] + points->normals[c]) > 0) continue;
    if (count++ == 0) first = a;
  }
  EXPECT_EQ(message->text.find(std::to_string(count) + " "), 0u) << message->text;
  EXPECT_EQ(message->element, element_of(VertexId{first}));
}

TEST(GaussMessages, ACoarseArcIsNamedOnBothSidesOfTheSurface) {
  // Between two dense loops one lacks four neighbours; with negative curvature loops run the other way round
  // through the Gauss map.
  const Truth sphere = ellipsoid(Vector3::Ones());
  const auto circle = [&](double angle, bool clockwise) {
    return circle_of_normals(sphere, Vector3::UnitZ(), angle, 48, clockwise);
  };
  Outline dome{{circle(0.55, false), circle(0.5, true), circle(0.42, false)}};
  OutlineLoop& gap = dome.loops[1];
  for (auto* list : {&gap.points, &gap.normals}) list->erase(list->begin() + 11, list->begin() + 15);
  Outline saddle = dome;
  for (OutlineLoop& loop : saddle.loops)
    for (auto* list : {&loop.points, &loop.normals}) std::reverse(list->begin(), list->end());
  for (OutlineLoop* loop :
       {&dome.loops[0], &dome.loops[1], &dome.loops[2], &saddle.loops[0], &saddle.loops[1], &saddle.loops[2]})
    loop->curvature.clear();
  GaussOptions options = in_mode(GaussMode::umbilic);
  EXPECT_EQ(expect_error(dome, options, e_boundary_edge), 48u + 10u);
  options.sign = CurvatureSign::negative;
  EXPECT_EQ(expect_error(saddle, options, e_boundary_edge), 48u + 44u - 1 - 11u);
}

TEST(GaussMessages, TheLimitOfPoints) {
  for (const GaussMode mode :
       {GaussMode::umbilic, GaussMode::curvature, GaussMode::paper, GaussMode::position})
    for (const GroundTruth& truth : {sphere_cap(32), sphere_band(32)}) {
      SCOPED_TRACE(truth.name + " " + std::to_string(int(mode)));
      GaussOptions options = in_mode(mode);
      options.most_points = 40;
      const auto few = must(control_points(truth.outline, options));
      EXPECT_LE(few->points.size(), few->boundary_count + 40);
      const Message* message = find_message(*few, w_too_many_points);
      ASSERT_TRUE(message);
      EXPECT_NE(message->text.find("40"), std::string::npos);
      if (mode == GaussMode::paper) continue;  // slow with all of them
      options.most_points = 20000;
      const auto all = must(control_points(truth.outline, options));
      EXPECT_FALSE(find_message(*all, w_too_many_points));
    }
}

TEST(GaussMessages, WrongCurvatureMakesAResultThatIsNotConvex) {
  const Outline outline = scaled_curvature(sphere_cap(32).outline, [](const Vector3& n) {
    return std::exp(2.2 * std::sin(3 * std::atan2(n.y(), n.x())));
  });
  const auto points = must(control_points(outline, in_mode(GaussMode::curvature)));
  const Message* message = find_message(*points, w_result_not_convex);
  ASSERT_TRUE(message);
  ASSERT_EQ(message->element.kind, Element::Kind::vertex);
  const auto vertex = std::size_t(message->element.id);
  EXPECT_GE(vertex, points->boundary_count);
  EXPECT_FALSE(points->curvature[vertex] > 0);
}

TEST(GaussMessages, RoughNormalsAreFilledWithoutCurvature) {
  Outline rough = sphere_cap(32).outline;
  OutlineLoop& loop = rough.loops[0];
  const Vector3 along = (loop.points[8] - loop.points[6]).normalized();
  loop.normals[7] = (loop.normals[7] + std::tan(3 * pi / 180) * along).normalized();
  const auto points = must(control_points(rough, in_mode(GaussMode::curvature)));
  const Message* message = find_message(*points, w_umbilic_used);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->element, element_of(VertexId{7}));
  const auto umbilic = must(control_points(rough, in_mode(GaussMode::umbilic)));
  EXPECT_EQ(points->points, umbilic->points);
}

TEST(GaussMessages, AModeThatIsGoneIsReplaced) {
  OutlineSettings settings;
  settings.mode_replaced = true;
  const Outline outline = sphere_cap(32).outline;
  const auto points = must(control_points(outline, gauss_options(settings)));
  ASSERT_EQ(points->messages.size(), 1u);
  EXPECT_EQ(points->messages[0].code, w_outline_method);
  EXPECT_FALSE(points->messages[0].remedy.empty());
  const auto umbilic = must(control_points(outline, in_mode(GaussMode::umbilic)));
  EXPECT_TRUE(umbilic->messages.empty());
  EXPECT_EQ(points->points, umbilic->points);
}

TEST(GaussMessages, BendingThatDoesNotSettle) {
  // Normals that rock to both sides, four times along the loop.
  Outline outline = sphere_cap(48).outline;
  OutlineLoop& loop = outline.loops[0];
  loop.curvature.clear();
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Vector3 out = Vector3(loop.points[i].x(), loop.points[i].y(), 0).normalized();
    const double tilt = std::sin(double(i) * pi / 6);
    loop.normals[i] = std::cos(tilt) * Vector3::UnitZ() + std::sin(tilt) * out;
  }
  const auto points = must(control_points(outline, in_mode(GaussMode::position)));
  EXPECT_TRUE(find_message(*points, w_not_settled));
  EXPECT_FALSE(
      find_message(*control_points(sphere_cap(48).outline, in_mode(GaussMode::position)), w_not_settled));
}

}  // namespace
}  // namespace hariko::test
