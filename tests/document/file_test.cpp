// Documents on disk: whatever fails while saving, the file is the old one or the new one.

#include "core/document/file.hpp"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "core/document/edits/edit_pictures.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/format/format.hpp"
#include "tests/document/random_documents.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

class DocumentFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "hariko_document_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

/// Passes calls on to the system and fails the n-th one, or cuts the n-th write short.
class FailingLayer final : public FileLayer {
 public:
  FailingLayer(int failing_call, bool only_partly) : failing_call_(failing_call), only_partly_(only_partly) {}
  int calls() const { return calls_; }

  int create(const std::string& path, unsigned mode) override {
    return fails() ? -EACCES : system_.create(path, mode);
  }
  int set_mode(int file, unsigned mode) override { return fails() ? -EPERM : system_.set_mode(file, mode); }
  std::int64_t write(int file, const char* data, std::size_t size) override {
    if (!fails()) return system_.write(file, data, size);
    if (only_partly_) system_.write(file, data, size / 2);
    return -ENOSPC;
  }
  int sync(int file) override { return fails() ? -EIO : system_.sync(file); }
  int close(int file) override {
    const int closed = system_.close(file);  // the descriptor is gone even where close fails
    return fails() ? -EIO : closed;
  }
  int rename(const std::string& from, const std::string& to) override {
    return fails() ? -EXDEV : system_.rename(from, to);
  }
  int remove(const std::string& path) override { return system_.remove(path); }
  int open_directory(const std::string& path) override {
    return fails() ? -EMFILE : system_.open_directory(path);
  }

 private:
  bool fails() { return ++calls_ == failing_call_; }
  SystemFileLayer system_;
  int failing_call_;
  bool only_partly_;
  int calls_ = 0;
};

TEST_F(DocumentFile, SavesAndLoads) {
  test::for_random(3, 20, [&](std::mt19937_64& rng) {
    const Document document = test::any_document(rng);
    const fs::path path = folder_ / "Größe 張り子.hariko";
    ASSERT_TRUE(save_document(document, path));
    const Result<Document> loaded = test::must(load_document(path));
    // In memory pictures have absolute paths.
    ASSERT_TRUE(*loaded == with_absolute_pictures(document, folder_));
    ASSERT_EQ(files_in_folder(), 1U);
  });
}

TEST_F(DocumentFile, EveryFailureLeavesTheOldOrTheNewFile) {
  const Document before = test::cube_document();
  const Document after = rename_object(before, test::cube_id, "After").value();
  const fs::path path = folder_ / "a.hariko";
  int failures = 0;
  for (const bool only_partly : {false, true})
    for (int n = 1;; ++n) {
      ASSERT_TRUE(save_document(before, path));
      FailingLayer layer(n, only_partly);
      const Result<Done> saved = save_document(after, path, layer);
      const Result<Document> found = load_document(path);
      ASSERT_TRUE(found) << "call " << n << ": " << to_string(found.error());
      ASSERT_TRUE(*found == before || *found == after) << "call " << n;
      ASSERT_EQ(files_in_folder(), 1U) << "a temporary file stayed behind after call " << n;
      ASSERT_TRUE(!saved || *found == after) << "call " << n;
      if (!saved) {
        ASSERT_EQ(saved.error().code.name, e_file_write.name) << to_string(saved.error());
        ++failures;
      }
      if (layer.calls() < n) break;
    }
  EXPECT_GE(failures, 8) << "the fault injection must reach create, write, sync, close and rename";
}

TEST_F(DocumentFile, ADocumentThatWouldNotReadBackIsNotWritten) {
  const fs::path path = folder_ / "a.hariko";
  const Document good = test::cube_document();
  ASSERT_TRUE(save_document(good, path));
  Document bad = good;
  bad.kept = KeptMembers{{"broken", "[1, "}};
  EXPECT_EQ(save_document(bad, path).error().code.name, e_save_verify.name);
  bad.kept = KeptMembers{{"unit", "\"m\""}};  // would change the meaning of the file
  EXPECT_EQ(save_document(bad, path).error().code.name, e_save_verify.name);
  EXPECT_TRUE(load_document(path).value() == good);
}

TEST_F(DocumentFile, WhatNoFileHasRoomForIsSaid) {
  Document document = test::cube_document();
  EXPECT_FALSE(has_too_large_meshes(document));
  PolygonMesh mesh;
  mesh.positions.resize(max_document_values / 4, Vector3::Zero());
  mesh.add_face({0, 1, 2});
  MeshSource scan;
  scan.mesh = std::move(mesh);
  EXPECT_TRUE(has_too_large_meshes(add_object(document, "Scan", std::move(scan))->document));
  std::string many = "[0";
  for (std::size_t i = 0; i < max_document_values; ++i) many += ",0";
  document.kept = KeptMembers{{"other", many + "]"}};
  EXPECT_EQ(save_document(document, folder_ / "a.hariko").error().code.name, e_document_size.name);
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(DocumentFile, LoadingNamesTheFile) {
  EXPECT_EQ(load_document(folder_ / "missing.hariko").error().code.name, e_file_open.name);
  EXPECT_EQ(load_document(folder_).error().code.name, e_file_open.name);
  const fs::path path = folder_ / "broken.hariko";
  std::ofstream(path) << "{\n]";
  const Message error = load_document(path).error();
  EXPECT_EQ(error.code.name, e_parse.name);
  EXPECT_NE(error.text.find("broken.hariko"), std::string::npos) << error.text;
  EXPECT_NE(error.text.find("line 2, column 1"), std::string::npos) << error.text;
}

}  // namespace
}  // namespace hariko
