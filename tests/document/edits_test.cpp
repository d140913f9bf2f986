// Edits: what each changes, what it leaves alone, and what it refuses.

#include "core/document/edits/edits.hpp"

#include <limits>

#include "core/document/object_box.hpp"
#include "core/network/network.hpp"
#include "core/polyhedron/validation.hpp"
#include "tests/document/random_documents.hpp"

namespace hariko {
namespace {

using test::cube_document;
using test::cube_id;
using test::polyhedron_of;
using Vertices = std::vector<VertexId>;
using Edges = std::vector<EdgeId>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
const EdgeId edge_01{{0}, {1}}, edge_45{{4}, {5}}, no_edge{{0}, {6}};

template <class T>
void expect_error(const Result<T>& result, Code code) {
  ASSERT_FALSE(result) << "expected " << code.name;
  EXPECT_EQ(result.error().code.name, code.name) << to_string(result.error());
  EXPECT_FALSE(result.error().text.empty());
}

/// The document with the one field that an edit may change put back: it must equal the one before.
template <class Restore>
void expect_only_change(const Document& before, const Document& after, Restore&& restore) {
  ASSERT_EQ(before.objects.size(), after.objects.size());
  EXPECT_FALSE(before == after);
  Object object = *after.objects[0];
  restore(object);
  EXPECT_TRUE(object == *before.objects[0]);
  EXPECT_EQ(before.next_object_id, after.next_object_id);
  EXPECT_EQ(before.kept, after.kept);
}

PolyhedronSource& source_of(Object& object) {
  return std::get<PolyhedronSource>(object.source);
}

/// Two cubes; the second must never feel an edit of the first. Every field has a value of its own.
Document rich_document() {
  Document document = cube_document();
  document.kept = KeptMembers{{"top", "1"}};
  document.unit = Unit::metre;
  Object object = *document.objects[0];
  object.kept = KeptMembers{{"own", "2"}};
  object.transform.scale = 3;
  object.display.density = 5;
  Shaping shaping;
  shaping.alpha.set({3}, 4);
  shaping.beta.set(edge_45, 5);
  shaping.crease.set(edge_45, true);
  shaping.tag.set({3}, VertexTag::smooth);
  shaping.pin.set({3}, {Pin::Kind::normal, {{0, 0, 1}}});
  source_of(object).shaping = shaping;
  source_of(object).kept = KeptMembers{{"inner", "3"}};
  document.objects[0] = std::make_shared<const Object>(std::move(object));
  return duplicate_object(document, cube_id).value().document;
}

TEST(Edits, MoveVertices) {
  const Document before = rich_document();
  const Document after =
      move_vertices(before, cube_id, Vertices{{0}, {7}}, std::vector<Vector3>{{9, 8, 7}, {1, 2, 3}}).value();
  EXPECT_EQ(polyhedron_of(after).polyhedron.position(0), Vector3(9, 8, 7));
  EXPECT_EQ(polyhedron_of(after).polyhedron.position(7), Vector3(1, 2, 3));
  EXPECT_EQ(after.objects[1], before.objects[1]) << "other objects stay shared";
  EXPECT_EQ(polyhedron_of(after).polyhedron.shared_topology(),
            polyhedron_of(before).polyhedron.shared_topology());
  expect_only_change(before, after,
                     [&](Object& o) { source_of(o).polyhedron = polyhedron_of(before).polyhedron; });
  EXPECT_TRUE(
      move_vertices(after, cube_id, Vertices{{7}, {0}}, std::vector<Vector3>{{-1, 1, 1}, {-1, -1, -1}})
          .value() == before)
      << "moving back gives an equal document";

  const std::vector<Vector3> one{{0, 0, 0}};
  expect_error(move_vertices(before, {77}, Vertices{{0}}, one), e_unknown_object);
  expect_error(move_vertices(before, cube_id, Vertices{{8}}, one), e_unknown_element);
  for (const double bad : {infinity, nan_value})
    expect_error(move_vertices(before, cube_id, Vertices{{0}}, std::vector<Vector3>{{0, bad, 0}}),
                 e_nonfinite);
}

TEST(Edits, Alpha) {
  const Document before = rich_document();
  const Document after = set_alpha(before, cube_id, Vertices{{5}, {1}, {5}}, 10).value();
  const auto& alpha = polyhedron_of(after).shaping->alpha;
  EXPECT_EQ(alpha.size(), 3U);
  EXPECT_EQ(alpha.get_or({1}, 0), 10);
  EXPECT_EQ(alpha.get_or({3}, 0), 4);
  EXPECT_EQ(alpha.get_or({5}, 0), 10);
  expect_only_change(before, after, [&](Object& o) {
    Shaping shaping = *source_of(o).shaping;
    shaping.alpha = polyhedron_of(before).shaping->alpha;
    source_of(o).shaping = shaping;
  });
  EXPECT_TRUE(set_alpha(after, cube_id, Vertices{{1}, {5}}, 0).value() == before)
      << "the default is not stored";
  expect_error(set_alpha(before, cube_id, Vertices{{0}}, -1e-9), e_tension_negative);
  expect_error(set_alpha(before, cube_id, Vertices{{0}}, 1000.1), e_tension_range);
  expect_error(set_alpha(before, cube_id, Vertices{{0}}, nan_value), e_tension_nonfinite);
  expect_error(set_alpha(before, cube_id, Vertices{{0}}, infinity), e_tension_nonfinite);
  expect_error(set_alpha(before, cube_id, Vertices{{0}, {8}}, 1), e_unknown_element);
  EXPECT_TRUE(set_alpha(before, cube_id, Vertices{{0}}, 1000));
}

TEST(Edits, Beta) {
  const Document before = rich_document();
  const Document after = set_beta(before, cube_id, Edges{edge_01}, 10).value();
  EXPECT_EQ(polyhedron_of(after).shaping->beta.get_or(edge_01, 1), 10);
  EXPECT_EQ(polyhedron_of(after).shaping->beta.get_or(edge_45, 1), 5);
  expect_only_change(before, after, [&](Object& o) {
    Shaping shaping = *source_of(o).shaping;
    shaping.beta = polyhedron_of(before).shaping->beta;
    source_of(o).shaping = shaping;
  });
  EXPECT_TRUE(set_beta(after, cube_id, Edges{edge_01}, 1).value() == before);
  expect_error(set_beta(before, cube_id, Edges{edge_01}, -1), e_tension_negative);
  expect_error(set_beta(before, cube_id, Edges{edge_01}, 0), e_tension_range);
  expect_error(set_beta(before, cube_id, Edges{edge_01}, 1001), e_tension_range);
  expect_error(set_beta(before, cube_id, Edges{edge_01}, nan_value), e_tension_nonfinite);
  expect_error(set_beta(before, cube_id, Edges{no_edge}, 2), e_unknown_element);
  EXPECT_EQ(set_beta(before, cube_id, Edges{no_edge}, 2).error().element, element_of(no_edge));
  Edges many(20, edge_01);
  many.push_back(no_edge);
  expect_error(set_beta(before, cube_id, many, 2), e_unknown_element);
}

TEST(Edits, CreasesTagsPinsAndMode) {
  const Document before = rich_document();
  const Document creased = set_crease(before, cube_id, Edges{edge_01}, true).value();
  EXPECT_EQ(polyhedron_of(creased).shaping->crease.size(), 2U);
  EXPECT_TRUE(set_crease(creased, cube_id, Edges{edge_01}, false).value() == before);
  expect_error(set_crease(before, cube_id, Edges{no_edge}, true), e_unknown_element);

  const Document tagged = set_vertex_tag(before, cube_id, Vertices{{0}}, VertexTag::corner).value();
  EXPECT_EQ(polyhedron_of(tagged).shaping->tag.get_or({0}, VertexTag::automatic), VertexTag::corner);
  EXPECT_TRUE(set_vertex_tag(tagged, cube_id, Vertices{{0}}, VertexTag::automatic).value() == before);
  expect_error(set_vertex_tag(before, cube_id, Vertices{{8}}, VertexTag::corner), e_unknown_element);

  const Pin pin{Pin::Kind::tangents, {{1, 0, 0}, {0, 1, 0}}};
  PolyhedronSource source = polyhedron_of(before);
  Shaping shaping = *source.shaping;
  shaping.pin.set({0}, pin);
  source.shaping = std::move(shaping);
  const Document pinned = set_source(before, cube_id, source).value();
  EXPECT_TRUE(clear_pins(pinned, cube_id, Vertices{{0}, {1}}).value() == before);
  expect_error(clear_pins(before, cube_id, Vertices{{8}}), e_unknown_element);
  expect_error(check_pin({Pin::Kind::normal, {{0, 0, 0}}}), e_pin_invalid);
  expect_error(check_pin({Pin::Kind::normal, {{0, 0, 1}, {0, 0, 1}}}), e_pin_invalid);
  expect_error(check_pin({Pin::Kind::tangents, {}}), e_pin_invalid);
  expect_error(check_pin({Pin::Kind::tangents, {{nan_value, 0, 0}}}), e_pin_invalid);

  Preparation preparation{.split_concave = true, .automatic_tension = 0.5};
  const Document prepared = set_preparation(before, cube_id, preparation).value();
  EXPECT_EQ(prepared.find(cube_id)->polyhedron()->preparation, preparation);
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    preparation.automatic_tension = bad;
    expect_error(set_preparation(before, cube_id, preparation), e_automatic_tension_range);
  }

  const Document paper = set_mode(before, cube_id, Mode::paper).value();
  expect_only_change(before, paper, [](Object& o) { source_of(o).mode = Mode::fair; });
  expect_error(set_mode(before, {77}, Mode::paper), e_unknown_object);
}

TEST(Edits, ObjectProperties) {
  const Document before = rich_document();
  expect_only_change(before, rename_object(before, cube_id, "Dice").value(),
                     [](Object& o) { o.name = "Cube"; });
  expect_error(rename_object(before, cube_id, ""), e_name_empty);
  expect_error(rename_object(before, cube_id, " \t"), e_name_empty);
  expect_error(rename_object(before, cube_id, "a\nb"), e_name_invalid);
  expect_error(rename_object(before, cube_id, "\xff"), e_name_invalid);
  expect_error(rename_object(before, cube_id, std::string(257, 'x')), e_name_invalid);
  expect_error(rename_object(before, {77}, "x"), e_unknown_object);

  expect_only_change(before, set_visible(before, cube_id, false).value(),
                     [](Object& o) { o.visible = true; });
  expect_error(set_visible(before, {77}, false), e_unknown_object);

  DisplaySettings display = before.objects[0]->display;
  display.map = SurfaceMap::gaussian;
  expect_only_change(before, set_display(before, cube_id, display).value(),
                     [](Object& o) { o.display.map = SurfaceMap::shaded; });
  for (const int density : {0, 65, -1}) {
    display.density = density;
    expect_error(set_display(before, cube_id, display), e_display_invalid);
  }

  Similarity transform;
  transform.rotation = Eigen::Quaterniond(2, 0, 0, 0);
  transform.translation = {1, 2, 3};
  const Document moved = set_transform(before, cube_id, transform).value();
  EXPECT_EQ(moved.objects[0]->transform.rotation.w(), 1) << "normalised";
  expect_only_change(before, moved, [&](Object& o) { o.transform = before.objects[0]->transform; });
  for (const double scale : {0.0, -1.0, 1e-10, 1e10, infinity, nan_value}) {
    Similarity bad;
    bad.scale = scale;
    expect_error(set_transform(before, cube_id, bad), e_transform_invalid);
  }
  Similarity bad;
  bad.rotation = Eigen::Quaterniond(0, 0, 0, 0);
  expect_error(set_transform(before, cube_id, bad), e_transform_invalid);
  bad = {};
  bad.translation.x() = nan_value;
  expect_error(set_transform(before, cube_id, bad), e_transform_invalid);

  EXPECT_EQ(set_unit(before, Unit::inch).unit, Unit::inch);
}

TEST(Edits, TheProposedDistanceOfPaperIsALengthInTheDocumentsUnit) {
  Document nothing;
  for (const Unit unit : {Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch}) {
    nothing.unit = unit;
    EXPECT_DOUBLE_EQ(proposed_distance(nothing, {}) * millimetres_per(unit), 0.5) << to_string(unit);
  }
  // One percent of a diagonal, whatever the unit.
  const Document cube = cube_document();
  const double diagonal = world_box(*cube.objects[0]).diagonal().norm();
  EXPECT_NEAR(proposed_distance(cube, unfoldable_objects(cube)), 0.01 * diagonal, 0.005 * diagonal);
}

TEST(Edits, AddDeleteDuplicateAppend) {
  const Document before = rich_document();
  const Added added =
      add_object(before, "New", PolyhedronSource::from_mesh(test::octahedron()).value()).value();
  EXPECT_EQ(added.id, before.next_object_id);
  EXPECT_EQ(added.document.objects.size(), 3U);
  EXPECT_EQ(added.document.objects[0], before.objects[0]);
  EXPECT_NE(added.document.next_object_id, before.next_object_id);
  expect_error(add_object(before, "", PolyhedronSource::from_mesh(test::octahedron()).value()), e_name_empty);

  const Document deleted = delete_objects(added.document, std::vector<ObjectId>{cube_id, added.id}).value();
  ASSERT_EQ(deleted.objects.size(), 1U);
  EXPECT_EQ(deleted.objects[0], before.objects[1]);
  EXPECT_EQ(deleted.next_object_id, added.document.next_object_id) << "ids are not used again";
  expect_error(delete_objects(before, std::vector<ObjectId>{cube_id, {77}}), e_unknown_object);

  const Added copy = duplicate_object(before, cube_id).value();
  ASSERT_EQ(copy.document.objects.size(), 3U);
  EXPECT_EQ(copy.document.objects[1]->id, copy.id);
  EXPECT_EQ(copy.document.objects[1]->name, "Cube 3") << "there is a Cube 2";
  EXPECT_TRUE(copy.document.objects[1]->source == before.objects[0]->source);
  EXPECT_EQ(copy.document.objects[1]->kept, before.objects[0]->kept);
  expect_error(duplicate_object(before, {77}), e_unknown_object);

  const std::string longest(Object::max_name_length - 2, 'x');
  const Document with_long = rename_object(before, cube_id, longest + "é").value();
  const Added long_copy = duplicate_object(with_long, cube_id).value();
  EXPECT_TRUE(check_name(long_copy.document.objects[1]->name));

  const Document both = append_document(before, added.document).value();
  EXPECT_EQ(both.objects.size(), 5U);
  for (const auto& object : both.objects) EXPECT_LT(object->id, both.next_object_id);

  Document full = before;
  full.next_object_id.value = no_index;
  expect_error(duplicate_object(full, cube_id), e_too_many_objects);
  expect_error(append_document(full, before), e_too_many_objects);
  expect_error(add_object(full, "x", PolyhedronSource::from_mesh(test::octahedron()).value()),
               e_too_many_objects);
}

TEST(Edits, LockedObjectsAndOtherKinds) {
  const Document locked = set_locked(rich_document(), cube_id, true).value();
  expect_error(set_alpha(locked, cube_id, Vertices{{0}}, 1), e_locked);
  expect_error(set_mode(locked, cube_id, Mode::paper), e_locked);
  expect_error(set_transform(locked, cube_id, {}), e_locked);
  expect_error(delete_objects(locked, std::vector<ObjectId>{cube_id}), e_locked);
  expect_error(set_source(locked, cube_id, MeshSource{}), e_locked);
  EXPECT_TRUE(set_visible(locked, cube_id, false));
  EXPECT_TRUE(rename_object(locked, cube_id, "x"));
  EXPECT_FALSE(duplicate_object(locked, cube_id).value().document.objects[1]->locked);
  EXPECT_TRUE(set_locked(locked, cube_id, false).value() == rich_document());

  const MeshSource mesh = MeshSource::from_mesh(test::cube()).value();
  const Document other = set_source(rich_document(), cube_id, mesh).value();
  EXPECT_EQ(kind_of(other.objects[0]->source), "mesh");
  expect_error(set_alpha(other, cube_id, Vertices{{0}}, 1), e_wrong_kind);
  expect_error(set_mode(other, cube_id, Mode::paper), e_wrong_kind);
}

TEST(Edits, NothingChangedKeepsTheObjectShared) {
  const Document before = rich_document();
  EXPECT_EQ(set_alpha(before, cube_id, Vertices{{3}}, 4).value().objects[0], before.objects[0]);
  EXPECT_EQ(rename_object(before, cube_id, "Cube").value().objects[0], before.objects[0]);
  EXPECT_EQ(
      move_vertices(before, cube_id, Vertices{{0}}, std::vector<Vector3>{{-1, -1, -1}}).value().objects[0],
      before.objects[0]);
}

TEST(Sources, ChooseTheirOrigin) {
  PolygonMesh far = test::cube();
  for (Vector3& position : far.positions) position += Vector3(1e6, -1e6, 0);
  const PolyhedronSource source = PolyhedronSource::from_mesh(far).value();
  for (Index v = 0; v < 8; ++v) {
    EXPECT_EQ(source.origin + source.polyhedron.position(v), far.positions[v]) << "exactly";
    EXPECT_LE(source.polyhedron.position(v).cwiseAbs().maxCoeff(), 4);
  }
  PolygonMesh bad = test::cube();
  bad.positions[2].y() = nan_value;
  const auto refused = PolyhedronSource::from_mesh(bad);
  expect_error(refused, e_nonfinite);
  EXPECT_EQ(refused.error().element, element_of(VertexId{2}));
  expect_error(PolyhedronSource::from_mesh({}), e_no_faces);
  expect_error(MeshSource::from_mesh({}), e_no_faces);
  expect_error(MeshSource::from_mesh(bad), e_nonfinite);
  PolygonMesh wrong = test::cube();
  wrong.add_face({0, 1});
  expect_error(MeshSource::from_mesh(wrong), e_face_too_small);
  wrong = test::cube();
  wrong.add_face({0, 1, 8});
  expect_error(MeshSource::from_mesh(wrong), e_index_range);
  expect_error(document_from_mesh(test::cube(), ""), e_name_empty);
  expect_error(document_from_mesh({}, "x"), e_no_faces);
}

TEST(Sources, SimilarityAndInverse) {
  test::for_random(5, 50, [](std::mt19937_64& rng) {
    const Similarity s = test::any_object(rng, {1}).transform;
    const Similarity back = s.inverse();
    const Vector3 p = test::random_vector(rng);
    const double size = s.translation.norm() / s.scale + 1;
    EXPECT_LE((back.apply(s.apply(p)) - p).norm(), 1e-14 * size);
  });
}

}  // namespace
}  // namespace hariko
