// Live copies: where the places are, what moves them, and how files keep them.

#include "core/document/live_copies.hpp"

#include <cmath>

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/format/format.hpp"
#include "core/document/object_box.hpp"
#include "core/modeling/objects/arrange.hpp"
#include "core/modeling/objects/transformation.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

Similarity any_place_of_copies(std::mt19937_64& rng) {
  Similarity out;
  out.rotation = Eigen::Quaterniond(test::uniform(rng, 0.1, 1), test::uniform(rng, -1, 1),
                                    test::uniform(rng, -1, 1), test::uniform(rng, -1, 1))
                     .normalized();
  out.scale = test::log_uniform(rng, 0.1, 10);
  out.translation = test::random_vector(rng, 10);
  return out;
}

/// An array of each kind.
std::vector<CopyArray> some_arrays(std::mt19937_64& rng) {
  ListOfCopies list;
  for (int k = 0; k < 3; ++k) {
    list.places.push_back(any_place_of_copies(rng));
    list.places.back().scale = 1;
  }
  return {RowOfCopies{test::uniform_int(rng, 2, 5), test::random_vector(rng, 5)},
          RingOfCopies{test::uniform_int(rng, 2, 5), test::random_vector(rng, 5),
                       test::random_vector(rng) + Vector3(0, 0, 2), test::uniform(rng, 10, 300)},
          list, MirrorOfCopies{test::random_vector(rng, 5), test::random_vector(rng) + Vector3(0, 0, 2)}};
}

Document document_with_copies(const Similarity& place, LiveCopies copies) {
  const Document document = document_from_mesh(test::prism(5), "Cup").value();
  const ObjectId id = document.objects[0]->id;
  return set_copies(set_transform(document, id, place).value(), id, std::move(copies)).value();
}

double far_apart(const Similarity& a, const Similarity& b) {
  double out = 0;
  for (const Vector3& p : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)})
    out = std::max(out, (a.apply(p) - b.apply(p)).norm());
  return out;
}

TEST(LiveCopies, AnObjectWithoutThemHasOnePlace) {
  const Document document = document_from_mesh(test::cube(), "Box").value();
  const Object& box = *document.objects[0];
  EXPECT_EQ(place_count(box), 1U);
  EXPECT_EQ(places_of(box), std::vector{box.transform});
  EXPECT_EQ(name_of_place(box, 0), "Box");
  EXPECT_EQ(name_of_place(box, 2), "Box (3)");
}

TEST(LiveCopies, StandInRowsRingsAndListsOfTheObjectsSpace) {
  const auto places = [](const CopyArray& array) {
    return places_of(*document_with_copies({}, {array}).objects[0]);
  };
  const auto row = places(RowOfCopies{4, Vector3(2, 0, 1)});
  ASSERT_EQ(row.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(row[k].translation, double(k) * Vector3(2, 0, 1));
  const auto ring = places(RingOfCopies{4, Vector3(1, 0, 0), Vector3(0, 0, 3), 360});
  ASSERT_EQ(ring.size(), 4U);
  EXPECT_LT((ring[1].translation - Vector3(1, -1, 0)).norm(), 1e-12) << "a quarter turn about x = 1";
  EXPECT_LT((ring[2].apply({0, 0, 5}) - Vector3(2, 0, 5)).norm(), 1e-12);
  const auto arc = places(RingOfCopies{3, Vector3::Zero(), Vector3::UnitZ(), -90});
  EXPECT_LT((arc[2].apply({1, 0, 0}) - Vector3(0, -1, 0)).norm(), 1e-12) << "both ends of an arc";
  Similarity there{.translation = {7, 8, 9}};
  EXPECT_EQ(places(ListOfCopies{{there}})[1], there);
}

TEST(LiveCopies, MayBeTheMirrorImageInAPlane) {
  test::for_random(816, 20, [](std::mt19937_64& rng) {
    const Vector3 point = test::random_vector(rng, 5), across = test::random_vector(rng) + Vector3(0, 0, 2);
    const Vector3 normal = across.normalized();
    const Document document = document_with_copies({}, {MirrorOfCopies{point, across}});
    const auto places = places_of(*document.objects[0]);
    ASSERT_EQ(places.size(), 2U);
    EXPECT_FALSE(places[0].mirrors());
    EXPECT_TRUE(places[1].mirrors());
    EXPECT_EQ(places[1].length_scale(), 1);
    for (int i = 0; i < 5; ++i) {
      const Vector3 p = test::random_vector(rng, 5);
      const Vector3 image = p - 2 * normal.dot(p - point) * normal;
      EXPECT_LT((places[1].apply(p) - image).norm(), 1e-12);
      EXPECT_LT((places[1].inverse().apply(image) - p).norm(), 1e-12);
      // Outward stays outward: the normal of a facet is reflected with it.
      const Vector3 outward = p.normalized();
      EXPECT_LT((places[1].apply_to_normal(outward) - (outward - 2 * normal.dot(outward) * normal)).norm(),
                1e-12);
    }
  });
}

TEST(LiveCopies, OfAMirroredRowAreTheRowAndItsImage) {
  const Document document =
      document_with_copies({}, {RowOfCopies{3, {5, 0, 0}}, MirrorOfCopies{{0, 10, 0}, {0, 1, 0}}});
  const auto places = places_of(*document.objects[0]);
  ASSERT_EQ(places.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(places[k].mirrors(), k >= 3);
    EXPECT_LT((places[k].translation - Vector3(5.0 * double(k % 3), k < 3 ? 0 : 20, 0)).norm(), 1e-12);
  }
  // The image of an image is not mirrored.
  const Document twice =
      document_with_copies({}, {MirrorOfCopies{{0, 0, 0}, {1, 0, 0}}, MirrorOfCopies{{0, 0, 0}, {0, 1, 0}}});
  const auto four = places_of(*twice.objects[0]);
  ASSERT_EQ(four.size(), 4U);
  EXPECT_TRUE(four[1].mirrors() && four[2].mirrors() && !four[3].mirrors());
  EXPECT_LT((four[3].apply({1, 2, 3}) - Vector3(-1, -2, 3)).norm(), 1e-12) << "a half turn";
}

/// A source that is reflected first stands at a place that does not mirror.
TEST(LiveCopies, OfMirrorsAreReflectedSourcesElsewhere) {
  test::for_random(817, 20, [](std::mt19937_64& rng) {
    const Similarity place = composed(any_place_of_copies(rng), reflection_in({1, 2, 3}, Vector3::UnitY()));
    ASSERT_TRUE(place.mirrors());
    for (int axis = 0; axis < 3; ++axis) {
      const Similarity other = place_of_reflected(place, axis);
      EXPECT_FALSE(other.mirrors());
      const Vector3 p = test::random_vector(rng, 5);
      Vector3 reflected = p;
      reflected[axis] = -reflected[axis];
      EXPECT_LT((other.apply(reflected) - place.apply(p)).norm(), 1e-10);
    }
  });
}

TEST(LiveCopies, OfARowAreAGrid) {
  const Document document = document_with_copies({}, {RowOfCopies{3, {5, 0, 0}}, RowOfCopies{2, {0, 7, 0}}});
  const Object& object = *document.objects[0];
  EXPECT_EQ(place_count(object), 6U);
  const auto places = places_of(object);
  ASSERT_EQ(places.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_EQ(places[k].translation, Vector3(5.0 * double(k % 3), 7.0 * double(k / 3), 0));
}

/// An array of the document's space stands there, whatever the place of the object.
TEST(LiveCopies, AreGivenInTheDocumentsSpace) {
  test::for_random(811, 20, [](std::mt19937_64& rng) {
    const Similarity place = any_place_of_copies(rng);
    for (const CopyArray& array : some_arrays(rng)) {
      const Document plain = document_with_copies(place, {});
      const ObjectId id = plain.objects[0]->id;
      const auto made = test::must(add_live_copies(plain, std::span(&id, 1), array));
      const auto motions = places_of(*document_with_copies({}, {array}).objects[0]);
      const auto places = places_of(*made->objects[0]);
      ASSERT_EQ(places.size(), motions.size());
      EXPECT_EQ(places[0], place);
      for (std::size_t k = 0; k < places.size(); ++k) {
        EXPECT_LT(far_apart(places[k], composed(motions[k], place)), 1e-10);
        EXPECT_DOUBLE_EQ(places[k].length_scale(), place.scale);
      }
    }
  });
}

/// Whatever is done to the object as a whole is done to all that is seen of it.
TEST(LiveCopies, GoAlongWithTheirObject) {
  test::for_random(812, 20, [](std::mt19937_64& rng) {
    for (const CopyArray& array : some_arrays(rng)) {
      const Document before = document_with_copies(any_place_of_copies(rng), {array});
      Transformation change;
      change.translation = test::random_vector(rng, 5);
      change.axis = (test::random_vector(rng) + Vector3(0, 0, 2)).normalized();
      change.degrees = test::uniform(rng, -170, 170);
      change.factors = Vector3::Constant(test::uniform(rng, 0.3, 3));
      const Vector3 pivot = test::random_vector(rng, 5);
      const auto after = test::must(transform_object(before, before.objects[0]->id, change, pivot));
      const auto from = places_of(*before.objects[0]), to = places_of(*after->objects[0]);
      ASSERT_EQ(from.size(), to.size());
      for (std::size_t k = 0; k < from.size(); ++k)
        for (const Vector3& p : {Vector3(0, 0, 0), Vector3(1, 2, 3)})
          EXPECT_LT((to[k].apply(p) - change.apply(from[k].apply(p), pivot)).norm(), 1e-9);
    }
  });
}

/// Mirrors and stretched rows are exact images as well; the source itself is then another one.
TEST(LiveCopies, OfMirroredAndStretchedObjectsStandWhereTheirImagesAre) {
  test::for_random(813, 20, [](std::mt19937_64& rng) {
    for (const CopyArray& array : some_arrays(rng))
      for (const bool mirrors : {true, false}) {
        if (!mirrors && !std::holds_alternative<RowOfCopies>(array)) continue;
        const Document before = document_with_copies(any_place_of_copies(rng), {array});
        Transformation change;
        change.factors = mirrors ? Vector3(-1, 1, 1) : Vector3(2, 0.5, 3);
        const auto after = transform_object(before, before.objects[0]->id, change, Vector3(1, 2, 3));
        ASSERT_TRUE(after.ok()) << to_string(after.error());
        const auto points = [](const Document& document, std::size_t place) {
          const Object& object = *document.objects[0];
          std::vector<Vector3> out;
          for (Index v = 0; v < object.polyhedron()->polyhedron.vertex_count(); ++v)
            out.push_back(places_of(object)[place].apply(object.cage_origin() +
                                                         object.polyhedron()->polyhedron.position(v)));
          return out;
        };
        for (std::size_t k = 0; k < place_count(*before.objects[0]); ++k) {
          const auto from = points(before, k), to = points(*after, k);
          for (std::size_t v = 0; v < from.size(); ++v)
            EXPECT_LT((to[v] - change.apply(from[v], Vector3(1, 2, 3))).norm(), 1e-9);
        }
      }
  });
}

TEST(LiveCopies, FollowTheUnit) {
  const Document before = document_with_copies({}, {RowOfCopies{3, {20, 0, 0}}, RingOfCopies{2, {0, 10, 0}}});
  const auto after = test::must(convert_unit(before, Unit::centimetre));
  const auto from = places_of(*before.objects[0]), to = places_of(*after->objects[0]);
  for (std::size_t k = 0; k < from.size(); ++k)
    EXPECT_LT((to[k].translation - from[k].translation / 10).norm(), 1e-12);
}

TEST(LiveCopies, AreInTheBox) {
  const Document row = document_with_copies({}, {RowOfCopies{5, {10, 0, 0}}});
  const Object& object = *row.objects[0];
  const Eigen::AlignedBox3d own = box_at_own_place(object), all = world_box(object);
  EXPECT_EQ(all.min(), own.min());
  EXPECT_EQ(all.max(), Vector3(own.max() + Vector3(40, 0, 0)));
  const Document ring = document_with_copies({}, {RingOfCopies{2, {10, 0, 0}}});
  EXPECT_NEAR(world_box(*ring.objects[0]).max().x(), 20 - own.min().x(), 1e-12) << "turned to the other side";
  const Document mirror = document_with_copies({}, {MirrorOfCopies{{10, 0, 0}, {2, 0, 0}}});
  EXPECT_NEAR(world_box(*mirror.objects[0]).max().x(), 20 - own.min().x(), 1e-12) << "behind the plane";
  EXPECT_NEAR(world_box(*mirror.objects[0]).max().y(), own.max().y(), 1e-12);
}

TEST(LiveCopies, ThatCannotBeAreRefused) {
  const Document document = document_from_mesh(test::cube(), "Box").value();
  const ObjectId id = document.objects[0]->id;
  Similarity scaled, far;
  scaled.scale = 2;
  far.translation.x() = INFINITY;
  const std::vector<LiveCopies> wrong{{RowOfCopies{1}},
                                      {RowOfCopies{10001}},
                                      {RowOfCopies{-3}},
                                      {RowOfCopies{3, Vector3::Zero()}},
                                      {RowOfCopies{101}, RowOfCopies{100}},
                                      {RingOfCopies{3, Vector3::Zero(), Vector3::Zero()}},
                                      {RingOfCopies{3, Vector3::Zero(), {0, 0, 1}, 0}},
                                      {RingOfCopies{3, Vector3::Zero(), {0, 0, 1}, 361}},
                                      {ListOfCopies{}},
                                      {ListOfCopies{{scaled}}},
                                      {ListOfCopies{{far}}},
                                      {MirrorOfCopies{Vector3::Zero(), Vector3::Zero()}},
                                      {MirrorOfCopies{{0, INFINITY, 0}, {0, 0, 1}}}};
  for (const LiveCopies& copies : wrong) {
    test::must_fail(set_copies(document, id, copies), e_copies_invalid);
  }
  ASSERT_TRUE(set_copies(document, id, {RowOfCopies{100}, RowOfCopies{100}}).ok());
  const auto locked = set_locked(document, id, true);
  EXPECT_EQ(set_copies(*locked, id, {RowOfCopies{}}).error().code, e_locked);
  const Document unknown =
      add_object({}, "Thing", Source(UnknownSource{"cloud", std::string("{}")}))->document;
  EXPECT_EQ(set_copies(unknown, unknown.objects[0]->id, {RowOfCopies{}}).error().code, e_no_live_copies);
}

/// The source of an image is reflected, so that the object is as it was seen, and looks outward.
TEST(LiveCopies, OfMirrorsBecomeReflectedObjects) {
  test::for_random(818, 10, [](std::mt19937_64& rng) {
    const CopyArray mirror{MirrorOfCopies{test::random_vector(rng, 5), test::random_vector(rng)}};
    const Document before = document_with_copies(any_place_of_copies(rng), {mirror});
    const Object& own = *before.objects[0];
    const auto made = test::must(copies_to_objects(before, std::span(&own.id, 1)));
    ASSERT_EQ(made->document.objects.size(), 2U);
    const Object& image = *made->document.objects[1];
    EXPECT_FALSE(image.transform.mirrors());
    EXPECT_TRUE(set_transform(made->document, image.id, image.transform).ok());
    const Polyhedron &from = own.polyhedron()->polyhedron, &to = image.polyhedron()->polyhedron;
    const Similarity place = places_of(own)[1];
    for (Index v = 0; v < from.vertex_count(); ++v) {
      const Vector3 there = to.position(to.find(from.vertex_id(v)));
      EXPECT_LT((image.transform.apply(image.cage_origin() + there) -
                 place.apply(own.cage_origin() + from.position(v)))
                    .norm(),
                1e-9);
    }
    const auto before_it = closed_component_volumes(from.topology(), from.positions()),
               volumes = closed_component_volumes(to.topology(), to.positions());
    ASSERT_EQ(volumes.size(), 1U);
    EXPECT_NEAR(volumes[0], before_it[0], 1e-9) << "the faces look outward";
  });
}

TEST(LiveCopies, BecomeObjectsAtTheSamePlaces) {
  test::for_random(814, 10, [](std::mt19937_64& rng) {
    const auto arrays = some_arrays(rng);
    const Document before = document_with_copies(any_place_of_copies(rng), {arrays[0], arrays[1]});
    const ObjectId id = before.objects[0]->id;
    const auto places = places_of(*before.objects[0]);
    const auto made = test::must(copies_to_objects(before, std::span(&id, 1)));
    ASSERT_EQ(made->document.objects.size(), places.size());
    EXPECT_EQ(made->ids.size(), places.size() - 1);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Object& object = *made->document.objects[k];
      EXPECT_LT(far_apart(object.transform, places[k]), 1e-12 * (1 + places[k].translation.norm()));
      EXPECT_TRUE(object.copies->empty());
      EXPECT_TRUE(object.source == before.objects[0]->source);
    }
    EXPECT_EQ(made->document.objects[0]->id, id) << "the original stays, and is the first";
    EXPECT_EQ(copies_to_objects(made->document, std::span(&id, 1)).error().code, e_no_live_copies);
  });
}

TEST(LiveCopies, AreKeptInFiles) {
  test::for_random(815, 20, [](std::mt19937_64& rng) {
    const Document document = document_with_copies(any_place_of_copies(rng), some_arrays(rng));
    const std::string text = write_document(document);
    const auto read = test::must(read_document(text));
    EXPECT_EQ(*read, document);
    EXPECT_EQ(write_document(*read), text);
  });
  // Files of objects without live copies say nothing of them.
  EXPECT_EQ(write_document(document_from_mesh(test::cube(), "Box").value()).find("copies"),
            std::string::npos);
}

TEST(LiveCopies, ThatFilesDescribeWronglyAreRefused) {
  const std::string text = write_document(document_with_copies({}, {RowOfCopies{3, {4, 0, 0}}}));
  const std::string row = "{\"kind\": \"row\", \"count\": 3, \"step\": [4, 0, 0]}";
  ASSERT_NE(text.find(row), std::string::npos) << text;
  const auto with = [&](const std::string& other) {
    std::string changed = text;
    changed.replace(changed.find(row), row.size(), other);
    const auto read = read_document(changed);
    return read.ok() ? std::string() : to_string(read.error());
  };
  EXPECT_EQ(with("{\"kind\": \"ring\", \"count\": 3, \"point\": [0, 0, 0], \"direction\": [0, 0, 1], "
                 "\"angle\": 90}"),
            "");
  for (const char* wrong :
       {"{\"kind\": \"row\", \"count\": 1, \"step\": [4, 0, 0]}", "{\"kind\": \"row\", \"count\": 3}",
        "{\"kind\": \"row\", \"count\": 3, \"step\": [0, 0, 0]}",
        "{\"kind\": \"row\", \"count\": 3, \"step\": [4, 0, 0], \"turn\": 1}", "{\"kind\": \"heap\"}",
        "{\"kind\": \"list\", \"places\": []}", "{\"kind\": \"mirror\", \"point\": [0, 0, 0]}",
        "{\"kind\": \"mirror\", \"point\": [0, 0, 0], \"normal\": [0, 0, 0]}", "7"})
    EXPECT_NE(with(wrong).find("copies"), std::string::npos) << wrong << ": " << with(wrong);
}

}  // namespace
}  // namespace hariko
