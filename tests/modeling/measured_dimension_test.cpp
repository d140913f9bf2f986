// Values of dimensions: right on known shapes at any size and place, and they follow what they measure.

#include "core/modeling/measuring/measured_dimension.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/document/edits/edits.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/modeling/measuring/surface_curves.hpp"
#include "core/modeling/measuring/surface_spot.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

constexpr ObjectId first_object{1};

Document cube_to_measure() {
  return document_from_mesh(test::cube(), "Cube").value();
}

Anchor vertex(std::uint32_t id) {
  return VertexAnchor{first_object, VertexId{id}};
}

SurfaceOf no_surfaces() {
  return [](ObjectId) -> const Surface* { return nullptr; };
}
SurfaceOf only(const Surface& surface) {
  return [&surface](ObjectId id) { return id == first_object ? &surface : nullptr; };
}
Surface final_surface(const Document& document) {
  return object_surface(document, *document.find(first_object)).value().surface;
}

double value_of(const Document& document, DimensionKind kind, std::vector<Anchor> anchors,
                const SurfaceOf& surfaces = no_surfaces()) {
  const auto found = measured(document, {{1}, kind, std::move(anchors), Vector3::Zero()}, surfaces);
  EXPECT_TRUE(found);
  return found ? found->value : std::numeric_limits<double>::quiet_NaN();
}

TEST(MeasuredDimension, DistancesAndAnglesOfACube) {
  const Document document = cube_to_measure();
  using enum DimensionKind;
  EXPECT_EQ(value_of(document, distance, {vertex(0), vertex(1)}), 2);
  EXPECT_DOUBLE_EQ(value_of(document, distance, {vertex(0), vertex(6)}), std::sqrt(12));
  EXPECT_EQ(value_of(document, distance, {vertex(0), vertex(0)}), 0);
  EXPECT_DOUBLE_EQ(value_of(document, angle, {vertex(1), vertex(0), vertex(3)}), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(value_of(document, angle, {vertex(1), vertex(0), vertex(2)}), std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(value_of(document, angle, {vertex(1), vertex(0), SpaceAnchor{{-3, -1, -1}}}),
                   std::numbers::pi);
  EXPECT_DOUBLE_EQ(value_of(document, distance, {vertex(6), SpaceAnchor{{1, 1, 4}}}), 3);
  EXPECT_FALSE(
      measured(document, {{1}, angle, {vertex(0), vertex(0), vertex(2)}, Vector3::Zero()}, no_surfaces()))
      << "an arm without a length";
}

TEST(MeasuredDimension, FollowsVerticesAndPlacement) {
  const Document document = cube_to_measure();
  const std::vector<Anchor> edge{vertex(0), vertex(1)};
  const std::vector<VertexId> moved{VertexId{1}};
  const std::vector<Vector3> to{{4, -1, -1}};
  const Document longer = move_vertices(document, first_object, moved, to).value();
  EXPECT_EQ(value_of(longer, DimensionKind::distance, edge), 5);
  Similarity place{.scale = 3};
  place.rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized());
  place.translation = {10, 20, -5};
  const Document placed = set_transform(longer, first_object, place).value();
  EXPECT_NEAR(value_of(placed, DimensionKind::distance, edge), 15, 1e-13);
  const Anchor held = ObjectAnchor{first_object, {1, 0, 0}, {}};
  EXPECT_TRUE(anchor_place(placed, held, no_surfaces())->isApprox(place.apply(Vector3(1, 0, 0)), 1e-14));
  EXPECT_EQ(*anchor_place(placed, SpaceAnchor{{1, 0, 0}}, no_surfaces()), Vector3(1, 0, 0));
}

TEST(MeasuredDimension, IsLostWithItsVertex) {
  Document document = cube_to_measure();
  document = add_dimension(document, DimensionKind::distance, {vertex(0), vertex(6)})->document;
  document = add_dimension(document, DimensionKind::distance, {vertex(0), vertex(1)})->document;
  const std::vector<VertexId> gone{VertexId{6}};
  const Document open = edit_polyhedron(document, first_object, [&](const PolyhedronSource& source) {
                          return delete_vertices(source, gone);
                        })->document;
  EXPECT_FALSE(measured(open, (*open.dimensions)[0], no_surfaces()));
  EXPECT_TRUE(measured(open, (*open.dimensions)[1], no_surfaces()));
  EXPECT_EQ(lost_dimensions(open), (std::vector<DimensionId>{{1}}));
}

TEST(MeasuredDimension, PointsOfEdgesLieOnTheirCurves) {
  const Document document = cube_to_measure();
  const Surface surface = final_surface(document);
  const EdgeId edge = EdgeId::of({0}, {1});
  const auto at = [&](double share, bool straight) {
    return *anchor_place(document, EdgeAnchor{first_object, edge, share, straight}, only(surface));
  };
  EXPECT_TRUE(at(0, false).isApprox(Vector3(-1, -1, -1), 1e-12));
  EXPECT_TRUE(at(1, false).isApprox(Vector3(1, -1, -1), 1e-12));
  EXPECT_EQ(at(0.25, true), Vector3(-0.5, -1, -1));
  const Vector3 middle = at(0.5, false);
  EXPECT_NEAR(middle.x(), 0, 1e-12) << "the cube is symmetric";
  EXPECT_NEAR(middle.y(), middle.z(), 1e-12);
  EXPECT_LT(middle.y(), -1.05) << "the curve bulges outwards";
  EXPECT_LT(at(0.25, false).x(), 0) << "shares run from the vertex with the smaller id";
  EXPECT_FALSE(anchor_place(document, EdgeAnchor{first_object, edge, 0.5, false}, no_surfaces()))
      << "no surface yet";
  const auto curves = curves_over(surface, edge);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_GT(curve_length(surface, curves[0]), 2 + 1e-3);
}

TEST(MeasuredDimension, RadiiOfASphereAtAnySize) {
  for (const double radius : {1e-3, 2.5, 1e6}) {
    const Surface sphere = test::sphere(radius);
    Document document = cube_to_measure();
    Similarity place{.scale = 2, .translation = {1e6, -1e6, 0}};
    document = set_transform(document, first_object, place).value();
    const Anchor anchor = patch_anchor(sphere, first_object, {5, {0.3, 0.25}});
    const auto found =
        measured(document, {{1}, DimensionKind::radius, {anchor}, Vector3::Zero()}, only(sphere));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value, 2 * radius, 2e-9 * radius);
    EXPECT_NEAR(found->first_radius, 2 * radius, 2e-9 * radius) << "positive: it bends away from its outside";
    EXPECT_NEAR(found->second_radius, 2 * radius, 2e-9 * radius);
    EXPECT_NEAR((found->points[0] - place.translation).norm(), 2 * radius, 1e-8 + 1e-12 * radius);
    EXPECT_NEAR(found->normal.dot((found->points[0] - place.translation).normalized()), 1, 1e-6);
  }
}

TEST(MeasuredDimension, RadiiOfATorusAndOfACylinder) {
  const double large = 3, small = 0.75;
  const Surface torus = test::torus(large, small, 5, 4);
  const Document document = cube_to_measure();
  test::for_random(31, 50, [&](std::mt19937_64& rng) {
    const SurfaceSpot spot{static_cast<Index>(test::uniform_int(rng, 0, 19)),
                           {test::uniform(rng), test::uniform(rng)}};
    const auto found = measured(
        document, {{1}, DimensionKind::radius, {patch_anchor(torus, first_object, spot)}, Vector3::Zero()},
        only(torus));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->first_radius, small, 1e-9) << "the narrow way round is bent most";
    const double v = 2 * std::numbers::pi / 4 * (spot.patch % 4 + spot.parameter.y());
    if (std::abs(std::cos(v)) > 1e-3) {
      const double across = (large + small * std::cos(v)) / std::cos(v);
      EXPECT_NEAR(found->second_radius, across, 1e-9 * std::abs(across)) << "negative inside of the ring";
    }
  });
  BezierPatch quarter;
  quarter.degree_s = 2;
  quarter.degree_t = 1;
  for (const double z : {0.0, 2.0})
    for (const auto& [x, y] : {std::pair(1.5, 0.0), std::pair(1.5, 1.5), std::pair(0.0, 1.5)})
      quarter.points.emplace_back(x, y, z);
  for (int j = 0; j < 2; ++j)
    for (const double w : {1.0, std::sqrt(0.5), 1.0}) quarter.weights.push_back(w);
  const Document cylinder =
      add_object({}, "Cylinder", BezierSource::from_patches({quarter}).value())->document;
  const Surface surface = final_surface(cylinder);
  const auto found = measured(
      cylinder,
      {{1}, DimensionKind::radius, {patch_anchor(surface, first_object, {0, {0.4, 0.7}})}, Vector3::Zero()},
      only(surface));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->first_radius, 1.5, 1e-9);
  EXPECT_TRUE(std::isinf(found->second_radius)) << found->second_radius;
}

TEST(MeasuredDimension, TheNearestPointOfASurfaceIsFound) {
  const Surface sphere = test::sphere(2);
  test::for_random(7, 200, [&](std::mt19937_64& rng) {
    const Vector3 point = test::random_vector(rng, 5);
    if (point.norm() < 0.1) return;
    const auto spot = nearest_spot(sphere, point);
    ASSERT_TRUE(spot);
    const Vector3 there = sphere.patches().evaluate(spot->patch, spot->parameter, Order::first).position;
    EXPECT_LT((there - 2 * point.normalized()).norm(), 1e-6) << point.transpose();
  });
  EXPECT_FALSE(nearest_spot(Surface(), Vector3::Zero()));
}

TEST(MeasuredDimension, NearestPointsFollowASurfaceWhosePatchesCome) {
  Solid ball{.kind = SolidKind::sphere, .radius = 5};
  const auto document_of = [&](double radius) {
    Solid solid = ball;
    solid.radius = radius;
    EnvelopeInput input{{solid}, {}};
    choose_ball(input);
    return add_object({}, "Ball", SolidsSource{input, {}})->document;
  };
  const Anchor top = NearestAnchor{first_object, {0, 0, 5}};
  for (const double radius : {5.0, 7.0}) {
    const Document document = document_of(radius);
    const auto made = test::must(object_surface(document, *document.find(first_object)));
    const auto place = anchor_place(document, top, only(made->surface));
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->norm(), radius, 0.15 * radius);
    EXPECT_LT(place->head<2>().norm(), 0.2 * radius);
  }
}

TEST(MeasuredDimension, PatchesKeepTheirNames) {
  test::for_random(11, 40, [](std::mt19937_64& rng) {
    const Document document = document_from_mesh(test::random_closed_shape(rng), "Any").value();
    const auto made = object_surface(document, *document.find(first_object));
    if (!made) return;
    const Surface& surface = made->surface;
    for (int i = 0; i < 10; ++i) {
      const SurfaceSpot spot{
          static_cast<Index>(test::uniform_int(rng, 0, static_cast<int>(surface.patch_count()) - 1)),
          {test::uniform(rng, 0, 0.5), test::uniform(rng, 0, 0.5)}};
      const auto again = spot_of(surface, patch_anchor(surface, first_object, spot));
      ASSERT_TRUE(again);
      EXPECT_EQ(again->patch, spot.patch);
      EXPECT_TRUE(again->parameter.isApprox(spot.parameter, 1e-15));
      EXPECT_TRUE(anchor_exists(document, patch_anchor(surface, first_object, spot)));
    }
  });
}

TEST(MeasuredDimension, AHalfWithALiveMirrorIsMeasuredAcrossThePlane) {
  PolygonMesh mesh = test::cube();
  for (Vector3& p : mesh.positions) p.x() += 3;
  PolyhedronSource half = PolyhedronSource::from_mesh(mesh).value();
  half.mirror = Mirror{Axis::x, 0};
  const Document document = add_object({}, "Half", half)->document;
  EXPECT_DOUBLE_EQ(
      value_of(document, DimensionKind::distance, {vertex(0), VertexAnchor{first_object, VertexId{0}, true}}),
      4);
  const Surface surface = final_surface(document);
  ASSERT_EQ(curves_over(surface, EdgeId::of({0}, {1})).size(), 2U);
  const auto on_half =
      anchor_place(document, EdgeAnchor{first_object, EdgeId::of({0}, {1}), 0.5, false}, only(surface));
  ASSERT_TRUE(on_half);
  EXPECT_GT(on_half->x(), 0) << "the curve of the half, not that of the image";
}

TEST(MeasuredDimension, IsRightAtAnyScaleAndFarAway) {
  test::for_random(3, 100, [](std::mt19937_64& rng) {
    PolygonMesh mesh = test::random_closed_shape(rng);
    const double scale = test::log_uniform(rng, 1e-3, 1e6);
    const Vector3 far = 1e6 * test::random_vector(rng);
    const auto count = static_cast<int>(mesh.positions.size());
    const auto any = [&] { return static_cast<std::uint32_t>(test::uniform_int(rng, 0, count - 1)); };
    const std::uint32_t a = any(), b = any(), c = any();
    if (a == b || b == c || a == c) return;
    const double length = scale * (mesh.positions[b] - mesh.positions[a]).norm();
    const Vector3 u = mesh.positions[a] - mesh.positions[b], v = mesh.positions[c] - mesh.positions[b];
    const double bend = std::atan2(u.cross(v).norm(), u.dot(v));
    for (Vector3& p : mesh.positions) p = far + scale * p;
    const Document document = document_from_mesh(mesh, "Any").value();
    // The numbers of the file have an error of 1e-10 at a million.
    const double error = 1e-9 + 1e-12 * length;
    EXPECT_NEAR(value_of(document, DimensionKind::distance, {vertex(a), vertex(b)}), length, error);
    EXPECT_NEAR(value_of(document, DimensionKind::angle, {vertex(a), vertex(b), vertex(c)}), bend,
                4 * error / (scale * std::min(u.norm(), v.norm())));
  });
}

TEST(MeasuredDimension, SizesOfElementsOfASphere) {
  test::AnalyticOptions options;
  options.source_edges = true;
  const Surface sphere = test::sphere(2, options);
  const SurfaceElements elements(sphere);
  const auto curves = elements.curves_over(EdgeId::of({0}, {2}));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_NEAR(curve_length(sphere, curves[0]), std::numbers::pi, 1e-7) << "a quarter of a great circle";
  EXPECT_TRUE(elements.curves_over(EdgeId::of({0}, {1})).empty()) << "opposite poles";
  std::vector<Index> all;
  for (Index p = 0; p < sphere.patch_count(); ++p) all.push_back(p);
  EXPECT_NEAR(patch_area(sphere, all), 16 * std::numbers::pi, 2e-6 * 16 * std::numbers::pi);
  EXPECT_NEAR(patch_area(sphere, std::vector<Index>{3}), 2 * std::numbers::pi, 2e-6 * 2 * std::numbers::pi);
  EXPECT_EQ(patch_area(sphere, {}), 0);
  EXPECT_TRUE(elements.patches_of(FaceId{0}).empty()) << "these patches come from no face";
}

}  // namespace
}  // namespace hariko
