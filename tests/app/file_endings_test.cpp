// Tests of the file types that dialogs offer.

#include <gtest/gtest.h>

#include <algorithm>

#include "ui/files/file_dialogs.hpp"

namespace hariko {
namespace {

bool has(const std::vector<std::string>& endings, const char* ending) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

TEST(FileEndings, CadFilesAreOfferedWhereTheyCanBeRead) {
  for (const char* ending : {".step", ".stp", ".iges", ".igs"}) {
    EXPECT_TRUE(has(openable_endings(true), ending)) << ending;
    EXPECT_TRUE(has(importable_endings(true), ending)) << ending;
    EXPECT_FALSE(has(openable_endings(false), ending)) << ending;
    EXPECT_FALSE(has(importable_endings(false), ending)) << ending;
  }
}

TEST(FileEndings, MeshesAreAlwaysOffered) {
  for (const bool cad : {false, true}) {
    for (const char* ending : {".obj", ".off", ".ply", ".stl", ".glb", ".gltf", ".3mf", ".bpt", ".json"}) {
      EXPECT_TRUE(has(openable_endings(cad), ending)) << ending;
      EXPECT_TRUE(has(importable_endings(cad), ending)) << ending;
    }
    EXPECT_TRUE(has(openable_endings(cad), ".hariko"));
    EXPECT_FALSE(has(importable_endings(cad), ".hariko"));
  }
}

}  // namespace
}  // namespace hariko
