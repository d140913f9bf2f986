// Snapping and working planes by hand: the menu beside a view's title, what is caught, and where tools draw
// and place.

#include <cmath>
#include <numbers>

#include "core/envelope/solid.hpp"
#include "core/gaussmap/outlines/drawn_loop.hpp"
#include "core/modeling/measuring/measured_dimension.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "ui/editor/dimension_view.hpp"

namespace hariko {
namespace {

constexpr double second_cube = 300;     ///< x of its centre
constexpr double turn_of_second = 0.3;  ///< about z, radians

PolygonMesh cube_of_100_mm() {
  PolygonMesh mesh = test::cube();
  for (Vector3& position : mesh.positions) position *= 50;
  return mesh;
}

/// Two cubes with edges of 100 mm, the second one turned, as a cage without its surface.
Document cube_and_cage() {
  const Document first = document_from_mesh(cube_of_100_mm(), "Cube").value();
  Similarity beside;
  beside.translation = {second_cube, 0, 0};
  beside.rotation = Eigen::AngleAxisd(turn_of_second, Vector3::UnitZ());
  const Added added =
      add_object(first, "Cage", PolyhedronSource::from_mesh(cube_of_100_mm()).value(), beside).value();
  DisplaySettings display = added.document.find(added.id)->display;
  display.surface = display.network = false;
  display.polyhedron = true;
  return set_display(added.document, added.id, display).value();
}

/// Hands on a workbench, with places of the world.
class SnappingHands : public test::BenchHands {
 protected:
  explicit SnappingHands(Document document = cube_and_cage()) : BenchHands(std::move(document), {1280, 900}) {
    editor().transform.gizmo = false;  // its handles would lie over vertices
    bench_.wait_for_surfaces();
    frames(6);
  }
  bool catches(const char* name) { return hint().find(name) != std::string::npos; }
  void move_to(const Vector3& world, const Vector2& beside = Vector2::Zero()) {
    BenchHands::move_to(pixel(world) + beside);
  }
  void click(const Vector3& world, const Vector2& beside = Vector2::Zero()) {
    BenchHands::click(pixel(world) + beside);
    frames(2);
  }
  void control(bool held) {
    bench_.hold(false, held, false);
    bench_.frame();
  }
  /// Through the menu beside the title.
  void choose(const std::string& row) {
    if (!marks().contains(row)) bench_.click("view.0.snaps");
    frames(2);
    bench_.click(row);
    frames(2);
    bench_.key("Esc");
    frames(2);
    bench_.move(640, 500);
  }
  const Object& object(std::size_t number) { return *editor().document().objects[number]; }
  Vector3 vertex(std::size_t number, std::uint32_t id) {
    const Polyhedron& cage = *object(number).cage();
    return object(number).transform.apply(object(number).cage_origin() +
                                          cage.position(cage.find(VertexId{id})));
  }
  void select_vertex(std::uint32_t id) {
    editor().mode = ElementMode::vertex;
    editor().selection.select({object(0).id, element_of(VertexId{id})}, Selection::How::replace);
    frames(2);
  }
};

using Snapping = SnappingHands;

TEST_F(Snapping, TheMenuBesideTheTitleHasABoxForEachKind) {
  EXPECT_TRUE(editor().settings.snaps.vertices && editor().settings.snaps.midpoints &&
              editor().settings.snaps.grid);
  choose("snaps.snap.vertices");
  EXPECT_FALSE(editor().settings.snaps.vertices);
  choose("snaps.snap.centres");
  choose("snaps.snap.intersections");
  choose("snaps.snap.perpendicular");
  choose("snaps.snap.tangent");
  choose("snaps.snap.curves");
  choose("snaps.snap.surfaces");
  choose("snaps.snap.always");
  SnapSettings all{false, true, true, true, true, true, true, true, true, true};
  EXPECT_EQ(editor().settings.snaps, all);
  choose("snaps.snap.vertices");
  choose("snaps.snap.midpoints");
  choose("snaps.snap.grid");
  all = {true, false, true, true, true, true, true, true, false, true};
  EXPECT_EQ(editor().settings.snaps, all);
}

TEST_F(Snapping, AMoveGoesToTheVertexThatItsNameTells) {
  select_vertex(6);
  const Vector3 goal = vertex(1, 4);
  bench_.key("G");
  move_to(goal, {5, -4});
  EXPECT_FALSE(catches("Vertex")) << "without Ctrl nothing is caught: " << hint();
  control(true);
  EXPECT_TRUE(catches("Vertex")) << hint();
  bench_.key("Enter");
  control(false);
  EXPECT_LT((vertex(0, 6) - goal).norm(), 1e-9) << vertex(0, 6).transpose();
  bench_.key("Ctrl+Z");
  // Switched off, the grid is what is left.
  choose("snaps.snap.vertices");
  bench_.key("G");
  control(true);
  move_to(goal, {5, -4});
  EXPECT_FALSE(catches("Vertex")) << hint();
  EXPECT_TRUE(catches("Grid")) << hint();
  choose("snaps.snap.grid");
  move_to(goal, {6, -4});
  EXPECT_FALSE(catches("Grid")) << hint();
  bench_.key("Esc");
  control(false);
}

TEST_F(Snapping, F9SnapsWithoutCtrlWhichThenLetsGo) {
  select_vertex(6);
  bench_.key("G");
  bench_.key("F9");
  EXPECT_TRUE(editor().settings.snaps.always) << "also in the middle of a tool";
  move_to(vertex(1, 4), {5, -4});
  EXPECT_TRUE(catches("Vertex")) << hint();
  control(true);
  EXPECT_FALSE(catches("Vertex")) << hint();
  control(false);
  bench_.key("Enter");
  EXPECT_LT((vertex(0, 6) - vertex(1, 4)).norm(), 1e-9);
}

TEST_F(Snapping, CentresOfFacesAndPointsOfCurvesAreCaughtWhereTheyAreAskedFor) {
  editor().settings.snaps = {false, false, true, false, false, false, true, false, false, false};
  select_vertex(6);
  bench_.key("G");
  control(true);
  const Vector3 centre(second_cube, 0, 50);  // centre of the top
  move_to(centre, {6, 5});
  EXPECT_TRUE(catches("Centre")) << hint();
  bench_.key("Enter");
  EXPECT_LT((vertex(0, 6) - centre).norm(), 1e-9);
  bench_.key("Ctrl+Z");
  editor().settings.snaps.centres = false;
  bench_.key("G");
  const Vector3 quarter = vertex(1, 4) + 0.25 * (vertex(1, 5) - vertex(1, 4));
  move_to(quarter, {1, 6});
  EXPECT_TRUE(catches("On a curve")) << hint();
  bench_.key("Enter");
  control(false);
  const Vector3 way = (vertex(1, 5) - vertex(1, 4)).normalized(), from = vertex(0, 6) - vertex(1, 4);
  EXPECT_LT(from.cross(way).norm(), 1e-3) << "on the edge";
  EXPECT_NEAR(from.dot(way), 25, 8);
}

TEST_F(Snapping, WhatMovesIsNotCaught) {
  select_vertex(6);
  bench_.key("G");
  control(true);
  move_to(vertex(0, 6), {4, 3});
  EXPECT_FALSE(catches("Vertex")) << hint();
  bench_.key("Esc");
  control(false);
}

TEST_F(Snapping, ADistanceEndsAtRightAnglesOnAnEdge) {
  choose("snaps.snap.perpendicular");
  const Vector3 from = vertex(0, 5), a = vertex(1, 4), along = (vertex(1, 7) - a).normalized();
  const Vector3 foot = a + along.dot(from - a) * along;
  ASSERT_GT((foot - a).norm(), 20) << "neither an end of the edge";
  ASSERT_GT((foot - (a + vertex(1, 7)) / 2).norm(), 20) << "nor its middle";
  bench_.key("D");
  click(from);
  control(true);
  move_to(foot, {2, 3});
  EXPECT_TRUE(catches("Perpendicular")) << hint();
  click(foot, {2, 3});
  control(false);
  bench_.key("Esc");
  frames(2);
  ASSERT_EQ(editor().dimensions.all().size(), 1U) << hint();
  ASSERT_TRUE(editor().dimensions.all()[0].measured);
  EXPECT_NEAR(editor().dimensions.all()[0].measured->value, (foot - from).norm(), 1e-9);
}

TEST_F(Snapping, AFaceBecomesTheWorkingPlaneOnWhichSolidsStandAndObjectsLie) {
  editor().mode = ElementMode::face;
  const Vector3 normal(std::cos(turn_of_second), std::sin(turn_of_second), 0);
  const Vector3 centre = Vector3(second_cube, 0, 0) + 50 * normal;
  const FaceId right{3};  // towards positive x of its object
  editor().selection.select({object(1).id, element_of(right)}, Selection::How::replace);
  frames(2);
  choose("snaps.plane.face");
  ASSERT_EQ(editor().working_plane.kind, WorkingPlane::Kind::face);
  const PlaneFrame plane = editor().working_plane.frame;
  EXPECT_LT((plane.normal() - normal).norm(), 1e-12);
  EXPECT_LT((plane.point - centre).norm(), 1e-9);
  EXPECT_TRUE(bench_.workbench().viewport().scene().scene().grid.plane) << "its grid is drawn";
  // A solid stands on it.
  run("solid.place_box");
  const Vector3 place = plane.at({40, 20, 0});
  click(place);
  ASSERT_EQ(editor().document().objects.size(), 3U) << hint();
  const Object& made = object(2);
  const Solid& solid = made.solids()->input->solids.front();
  const Vector3 at = plane.local(made.transform.apply(solid.position));
  EXPECT_NEAR(at.x(), 40, 1);
  EXPECT_NEAR(at.y(), 20, 1);
  EXPECT_GT(at.z(), 1) << "its middle is above the plane";
  EXPECT_LT((made.transform.rotation * (solid_rotation(solid.rotation) * Vector3::UnitZ()) - normal).norm(),
            1e-9);
  bench_.key("Ctrl+Z");
  // A new object lies along its axes.
  run("add.plane");
  const Similarity there = editor().active_object()->transform;
  EXPECT_LT((there.rotation * Vector3::UnitZ() - normal).norm(), 1e-12);
  EXPECT_NEAR(plane.local(there.translation).z(), 0, 1e-9);
  bench_.key("Ctrl+Z");
  choose("snaps.plane.ground");
  EXPECT_TRUE(editor().working_plane.is_ground());
  EXPECT_FALSE(bench_.workbench().viewport().scene().scene().grid.plane);
}

TEST_F(Snapping, ThreeClickedPointsSpanAPlaneInTheirOrder) {
  const Vector3 zero = vertex(0, 5), on_x = vertex(0, 4), aside = vertex(0, 6);
  editor().mode = ElementMode::vertex;
  editor().selection.clear_elements();
  EXPECT_FALSE(bench_.workbench().commands().run("plane.points").ran);
  click(zero);
  bench_.hold(true, false, false);
  click(on_x);
  click(aside);
  bench_.hold(false, false, false);
  frames(2);
  ASSERT_EQ(editor().selection.of(object(0).id).vertices.size(), 3U);
  choose("snaps.plane.points");
  ASSERT_EQ(editor().working_plane.kind, WorkingPlane::Kind::points);
  const PlaneFrame& plane = editor().working_plane.frame;
  EXPECT_LT((plane.point - zero).norm(), 1e-9);
  EXPECT_LT((plane.axes.col(0) - (on_x - zero).normalized()).norm(), 1e-12);
  EXPECT_GT(plane.local(aside).y(), 0);
  // Looking at it brings the normal towards the eye.
  run("plane.look");
  frames(20);
  EXPECT_LT((editor().camera().forward() + plane.normal()).norm(), 1e-9);
}

TEST_F(Snapping, TheViewsOwnPlaneFacesTheViewer) {
  editor().selection.clear_elements();
  frames(2);
  choose("snaps.plane.view");
  const PlaneFrame& plane = editor().working_plane.frame;
  EXPECT_LT((plane.normal() + editor().camera().forward()).norm(), 1e-12);
  EXPECT_LT((plane.point - editor().camera().target).norm(), 1e-9);
  // Another document begins on the ground.
  editor().open({}, {});
  EXPECT_TRUE(editor().working_plane.is_ground());
}

TEST_F(Snapping, ASectionGivesItsPlane) {
  run("add.skin");
  bench_.wait_for_surfaces();
  EXPECT_FALSE(bench_.workbench().commands().run("plane.section").ran) << "no point is selected";
  const Object& skin = *editor().active_object();
  const SkinSection& section = skin.skin()->skin->sections.back();
  ElementSelection points;
  for (const SectionPoint& point : section.points) points.vertices.insert(VertexId{point.id});
  editor().mode = ElementMode::vertex;
  editor().selection.set(skin.id, points);
  frames(2);
  choose("snaps.plane.section");
  ASSERT_EQ(editor().working_plane.kind, WorkingPlane::Kind::section);
  const auto height = [&](const SectionPoint& point) {
    return editor().working_plane.frame.local(skin.transform.apply(point.position)).z();
  };
  for (const SectionPoint& point : section.points)
    EXPECT_NEAR(height(point), height(section.points.front()), 1e-6);
}

TEST_F(Snapping, TheMiddleOfAnOpenPathIsHalfWayAlongIt) {
  run("add.skin");
  bench_.wait_for_surfaces();
  frames(20);  // the flight of the view
  editor().settings.snaps.vertices = false;
  const Object& skin = *editor().active_object();
  const SubdivisionCurve& path = skin.skin()->skin->path;
  ASSERT_FALSE(path.closed);
  constexpr int steps = 4000;
  double way = 0, share = 0;
  for (Vector3 last = evaluate(path, 0).position; share < 1 && way < length(path) / 2; share += 1.0 / steps) {
    const Vector3 next = evaluate(path, share + 1.0 / steps).position;
    way += (next - last).norm();
    last = next;
  }
  const Vector3 middle = skin.transform.apply(evaluate(path, share).position);
  run("solid.place_sphere");
  control(true);
  move_to(middle, {5, 4});
  EXPECT_TRUE(catches("Midpoint")) << hint();
  editor().settings.snaps.midpoints = false;
  move_to(middle, {6, 4});
  EXPECT_FALSE(catches("Midpoint")) << hint();
  bench_.key("Esc");
  control(false);
}

/// An outline on the ground, a circle of 60 mm, and a point beside it.
Document circle_outline() {
  std::vector<Vector3> corners;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * std::numbers::pi * i / 16;
    corners.emplace_back(60 * std::cos(angle), 60 * std::sin(angle), 0);
  }
  OutlineSource source;
  source.outline = Outline{{drawn_loop(corners, {}).value()}};
  return add_object(Document(), "Outline", std::move(source)).value().document;
}

class SnappingOnACircle : public SnappingHands {
 protected:
  SnappingOnACircle() : SnappingHands(circle_outline()) { stand_back(); }
  /// So that places beside the circle are seen, too.
  void stand_back() {
    Camera camera = editor().camera();
    camera.distance *= 2;
    editor().set_camera(camera);
    frames(2);
  }
  Vector3 anchor(std::size_t number) {
    return *anchor_place(editor().document(), editor().document().dimensions->at(0).anchors[number],
                         ready_surfaces(editor()));
  }
};

TEST_F(SnappingOnACircle, ADistanceTouchesIt) {
  run("view.top");
  frames(20);
  editor().settings.snaps = {false, false, false, false, false, true, false, false, false, false};
  const Vector3 from(90, 20, 0);
  bench_.key("D");
  click(from);
  control(true);
  // The angle at the centre has the cosine of radius over distance.
  const double at = std::atan2(from.y(), from.x()) + std::acos(60 / from.norm());
  const Vector3 touched(60 * std::cos(at), 60 * std::sin(at), 0);
  move_to(touched, {4, 3});
  EXPECT_TRUE(catches("Tangent")) << hint();
  click(touched, {4, 3});
  control(false);
  bench_.key("Esc");
  ASSERT_EQ(editor().document().dimensions->size(), 1U) << hint();
  const Vector3 place = anchor(1), begun = anchor(0);
  EXPECT_NEAR(place.norm(), 60, 0.3);
  EXPECT_NEAR(place.dot(place - begun) / (place.norm() * (place - begun).norm()), 0, 0.02);
}

TEST_F(SnappingOnACircle, ItsCentreIsCaught) {
  editor().settings.snaps = {false, false, true, false, false, false, false, false, true, false};
  run("solid.place_sphere");
  control(true);
  move_to({0, 0, 0}, {5, 4});
  EXPECT_TRUE(catches("Centre")) << hint();
  move_to({30, 0, 0});
  EXPECT_FALSE(catches("Centre")) << hint();
  bench_.key("Esc");
  control(false);
}

TEST_F(SnappingOnACircle, ASkinsPathIsDrawnInTheWorkingPlane) {
  const PlaneFrame plane = upright_plane({10, 20, 30}, Vector3(1, -2, 2).normalized());
  editor().working_plane = {WorkingPlane::Kind::face, plane};
  run("skin.draw");
  for (const Vector2& at : {Vector2(-60, -20), Vector2(0, 20), Vector2(60, -20)})
    click(plane.at({at.x(), at.y(), 0}));
  const auto press = [&](std::initializer_list<const char*> keys) {
    for (const char* key : keys) bench_.key(key);
    frames(20);  // and the flight of the view
  };
  press({"Enter"});
  press({"O", "2", "0", "Enter"});
  press({"Enter"});
  press({"O", "1", "0", "Enter"});
  press({"Enter"});
  ASSERT_TRUE(editor().active_object() && editor().active_object()->skin()) << hint();
  const SubdivisionCurve& path = editor().active_object()->skin()->skin->path;
  ASSERT_EQ(path.size(), 3);
  for (const Vector3& point : limit_points(path)) EXPECT_NEAR(plane.local(point).z(), 0, 1e-9);
  EXPECT_LT((limit_points(path)[1] - plane.at({0, 20, 0})).norm(), 3);
}

}  // namespace
}  // namespace hariko
