#include "core/exchange/detect_json_format.hpp"

#include <gtest/gtest.h>

#include "core/base/files/file_io.hpp"
#include "core/exchange/imported_mesh.hpp"

namespace hariko {
namespace {

TEST(JsonKindOf, ContentDecides) {
  const auto kind = [](const char* text) { return json_kind(text); };
  EXPECT_EQ(*kind(R"({"objects": [{"name": "a"}], "format": "hariko", "version": 1})"), JsonKind::document);
  EXPECT_EQ(*kind(R"({"a": [{"degree": [1, 1], "ctrl": [[[0,0,0]]]}]})"), JsonKind::patches);
  EXPECT_EQ(*kind(R"({"format": "hariko-keys", "keys": {}})"), JsonKind::keys);
  EXPECT_EQ(*kind(R"({"format": "unfolding-1", "faces": []})"), JsonKind::layout);
  EXPECT_EQ(*kind(R"({"primitives": [], "roundness": 1})"), JsonKind::scene);
  EXPECT_EQ(*kind(R"({"path": {"points": []}, "sections": []})"), JsonKind::skin);
  EXPECT_EQ(*kind(R"({"name": "a", "loops": []})"), JsonKind::outline);
  // Marks count only where they belong.
  for (const char* text : {R"({"a": {"format": "hariko"}})", R"({"ctrl": []})", R"({"format": 3})", "[]", "7",
                           R"({"path": []})", R"({"format": "other"})"}) {
    const auto unknown = kind(text);
    ASSERT_FALSE(unknown.ok()) << text;
    EXPECT_EQ(unknown.error().code, e_format_unknown);
    EXPECT_NE(unknown.error().remedy.find("Hariko document"), std::string::npos);
    EXPECT_NE(unknown.error().remedy.find("\"ctrl\""), std::string::npos);
  }
  for (const char* text : {"", "{", R"({"format": "hariko")", "{\"a\": nan}", "\xff\xfe"}) {
    const auto broken = kind(text);
    ASSERT_FALSE(broken.ok()) << text;
    EXPECT_EQ(broken.error().code, e_parse);
  }
  EXPECT_TRUE(use_of(JsonKind::document).empty());
  EXPECT_FALSE(use_of(JsonKind::keys).empty());
}

}  // namespace
}  // namespace hariko
