// Files of reference pictures: PNG, JPEG and WebP, upright, with their smaller versions.

#include "render/reference_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/files/file_io.hpp"
#include "core/document/picture_source.hpp"
#include "render/read_photo.hpp"
#include "render/scene.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

std::string file_bytes(const std::string& name) {
  return read_file(test::source_folder() + "/tests/render/pictures/" + name).value();
}

/// 'r', 'g', 'b', 'w' or '?' of a pixel, whatever the compression did to it.
char colour_at(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  const bool red = p[0] > 190, green = p[1] > 190, blue = p[2] > 190;
  const bool none = p[0] < 70 || p[1] < 70 || p[2] < 70;
  if (red && green && blue) return 'w';
  if (!none) return '?';
  return red ? 'r' : green ? 'g' : blue ? 'b' : '?';
}
/// Upper left, upper right, lower left, lower right.
std::string quadrants(const Image& image) {
  const int w = image.width, h = image.height;
  return {colour_at(image, w / 4, h / 4), colour_at(image, 3 * w / 4, h / 4),
          colour_at(image, w / 4, 3 * h / 4), colour_at(image, 3 * w / 4, 3 * h / 4)};
}

std::string number_bytes(std::uint32_t value, std::size_t size, bool little) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i)
    bytes += static_cast<char>(value >> (8 * (little ? i : size - 1 - i)));
  return bytes;
}

/// A camera's note on which side is up, as TIFF has it.
std::string orientation_note(int orientation, bool little) {
  const auto number = [&](std::uint32_t value, std::size_t size) {
    return number_bytes(value, size, little);
  };
  std::string tiff = (little ? "II" : "MM") + number(42, 2) + number(8, 4);
  tiff += number(2, 2);
  tiff += number(0x010f, 2) + number(2, 2) + number(4, 4) + "Abc" + std::string(1, '\0');
  tiff +=
      number(0x0112, 2) + number(3, 2) + number(1, 4) + number(std::uint32_t(orientation), 2) + number(0, 2);
  return tiff + number(0, 4);
}

/// The file with such a note.
std::string with_orientation(const std::string& jpeg, int orientation, bool little) {
  const std::string body = std::string("Exif\0\0", 6) + orientation_note(orientation, little);
  const std::size_t size = body.size() + 2;
  return jpeg.substr(0, 2) + "\xff\xe1" + static_cast<char>(size >> 8) + static_cast<char>(size & 0xff) +
         body + jpeg.substr(2);
}

std::string webp_chunk(const std::string& kind, const std::string& body) {
  return kind + number_bytes(std::uint32_t(body.size()), 4, true) + body + std::string(body.size() % 2, '\0');
}
/// A simple WebP file of 32 x 16 pixels in the extended form, with these flags and a further chunk.
std::string extended_webp(const std::string& simple, int flags, const std::string& chunk) {
  const std::string size = number_bytes(31, 3, true) + number_bytes(15, 3, true);
  const std::string body = "WEBP" + webp_chunk("VP8X", number_bytes(std::uint32_t(flags), 4, true) + size) +
                           simple.substr(12) + chunk;
  return webp_chunk("RIFF", body);
}

TEST(ReferenceImage, JpegsOfAllKindsAreRead) {
  const auto colours = decode_reference(file_bytes("quadrants.jpg"));
  ASSERT_TRUE(colours.ok()) << to_string(colours.error());
  EXPECT_EQ(colours->size, (PixelSize{32, 16}));
  EXPECT_EQ(quadrants(colours->levels[0]), "rgbw");
  const auto print = decode_reference(file_bytes("quadrants_cmyk.jpg"));
  ASSERT_TRUE(print.ok()) << to_string(print.error());
  EXPECT_EQ(quadrants(print->levels[0]), "rgbw");
  const auto grey = decode_reference(file_bytes("quadrants_grey.jpg"));
  ASSERT_TRUE(grey.ok()) << to_string(grey.error());
  EXPECT_EQ(quadrants(grey->levels[0])[3], 'w');
  const std::uint8_t* p = grey->levels[0].pixel(4, 4);
  EXPECT_EQ(p[0], p[1]);
  EXPECT_EQ(p[3], 255);
}

TEST(ReferenceImage, PhotographsStandUprightAsTheirCameraNoted) {
  const std::string jpeg = file_bytes("quadrants.jpg");
  // Places to which the rows and columns of the file go, by the definition of the tag: r g / b w as seen
  // then.
  const std::array<const char*, 9> seen{"", "rgbw", "grwb", "wbgr", "bwrg", "rbgw", "brwg", "wgbr", "gwrb"};
  for (int orientation = 1; orientation <= 8; ++orientation)
    for (const bool little : {false, true}) {
      const std::string turned = with_orientation(jpeg, orientation, little);
      const auto image = decode_reference(turned);
      ASSERT_TRUE(image.ok()) << to_string(image.error());
      EXPECT_EQ(quadrants(image->levels[0]), seen[std::size_t(orientation)]) << orientation;
      const PixelSize size = orientation >= 5 ? PixelSize{16, 32} : PixelSize{32, 16};
      EXPECT_EQ(image->size, size) << orientation;
      EXPECT_EQ(reference_size(turned).value(), size) << orientation;
    }
  EXPECT_EQ(quadrants(decode_reference(with_orientation(jpeg, 9, true))->levels[0]), "rgbw")
      << "no such side";
}

TEST(ReferenceImage, WebpIsReadWhereItsLibraryIsThereAndElseRefusedByItsName) {
  const std::string lossy = file_bytes("quadrants.webp"), lossless = file_bytes("quadrants_lossless.webp");
  if (!reads_webp()) {
    for (const auto& read : {decode_reference(lossy), decode_reference(lossless)}) {
      ASSERT_FALSE(read.ok());
      EXPECT_EQ(read.error().code, e_picture_webp);
      EXPECT_NE(read.error().remedy.find("PNG or JPEG"), std::string::npos);
    }
    return;
  }
  const auto colours = decode_reference(lossy);
  ASSERT_TRUE(colours.ok()) << to_string(colours.error());
  EXPECT_EQ(colours->size, (PixelSize{32, 16}));
  EXPECT_EQ(quadrants(colours->levels[0]), "rgbw");
  const auto clear = decode_reference(lossless);
  ASSERT_TRUE(clear.ok()) << to_string(clear.error());
  const std::uint8_t* p = clear->levels[0].pixel(8, 4);
  EXPECT_EQ(p[0], 128) << "red times alpha";
  EXPECT_EQ(p[1], 0);
  EXPECT_EQ(p[3], 128);
  for (const std::string& cut : {lossy.substr(0, 40), lossy.substr(0, 13), lossless.substr(0, 30)}) {
    const auto read = decode_reference(cut);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, e_image_read);
  }
}

TEST(ReferenceImage, WebpPhotographsStandUprightAndAnimationsAreRefused) {
  if (!reads_webp()) GTEST_SKIP() << "built without libwebp";
  constexpr int has_notes = 8, animated = 2;
  const std::string lossy = file_bytes("quadrants.webp");
  for (const std::string& mark : {std::string(), std::string("Exif\0\0", 6)}) {
    const std::string turned =
        extended_webp(lossy, has_notes, webp_chunk("EXIF", mark + orientation_note(6, true)));
    const auto image = decode_reference(turned);
    ASSERT_TRUE(image.ok()) << to_string(image.error());
    EXPECT_EQ(quadrants(image->levels[0]), "brwg");
    EXPECT_EQ(image->size, (PixelSize{16, 32}));
    EXPECT_EQ(reference_size(turned).value(), image->size);
  }
  const auto moving = reference_size(extended_webp(lossy, animated, {}));
  ASSERT_FALSE(moving.ok());
  EXPECT_EQ(moving.error().code, e_image_read);
  EXPECT_NE(moving.error().text.find("animation"), std::string::npos);
}

TEST(ReferenceImage, PngsKeepTheirAlphaAndLevelsHalve) {
  const test::TemporaryFolder folder;
  Image image(13, 6);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 13; ++x) {
      std::uint8_t* p = image.pixel(x, y);
      p[0] = 200;
      p[3] = 128;
    }
  ASSERT_TRUE(write_png(folder.path() / "a.png", image).ok());
  const auto read = decode_reference(read_file(folder.path() / "a.png").value());
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const std::array<PixelSize, 4> sizes{PixelSize{13, 6}, {6, 3}, {3, 1}, {1, 1}};
  ASSERT_EQ(read->levels.size(), sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Image& level = read->levels[i];
    EXPECT_EQ((PixelSize{level.width, level.height}), sizes[i]);
    EXPECT_EQ(level.pixel(0, 0)[0], 100) << "colours times alpha";
    EXPECT_EQ(level.pixel(0, 0)[3], 128);
  }
}

TEST(ReferenceImage, VeryLargePicturesAreKeptSmaller) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_png(folder.path() / "wide.png", Image(9000, 40)).ok());
  const auto read = decode_reference(read_file(folder.path() / "wide.png").value());
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->size, (PixelSize{9000, 40})) << "its shape is that of the file";
  EXPECT_EQ(read->levels[0].width, 4500);
}

TEST(ReferenceImage, WhatIsNoPictureIsRefusedWithAWayOut) {
  const std::string jpeg = file_bytes("quadrants.jpg");
  for (const std::string& bytes : {std::string(), std::string("GIF89a"), std::string("v 0 0 0\n")}) {
    const auto read = decode_reference(bytes);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, e_picture_kind);
    EXPECT_NE(read.error().remedy.find("PNG or JPEG"), std::string::npos);
  }
  const auto cut = decode_reference(jpeg.substr(0, 40));
  ASSERT_FALSE(cut.ok());
  EXPECT_EQ(cut.error().code, e_image_read);
  EXPECT_FALSE(decode_reference("\x89PNG\r\n\x1a\nrest").ok());
}

TEST(ReferenceImage, DamagedFilesNeverCrash) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_png(folder.path() / "a.png", Image(20, 20)).ok());
  const std::array files{with_orientation(file_bytes("quadrants.jpg"), 6, true),
                         file_bytes("quadrants_cmyk.jpg"), read_file(folder.path() / "a.png").value()};
  test::for_random(1, 300, [&](std::mt19937_64& rng) {
    std::string bytes = files[rng() % files.size()];
    for (int i = test::uniform_int(rng, 1, 6); i > 0; --i)
      bytes[rng() % bytes.size()] = static_cast<char>(rng());
    if (test::chance(rng, 0.3)) bytes.resize(rng() % bytes.size());
    (void)reference_size(bytes);
    // A changed header may promise a hundred million pixels.
    if (const auto size = reference_size(bytes); size && std::int64_t(size->width) * size->height < 1'000'000)
      (void)decode_reference(bytes);
  });
}

TEST(ReferenceImage, EndingsAreKnownInAnyCase) {
  for (const char* name : {"a.png", "a.JPG", "b.jpeg", "/c/d.Png", "e.WebP"})
    EXPECT_TRUE(is_reference_file(name)) << name;
  for (const char* name : {"a.obj", "png", "a.hariko", "a.jpg.txt"})
    EXPECT_FALSE(is_reference_file(name)) << name;
  const auto endings = reference_endings();
  EXPECT_EQ(std::count(endings.begin(), endings.end(), ".webp"), reads_webp() ? 1 : 0)
      << "dialogs offer what can be read";
}

TEST(ScenePicture, SidesAreThoseOfTheStandardViews) {
  const std::pair<PictureSide, StandardView> sides[] = {
      {PictureSide::front, StandardView::front}, {PictureSide::back, StandardView::back},
      {PictureSide::left, StandardView::left},   {PictureSide::right, StandardView::right},
      {PictureSide::top, StandardView::top},     {PictureSide::bottom, StandardView::bottom}};
  for (const auto& [side, view] : sides) {
    ScenePicture picture;
    picture.look.only_from = side;
    for (const auto& [other, other_view] : sides)
      EXPECT_EQ(picture.seen_by(Camera::standard(other_view)), view == other_view) << int(side) << int(other);
    EXPECT_FALSE(picture.seen_by(Camera::standard(StandardView::iso)));
    EXPECT_FALSE(picture.seen_by(Camera::standard(view).orbit(1e-3, 0))) << "while it turns";
  }
}

TEST(ScenePicture, RaysMeetItWhereItsCornersSay) {
  test::for_random(1, 100, [](std::mt19937_64& rng) {
    ScenePicture picture;
    picture.half = {test::uniform(rng, 0.1, 5), test::uniform(rng, 0.1, 5)};
    Eigen::Quaterniond turn(test::uniform(rng, 0.1, 1), test::uniform(rng), test::uniform(rng),
                            test::uniform(rng));
    picture.transform.topLeftCorner<3, 3>() =
        test::uniform(rng, 0.1, 9) * turn.normalized().toRotationMatrix();
    picture.transform.topRightCorner<3, 1>() = 10 * test::random_vector(rng);
    const auto corners = picture.corners();
    const double u = test::uniform(rng, -0.3, 1.3), v = test::uniform(rng, -0.3, 1.3);
    const Vector3 point = corners[0] + u * (corners[1] - corners[0]) + v * (corners[3] - corners[0]);
    const Vector3 eye =
        point + 20 * (picture.transform.col(2).head<3>().normalized()) + test::random_vector(rng);
    const auto t = picture.hit({eye, (point - eye).normalized()});
    const bool inside = u > 0 && u < 1 && v > 0 && v < 1;
    ASSERT_EQ(t.has_value(), inside) << u << " " << v;
    if (t) EXPECT_NEAR(*t, (point - eye).norm(), 1e-9);
  });
}

}  // namespace
}  // namespace hariko
