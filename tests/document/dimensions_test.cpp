// Dimensions in the document: adding, removing, moving labels, and what becomes of them when objects change.

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/history/history.hpp"
#include "tests/document/random_documents.hpp"

namespace hariko {
namespace {

using test::cube_document;
using test::cube_id;

Anchor corner(std::uint32_t vertex, ObjectId object = cube_id) {
  return VertexAnchor{object, VertexId{vertex}};
}

/// The cube with the length of an edge (1) and an angle (2).
Document measured_cube() {
  const Document one =
      add_dimension(cube_document(), DimensionKind::distance, {corner(0), corner(1)})->document;
  return add_dimension(one, DimensionKind::angle, {corner(1), corner(0), corner(3)}, Vector3(0, 0, 1))
      ->document;
}

Code dimension_code(const Result<AddedDimension>& added) {
  return added ? Code{"fine"} : added.error().code;
}

TEST(Dimensions, AreAddedUnderNewIds) {
  const Document document = measured_cube();
  ASSERT_EQ(document.dimensions->size(), 2U);
  EXPECT_EQ((*document.dimensions)[0].id, DimensionId{1});
  EXPECT_EQ((*document.dimensions)[1].id, DimensionId{2});
  EXPECT_EQ((*document.dimensions)[1].label, Vector3(0, 0, 1));
  const std::vector<DimensionId> both{{1}, {2}};
  EXPECT_EQ(remove_dimensions(document, both)->objects, document.objects) << "nothing else changes";
  EXPECT_EQ(find_dimension(document, DimensionId{2})->kind, DimensionKind::angle);
  EXPECT_EQ(find_dimension(document, DimensionId{3}), nullptr);
  // The first one goes: its id is not given to another while a higher one is there.
  const std::vector<DimensionId> first{{1}};
  const Document left = remove_dimensions(document, first).value();
  EXPECT_EQ(add_dimension(left, DimensionKind::distance, {corner(0), corner(2)})->id, DimensionId{3});
}

TEST(Dimensions, TheHighestIdIsNoEnd) {
  Document document = measured_cube();
  Dimensions all = *document.dimensions;
  all[1].id = {max_dimension_id};
  document.dimensions = all;
  EXPECT_EQ(add_dimension(document, DimensionKind::distance, {corner(0), corner(2)})->id, DimensionId{2});
}

TEST(Dimensions, WhatMakesNoneIsRefused) {
  const Document document = cube_document();
  const double infinity = std::numeric_limits<double>::infinity();
  const PatchAnchor patch{cube_id, element_of(FaceId{0}), 0, {0.5, 0.25}};
  const auto code = [&](DimensionKind kind, std::vector<Anchor> anchors, Vector3 label = Vector3::Zero()) {
    return dimension_code(add_dimension(document, kind, std::move(anchors), label));
  };
  using enum DimensionKind;
  EXPECT_EQ(code(distance, {corner(0)}), e_dimension_invalid);
  EXPECT_EQ(code(distance, {corner(0), corner(1), corner(2)}), e_dimension_invalid);
  EXPECT_EQ(code(angle, {corner(0), corner(1)}), e_dimension_invalid);
  EXPECT_EQ(code(radius, {corner(0)}), e_dimension_invalid) << "a vertex has no curvature of its own";
  EXPECT_EQ(code(radius, {patch}), Code{"fine"});
  EXPECT_EQ(code(distance, {corner(0), SpaceAnchor{{infinity, 0, 0}}}), e_dimension_invalid);
  EXPECT_EQ(code(distance, {corner(0), corner(1)}, {infinity, 0, 0}), e_dimension_invalid);
  EXPECT_EQ(code(distance, {corner(0), corner(8)}), e_unknown_element);
  EXPECT_EQ(code(distance, {corner(0), corner(1, {7})}), e_unknown_object);
  EXPECT_EQ(code(distance, {corner(0), EdgeAnchor{cube_id, EdgeId::of({0}, {6}), 0.5}}), e_unknown_element)
      << "no edge joins opposite corners";
  EXPECT_EQ(code(distance, {corner(0), EdgeAnchor{cube_id, EdgeId::of({0}, {1}), 0.5}}), Code{"fine"});
  EXPECT_EQ(code(distance, {corner(0), VertexAnchor{cube_id, VertexId{1}, true}}), e_unknown_element)
      << "there is no mirror";
  EXPECT_EQ(code(distance, {corner(0), ObjectAnchor{cube_id, {1, 0, 0}, 3U}}), e_unknown_element)
      << "there are no solids";
}

TEST(Dimensions, GoAndTheirLabelsMove) {
  const Document document = measured_cube();
  const Document moved = move_dimension_label(document, {1}, {0, -2, 0}).value();
  EXPECT_EQ(find_dimension(moved, {1})->label, Vector3(0, -2, 0));
  EXPECT_EQ(*find_dimension(moved, {2}), *find_dimension(document, {2}));
  const Document same = move_dimension_label(moved, {1}, {0, -2, 0}).value();
  EXPECT_EQ(same.dimensions.get(), moved.dimensions.get()) << "an edit without effect shares everything";
  const std::vector<DimensionId> second{{2}};
  const Document left = remove_dimensions(document, second).value();
  ASSERT_EQ(left.dimensions->size(), 1U);
  EXPECT_EQ((*left.dimensions)[0].id, DimensionId{1});
  EXPECT_EQ(remove_dimensions(left, second).error().code, e_unknown_dimension);
  EXPECT_EQ(move_dimension_label(left, {2}, {0, 0, 0}).error().code, e_unknown_dimension);
  EXPECT_EQ(remove_dimensions(document, {})->dimensions.get(), document.dimensions.get());
}

TEST(Dimensions, LockedObjectsAreMeasured) {
  const Document locked = set_locked(cube_document(), cube_id, true).value();
  EXPECT_TRUE(add_dimension(locked, DimensionKind::distance, {corner(0), corner(1)}));
}

TEST(Dimensions, GoWithTheObjectsTheyMeasure) {
  const Document document = measured_cube();
  const Added two = duplicate_object(document, cube_id).value();
  EXPECT_EQ(two.document.dimensions->size(), 2U) << "copies are not measured";
  const Document between =
      add_dimension(two.document, DimensionKind::distance, {corner(0), corner(0, two.id)})->document;
  const std::vector<ObjectId> copy{two.id}, cube{cube_id};
  const Document without_copy = delete_objects(between, copy).value();
  ASSERT_EQ(without_copy.dimensions->size(), 2U);
  EXPECT_EQ(dimensions_that_went(between, without_copy), (std::vector<DimensionId>{{3}}));
  EXPECT_TRUE(delete_objects(between, cube)->dimensions->empty());
  EXPECT_TRUE(lost_dimensions(between).empty());
}

TEST(Dimensions, OfWhatIsNoMoreAreFound) {
  const Document document = measured_cube();
  // A pyramid over the cube's lower face: vertices 5, 6 and 7 are gone, and so is vertex 3 in the second one.
  PolygonMesh mesh = test::pyramid(4);
  const Document pyramid = set_source(document, cube_id, PolyhedronSource::from_mesh(mesh).value()).value();
  EXPECT_TRUE(lost_dimensions(pyramid).empty());
  const Document triangle =
      set_source(document, cube_id, PolyhedronSource::from_mesh(test::grid(1, 1)).value()).value();
  EXPECT_TRUE(lost_dimensions(triangle).empty()) << "a square has four corners";
  PolygonMesh three;
  three.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  three.add_face({0, 1, 2});
  const Document small = set_source(document, cube_id, PolyhedronSource::from_mesh(three).value()).value();
  EXPECT_EQ(lost_dimensions(small), (std::vector<DimensionId>{{2}}));
  EXPECT_TRUE(dimensions_that_went(document, small).empty()) << "they are still in the document";
  const Document pruned = remove_dimensions(small, lost_dimensions(small)).value();
  EXPECT_EQ(dimensions_that_went(document, pruned), (std::vector<DimensionId>{{2}}));
  const std::vector<DimensionId> first{{1}};
  EXPECT_TRUE(dimensions_that_went(document, *remove_dimensions(document, first)).empty())
      << "what was deleted by hand did not go with its object";
}

TEST(Dimensions, ComeAlongWithADocumentThatIsAppended) {
  const Document document = measured_cube();
  Document other = measured_cube();
  other = add_dimension(other, DimensionKind::distance, {SpaceAnchor{{1, 2, 3}}, corner(4)})->document;
  const Document both = append_document(document, other).value();
  ASSERT_EQ(both.dimensions->size(), 5U);
  const Dimension& last = both.dimensions->back();
  EXPECT_EQ(last.id, DimensionId{5});
  EXPECT_EQ(last.anchors[0], Anchor(SpaceAnchor{{1, 2, 3}}));
  EXPECT_EQ(last.anchors[1], corner(4, both.objects.back()->id));
  EXPECT_TRUE(lost_dimensions(both).empty());
}

TEST(Dimensions, TheirNumbersAreConvertedToAnotherUnit) {
  Document document = cube_document();
  document.dimensions = Dimensions{
      {{1}, DimensionKind::distance, {corner(0), SpaceAnchor{{10, 20, 30}}}, {0, 0, 5}},
      {{2}, DimensionKind::distance, {ObjectAnchor{cube_id, {1, 0, 0}, {}}, corner(1)}, Vector3::Zero()},
      {{3}, DimensionKind::radius, {NearestAnchor{cube_id, {0, 0, 1}}}, Vector3::Zero()}};
  const Document converted = convert_unit(document, Unit::centimetre).value();
  const Dimensions& all = *converted.dimensions;
  EXPECT_EQ(all[0].anchors[0], corner(0));
  EXPECT_TRUE(std::get<SpaceAnchor>(all[0].anchors[1]).point.isApprox(Vector3(1, 2, 3), 1e-15));
  EXPECT_TRUE(all[0].label.isApprox(Vector3(0, 0, 0.5), 1e-15));
  EXPECT_TRUE(std::get<ObjectAnchor>(all[1].anchors[0]).point.isApprox(Vector3(0.1, 0, 0), 1e-15));
  EXPECT_TRUE(std::get<NearestAnchor>(all[2].anchors[0]).point.isApprox(Vector3(0, 0, 0.1), 1e-15));
  EXPECT_EQ(set_unit(document, Unit::centimetre).dimensions, document.dimensions)
      << "the numbers stay where the size changes";
}

TEST(Dimensions, AreStepsThatCanBeUndone) {
  History history(cube_document());
  const Document measured = measured_cube();
  ASSERT_TRUE(history.push(measured, "Measure distance"));
  EXPECT_FALSE(history.push(measured, "Nothing")) << "an equal document is no step";
  const std::size_t bytes = history.bytes();
  ASSERT_TRUE(history.undo());
  EXPECT_TRUE(history.current().dimensions->empty());
  ASSERT_TRUE(history.redo());
  EXPECT_EQ(history.current(), measured);
  EXPECT_EQ(history.bytes(), bytes);
}

}  // namespace
}  // namespace hariko
