// The plane of symmetric edits of a skin is a part of the document.

#include <gtest/gtest.h>

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edit_skin.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/format/format.hpp"
#include "core/document/history/history.hpp"
#include "core/skinning/columns/simple_skin.hpp"

namespace hariko {
namespace {

Document skin_document() {
  return add_object({}, "skin", Source(SkinSource{arched_skin(6, 4, 1, 5), {}}), {}).value().document;
}

const Skin& skin_of(const Document& document) {
  return *document.objects[0]->skin()->skin;
}

Document with_mirror(const Document& document, const std::optional<MirrorPlane>& mirror) {
  Skin skin = skin_of(document);
  skin.mirror = mirror;
  return set_skin(document, document.objects[0]->id, skin).value();
}

TEST(SkinMirror, IsKeptInFilesAndUndone) {
  const Document none = skin_document();
  EXPECT_EQ(write_document(none).find("mirror"), std::string::npos);
  for (int axis = 0; axis < 3; ++axis) {
    const MirrorPlane plane{axis, -0.1};
    History history(none);
    const Document set = with_mirror(none, plane);
    ASSERT_TRUE(history.push(set, "Mirror of the skin"));
    const std::string text = write_document(history.current());
    const auto read = read_document(text);
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(skin_of(*read).mirror, plane);
    EXPECT_EQ(*read, set);
    EXPECT_EQ(write_document(*read), text);
    history.undo();
    EXPECT_FALSE(skin_of(history.current()).mirror.has_value());
    history.redo();
    EXPECT_EQ(skin_of(history.current()).mirror, plane);
  }
}

TEST(SkinMirror, GoesWithTheUnit) {
  const Document set = with_mirror(skin_document(), MirrorPlane{0, 25});
  const Document converted = convert_unit(set, Unit::centimetre).value();
  EXPECT_EQ(skin_of(converted).mirror, (MirrorPlane{0, 2.5}));
}

TEST(SkinMirror, WhatIsWrongIsRefused) {
  const std::string text = write_document(with_mirror(skin_document(), MirrorPlane{1, 0.5}));
  const std::string plane = R"({"axis": "y", "position": 0.5})";
  ASSERT_NE(text.find(plane), std::string::npos);
  for (const char* wrong :
       {R"({"axis": "w", "position": 0.5})", R"({"axis": "y"})", R"({"position": 0.5})", R"(1)",
        R"({"axis": "y", "position": "here"})", R"({"axis": "y", "position": 0.5, "angle": 3})"}) {
    std::string changed = text;
    changed.replace(changed.find(plane), plane.size(), wrong);
    const auto read = read_document(changed);
    ASSERT_FALSE(read.ok()) << wrong;
    EXPECT_EQ(read.error().code.name, "E_SCHEMA") << wrong;
    EXPECT_NE(read.error().text.find("mirror"), std::string::npos) << read.error().text;
  }
}

}  // namespace
}  // namespace hariko
