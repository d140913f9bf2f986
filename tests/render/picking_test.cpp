#include "render/picking.hpp"

#include <chrono>

#include "render/region_picking.hpp"
#include "render/surface_maps.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace hariko::test;

constexpr PixelSize picking_size{800, 600};

/// columns x rows unit squares in the plane z = 0, from (0, 0).
Polyhedron grid(Index columns, Index rows) {
  PolygonMesh mesh;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) mesh.positions.push_back({double(i), double(j), 0});
  const auto at = [&](Index i, Index j) { return j * (columns + 1) + i; };
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i)
      mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return Polyhedron::build(mesh).value();
}

Polyhedron cube() {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  mesh.add_face({0, 2, 3, 1});
  mesh.add_face({4, 5, 7, 6});
  mesh.add_face({0, 1, 5, 4});
  mesh.add_face({2, 6, 7, 3});
  mesh.add_face({0, 4, 6, 2});
  mesh.add_face({1, 3, 7, 5});
  return Polyhedron::build(mesh).value();
}

Scene scene_with(const Polyhedron& polyhedron) {
  Scene scene;
  SceneObject object;
  object.polyhedron = DisplayPolyhedron::build(polyhedron, {}, Vector3::Zero());
  object.show_polyhedron = true;
  scene.objects.push_back(std::move(object));
  return scene;
}

Projector view_of(const Scene& scene, StandardView view, bool orthographic = false) {
  Camera camera = Camera::standard(view);
  camera.orthographic = orthographic;
  return {framed(camera, scene, picking_size), picking_size};
}

TEST(Picking, VerticesBeforeEdgesBeforeFaces) {
  const Scene scene = scene_with(grid(3, 3));
  for (const bool orthographic : {false, true}) {
    const Projector projector = view_of(scene, StandardView::top, orthographic);
    const Vector2 vertex = projector.project({1, 1, 0})->head<2>();
    const auto at_vertex = pick(scene, projector, vertex + Vector2(5, 3));
    ASSERT_TRUE(at_vertex);
    EXPECT_EQ(at_vertex->kind, Element::Kind::vertex);
    EXPECT_EQ(at_vertex->index, 5U);
    EXPECT_EQ(at_vertex->element, element_of(VertexId{5}));
    EXPECT_NEAR(at_vertex->distance, std::hypot(5, 3), 1e-9);
    const Vector2 edge = projector.project({1.5, 1, 0})->head<2>();
    const auto at_edge = pick(scene, projector, edge + Vector2(0, 4));
    ASSERT_TRUE(at_edge);
    EXPECT_EQ(at_edge->kind, Element::Kind::edge);
    EXPECT_EQ(at_edge->element, element_of(EdgeId::of({5}, {6})));
    EXPECT_LT((at_edge->point - Vector3(1.5, 1, 0)).norm(), 1e-6);
    const auto at_face = pick(scene, projector, projector.project({1.5, 1.5, 0})->head<2>());
    ASSERT_TRUE(at_face);
    EXPECT_EQ(at_face->kind, Element::Kind::face);
    EXPECT_EQ(at_face->index, 4U);
    EXPECT_FALSE(pick(scene, projector, {2, 2}));
  }
}

TEST(Picking, RadiiFollowTheScaleOfThePixels) {
  Scene scene = scene_with(grid(3, 3));
  const Projector projector = view_of(scene, StandardView::top);
  const Vector2 vertex = projector.project({1, 1, 0})->head<2>();
  const Vector2 edge = projector.project({1.5, 1, 0})->head<2>();
  const PickOptions options;
  for (const double scale : {1.0, 1.5, 2.0, 3.0}) {
    scene.pixel_scale = scale;
    const auto kind_at = [&](const Vector2& pixel) { return pick(scene, projector, pixel)->kind; };
    const Vector2 aslant = Vector2(1, 1).normalized();
    EXPECT_EQ(kind_at(vertex + 0.97 * options.vertex_radius * scale * aslant), Element::Kind::vertex)
        << scale;
    EXPECT_NE(kind_at(vertex + 1.03 * options.vertex_radius * scale * aslant), Element::Kind::vertex)
        << scale;
    EXPECT_EQ(kind_at(edge + Vector2(0, 0.97 * options.edge_radius * scale)), Element::Kind::edge) << scale;
    EXPECT_EQ(kind_at(edge + Vector2(0, 1.03 * options.edge_radius * scale)), Element::Kind::face) << scale;
  }
}

TEST(Picking, TypesCanBeSwitchedOff) {
  const Scene scene = scene_with(grid(3, 3));
  const Projector projector = view_of(scene, StandardView::top);
  const Vector2 vertex = projector.project({1, 1, 0})->head<2>();
  PickOptions options{.vertices = false};
  EXPECT_EQ(pick(scene, projector, vertex, options)->kind, Element::Kind::edge);
  options.edges = false;
  EXPECT_EQ(pick(scene, projector, vertex, options)->kind, Element::Kind::face);
  options.faces = false;
  EXPECT_FALSE(pick(scene, projector, vertex, options));
}

TEST(Picking, ANetThatDoesNotShowIsNotPicked) {
  Scene scene = scene_with(grid(3, 3));
  const Projector projector = view_of(scene, StandardView::top);
  const Vector2 corner = projector.project(Vector3(1, 1, 0))->head<2>();
  ASSERT_EQ(pick(scene, projector, corner)->kind, Element::Kind::vertex);
  scene.objects[0].elements_pickable = false;
  EXPECT_EQ(pick(scene, projector, corner)->kind, Element::Kind::face);
  PickOptions elements_only;
  elements_only.faces = false;
  EXPECT_FALSE(pick(scene, projector, corner, elements_only));
}

TEST(Picking, OfTwoVerticesBehindEachOtherTheNearWins) {
  const Scene scene = scene_with(cube());
  const Projector projector = view_of(scene, StandardView::front, true);
  const Vector2 corner = projector.project({1, -1, 1})->head<2>();
  const auto hits = pick_all(scene, projector, corner);
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0].point, Vector3(1, -1, 1));
  EXPECT_EQ(hits[1].point, Vector3(1, 1, 1));
}

TEST(Picking, HiddenElementsCanBeLeftOut) {
  const Scene scene = scene_with(cube());
  Projector projector = view_of(scene, StandardView::iso);
  PickOptions options;
  const Vector3 hidden(-1, 1, -1);
  const auto through = pick(scene, projector, projector.project(hidden)->head<2>(), options);
  ASSERT_TRUE(through);
  EXPECT_EQ(through->kind, Element::Kind::vertex);
  options.visible_only = true;
  const auto visible = pick_all(scene, projector, projector.project(hidden)->head<2>(), options);
  for (const PickHit& hit : visible) EXPECT_GT((hit.point - hidden).norm(), 0.1);
  const Vector3 corner(1, -1, 1);
  EXPECT_EQ(pick(scene, projector, projector.project(corner)->head<2>(), options)->point, corner);
}

TEST(Picking, TransformsApply) {
  Scene scene = scene_with(grid(2, 2));
  Similarity similarity;
  similarity.rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized());
  similarity.scale = 2.5;
  similarity.translation = {10, -20, 30};
  scene.objects[0].transform = matrix_of(similarity);
  const Projector projector = view_of(scene, StandardView::iso);
  for (Index v = 0; v < 9; ++v) {
    const Vector3 world = similarity.apply(scene.objects[0].polyhedron->position(v));
    const auto hit = pick(scene, projector, projector.project(world)->head<2>());
    ASSERT_TRUE(hit);
    EXPECT_LT((hit->point - world).norm(), 1e-6);
  }
  const Vector3 inside = similarity.apply({0.5, 1.5, 0});
  const auto hit = pick(scene, projector, projector.project(inside)->head<2>());
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->kind, Element::Kind::face);
  EXPECT_EQ(hit->index, 2U);
  EXPECT_LT((hit->point - inside).norm(), 1e-6);
}

TEST(Picking, EdgesThatPassTheEyeStillCount) {
  const Scene scene = scene_with(grid(3, 3));
  Camera camera = Camera::standard(StandardView::front);
  camera.target = {1.5, 1.5, 0.2};
  camera.distance = 0.4;  // inside the model: some ends lie behind
  camera = camera.orbit(0, 0.3);
  const Projector projector(camera, picking_size);
  const auto on_edge = projector.project({1, 2.5, 0});
  ASSERT_TRUE(on_edge);
  PickOptions options{.vertices = false};
  const auto hit = pick(scene, projector, on_edge->head<2>(), options);
  ASSERT_TRUE(hit);
  EXPECT_LT((hit->point - Vector3(1, 2.5, 0)).norm(), 1e-6);
}

TEST(Picking, SurfaceHitsAreOnTheSurface) {
  Scene scene;
  SceneObject object;
  object.mesh = DisplayMesh::build(sphere(2), map_options(SurfaceMap::gaussian, 16));
  Similarity similarity{.scale = 3, .translation = {100, 0, 0}};
  object.transform = matrix_of(similarity);
  scene.objects.push_back(object);
  for_random(11, 50, [&](std::mt19937_64& rng) {
    const Vector3 eye = Vector3(100, 0, 0) + 40 * random_vector(rng).normalized();
    const Vector3 aim = Vector3(100, 0, 0) + 3 * random_vector(rng).normalized();
    const auto hit = pick_surface(scene, {eye, (aim - eye).normalized()});
    ASSERT_TRUE(hit);
    EXPECT_NEAR((hit->point - Vector3(100, 0, 0)).norm(), 6, 0.03);
    EXPECT_LT(hit->t, 40);
    const Vector3 exact = 3 * sphere(2).patches().evaluate(hit->patch, hit->parameter, Order::first).position;
    EXPECT_LT((exact + Vector3(100, 0, 0) - hit->point).norm(), 0.1);
  });
  EXPECT_FALSE(pick_surface(scene, {Vector3(0, 0, 50), Vector3::UnitZ()}));
}

TEST(Picking, WhatTheSectionCutsAwayIsNotThere) {
  Scene scene = scene_with(grid(3, 3));
  const Projector projector = view_of(scene, StandardView::top);
  const auto at = [&](double x, double y) { return Vector2(projector.project({x, y, 0})->head<2>()); };
  scene.section = SectionPlane{Vector3::UnitX(), 1.6};
  EXPECT_TRUE(pick(scene, projector, at(1, 1)));
  EXPECT_FALSE(pick(scene, projector, at(3, 1))) << "a vertex";
  EXPECT_FALSE(pick(scene, projector, at(2.5, 1))) << "an edge";
  EXPECT_FALSE(pick(scene, projector, at(2.5, 1.5))) << "a face";
  PickOptions edges;
  edges.vertices = edges.faces = false;
  EXPECT_TRUE(pick(scene, projector, at(1.3, 1), edges));
  EXPECT_FALSE(pick(scene, projector, at(1.9, 1), edges)) << "the part of an edge behind the plane";

  Scene ball;
  SceneObject object;
  object.mesh = DisplayMesh::build(sphere(2), map_options(SurfaceMap::gaussian, 16));
  ball.objects.push_back(object);
  const Ray down{{0, 0, 9}, -Vector3::UnitZ()};
  EXPECT_NEAR(pick_surface(ball, down)->point.z(), 2, 0.05);
  ball.section = SectionPlane{Vector3::UnitZ(), 0};
  EXPECT_NEAR(pick_surface(ball, down)->point.z(), -2, 0.05) << "through the opening";
}

TEST(Occlusion, TheSectionOpensTheView) {
  Scene scene = scene_with(cube());
  Camera camera = Camera::standard(StandardView::top);
  camera.distance = 20;
  const Box3 box = scene.world_box();
  camera.target = box.center();
  const Vector3 bottom(box.center().x() + 0.1, box.center().y() + 0.07, box.min().z());
  EXPECT_FALSE(Occlusion(scene, Projector(camera, picking_size)).visible(bottom));
  scene.section = SectionPlane{Vector3::UnitZ(), box.center().z()};
  const Occlusion open(scene, Projector(camera, picking_size));
  EXPECT_TRUE(open.visible(bottom));
  EXPECT_FALSE(open.visible(Vector3(bottom.x(), bottom.y(), box.max().z()))) << "cut away itself";
}

TEST(Occlusion, TheSlackIsAsWideOnFineScreens) {
  Scene scene = scene_with(cube());
  Camera camera = Camera::standard(StandardView::top);
  camera.distance = 20;
  const Box3 box = scene.world_box();
  camera.target = box.center();
  const Projector projector(camera, picking_size);
  const Vector3 top(box.center().x() + 0.1, box.center().y() + 0.07, box.max().z());
  const auto below = [&](double pixels) {
    return Vector3(top - pixels * projector.pixel_length_at(top) * Vector3::UnitZ());
  };
  EXPECT_TRUE(Occlusion(scene, projector).visible(below(0.6 * hiding_slack_pixels)));
  EXPECT_FALSE(Occlusion(scene, projector).visible(below(1.5 * hiding_slack_pixels)));
  scene.pixel_scale = 2;
  EXPECT_TRUE(Occlusion(scene, projector).visible(below(1.5 * hiding_slack_pixels)));
  EXPECT_FALSE(Occlusion(scene, projector).visible(below(3 * hiding_slack_pixels)));
}

TEST(Picking, BoxesTakeWhatIsInsideOrTouched) {
  const Scene scene = scene_with(grid(3, 3));
  const Projector projector = view_of(scene, StandardView::top);
  const auto pixel = [&](double x, double y) { return Vector2(projector.project({x, y, 0})->head<2>()); };
  const PixelBox box{pixel(0.5, 0.5), pixel(2.5, 2.5)};
  const Highlights window = pick_box(scene.objects[0], projector, box, false);
  EXPECT_EQ(window.vertices, (std::vector<Index>{5, 6, 9, 10}));
  EXPECT_EQ(window.edges.size(), 4U);
  EXPECT_EQ(window.faces, (std::vector<Index>{4}));
  const Highlights crossing = pick_box(scene.objects[0], projector, box, true);
  EXPECT_EQ(crossing.edges.size(), 12U);
  EXPECT_EQ(crossing.faces.size(), 9U);
}

TEST(Picking, TwentyThousandFacesInAnInstant) {
  const Scene scene = scene_with(grid(200, 100));
  const Projector projector = view_of(scene, StandardView::top);
  const auto begin = std::chrono::steady_clock::now();
  const auto hit = pick(scene, projector, projector.project({100.5, 50.5, 0})->head<2>(), {1, 1});
  const double milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->kind, Element::Kind::face);
  EXPECT_EQ(hit->index, 50U * 200U + 100U);
  RecordProperty("milliseconds", std::to_string(milliseconds));
  EXPECT_LT(milliseconds, 200);  // about 5 on an idle core; the bound only catches a change of order
}

}  // namespace
}  // namespace hariko
