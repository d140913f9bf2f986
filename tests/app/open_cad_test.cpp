// STEP and IGES files, as the window and the command line open them.

#include <gtest/gtest.h>

#include "app/files/export_cad.hpp"
#include "app/files/file_kind.hpp"
#include "app/files/open_file.hpp"
#include "core/base/files/file_io.hpp"
#include "core/cad/kernel/read_cad_file.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/object_box.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

/// A saddle.
BezierSource patch() {
  BezierPatch out;
  out.degree_s = out.degree_t = 2;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) out.points.emplace_back(i, j, (i - 1) * (j - 1));
  return BezierSource::from_patches({out}).value();
}

/// Two objects of different colours, in inches.
Document two_objects() {
  Document document;
  document.unit = Unit::inch;
  DisplaySettings red;
  red.colour = {200, 30, 90};
  document = add_object(document, "one", patch(), {}, red)->document;
  return add_object(document, "two", patch())->document;
}

TEST(OpenCad, PartsKeepNamesColoursAndSizes) {
  const test::TemporaryFolder folder;
  const Document document = two_objects();
  for (const char* name : {"a.step", "a.igs"}) {
    SCOPED_TRACE(name);
    const auto file = folder.path() / name;
    const auto written = export_cad(document, file, {}, "2026-11-22T12:00:00");
    if (why_no_cad_files()) {
      EXPECT_EQ(written.error().code, e_no_cad_kernel);
      continue;
    }
    ASSERT_TRUE(written.ok()) << to_string(written.error());
    const OpenedFile opened = open_file(file);
    for (const Message& message : opened.messages) ADD_FAILURE() << to_string(message);
    ASSERT_TRUE(opened.document);
    EXPECT_TRUE(opened.says_unit);
    EXPECT_FALSE(opened.native);
    EXPECT_EQ(opened.document->unit, Unit::millimetre);
    ASSERT_EQ(opened.document->objects.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      const Object &was = *document.objects[k], &is = *opened.document->objects[k];
      EXPECT_EQ(is.name, was.name);
      EXPECT_EQ(is.display.colour, was.display.colour);
      EXPECT_TRUE(is.bezier());
      const double size = 25.4 * world_box(was).diagonal().norm();
      EXPECT_NEAR(world_box(is).diagonal().norm(), size, 1e-9 * size);
    }
  }
}

TEST(OpenCad, FilesWithoutAnEndingAreKnownByTheirContent) {
  const test::TemporaryFolder folder;
  const auto gltf = folder.path() / "scene";
  ASSERT_TRUE(write_file_atomic(gltf, R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "type": "VEC3", "count": 3, "componentType": 5126}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})")
                  .ok());
  const OpenedFile scene = open_file(gltf);
  EXPECT_EQ(scene.error(), nullptr);
  EXPECT_TRUE(scene.document);
  EXPECT_EQ(ending_of_content("ISO-10303-21;\nHEADER;"), "step");
  EXPECT_EQ(ending_of_content("{\"format\": \"hariko\"}"), "hariko");
  EXPECT_EQ(ending_of_content("\xEF\xBB\xBF{\"asset\" : {}}"), "gltf");
  EXPECT_EQ(ending_of_content("{\"name\": \"asset\"}"), "json");
  EXPECT_EQ(ending_of_content("words"), std::nullopt);
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  for (const char* name : {"a.step", "a.igs"}) {
    SCOPED_TRACE(name);
    const auto file = folder.path() / name, bare = folder.path() / "bare";
    ASSERT_TRUE(export_cad(two_objects(), file, {}, "2026-11-22T12:00:00").ok());
    std::filesystem::rename(file, bare);
    const OpenedFile opened = open_file(bare);
    ASSERT_EQ(opened.error(), nullptr);
    EXPECT_TRUE(opened.says_unit);
    EXPECT_EQ(opened.document->objects.size(), 2U);
  }
}

TEST(OpenCad, WhatTheFileHidesIsAHiddenObject) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  const auto file =
      std::filesystem::path(test::source_folder()) / "tests" / "cad" / "fixtures" / "hidden_face.igs";
  const OpenedFile opened = open_file(file);
  ASSERT_TRUE(opened.document);
  ASSERT_EQ(opened.document->objects.size(), 2U);
  EXPECT_TRUE(opened.document->objects[0]->visible);
  EXPECT_FALSE(opened.document->objects[1]->visible);
}

TEST(OpenCad, HalfAFileIsRefused) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  const test::TemporaryFolder folder;
  for (const char* name : {"a.stp", "a.iges"}) {
    SCOPED_TRACE(name);
    const auto file = folder.path() / name;
    ASSERT_TRUE(export_cad(two_objects(), file, {}, "2026-11-22T12:00:00").ok());
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    const OpenedFile opened = open_file(file);
    EXPECT_FALSE(opened.document);
    ASSERT_TRUE(opened.error());
    EXPECT_EQ(opened.error()->code, e_cad_read);
  }
}

TEST(OpenCad, CanBeCancelled) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.step";
  ASSERT_TRUE(export_cad(two_objects(), file, {}, "2026-11-22T12:00:00").ok());
  CancelToken cancel = CancelToken::make();
  cancel.cancel();
  const OpenedFile opened = open_file(file, cancel);
  EXPECT_FALSE(opened.document);
  ASSERT_EQ(opened.messages.size(), 1U);
  EXPECT_EQ(opened.messages[0].code, e_cancelled);
  EXPECT_EQ(opened.messages[0].text, "The import was cancelled.");
}

}  // namespace
}  // namespace hariko
