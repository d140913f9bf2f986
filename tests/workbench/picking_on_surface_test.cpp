// Picking on the surface: curves stand for edges, patches for faces, outlines for objects.

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "render/scene.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko {
namespace {

class PickingOnSurface : public ::testing::Test {
 protected:
  explicit PickingOnSurface(Document document = document_from_mesh(test::prism(6), "Prism").value())
      : bench(std::move(document), {1100, 760}) {
    Camera camera = Camera::standard(StandardView::iso);
    camera.distance = 8;
    editor.set_camera(camera);
    editor.mode = ElementMode::edge;
    bench.wait_for_surfaces();
  }
  const SceneObject& shown() const { return bench.workbench().viewport().scene().scene().objects[0]; }
  Projector projector() const { return {editor.camera(), editor.viewport}; }
  Vector2 window_pixel(const Vector3& world) const {
    const ImVec2 corner = bench.workbench().viewport().rect().min;
    return projector().project(world)->head<2>() + Vector2(double(corner.x), double(corner.y));
  }
  void click(const Vector2& at, int times = 1) {
    bench.move(at.x(), at.y());
    for (int i = 0; i < times; ++i) {
      bench.press();
      bench.release();
    }
  }
  void set_shown(bool polyhedron, bool network) {
    DisplaySettings display = editor.active_object()->display;
    display.polyhedron = polyhedron;
    display.network = network;
    editor.commit(set_display(editor.history.current(), editor.selection.active, display), "Show");
    bench.frame();
  }
  Vector3 middle_of_line(Index e) const {
    const auto& [a, b] = shown().polyhedron->edges[e];
    return 0.5 * (shown().to_world(shown().polyhedron->origin, shown().polyhedron->positions[a]) +
                  shown().to_world(shown().polyhedron->origin, shown().polyhedron->positions[b]));
  }
  Vector3 middle_of_curve(Index e) const {
    const auto segments = shown().edge_curves->segments(shown().edge_curves->of(e)[0]);
    return shown().mesh_vertex(segments[segments.size() / 2].vertices[1]);
  }
  bool in_sight(const Vector3& point) const {
    const auto hit = pick_surface(bench.workbench().viewport().scene().scene(),
                                  projector().ray(projector().project(point)->head<2>()));
    return hit && (hit->point - point).norm() < 0.02;
  }
  /// An edge whose curve is in sight and far from its straight line on the screen, whose middle lies under
  /// the surface and beside all other curves.
  Index arched_edge() const {
    Index best = no_index;
    double most = 12;
    for (Index e = 0; e < shown().polyhedron->edges.size(); ++e) {
      const double apart = (window_pixel(middle_of_curve(e)) - window_pixel(middle_of_line(e))).norm();
      if (!in_sight(middle_of_curve(e)) || apart < most || nearest_curve(middle_of_line(e)) < 10) continue;
      most = apart;
      best = e;
    }
    return best;
  }
  double nearest_curve(const Vector3& point) const {
    double least = 1e9;
    for (Index e = 0; e < shown().polyhedron->edges.size(); ++e)
      for (const EdgeCurves::Run& run : shown().edge_curves->of(e))
        for (const CurveSegment& s : shown().edge_curves->segments(run))
          least = std::min(least,
                           (window_pixel(shown().mesh_vertex(s.vertices[2])) - window_pixel(point)).norm());
    return least;
  }
  /// Pixels of the picture that are like a colour.
  int count_like(const char* hex, double tolerance = 40) {
    const Image image = bench.renderer().read(0);
    const Color c = color_from_hex(hex);
    int out = 0;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
      const Vector3 pixel(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]);
      out += (pixel - 255 * Vector3(double(c.r), double(c.g), double(c.b))).norm() < tolerance ? 1 : 0;
    }
    return out;
  }
  static constexpr const char* selection_colour = "#ffa51f";

  mutable test::HeadlessWorkbench bench;
  Editor& editor = bench.editor();
};

TEST_F(PickingOnSurface, TheCurveIsTheEdge) {
  const Index e = arched_edge();
  ASSERT_NE(e, no_index);
  const EdgeId id = shown().polyhedron->edge_id(e);
  const Vector2 curve = window_pixel(middle_of_curve(e)), line = window_pixel(middle_of_line(e));
  bench.move(curve.x(), curve.y());
  ASSERT_TRUE(editor.hovered) << "the curve lights up";
  EXPECT_EQ(editor.hovered->element, element_of(id));
  click(curve);
  EXPECT_EQ(editor.selection.of_active().edges, std::set<EdgeId>{id});
  bench.move(line.x(), line.y());
  EXPECT_FALSE(editor.hovered) << "nobody sees the straight line inside of the surface";
  click(line);
  EXPECT_TRUE(editor.selection.no_elements());
  // Lines are the edges if the polyhedron alone is shown.
  set_shown(true, false);
  DisplaySettings display = editor.active_object()->display;
  display.surface = false;
  editor.commit(set_display(editor.history.current(), editor.selection.active, display), "Hide surface");
  editor.selecting.through = true;  // faces of the polyhedron may lie before it
  bench.frame();
  click(line);
  EXPECT_TRUE(editor.selection.of_active().edges.contains(id));
}

TEST_F(PickingOnSurface, DoubleClicksAndBoxesActOnCurves) {
  const Index e = arched_edge();
  ASSERT_NE(e, no_index);
  const EdgeId id = shown().polyhedron->edge_id(e);
  const Vector2 curve = window_pixel(middle_of_curve(e));
  click(curve, 2);
  EXPECT_TRUE(editor.selection.of_active().edges.contains(id));
  const std::size_t loop = editor.selection.of_active().edges.size();
  EXPECT_GE(loop, 1U);
  editor.selection.clear_elements();
  // From right to left: what the small box touches, which the straight line does not come near.
  bench.workbench().commands().run("select.box");
  bench.frame();
  bench.move(curve.x() + 4, curve.y() + 4);
  bench.press();
  bench.move(curve.x() - 4, curve.y() - 4);
  bench.release();
  EXPECT_EQ(editor.selection.of_active().edges, std::set<EdgeId>{id});
}

/// A lasso takes what lies inside of it: the curve that one sees, not the straight line below.
TEST_F(PickingOnSurface, ALassoTakesTheCurvesInsideOfIt) {
  const Index e = arched_edge();
  ASSERT_NE(e, no_index);
  const EdgeId id = shown().polyhedron->edge_id(e);
  const std::vector<Vector3> curve = shown_curve(shown(), e);
  ASSERT_GE(curve.size(), 3U);
  set_shown(false, true);
  editor.selecting.through = true;  // the ends may be hidden
  bench.key("Q");
  ASSERT_TRUE(editor.selecting.lasso);
  const auto chosen_by_lasso_round = [&](const std::vector<Vector3>& line) {
    editor.selection.clear_elements();
    std::vector<Vector2> path;
    constexpr double wide = 6;
    for (const int side : {1, -1})
      for (std::size_t k = 0; k < line.size(); ++k) {
        const std::size_t i = side > 0 ? k : line.size() - 1 - k;
        const Vector2 along =
            (window_pixel(line[std::min(i + 1, line.size() - 1)]) - window_pixel(line[i > 0 ? i - 1 : 0]))
                .normalized();
        const double cap = i == 0 ? -wide : i + 1 == line.size() ? wide : 0;
        path.push_back(window_pixel(line[i]) + cap * along + side * wide * Vector2(-along.y(), along.x()));
      }
    bench.workbench().commands().run("select.box");
    bench.frame();
    bench.move(path.front().x(), path.front().y());
    bench.press();
    for (const Vector2& at : path) bench.move(at.x(), at.y());
    bench.release();
    bench.frame();
    return editor.selection.of_active().edges;
  };
  EXPECT_EQ(chosen_by_lasso_round(curve), std::set<EdgeId>{id});
  EXPECT_TRUE(chosen_by_lasso_round({curve.front(), curve.back()}).empty())
      << "round the straight line, which nobody sees";
}

TEST_F(PickingOnSurface, PartsOfSelectedCurvesBehindTheSurfaceAreFaint) {
  set_shown(false, true);
  Index hidden = no_index;
  for (Index e = 0; e < shown().polyhedron->edges.size() && hidden == no_index; ++e) {
    const std::vector<Vector3> curve = shown_curve(shown(), e);
    const bool behind =
        std::none_of(curve.begin(), curve.end(), [&](const Vector3& point) { return in_sight(point); });
    if (!curve.empty() && behind) hidden = e;
  }
  ASSERT_NE(hidden, no_index) << "all curves are in sight";
  bench.move(2, 2);
  bench.frame();
  const Image before = bench.renderer().read(0);
  const int bright = count_like(selection_colour);
  editor.selection.select({editor.selection.active, element_of(shown().polyhedron->edge_id(hidden))},
                          Selection::How::replace);
  editor.transform.gizmo = false;  // stands at its middle
  bench.frame();
  bench.frame();
  const Image after = bench.renderer().read(0);
  ASSERT_EQ(after.rgba.size(), before.rgba.size());
  int changed = 0;
  for (std::size_t i = 0; i < after.rgba.size(); i += 4) changed += after.rgba[i] != before.rgba[i] ? 1 : 0;
  EXPECT_GT(changed, 100) << "it is not seen at all";
  EXPECT_LT(count_like(selection_colour), bright + changed / 10) << "as if it lay before the surface";
}

TEST_F(PickingOnSurface, SelectedEdgesShowOverTheSurface) {
  set_shown(false, true);
  bench.frame();
  const int before = count_like(selection_colour);
  bench.workbench().commands().run("select.all");
  bench.frame();
  bench.frame();
  // The curves in sight alone are some thousand pixels long, and lines four pixels wide.
  EXPECT_GT(count_like(selection_colour), before + 3000);
}

TEST_F(PickingOnSurface, ASelectedCreaseIsNoLongerRed) {
  const Index e = arched_edge();
  ASSERT_NE(e, no_index);
  const EdgeId id = shown().polyhedron->edge_id(e);
  set_shown(false, true);
  editor.transform.gizmo = false;
  editor.commit(set_crease(editor.history.current(), editor.selection.active, std::vector{id}, true),
                "Crease");
  bench.wait_for_surfaces();
  bench.move(2, 2);
  bench.frame();
  constexpr const char* crease_colour = "#c2185b";
  const int red = count_like(crease_colour, 60), orange = count_like(selection_colour);
  ASSERT_GT(red, 30) << "the crease is not seen";
  editor.selection.select({editor.selection.active, element_of(id)}, Selection::How::replace);
  bench.frame();
  bench.frame();
  EXPECT_LT(count_like(crease_colour, 60), red / 2);
  EXPECT_GT(count_like(selection_colour) - orange, red / 2) << "as much as the crease was";
}

TEST_F(PickingOnSurface, FacesAreTintedOnTheSurfaceAlone) {
  editor.mode = ElementMode::face;
  bench.frame();
  const Vector2 middle = window_pixel({0, 0, 0});
  bench.move(middle.x(), middle.y());
  ASSERT_TRUE(editor.hovered);
  EXPECT_EQ(editor.hovered->element.kind, Element::Kind::face);
  EXPECT_FALSE(shown().hovered_patches.empty()) << "the patches of the face";
  click(middle);
  EXPECT_EQ(editor.selection.of_active().faces.size(), 1U);
  EXPECT_FALSE(shown().selected_patches.empty());
  // A box round a part of the face's patch that no straight edge comes near.
  editor.selection.clear_elements();
  bench.workbench().commands().run("select.box");
  bench.frame();
  bench.move(middle.x() + 5, middle.y() + 5);
  bench.press();
  bench.move(middle.x() - 5, middle.y() - 5);
  bench.release();
  EXPECT_EQ(editor.selection.of_active().faces.size(), 1U);
}

TEST_F(PickingOnSurface, ChosenObjectsHaveAnOutlineWithoutAnyLines) {
  set_shown(false, false);
  editor.mode = ElementMode::object;
  bench.frame();
  bench.move(2, 2);
  bench.frame();
  const int before = count_like(selection_colour);
  bench.workbench().commands().run("select.all");
  bench.frame();
  bench.frame();
  EXPECT_TRUE(shown().outlined);
  EXPECT_GT(count_like(selection_colour), before + 800) << "round the whole object";
  // It runs round the silhouette: the middle of the object stays as it was.
  EXPECT_TRUE(shown().selected.empty());
}

TEST_F(PickingOnSurface, SurfacesOnlyHidesAllLinesAndTakesNone) {
  editor.mode = ElementMode::vertex;
  bench.workbench().commands().run("select.all");
  bench.frame();
  bench.key("V");
  bench.frame();
  EXPECT_TRUE(editor.view.surfaces_only);
  EXPECT_FALSE(editor.history.dirty()) << "a way of looking";
  EXPECT_FALSE(shown().show_polyhedron || shown().show_network);
  EXPECT_TRUE(shown().selected.empty());
  EXPECT_LT(count_like(selection_colour), 50);
  EXPECT_NE(bench.workbench().status().find("Surfaces only"), std::string::npos);
  const auto chosen = editor.selection.of_active();
  const Vector2 corner =
      window_pixel(shown().to_world(shown().polyhedron->origin, shown().polyhedron->positions.back()));
  bench.move(corner.x(), corner.y());
  EXPECT_FALSE(editor.hovered);
  bench.key("V");
  bench.frame();
  EXPECT_EQ(editor.selection.of_active(), chosen);
  EXPECT_GT(count_like(selection_colour), 100);
}

}  // namespace
}  // namespace hariko
