// Refining by hand: the surface stays where it was, and what is cut and snapped to are the curves that one
// sees.

#include <cmath>
#include <limits>

#include "render/picking.hpp"
#include "render/scene.hpp"
#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {
namespace {

/// Largest distance between two surfaces round zero, as a share of their size: along rays from all sides.
double distance(const Scene& a, const Scene& b) {
  constexpr int rays = 600;
  constexpr double far = 1e3;
  double worst = 0;
  for (int i = 0; i < rays; ++i) {
    // A spiral over the sphere.
    const double z = 1 - (2 * i + 1.0) / rays, r = std::sqrt(1 - z * z), turn = 2.399963 * i;
    const Vector3 out(r * std::cos(turn), r * std::sin(turn), z);
    const Ray ray{far * out, -out};
    const auto first = pick_surface(a, ray), second = pick_surface(b, ray);
    if (!first || !second) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, (first->point - second->point).norm());
  }
  return worst / a.objects[0].mesh->box().diagonal().norm();
}

class RefinementHands : public BenchHands {
 protected:
  RefinementHands() : BenchHands(Document()) {
    bench_.workbench().commands().run("add.box");
    bench_.wait_for_surfaces();
    bench_.click("field.width");
    bench_.frame();
    for (const char* number : {"62", "110", "36"}) {
      bench_.type(number);
      bench_.tap(std::string_view(number) == "36" ? "Enter" : "Tab");
    }
    bench_.wait_for_surfaces();
    bench_.move(400, 950);
    bench_.key("Home");
    for (int i = 0; i < 8; ++i) bench_.frame();
    bench_.workbench().commands().run("select.none");
    bench_.frame();
  }
  const SceneObject& object() { return bench_.workbench().viewport().scene().scene().objects[0]; }
  const PolyhedronSource& source() { return *editor().active_object()->polyhedron(); }
  Scene shown() {
    bench_.wait_for_surfaces();
    return bench_.workbench().viewport().scene().scene();
  }
  Vector3 end(Index edge, int which) {
    const DisplayPolyhedron& lines = *object().polyhedron;
    return object().to_world(lines.origin, lines.positions[lines.edges[edge][std::size_t(which)]]);
  }
  /// A point of the curve of an edge.
  Vector3 on_curve(Index edge, double share) {
    const std::vector<Vector3> curve = shown_curve(object(), edge);
    return curve.at(std::size_t(std::lround(share * double(curve.size() - 1))));
  }
  /// The edge along an axis whose middle is nearest to a place.
  Index edge_near(int axis, const Vector3& place) {
    Index best = no_index;
    double least = 1e300;
    for (Index e = 0; e < object().polyhedron->edges.size(); ++e) {
      const Vector3 a = end(e, 0), b = end(e, 1);
      if (std::abs((b - a).normalized()[axis]) < 0.99) continue;
      const double far = ((a + b) / 2 - place).norm();
      if (far >= least) continue;
      least = far;
      best = e;
    }
    return best;
  }
  /// Over the middle of the curve of a long edge.
  void cut_loop() {
    const Vector2 at = pixel(on_curve(edge_near(1, {31, 0, 18}), 0.5));
    bench_.move(at.x() - 3, at.y());
    press({"Ctrl+R"});
    click(at);
    click(at);
  }
  /// World places of the vertices that are not of the box.
  std::vector<Vector3> new_vertices() {
    std::vector<Vector3> out;
    for (Index v = 8; v < source().polyhedron.vertex_count(); ++v)
      out.push_back(
          editor().active_object()->transform.apply(source().origin + source().polyhedron.position(v)));
    return out;
  }
};

TEST_F(RefinementHands, ALoopCutKeepsTheFormUnlessItLiesOnStraightEdges) {
  const Scene before = shown();
  cut_loop();
  ASSERT_EQ(editor().history.undo_label(), "Loop cut") << bench_.workbench().viewport().hint();
  const double on_surface = distance(before, shown());
  EXPECT_LT(on_surface, 0.06);
  editor().undo();
  bench_.wait_for_surfaces();
  const Vector2 at = pixel(on_curve(edge_near(1, {31, 0, 18}), 0.5));
  bench_.move(at.x() - 3, at.y());
  press({"Ctrl+R"});
  bench_.workbench().key({KeyChord::parse("E").value(), U'e'});
  click(at);
  click(at);
  EXPECT_GT(distance(before, shown()), 1.5 * on_surface) << "the waist that a straight cut makes";
}

TEST_F(RefinementHands, TheMirrorOfAHalfKeepsTheForm) {
  const Scene before = shown();
  ASSERT_TRUE(bench_.workbench().commands().run("mirror.live_x").ran);
  EXPECT_LT(distance(before, shown()), 0.06);
}

/// The steps of the complaint: this box had equal frames, and its mirror made a spool of the ball.
TEST_F(RefinementHands, TheBoxThatADocumentBeginsWithKeepsItsFormToo) {
  editor().history.mark_saved(editor().history.serial());
  ASSERT_TRUE(bench_.workbench().commands().run("file.new_from_box").ran);
  bench_.wait_for_surfaces();
  ASSERT_EQ(source().frames, Frames::metric);
  const Scene before = shown();
  for (const char* mirror : {"mirror.live_x", "mirror.live_y", "mirror.live_z"}) {
    SCOPED_TRACE(mirror);
    ASSERT_TRUE(bench_.workbench().commands().run(mirror).ran);
    EXPECT_LT(distance(before, shown()), 0.02);
    editor().undo();
  }
}

TEST_F(RefinementHands, SubdividingKeepsTheForm) {
  const Scene before = shown();
  press({"3", "Ctrl+A"});
  ASSERT_TRUE(bench_.workbench().commands().run("mesh.subdivide").ran);
  EXPECT_LT(distance(before, shown()), 0.015);
}

TEST_F(RefinementHands, TheKnifeCutsCurvesWhereTheyAreClicked) {
  bench_.wait_for_surfaces();
  editor().view.x_ray = true;  // the far curves are at the edge of sight
  const Index front = edge_near(1, {31, 0, 18}), back = edge_near(1, {-31, 0, 18});
  const Vector2 a = pixel(on_curve(front, 0.25)), b = pixel(on_curve(back, 0.25));
  press({"K"});
  click(a);
  click(b);
  press({"Enter"});
  ASSERT_EQ(editor().history.undo_label(), "Knife") << bench_.workbench().viewport().hint();
  const std::vector<Vector3> made = new_vertices();
  ASSERT_EQ(made.size(), 2U);
  for (const Vector2& clicked : {a, b}) {
    double nearest = 1e300;
    for (const Vector3& place : made) nearest = std::min(nearest, (pixel(place) - clicked).norm());
    EXPECT_LT(nearest, 2);
  }
}

TEST_F(RefinementHands, TheKnifeCrossesTheCurvesOnItsWayWhereItsLineDoes) {
  bench_.wait_for_surfaces();
  editor().view.x_ray = true;
  const Index corner = edge_near(2, {31, -55, 0}), back = edge_near(1, {-31, 0, 18});
  // Aslant, so that the straight edge between is crossed elsewhere than its curve.
  const Vector2 a = pixel(on_curve(corner, 0.5)), b = pixel(on_curve(back, 0.75));
  press({"K"});
  click(a);
  click(b);
  press({"Enter"});
  ASSERT_EQ(editor().history.undo_label(), "Knife") << bench_.workbench().viewport().hint();
  const std::vector<Vector3> made = new_vertices();
  ASSERT_EQ(made.size(), 3U);
  const Vector2 along = (b - a).normalized();
  for (const Vector3& place : made) {
    const Vector2 from = pixel(place) - a;
    EXPECT_LT(std::abs(along.x() * from.y() - along.y() * from.x()), 2) << "beside the line";
  }
}

TEST_F(RefinementHands, MovesSnapToTheMiddlesOfCurvesWhereTheseAreShown) {
  const auto show = [&](bool polyhedron, bool network) {
    DisplaySettings display = editor().active_object()->display;
    display.polyhedron = polyhedron;
    display.network = network;
    editor().commit(set_display(editor().history.current(), editor().selection.active, display), "Show");
    bench_.wait_for_surfaces();
  };
  const Index edge = edge_near(1, {31, 0, 18});
  const VertexId moved = source().polyhedron.vertex_id(0);
  const auto place = [&] {
    const Index v = source().polyhedron.find(moved);
    return Vector3(
        editor().active_object()->transform.apply(source().origin + source().polyhedron.position(v)));
  };
  ASSERT_LT((place() - Vector3(-31, -55, -18)).norm(), 1e-9) << "far from the edge";
  const auto snap_to = [&](const Vector3& target) {
    editor().mode = ElementMode::vertex;
    editor().selection.clear_elements();
    editor().selection.select({editor().selection.active, element_of(moved)}, Selection::How::replace);
    bench_.frame();
    const Vector2 from = pixel(place()), to = pixel(target);
    bench_.move(from.x(), from.y());
    press({"G"});
    bench_.hold(false, true, false);
    bench_.move(to.x() + 3, to.y() - 2);
    press({"Enter"});
    bench_.hold(false, false, false);
    const Vector3 reached = place();
    editor().undo();
    bench_.wait_for_surfaces();
    return reached;
  };
  show(false, true);
  const Vector3 curve = on_curve(edge, 0.5), line = (end(edge, 0) + end(edge, 1)) / 2;
  ASSERT_GT((pixel(curve) - pixel(line)).norm(), 20);
  EXPECT_LT((snap_to(curve) - curve).norm(), 1e-4);
  EXPECT_GT((snap_to(line) - line).norm(), 0.01) << "nobody sees the straight line";
  show(true, false);
  EXPECT_LT((snap_to(line) - line).norm(), 1e-9);
  EXPECT_GT((snap_to(curve) - curve).norm(), 0.01);
  show(true, true);
  EXPECT_LT((snap_to(line) - line).norm(), 1e-9);
  EXPECT_LT((snap_to(curve) - curve).norm(), 1e-4);
}

}  // namespace
}  // namespace hariko::test
