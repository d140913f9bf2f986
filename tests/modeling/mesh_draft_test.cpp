// MeshEditor: what it keeps, what it forgets, what it refuses; and edits of the document by operations.

#include "core/modeling/mesh_editor.hpp"

#include "core/document/edits/edits.hpp"
#include "core/document/history/history.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/polyhedron/validation.hpp"
#include "tests/document/random_documents.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

PolyhedronSource cube_source() {
  return PolyhedronSource::from_mesh(test::cube()).value();
}

TEST(MeshEditor, UnchangedGivesAnEqualSource) {
  test::for_random(10, 100, [](std::mt19937_64& rng) {
    PolyhedronSource source = test::any_polyhedron(rng);
    Shaping shaping = *source.shaping;
    // Tags that no surface can be made with are dropped; a document may hold them.
    shaping.tag = {};
    source.shaping = shaping;
    // So are attachments of edges that are not on the border.
    source.attachments = Attachments{};
    EXPECT_TRUE(MeshEditor(source).finish().value() == source);
  });
}

TEST(MeshEditor, NewIdsFollowTheGreatest) {
  MeshEditor draft(cube_source());
  EXPECT_EQ(draft.add_vertex({0, 0, 2}), VertexId{8});
  EXPECT_EQ(draft.add_vertex({0, 0, 3}), VertexId{9});
  draft.remove_face({5});
  EXPECT_EQ(draft.add_face({{0}, {4}, {7}, {3}}), FaceId{6}) << "not the one that was just removed";
  const auto result = std::move(draft).finish().value();
  EXPECT_EQ(result.polyhedron.vertex_count(), 8U) << "vertices without faces are dropped";
  EXPECT_EQ(result.polyhedron.find(FaceId{5}), no_index);
  EXPECT_NE(result.polyhedron.find(FaceId{6}), no_index);
}

TEST(MeshEditor, NumbersUsedUpAreRefused) {
  PolygonMesh mesh = test::cube();
  std::vector<VertexId> ids{{0}, {1}, {2}, {3}, {4}, {5}, {6}, {0xfffffffeU}};
  PolyhedronSource source = cube_source();
  source.polyhedron = Polyhedron::build(mesh, ids, {{0}, {1}, {2}, {3}, {4}, {5}}).value();
  MeshEditor draft(source);
  for (int i = 0; i < 3; ++i) {
    const VertexId v = draft.add_vertex({0, 0, 0});
    draft.set_face({1}, {{4}, {5}, {6}, v});
  }
  const auto refused = std::move(draft).finish();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code.name, e_too_many_elements.name);
}

TEST(MeshEditor, SplitEdgeAndItsShaping) {
  PolyhedronSource source = cube_source();
  Shaping shaping;
  shaping.beta.set(EdgeId::of({0}, {1}), 7);
  shaping.crease.set(EdgeId::of({0}, {1}), true);
  source.shaping = shaping;
  MeshEditor draft(source);
  const VertexId middle = draft.add_vertex({0, -1, -1});
  draft.split_edge(EdgeId::of({0}, {1}), middle);
  EXPECT_FALSE(draft.contains(EdgeId::of({0}, {1})));
  EXPECT_EQ(draft.faces_at(EdgeId::of({0}, middle)), (std::vector<FaceId>{{0}, {2}}));
  const auto result = std::move(draft).finish().value();
  EXPECT_EQ(result.polyhedron.vertex_count(), 9U);
  EXPECT_EQ(result.polyhedron.edge_count(), 13U);
  EXPECT_EQ(result.shaping->beta.size(), 2U);
  EXPECT_EQ(result.shaping->beta.get_or(EdgeId::of({0}, middle), 1), 7);
  EXPECT_EQ(result.shaping->beta.get_or(EdgeId::of(middle, {1}), 1), 7);
  EXPECT_EQ(result.shaping->crease.size(), 2U);
}

TEST(MeshEditor, ShapingOfWhatIsGoneIsForgotten) {
  PolyhedronSource source = cube_source();
  Shaping shaping;
  shaping.alpha.set({0}, 2);
  shaping.alpha.set({6}, 3);
  shaping.beta.set(EdgeId::of({6}, {7}), 4);
  shaping.crease.set(EdgeId::of({4}, {5}), true);
  shaping.pin.set({0}, {Pin::Kind::tangents, {{1, 0, 0}, {0, 1, 0}}});
  shaping.pin.set({4}, {Pin::Kind::tangents, {{1, 0, 0}, {0, 1, 0}}});
  shaping.pin.set({5}, {Pin::Kind::tangents, {{1, 0, 0}, {2, 0, 0}}});
  source.shaping = shaping;
  MeshEditor draft(source);
  for (const FaceId face : draft.faces_at(VertexId{6})) draft.remove_face(face);
  const auto result = std::move(draft).finish().value();
  EXPECT_EQ(result.polyhedron.vertex_count(), 7U);
  EXPECT_EQ(result.shaping->alpha.size(), 1U);
  EXPECT_EQ(result.shaping->beta.size(), 0U);
  EXPECT_EQ(result.shaping->crease.size(), 1U);
  EXPECT_EQ(result.shaping->pin.find({0})->kind, Pin::Kind::tangents) << "same edges round it";
  EXPECT_EQ(*result.shaping->pin.find({4}), (Pin{Pin::Kind::normal, {{0, 0, -1}}})) << "has lost an edge";
  EXPECT_FALSE(result.shaping->pin.contains({5})) << "parallel tangents have no plane";
}

TEST(MeshEditor, CornerTagsNeedABorderOrCreases) {
  PolygonMesh open = test::without_face(test::cube(), 1);
  PolyhedronSource source = PolyhedronSource::from_mesh(open).value();
  Shaping shaping;
  shaping.tag.set({4}, VertexTag::corner);
  shaping.tag.set({5}, VertexTag::corner);
  shaping.tag.set({6}, VertexTag::smooth);
  shaping.crease.set(EdgeId::of({1}, {5}), true);
  shaping.crease.set(EdgeId::of({4}, {5}), true);
  source.shaping = shaping;
  MeshEditor draft(source);
  draft.add_face({{4}, {5}, {6}, {7}});
  const auto closed = std::move(draft).finish().value();
  EXPECT_FALSE(closed.shaping->tag.contains({4}));
  EXPECT_TRUE(closed.shaping->tag.contains({5}));
  EXPECT_TRUE(closed.shaping->tag.contains({6}));
}

TEST(MeshEditor, RefusesWhatIsNoPolyhedron) {
  const auto code_of = [](MeshEditor draft) { return std::move(draft).finish().error().code.name; };
  MeshEditor three(cube_source());
  const VertexId apex = three.add_vertex({0, 0, 5});
  three.add_face({{4}, {5}, apex});
  EXPECT_EQ(code_of(three), e_would_be_nonmanifold.name);
  MeshEditor none(cube_source());
  for (const FaceId face : none.faces()) none.remove_face(face);
  EXPECT_EQ(code_of(none), e_no_faces.name);
  MeshEditor far(cube_source());
  far.move_vertex({3}, {0, 0, std::numeric_limits<double>::infinity()});
  EXPECT_EQ(code_of(far), e_nonfinite.name);
  MeshEditor small(cube_source());
  small.set_face({0}, {{0}, {1}});
  EXPECT_EQ(code_of(small), e_would_be_nonmanifold.name);
  MeshEditor touching(cube_source());
  touching.remove_face({0});
  touching.remove_face({3});
  touching.remove_face({5});
  touching.add_face({{0}, {3}, {4}});
  EXPECT_EQ(code_of(touching), e_would_be_nonmanifold.name);
}

Result<EditResult> open_the_top(const PolyhedronSource& source) {
  MeshEditor draft(source);
  draft.remove_face({1});
  Result<PolyhedronSource> result = std::move(draft).finish();
  if (!result) return result.error();
  return EditResult{std::move(result).value(), {{{4}}, {}, {}}};
}

TEST(EditPolyhedron, ReplacesTheSourceAndUndoGivesItBack) {
  const Document before = test::cube_document();
  History history(before);
  const ModeledDocument edited = edit_polyhedron(before, test::cube_id, open_the_top).value();
  EXPECT_EQ(edited.selection.vertices, std::set<VertexId>{{4}});
  EXPECT_EQ(test::polyhedron_of(edited.document).polyhedron.face_count(), 5U);
  ASSERT_TRUE(history.push(edited.document, "Open"));
  ASSERT_TRUE(history.undo());
  EXPECT_TRUE(history.current() == before);
  ASSERT_TRUE(history.redo());
  EXPECT_TRUE(history.current() == edited.document);
}

TEST(EditPolyhedron, Refusals) {
  const Document document = test::cube_document();
  const auto code_of = [](const Document& d, ObjectId id) {
    return edit_polyhedron(d, id, open_the_top).error().code.name;
  };
  EXPECT_EQ(code_of(document, {77}), e_unknown_object.name);
  EXPECT_EQ(code_of(set_locked(document, test::cube_id, true).value(), test::cube_id), e_locked.name);
  const MeshSource mesh = MeshSource::from_mesh(test::cube()).value();
  EXPECT_EQ(code_of(set_source(document, test::cube_id, mesh).value(), test::cube_id), e_wrong_kind.name);
  const auto refusing = [](const PolyhedronSource&) -> Result<EditResult> {
    return make_error(e_wrong_selection, "No.");
  };
  EXPECT_EQ(edit_polyhedron(document, test::cube_id, refusing).error().code.name, e_wrong_selection.name);
}

}  // namespace
}  // namespace hariko
