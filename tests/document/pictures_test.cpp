// Reference pictures in the document: what comes back from files, what is refused, where files are looked
// for, and edits.

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "core/document/format/format.hpp"
#include "core/document/history/memory.hpp"
#include "core/document/history/recovery.hpp"
#include "core/document/object_box.hpp"
#include "tests/document/random_documents.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

PictureSource photograph(std::string path = "/photographs/side.jpg") {
  PictureSource picture;
  picture.path = std::move(path);
  picture.columns = 4000;
  picture.rows = 3000;
  picture.width = 240;
  return picture;
}

Added with_picture(PictureSource picture, const Similarity& transform = {}) {
  return add_picture({}, "Side", std::move(picture), transform).value();
}

const PictureSource& picture_of(const Document& document, std::size_t number = 0) {
  return *document.objects[number]->picture();
}

template <class T>
std::string code_of(const Result<T>& result) {
  return result ? std::string() : std::string(result.error().code.name);
}

TEST(Pictures, EveryFieldComesBackFromText) {
  PictureSource picture = photograph("/π/\"side\" view.png");
  picture.bytes = std::string("\x89PNG\0\xff", 6);
  picture.look = {0.25, PictureLayer::front, PictureSide::left};
  const Document document = with_picture(picture).document;
  const auto again = test::must(read_document(write_document(document)));
  EXPECT_TRUE(*again == document);
  EXPECT_EQ(picture_of(*again), picture);
  EXPECT_EQ(write_document(*again), write_document(document));
}

TEST(Pictures, WhatIsWrongInAFileIsRefusedByItsPlace) {
  PictureSource picture = photograph();
  picture.bytes = std::string("PNG");
  const std::string good = write_document(with_picture(picture).document);
  ASSERT_TRUE(read_document(good));
  const std::pair<const char*, const char*> changes[] = {{"\"/photographs/side.jpg\"", "\"\""},
                                                         {"\"/photographs/side.jpg\"", "\"a\\u0000b\""},
                                                         {"\"/photographs/side.jpg\"", "3"},
                                                         {"[4000, 3000]", "[0, 3000]"},
                                                         {"[4000, 3000]", "[4000]"},
                                                         {"\"width\": 240", "\"width\": 0"},
                                                         {"\"width\": 240", "\"width\": -1"},
                                                         {"\"opacity\": 0.6", "\"opacity\": 1.5"},
                                                         {"\"layer\": \"space\"", "\"layer\": \"sideways\""},
                                                         {"\"UE5H\"", "\"UE5*\""},
                                                         {"\"UE5H\"", "\"UE5\""},
                                                         {"\"UE5H\"", "\"\""}};
  for (const auto& [from, to] : changes) {
    std::string text = good;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, std::string(from).size(), to);
    const auto read = read_document(text);
    EXPECT_EQ(code_of(read), "E_SCHEMA") << from << " -> " << to;
    if (!read)
      EXPECT_NE(read.error().text.find("objects[0].source"), std::string::npos) << to_string(read.error());
  }
}

TEST(Pictures, EditsRefuseWhatNoFileCouldHold) {
  const auto refused = [](auto&& change) {
    PictureSource picture = photograph();
    change(picture);
    return code_of(add_picture({}, "Side", picture, {}));
  };
  EXPECT_EQ(refused([](PictureSource& p) { p.path = "\xff.png"; }), "E_PICTURE_INVALID") << "no UTF-8";
  EXPECT_EQ(refused([](PictureSource& p) { p.path.clear(); }), "E_PICTURE_INVALID");
  EXPECT_EQ(refused([](PictureSource& p) { p.rows = 0; }), "E_PICTURE_INVALID");
  EXPECT_EQ(refused([](PictureSource& p) { p.width = std::nan(""); }), "E_PICTURE_INVALID");
  EXPECT_EQ(refused([](PictureSource& p) { p.look.opacity = -0.1; }), "E_PICTURE_INVALID");
  EXPECT_EQ(refused([](PictureSource&) {}), "");
  const Document cube = test::cube_document();
  EXPECT_EQ(code_of(set_picture_look(cube, test::cube_id, {})), "E_WRONG_KIND");
  EXPECT_EQ(code_of(set_picture_look(cube, ObjectId{99}, {})), "E_UNKNOWN_OBJECT");
}

TEST(Pictures, ALinkGoesFromTheFolderOfTheDocument) {
  const test::TemporaryFolder folder;
  const auto model = folder.path() / "work", other = folder.path() / "else" / "where",
             pictures = model / "pictures";
  for (const auto& path : {model, other, pictures}) std::filesystem::create_directories(path);
  const std::string file = (pictures / "side.png").generic_string();
  const Document document = with_picture(photograph(file)).document;
  ASSERT_TRUE(save_document(document, model / "cup.hariko"));
  EXPECT_NE(test::slurp(model / "cup.hariko").find("\"path\": \"pictures/side.png\""), std::string::npos);
  EXPECT_TRUE(load_document(model / "cup.hariko").value() == document) << "absolute again";
  // Saved elsewhere it still shows the same file.
  ASSERT_TRUE(save_document(document, other / "cup.hariko"));
  EXPECT_NE(test::slurp(other / "cup.hariko").find("\"path\": \"../../work/pictures/side.png\""),
            std::string::npos);
  EXPECT_TRUE(load_document(other / "cup.hariko").value() == document);
  // Moved together with its pictures it shows those.
  std::filesystem::rename(model, folder.path() / "moved");
  EXPECT_EQ(picture_of(load_document(folder.path() / "moved" / "cup.hariko").value()).path,
            (folder.path() / "moved" / "pictures" / "side.png").generic_string());
}

TEST(Pictures, FoldersWhoseNamesAreNoUtf8CostNoDocument) {
  const test::TemporaryFolder folder;
  const auto odd = folder.path() / "\x8e\xca", other = folder.path() / "other", kept = folder.path() / "kept";
  for (const auto& path : {odd, other, kept}) std::filesystem::create_directories(path);
  ASSERT_TRUE(save_document(with_picture(photograph("side.png")).document, odd / "cup.hariko"));
  const Document document = load_document(odd / "cup.hariko").value();
  EXPECT_EQ(picture_of(document).path, (odd / "side.png").generic_string());
  ASSERT_TRUE(save_document(document, odd / "cup.hariko"));
  EXPECT_TRUE(load_document(odd / "cup.hariko").value() == document);
  // No other file can name that folder.
  ASSERT_TRUE(save_document(document, other / "cup.hariko"));
  EXPECT_EQ(picture_of(load_document(other / "cup.hariko").value()).path,
            (other / "side.png").generic_string());
  SystemFileLayer layer;
  ASSERT_TRUE(write_recovery(kept, document, {odd / "cup.hariko", {}, 1}, layer));
  const auto copy = test::must(read_recovery(kept));
  EXPECT_TRUE(with_absolute_pictures(copy->document, odd) == document);
}

TEST(Pictures, PackedNamesStayAsTheyAre) {
  PictureSource picture = photograph("side.png");
  picture.bytes = std::string("PNG");
  const Document document = with_picture(picture).document;
  EXPECT_EQ(picture_of(with_absolute_pictures(document, "/work")).path, "side.png");
  EXPECT_EQ(picture_of(with_relative_pictures(document, "/work")).path, "side.png");
}

TEST(Pictures, ADocumentHasRoomForAHundredMebibytes) {
  const Shared<std::string> half(std::string(max_packed_pictures / 2, 'x'));
  Document document;
  for (int i = 0; i < 3; ++i) document = add_picture(document, "Side", photograph("side.png"), {})->document;
  const auto pack = [&](const Document& before, std::size_t number, const Shared<std::string>& bytes) {
    return set_picture_file(before, before.objects[number]->id, {"side.png", bytes, 4, 3});
  };
  const auto first = pack(document, 0, half);
  const auto second = pack(first.value(), 1, half);
  ASSERT_TRUE(second) << "just full";
  EXPECT_EQ(packed_picture_bytes(*second), max_packed_pictures);
  const auto third = pack(*second, 2, std::string("x"));
  ASSERT_EQ(code_of(third), "E_PICTURES_TOO_LARGE");
  EXPECT_NE(third.error().remedy.find("linked"), std::string::npos);
  EXPECT_EQ(code_of(pack(document, 0, std::string(max_packed_pictures + 1, 'x'))), "E_PICTURES_TOO_LARGE");
  // Copies share their bytes in memory.
  SharedMemory memory;
  memory.add(*second);
  EXPECT_LT(memory.bytes(), max_packed_pictures / 2 + 100'000);
  const auto again = test::must(read_document(write_document(*second)));
  EXPECT_TRUE(*again == *second);
}

TEST(Pictures, CopiesAndAppendedDocumentsKeepToTheRoom) {
  PictureSource picture = photograph("side.png");
  picture.bytes = std::string(max_packed_pictures / 2, 'x');
  const Added one = with_picture(picture);
  const auto two = duplicate_object(one.document, one.id);
  ASSERT_TRUE(two) << "just full";
  EXPECT_EQ(code_of(duplicate_object(two->document, one.id)), "E_PICTURES_TOO_LARGE");
  EXPECT_EQ(code_of(duplicate_objects(one.document, std::span(&one.id, 1), 2)), "E_PICTURES_TOO_LARGE");
  EXPECT_TRUE(append_document(one.document, one.document));
  EXPECT_EQ(code_of(append_document(two->document, one.document)), "E_PICTURES_TOO_LARGE");
}

TEST(Pictures, TwoPointsGetTheirLength) {
  test::for_random(1, 100, [](std::mt19937_64& rng) {
    Similarity place;
    place.rotation = Eigen::Quaterniond(test::uniform(rng, 0.1, 1), test::uniform(rng, -1, 1),
                                        test::uniform(rng, -1, 1), test::uniform(rng, -1, 1))
                         .normalized();
    place.scale = test::log_uniform(rng, 1e-3, 1e3);
    place.translation = 100 * test::random_vector(rng);
    const Added added = with_picture(photograph(), place);
    // Points of the picture, in its own lengths.
    const Vector3 own_a(test::uniform(rng, -120, 120), test::uniform(rng, -90, 90), 0),
        own_b(test::uniform(rng, -120, 120), test::uniform(rng, -90, 90), 0);
    const double length = test::log_uniform(rng, 1e-2, 1e4);
    const auto scaled =
        test::must(scale_picture(added.document, added.id, place.apply(own_a), place.apply(own_b), length));
    const Similarity& now = scaled->objects[0]->transform;
    EXPECT_NEAR((now.apply(own_b) - now.apply(own_a)).norm(), length, 1e-9 * length);
    const double size = place.scale * 240 + place.translation.norm() + length;
    EXPECT_LT((now.apply(own_a) - place.apply(own_a)).norm(), 1e-9 * size) << "the first point stays";
  });
}

TEST(Pictures, PointsAtOnePlaceAndLockedPicturesAreNotScaled) {
  const Added added = with_picture(photograph());
  const Vector3 a(1, 2, 0), b(3, 4, 0);
  const auto code = [&](const Document& document, const Vector3& to, double length) {
    return code_of(scale_picture(document, added.id, a, to, length));
  };
  EXPECT_EQ(code(added.document, a, 5), "E_PICTURE_INVALID");
  EXPECT_EQ(code(added.document, b, 0), "E_PICTURE_INVALID");
  EXPECT_EQ(code(added.document, b, -5), "E_PICTURE_INVALID");
  EXPECT_EQ(code(added.document, b, 1e300), "E_TRANSFORM_INVALID");
  const Document locked = set_locked(added.document, added.id, true).value();
  EXPECT_EQ(code(locked, b, 5), "E_LOCKED");
  EXPECT_EQ(code_of(face_picture(locked, added.id, PictureSide::top)), "E_LOCKED");
  EXPECT_TRUE(set_picture_look(locked, added.id, {0.2, PictureLayer::behind, {}})) << "nothing moves";
}

TEST(Pictures, FacingASideKeepsTheTurnOfWhatFacesIt) {
  for (const PictureSide side : {PictureSide::front, PictureSide::back, PictureSide::left, PictureSide::right,
                                 PictureSide::top, PictureSide::bottom}) {
    EXPECT_EQ(faced_side(facing(side)), side);
    Similarity turned;
    turned.rotation = facing(side) * Eigen::AngleAxisd(0.7, Vector3::UnitZ());
    const Added added = with_picture(photograph(), turned);
    EXPECT_EQ(faced_side(turned.rotation), side);
    EXPECT_TRUE(face_picture(added.document, added.id, side).value() == added.document);
    const PictureSide other = side == PictureSide::top ? PictureSide::left : PictureSide::top;
    PictureLook bound;
    bound.only_from = side;
    const Document moved =
        face_picture(set_picture_look(added.document, added.id, bound).value(), added.id, other).value();
    EXPECT_EQ(faced_side(moved.objects[0]->transform.rotation), other);
    EXPECT_EQ(picture_of(moved).look.only_from, other) << "the view it belongs to follows";
  }
  EXPECT_FALSE(faced_side(Eigen::Quaterniond(Eigen::AngleAxisd(0.01, Vector3::UnitX()))));
}

TEST(Pictures, AnotherUnitKeepsTheirSize) {
  Similarity place{.scale = 2, .translation = {1, 2, 3}};
  const Added added = with_picture(photograph(), place);
  const auto in_inches = convert_unit(added.document, Unit::inch).value();
  const auto before = world_box(*added.document.objects[0]), after = world_box(*in_inches.objects[0]);
  EXPECT_LT((after.min() * 25.4 - before.min()).norm(), 1e-9);
  EXPECT_LT((after.max() * 25.4 - before.max()).norm(), 1e-9);
  EXPECT_NEAR(before.sizes().x(), 480, 1e-9);
  EXPECT_NEAR(before.sizes().y(), 360, 1e-9);
}

}  // namespace
}  // namespace hariko
