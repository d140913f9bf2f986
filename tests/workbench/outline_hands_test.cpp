// Outlines by hand, through the whole interface: loops drawn on the ground and on a surface, normals turned,
// spread and made even, borders of a surface, the polyhedron, files; a surface that follows every step of a
// drag.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/document/edits/edit_outlines.hpp"
#include "core/document/file.hpp"
#include "core/geometry/angles.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "tests/workbench/program_hands.hpp"
#include "ui/editor/outlines.hpp"

namespace hariko::test {
namespace {

/// Least and largest angle between the normals of neighbours.
std::pair<double, double> steps_of_normals(const OutlineLoop& loop) {
  double least = HUGE_VAL, largest = 0;
  for (std::size_t i = 0; i < loop.normals.size(); ++i) {
    const double step = angle_between(loop.normals[i], loop.normals[(i + 1) % loop.normals.size()]);
    least = std::min(least, step);
    largest = std::max(largest, step);
  }
  return {least, largest};
}

class OutlineByHand : public ::testing::Test, protected ProgramHands {
 protected:
  OutlineByHand() : ProgramHands(Begin::start_page, std::make_shared<TemporaryFolder>(), {1280, 800}) {
    wait();
  }
  const Outline& outline() { return *editor().active_object()->outline()->outline; }
  /// Draws a loop round the middle of the view with the tool of a command: it looks as a circle on the ground
  /// does. `share`: of the view.
  void draw(const char* name, const char* command, double share, int count) {
    menu(name, command);
    wait();
    const Vector2 middle = in_view(0.5, 0.5);
    const Marks::Rect view = marks().at("view.0");
    const double radius = share * std::min(view.width, view.height) / 2;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      click(middle + radius * Vector2(std::cos(angle), 0.6 * std::sin(angle)));
    }
    press({"Enter"});
    wait();
  }
  /// An outline on the ground, drawn from the start page on.
  void draw_first() {
    draw("Add", "add.outline", 0.6, 8);
    expect_step(1, "Add outline");
    ASSERT_TRUE(editor().active_object() && editor().active_object()->outline()) << hint();
    ASSERT_EQ(surface_error(), "");
  }
  /// A steeper one with a hole.
  void draw_both() {
    draw_first();
    press({"1", "Ctrl+A"});
    enter("outline_tilt", "60");
    wait_for_step(2, "Turn 32 normals");
    press({"Esc"});
    draw("Outline", "outline.add_loop", 0.16, 6);
    expect_step(3, "Add loop");
    ASSERT_EQ(surface_error(), "");
    ASSERT_EQ(outline().point_count(), 64U);
  }
};

TEST_F(OutlineByHand, ADraggedArrowTurnsItsNormalAndTheSurfaceFollows) {
  draw_first();
  const Vector2 arrow = middle_of("outline.normal.0"), point = middle_of("outline.point.0");
  begin_drag(arrow, arrow + Vector2(14, 20));
  for (int i = 0; i < 3; ++i) bench().settle();
  EXPECT_TRUE(editor().history.in_gesture());
  const SurfaceView* view = editor().view_of(editor().selection.active);
  ASSERT_NE(view, nullptr);
  EXPECT_EQ(*view->object->outline()->outline, outline()) << "the surface is that from before the drag";
  bench().release();
  wait_for_step(2, "Turn normal");
  EXPECT_EQ(surface_error(), "");
  EXPECT_GT((middle_of("outline.normal.0") - arrow).norm(), 2) << "the arrow stayed where it was";
  EXPECT_LT((middle_of("outline.point.0") - point).norm(), 1) << "turning a normal moved its point";
  press({"Ctrl+Z"});
  wait_for_step(1, "Add outline");
  EXPECT_LT((middle_of("outline.normal.0") - arrow).norm(), 1) << "undo did not put the arrow back";
}

TEST_F(OutlineByHand, AllNormalsAreTurnedByANumberAndAPointIsDragged) {
  draw_first();
  press({"1", "Ctrl+A"});
  EXPECT_EQ(selected(), "32 points");
  enter("outline_tilt", "60");
  wait_for_step(2, "Turn 32 normals");
  EXPECT_EQ(surface_error(), "") << "the steeper dome";
  press({"Esc"});
  const Outline before = outline();
  const Vector2 point = middle_of("outline.point.4");
  click(point);
  wait();
  EXPECT_EQ(selected(), "1 point");
  drag(point, point + Vector2(6, 4));
  wait_for_step(3, "Move vertex");
  EXPECT_FALSE(outline().loops[0].points[4] == before.loops[0].points[4]);
  EXPECT_TRUE(outline().loops[0].points[5] == before.loops[0].points[5]);
  press({"Ctrl+Z"});
  wait_for_step(2, "Turn 32 normals");
  EXPECT_EQ(outline(), before);
}

TEST_F(OutlineByHand, OneWithAHoleBecomesAPolyhedron) {
  draw_both();
  click("button.outline.convert");
  wait_for_step(4, "Convert to polyhedron");
  EXPECT_EQ(surface_error(), "") << "the surface of the polyhedron";
  ASSERT_TRUE(editor().active_object()->polyhedron());
  EXPECT_GT(editor().active_object()->polyhedron()->polyhedron.vertex_count(), 64U) << "no inner vertices";
  press({"Ctrl+Z"});
  wait_for_step(3, "Add loop");
  EXPECT_TRUE(marks().contains("outline.point.0"));
  press({"Ctrl+Y"});
  wait_for_step(4, "Convert to polyhedron");
}

TEST_F(OutlineByHand, OneWithAHoleIsExportedAndSaved) {
  draw_both();
  press({"Ctrl+E"});
  name_file("outline.obj");
  wait();
  std::istringstream lines(slurp(folder() / "outline.obj"));
  std::size_t triangles = 0;
  for (std::string line; std::getline(lines, line);) triangles += line.starts_with("f ") ? 1 : 0;
  EXPECT_GT(triangles, 1000U) << notice();
  press({"Ctrl+S"});
  name_file("outline.hariko");
  wait();
  const auto saved = load_document(folder() / "outline.hariko");
  ASSERT_TRUE(saved.ok()) << notice();
  EXPECT_EQ(*saved, editor().document());
  session().open(folder() / "outline.hariko");
  wait();
  EXPECT_EQ(surface_error(), "") << "the saved outline has no surface";
  EXPECT_TRUE(marks().contains("outline.point.63"));
}

/// Outlines of both borders of a band of a sphere of radius 50 round the origin.
class BordersByHand : public OutlineByHand {
 protected:
  void SetUp() override {
    open_sample("sphere_band");
    ASSERT_TRUE(editor().active_object() && editor().active_object()->outline()) << notice();
    menu("Outline", "outline.from_border");
    wait_for_step(1, "Outline from border");
    ASSERT_EQ(objects().size(), 3U) << notice();
    ASSERT_EQ(editor().selection.active, objects()[2]->id);
  }
  const std::vector<std::shared_ptr<const Object>>& objects() { return editor().document().objects; }
  const OutlineLoop& last_loop() { return objects()[2]->outline()->outline->loops[0]; }
  /// Turns one normal, and all others of its loop with it.
  void spread() {
    press({"1"});
    click(middle_of("outline.point.3"));
    wait();
    ASSERT_EQ(editor().selection.active, objects()[2]->id);
    ASSERT_EQ(selected(), "1 point");
    enter("outline_tilt", "50");
    wait_for_step(2, "Turn normal");
    click("button.outline.spread");
    wait_for_step(3, "Spread normals");
  }
};

TEST_F(BordersByHand, LieOnTheSphereAndAreFilledByDomes) {
  for (std::size_t i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    const OutlineSource& source = *objects()[i]->outline();
    EXPECT_EQ(source.outline->loops.size(), i == 0 ? 2U : 1U);
    // Saddles would fill the rest of the sphere instead of the holes.
    EXPECT_EQ(source.settings.sign, CurvatureSign::positive);
    const SurfaceView* view = editor().view_of(objects()[i]->id);
    ASSERT_NE(view, nullptr);
    EXPECT_TRUE(view->mesh);
    EXPECT_FALSE(view->error.has_value()) << to_string(*view->error);
  }
  for (const std::size_t i : {1U, 2U}) {
    const OutlineLoop& loop = objects()[i]->outline()->outline->loops[0];
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      EXPECT_NEAR(loop.points[k].norm(), 50, 0.1);
      // Normals of the band are off by up to 2.3 degrees (docs/gaussmap.md 6).
      EXPECT_LT(angle_between(loop.points[k], loop.normals[k]), 0.05);
    }
  }
}

TEST_F(BordersByHand, OneNormalIsSpreadAlongItsLoop) {
  const OutlineLoop before = last_loop();
  spread();
  EXPECT_EQ(surface_error(), "") << "the surface with spread normals";
  const OutlineLoop after = last_loop();
  EXPECT_TRUE(after.points == before.points) << "spreading normals moved points";
  for (const Vector3& normal : after.normals) EXPECT_NEAR(normal.z(), after.normals[0].z(), 1e-3);
  EXPECT_GT(angle_between(after.normals[0], before.normals[0]), 0.05) << "no normal was turned";
}

TEST_F(BordersByHand, StepsOfNormalsAreMadeEvenAgain) {
  spread();
  press({"Del"});
  wait();
  EXPECT_EQ(editor().history.position(), 4U);
  const OutlineLoop uneven = last_loop();
  const auto [least, largest] = steps_of_normals(uneven);
  EXPECT_GT(largest, 1.5 * least) << "the steps are even already";
  press({"Esc"});
  click("button.outline.resample");
  wait_for_step(5, "Resample by normals");
  EXPECT_EQ(surface_error(), "") << "the surface of the resampled outline";
  EXPECT_EQ(last_loop().points.size(), uneven.points.size()) << "resampling changed the number of points";
  const auto [even_least, even_largest] = steps_of_normals(last_loop());
  EXPECT_LT(even_largest, 1.02 * even_least) << "uneven steps";
}

/// The ellipsoid (2, 1.5, 1) over a circle of 36 normals 60 degrees round z, with its curvature.
Document dense_cap() {
  constexpr int count = 36;
  constexpr double size = 25;
  const Vector3 squares(4, 2.25, 1);
  OutlineLoop loop;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i / count, polar = std::numbers::pi / 3;
    const Vector3 normal(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
    const double square = squares.dot(normal.cwiseAbs2());
    loop.points.push_back(size / std::sqrt(square) * squares.cwiseProduct(normal));
    loop.normals.push_back(normal);
    loop.curvature.push_back(square * square / (squares.prod() * size * size));
  }
  const Document sample = load_document(source_folder() + "/assets/samples/ellipsoid_cap.hariko").value();
  return edit_outline(sample, sample.objects[0]->id,
                      [&](const Outline&) -> Result<Outline> { return Outline{{loop}}; })
      .value();
}

class DenseCap : public BenchHands {
 protected:
  DenseCap() : BenchHands(dense_cap(), {1280, 800}) { bench_.wait_for_surfaces(); }
  const SurfaceView& view() { return *editor().view_of(editor().selection.active); }
  /// Points all over the surface.
  std::vector<Vector3> samples() {
    std::vector<Vector3> out;
    const Surface& surface = view().surface;
    for (Index patch = 0; patch < surface.patch_count(); ++patch)
      out.push_back(surface.patches().evaluate(patch, {0.3, 0.3}, Order::first).position);
    return out;
  }
  /// Until the gesture has rested for so long that its surface is as fine as afterwards.
  void rest() {
    for (int i = 0; i < 12; ++i) bench_.settle();
  }
  std::size_t changed_pixels(const Image& before) {
    const Image after = bench_.renderer().read(0);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < std::min(before.rgba.size(), after.rgba.size()); ++i)
      changed += before.rgba[i] != after.rgba[i] ? 1 : 0;
    return changed;
  }
};

double largest_way(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

/// With two hundred points inside every step of a drag has its surface before the button is released.
TEST_F(DenseCap, FollowsEveryStepOfADraggedNormal) {
  ASSERT_GE(inserted_points(editor(), *editor().active_object()), 200U);
  ASSERT_FALSE(view().error.has_value());
  // The point furthest to the left: its arrow is seen from the side.
  const std::string normal = "outline.normal.", point = "outline.point.";
  int number = 0;
  for (int i = 0; i < 36; ++i)
    if (marks().at(point + std::to_string(i)).x < marks().at(point + std::to_string(number)).x) number = i;
  const Marks::Rect head = marks().at(normal + std::to_string(number));
  const Vector2 arrow(head.x + head.width / 2.0, head.y + head.height / 2.0);
  const std::vector<Vector3> first = samples();
  std::vector<Vector3> last = first;
  Image picture = bench_.renderer().read(0);
  move_to(arrow);
  bench_.press();
  for (int i = 1; i <= 4; ++i) {
    SCOPED_TRACE(i);
    // A first step that is taken for a drag, and not for a click.
    move_to(arrow + Vector2(2.0 + i, -3 - 1.5 * i));
    for (int k = 0; k < 3; ++k) bench_.settle();
    EXPECT_EQ(*view().object->outline()->outline, *editor().active_object()->outline()->outline);
    rest();
    ASSERT_FALSE(view().error.has_value()) << to_string(*view().error);
    EXPECT_EQ(view().quality, Quality::final);
    EXPECT_EQ(*view().object->outline()->outline, *editor().active_object()->outline()->outline);
    EXPECT_GT(largest_way(samples(), last), 1e-3) << "the surface is that of the step before";
    EXPECT_GT(changed_pixels(picture), 20U) << "it looks as before";
    last = samples();
    picture = bench_.renderer().read(0);
  }
  EXPECT_EQ(editor().history.position(), 0U) << "the gesture made a step before its end";
  bench_.release();
  bench_.wait_for_surfaces();
  EXPECT_EQ(editor().history.undo_label(), "Turn normal");
  tap("Ctrl+Z");
  bench_.wait_for_surfaces();
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_LT(largest_way(samples(), first), 1e-6) << "undo did not bring the surface back";
}

}  // namespace
}  // namespace hariko::test
