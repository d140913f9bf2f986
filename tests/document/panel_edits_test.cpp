// Edits that the panels are made of: order of objects, many tensions at once, units, angles.

#include "core/document/angles.hpp"
#include "core/document/convert_unit.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/document/random_documents.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using test::cube_document;
using test::cube_id;
using test::polyhedron_of;

Document row_of(int count) {
  Document document = cube_document();
  while (static_cast<int>(document.objects.size()) < count)
    document = duplicate_object(document, document.objects.back()->id)->document;
  return document;
}

std::vector<std::uint32_t> order_of(const Document& document) {
  std::vector<std::uint32_t> ids;
  for (const auto& object : document.objects) ids.push_back(object->id.value);
  return ids;
}

TEST(ManyObjects, AreHiddenAndLockedAsOneAfterTheOther) {
  Document document = row_of(6);
  document = set_locked(document, document.objects[1]->id, true).value();
  document = set_visible(document, document.objects[2]->id, false).value();
  const std::vector<ObjectId> ids{document.objects[4]->id, document.objects[1]->id, document.objects[2]->id,
                                  document.objects[4]->id};
  Document hidden = document, locked = document, unlocked = document;
  for (const ObjectId id : ids) {
    hidden = set_visible(hidden, id, false).value();
    locked = set_locked(locked, id, true).value();
    unlocked = set_locked(unlocked, id, false).value();
  }
  EXPECT_TRUE(hide_objects(document, ids).value() == hidden);
  EXPECT_TRUE(lock_objects(document, ids, true).value() == locked);
  EXPECT_TRUE(lock_objects(document, ids, false).value() == unlocked);
  EXPECT_EQ(hide_objects(document, ids)->objects[0], document.objects[0]) << "others are shared";
  EXPECT_EQ(hide_objects(document, ids)->objects[2], document.objects[2]) << "it was hidden";
  const ObjectId unknown{document.next_object_id};
  EXPECT_EQ(hide_objects(document, std::span(&unknown, 1)).error().code, e_unknown_object);
}

TEST(MoveMembers, puts_objects_before_a_place) {
  const Document document = row_of(5);
  const auto ids = order_of(document);
  const auto reordered = [&](std::vector<std::size_t> moved, std::size_t place) {
    std::vector<Member> objects;
    for (const std::size_t i : moved) objects.push_back(ObjectId{ids[i]});
    const auto before = place < ids.size() ? std::optional<Member>(ObjectId{ids[place]}) : std::nullopt;
    return order_of(move_members(document, objects, {{}, before}).value());
  };
  using Order = std::vector<std::uint32_t>;
  EXPECT_EQ(reordered({0}, 2), (Order{ids[1], ids[0], ids[2], ids[3], ids[4]}));
  EXPECT_EQ(reordered({4}, 0), (Order{ids[4], ids[0], ids[1], ids[2], ids[3]}));
  EXPECT_EQ(reordered({3, 1}, 5), (Order{ids[0], ids[2], ids[4], ids[1], ids[3]}))
      << "in their present order";
  EXPECT_EQ(reordered({1}, 1), ids);
  EXPECT_EQ(reordered({1}, 2), ids);
  EXPECT_EQ(reordered({}, 3), ids);
  const Member unknown = ObjectId{12345};
  EXPECT_EQ(move_members(document, {&unknown, 1}, {}).error().code.name, e_unknown_object.name);
}

TEST(SetTensions, many_at_once_equal_one_after_the_other) {
  test::for_random(7302, 100, [](std::mt19937_64& rng) {
    const Document start = cube_document();
    const Polyhedron& cube = polyhedron_of(start).polyhedron;
    Document each = start;
    std::vector<VertexId> vertices;
    std::vector<EdgeId> edges;
    std::vector<double> alphas, betas;
    for (int i = test::uniform_int(rng, 0, 12); i > 0; --i) {
      vertices.push_back(cube.vertex_id(static_cast<Index>(test::uniform_int(rng, 0, 7))));
      alphas.push_back(test::chance(rng, 0.3) ? 0 : test::uniform(rng, 0, 100));
      edges.push_back(cube.edge_id(static_cast<Index>(test::uniform_int(rng, 0, 11))));
      betas.push_back(test::chance(rng, 0.3) ? 1 : test::uniform(rng, 0.1, 100));
    }
    each = set_alpha(each, cube_id, std::vector{VertexId{3}, VertexId{5}}, 7).value();
    each = set_beta(each, cube_id, std::vector{cube.edge_id(2), cube.edge_id(8)}, 7).value();
    Document at_once = set_alphas(each, cube_id, vertices, alphas).value();
    at_once = set_betas(at_once, cube_id, edges, betas).value();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      each = set_alpha(each, cube_id, {&vertices[i], 1}, alphas[i]).value();
      each = set_beta(each, cube_id, {&edges[i], 1}, betas[i]).value();
    }
    EXPECT_TRUE(at_once == each);
  });
}

TEST(SetTensions, refuses_one_bad_value_of_many) {
  const Document document = cube_document();
  const std::vector<VertexId> vertices{{0}, {1}};
  EXPECT_EQ(set_alphas(document, cube_id, vertices, std::vector{1.0, -1.0}).error().code.name,
            "E_TENSION_NEGATIVE");
  const std::vector<VertexId> unknown{{0}, {99}};
  EXPECT_EQ(set_alphas(document, cube_id, unknown, std::vector{1.0, 1.0}).error().code.name,
            e_unknown_element.name);
}

TEST(ConvertUnit, keeps_every_size) {
  Document document = cube_document();
  Similarity place{.scale = 2, .translation = {10, 20, 30}};
  document = set_transform(document, cube_id, place).value();
  PolyhedronSource mirrored = polyhedron_of(document);
  Shaping shaping = *mirrored.shaping;
  shaping.pin.set(VertexId{0}, {Pin::Kind::tangents, {{1, 0, 0}, {0, 2, 0}}});
  mirrored.shaping = std::move(shaping);
  mirrored.mirror = Mirror{Axis::x, 0.5};
  document = set_source(document, cube_id, mirrored).value();
  document = set_locked(document, cube_id, true).value();
  const Document converted = convert_unit(document, Unit::centimetre).value();
  EXPECT_EQ(converted.unit, Unit::centimetre);
  const auto world = [](const Document& of, Index v) {
    const Object& object = *of.find(cube_id);
    return Vector3(
        millimetres_per(of.unit) *
        object.transform.apply(polyhedron_of(of).origin + polyhedron_of(of).polyhedron.position(v)));
  };
  for (Index v = 0; v < polyhedron_of(document).polyhedron.vertex_count(); ++v)
    EXPECT_LT((world(document, v) - world(converted, v)).norm(), 1e-12);
  EXPECT_EQ(converted.find(cube_id)->transform.scale, 2) << "lengths are converted, factors are not";
  EXPECT_NEAR(polyhedron_of(converted).mirror->weld_distance, 0.05, 1e-15);
  EXPECT_NEAR(polyhedron_of(converted).shaping->pin.find(VertexId{0})->vectors[1].y(), 0.2, 1e-15);
  EXPECT_TRUE(convert_unit(document, Unit::millimetre).value() == document);
  const Document back = convert_unit(converted, Unit::millimetre).value();
  for (Index v = 0; v < 8; ++v) EXPECT_LT((world(document, v) - world(back, v)).norm(), 1e-12);
}

TEST(Angles, come_back_as_the_same_rotation) {
  test::for_random(7303, 300, [](std::mt19937_64& rng) {
    const Vector3 degrees(test::uniform(rng, -180, 180), test::uniform(rng, -90, 90),
                          test::uniform(rng, -180, 180));
    EXPECT_LT((angles_of(rotation_of(degrees)) - degrees).norm(), 1e-6);
  });
  for (const double y : {90.0, -90.0}) {
    const Eigen::Quaterniond rotation = rotation_of({30, y, 40});
    EXPECT_LT(rotation.angularDistance(rotation_of(angles_of(rotation))), 1e-6)
        << "x and z are one axis here";
  }
  EXPECT_EQ(angles_of(Eigen::Quaterniond::Identity()), Vector3::Zero().eval());
}

}  // namespace
}  // namespace hariko
