// Surroundings that maps of making depend on beside their object: surfaces are made anew where they change,
// and only there.

#include "app/engines/map_surroundings.hpp"

#include "app/engines/rebuild_engine.hpp"
#include "app/engines/surface_builder.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

constexpr ObjectId first_cube{1}, second_cube{2};

Document two_equal_cubes(SurfaceMap map) {
  Document document = document_from_mesh(test::cube(), "First").value();
  document = add_object(document, "Second", document.objects[0]->source)->document;
  DisplaySettings display;
  display.map = map;
  return set_display(document, first_cube, display).value();
}

Document compared_with(const Document& document, ObjectId reference) {
  MakingSettings making = document.making;
  making.reference = reference;
  return set_making(document, making).value();
}

Document moved_by(const Document& document, ObjectId id, const Vector3& by) {
  Similarity place = document.find(id)->transform;
  place.translation += by;
  return set_transform(document, id, place).value();
}

TEST(MapSurroundings, NameWhyThereIsNoReference) {
  const Document plain = two_equal_cubes(SurfaceMap::deviation);
  const Surface ball = test::sphere(1);
  const auto state = [&](const Document& document, const ShownSurface& shown) {
    return surroundings_of(document, *document.find(first_cube), shown).state;
  };
  const ShownSurface none = [](ObjectId) { return nullptr; }, all = [&](ObjectId) { return &ball; };
  EXPECT_EQ(state(plain, all), ReferenceState::none);
  EXPECT_EQ(state(compared_with(plain, ObjectId{77}), all), ReferenceState::none);
  EXPECT_EQ(state(compared_with(plain, first_cube), all), ReferenceState::itself);
  const Document compared = compared_with(plain, second_cube);
  EXPECT_EQ(state(set_visible(compared, second_cube, false).value(), all), ReferenceState::hidden);
  EXPECT_EQ(state(compared, none), ReferenceState::waiting);
  EXPECT_EQ(state(compared, all), ReferenceState::ready);
  EXPECT_EQ(state(two_equal_cubes(SurfaceMap::mean), all), ReferenceState::unasked);
}

TEST(MapSurroundings, LeaveOutWhatAMapDoesNotDependOn) {
  const ShownSurface none = [](ObjectId) { return nullptr; };
  const auto of = [&](const Document& document) {
    return surroundings_of(document, *document.find(first_cube), none);
  };
  for (const SurfaceMap map : {SurfaceMap::mean, SurfaceMap::radius, SurfaceMap::draft}) {
    const Document document = two_equal_cubes(map);
    MakingSettings making;
    making.pull = Vector3::UnitX();
    making.radius = 17;
    const Document other = set_making(document, making).value();
    EXPECT_EQ(same_values(of(document), of(other)), map != SurfaceMap::draft) << int(map);
    EXPECT_EQ(of(document).limit == of(other).limit, map != SurfaceMap::radius) << int(map);
    const Document moved = moved_by(document, first_cube, {1, 2, 3});
    EXPECT_EQ(same_values(of(document), of(moved)), map == SurfaceMap::mean) << int(map);
  }
}

/// With 13 intervals along the sides of its patches the zebra of a mouse had corners.
TEST(SurfaceBuilders, DrawStripesFinerWhileNothingIsDragged) {
  const auto density = [](SurfaceMap map, Quality quality) {
    const Document document = two_equal_cubes(map);
    SurfaceBuilder builder;
    const SurfaceView view = builder.build(document.objects[0], {}, {}, quality, {});
    return view.mesh ? view.mesh->options().density : 0;
  };
  const int shaded = density(SurfaceMap::shaded, Quality::final);
  EXPECT_GT(shaded, 0);
  EXPECT_GT(density(SurfaceMap::zebra, Quality::final), shaded);
  EXPECT_GT(density(SurfaceMap::isophotes, Quality::final), shaded);
  EXPECT_EQ(density(SurfaceMap::zebra, Quality::drag), shaded);
}

struct RealEngine {
  int published = 0;
  RebuildEngine engine{[] { return std::make_unique<SurfaceBuilder>(); },
                       {},
                       [this](ObjectId id, const SurfaceView&) { published += id == first_cube ? 1 : 0; }};
  const SurfaceView& settle(const Document& document) {
    for (int i = 0; i < 4; ++i) {
      engine.sync(document, false, i);
      engine.wait();
      engine.publish();
    }
    return engine.views().at(first_cube);
  }
};

TEST(MapSurroundings, DeviationsFollowTheReference) {
  RealEngine rig;
  Document document = compared_with(two_equal_cubes(SurfaceMap::deviation), second_cube);
  const SurfaceView& view = rig.settle(document);
  ASSERT_TRUE(view.mesh && !view.map_error) << (view.map_error ? view.map_error->text : "");
  for (const float value : view.mesh->defined_values()) EXPECT_NEAR(value, 0, 1e-6);
  const int before = rig.published;
  rig.settle(document);
  EXPECT_EQ(rig.published, before) << "nothing changed";
  document = moved_by(document, second_cube, {0, 0, -0.125});
  const auto values = rig.settle(document).mesh->defined_values();
  EXPECT_GT(rig.published, before);
  ASSERT_FALSE(values.empty());
  EXPECT_NEAR(*std::max_element(values.begin(), values.end()), 0.125, 0.01);
  EXPECT_NEAR(*std::min_element(values.begin(), values.end()), -0.125, 0.01);
  const SurfaceView& alone = rig.settle(set_visible(document, second_cube, false).value());
  ASSERT_TRUE(alone.map_error);
  EXPECT_EQ(alone.map_error->code, e_map_reference);
  EXPECT_FALSE(alone.mesh->has_values());
}

TEST(MapSurroundings, OnlyMapsOfMakingAreMadeAnewWhenAnObjectMoves) {
  for (const SurfaceMap map : {SurfaceMap::mean, SurfaceMap::thickness}) {
    RealEngine rig;
    const Document document = two_equal_cubes(map);
    rig.settle(document);
    const int before = rig.published;
    rig.settle(moved_by(document, first_cube, {5, 0, 0}));
    EXPECT_EQ(rig.published > before, map == SurfaceMap::thickness);
  }
}

TEST(MapSurroundings, AnotherLimitIsAnotherRangeOfTheSameMesh) {
  RealEngine rig;
  const Document document = two_equal_cubes(SurfaceMap::thickness);
  const SurfaceView& view = rig.settle(document);
  EXPECT_EQ(view.range, (ValueRange{0, 4, 2}));
  const auto mesh = view.mesh;
  MakingSettings making;
  making.thickness = 0.5;
  EXPECT_EQ(rig.settle(set_making(document, making).value()).range, (ValueRange{0, 1, 0.5}));
  EXPECT_EQ(rig.engine.views().at(first_cube).mesh, mesh);
}

}  // namespace
}  // namespace hariko
