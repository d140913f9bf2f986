// Making: the way parts are going to be made, a part of the document.

#include "core/document/making.hpp"

#include <functional>
#include <limits>

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/format/format.hpp"
#include "tests/document/random_documents.hpp"

namespace hariko {
namespace {

Document made_so(const std::function<void(MakingSettings&)>& change) {
  Document document = test::cube_document();
  change(document.making);
  return document;
}

TEST(Making, EveryFieldIsNoticedAndComesBack) {
  const Document plain = test::cube_document();
  EXPECT_EQ(write_document(plain).find("making"), std::string::npos) << "simple files stay simple";
  const std::function<void(MakingSettings&)> changes[] = {
      [](MakingSettings& m) {
        m.pull = {0, 1, 0};
      },
      [](MakingSettings& m) { m.draft = 1.5; }, [](MakingSettings& m) { m.radius = 0.125; },
      [](MakingSettings& m) { m.thickness = 1e-3; }, [](MakingSettings& m) { m.reference = test::cube_id; }};
  for (const auto& change : changes) {
    const Document other = made_so(change);
    EXPECT_FALSE(other == plain);
    const auto again = test::must(read_document(write_document(other)));
    EXPECT_TRUE(*again == other) << write_document(other);
  }
}

TEST(Making, MapsOfMakingComeBackWithTheirRanges) {
  for (const SurfaceMap map :
       {SurfaceMap::draft, SurfaceMap::radius, SurfaceMap::thickness, SurfaceMap::deviation}) {
    Document document = test::cube_document();
    DisplaySettings display = document.objects[0]->display;
    display.map = map;
    range_of(display, map) = {RangeMode::manual, 0.5, 7};
    document = set_display(document, test::cube_id, display).value();
    const auto again = test::must(read_document(write_document(document)));
    EXPECT_EQ(again->objects[0]->display.map, map);
    EXPECT_EQ(range_of(again->objects[0]->display, map), (MapRange{RangeMode::manual, 0.5, 7}));
  }
}

TEST(Making, WhatVersion7WroteReadsForEver) {
  const std::string text =
      "{\"format\": \"hariko\", \"version\": 7, \"objects\": [], \"making\": {\"pull\": [0, -1, 0.5], "
      "\"draft\": 1.5, \"radius\": 0.75, \"thickness\": 1.25, \"reference\": 3}}";
  const auto read = test::must(read_document(text));
  EXPECT_EQ(read->making, (MakingSettings{{0, -1, 0.5}, 1.5, 0.75, 1.25, ObjectId{3}}));
}

TEST(Making, WhatMakesNoSenseIsRefusedWithItsPlace) {
  for (const char* wrong :
       {"\"pull\": [0, 0, 0]", "\"pull\": [1e300, 0, 0]", "\"pull\": 3", "\"draft\": -1", "\"draft\": 90",
        "\"radius\": 0", "\"thickness\": 1e12", "\"reference\": \"Cube\"", "\"speed\": 1"}) {
    const auto read =
        read_document("{\"format\": \"hariko\", \"version\": 7, \"objects\": [], \"making\": {" +
                      std::string(wrong) + "}}");
    ASSERT_FALSE(read) << wrong;
    EXPECT_NE(read.error().text.find("making"), std::string::npos) << read.error().text;
  }
  Document document = test::cube_document();
  MakingSettings making;
  making.draft = std::numeric_limits<double>::quiet_NaN();
  const auto refused = set_making(document, making);
  test::must_fail(refused, e_making_invalid);
  EXPECT_FALSE(refused.error().remedy.empty());
}

TEST(Making, ToolsKeepTheirSizeInEveryUnit) {
  Document document = made_so([](MakingSettings& m) { m.radius = 25.4; });
  EXPECT_EQ(limit_of(document, SurfaceMap::radius), 25.4);
  const Document inches = convert_unit(document, Unit::inch).value();
  EXPECT_EQ(limit_of(inches, SurfaceMap::radius), 1);
  EXPECT_EQ(limit_of(inches, SurfaceMap::draft), 3);
  EXPECT_DOUBLE_EQ(limit_of(set_unit(document, Unit::metre), SurfaceMap::radius), 0.0254);
  EXPECT_EQ(limit_of(document, SurfaceMap::gaussian), 0);
}

}  // namespace
}  // namespace hariko
