// Words of other programs, typed into the palette: it finds what does that here.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/command_search.hpp"

namespace hariko {
namespace {

using test::HeadlessWorkbench;

class PaletteWords : public ::testing::Test {
 protected:
  /// Place of a command among what is found; nothing where it is not found.
  std::optional<std::size_t> place_of(const char* id, std::string_view words, const Language& language = {}) {
    const auto found = search_commands(bench_.workbench().commands(), language, words, {});
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i]->id == id) return i;
    return {};
  }
  void expect_shown(const char* words, const char* id, const Language& language = {}) {
    constexpr std::size_t rows_shown = 9;
    const auto place = place_of(id, words, language);
    EXPECT_TRUE(place && *place < rows_shown) << words << " for " << id;
  }

  HeadlessWorkbench bench_{document_from_mesh(test::prism(4), "Box").value()};
};

struct WordsFor {
  const char *words, *id;
};

TEST_F(PaletteWords, OfOtherProgramsFindWhatIsCalledOtherwiseHere) {
  constexpr WordsFor pairs[] = {
      {"fillet", "mesh.bevel_edges"},
      {"fillet", "property.rounding"},
      {"chamfer", "mesh.bevel_edges"},
      {"bevel", "mesh.bevel_edges"},
      {"loft", "add.skin"},
      {"sweep", "skin.draw"},
      {"two rails", "property.skin_frame.3"},
      {"extrude", "mesh.extrude"},
      {"inset", "mesh.inset"},
      {"offset", "mesh.inset"},
      {"mirror", "property.mirror"},
      {"symmetry", "mirror.live_x"},
      {"symmetry", "property.envelope_symmetry"},
      {"array", "object.array_row"},
      {"polar array", "object.array_ring"},
      {"weld", "mesh.merge_distance"},
      {"weld", "shape.weld_patches"},
      {"remove doubles", "mesh.merge_distance"},
      {"cap", "mesh.fill_hole"},
      {"flip normals", "mesh.flip"},
      {"explode", "shape.separate_patches"},
      {"shrinkwrap", "mesh.project_reference"},
      {"sharp edge", "shape.crease"},
      {"hide", "object.hide"},
      {"unhide", "object.show_all"},
      {"isolate", "object.isolate"},
      {"freeze", "object.lock"},
      {"gumball", "transform.gizmo"},
      {"proportional editing", "transform.soft"},
      {"marquee", "select.box"},
      {"deselect", "select.none"},
      {"snap", "snap.grid"},
      {"osnap", "snap.always"},
      {"cplane", "plane.face"},
      {"grid", "view.grid"},
      {"pan", "property.preferences.navigation"},
      {"zoom extents", "view.frame_all"},
      {"zoom selected", "view.frame_selection"},
      {"quad view", "view.four"},
      {"screenshot", "file.export_picture"},
      {"render", "file.export_picture"},
      {"clipping plane", "analyse.section"},
      {"contours", "analyse.section_curves"},
      {"curvature graph", "analyse.combs"},
      {"wireframe", "property.wire"},
      {"blueprint", "picture.add"},
      {"ruler", "measure.distance"},
      {"unroll", "paper.unfold"},
      {"unit", "property.unit"},
      {"units", "property.unit"},
      {"shortcuts", "help.keys"},
      {"settings", "edit.preferences"},
      {"dark mode", "property.preferences.theme"},
      {"macro", "edit.record_script"},
      {"exit", "file.quit"},
  };
  for (const WordsFor& pair : pairs) expect_shown(pair.words, pair.id);
}

TEST_F(PaletteWords, InJapaneseDoSoToo) {
  const auto japanese = Language::load(test::source_folder() + "/assets/languages/ja.po");
  ASSERT_TRUE(japanese.ok());
  constexpr WordsFor pairs[] = {
      {"\u30d5\u30a3\u30ec\u30c3\u30c8", "mesh.bevel_edges"},
      {"\u30ed\u30d5\u30c8", "add.skin"},
      {"\u30b7\u30f3\u30e1\u30c8\u30ea\u30fc", "mirror.live_x"},
      {"\u30b9\u30af\u30ea\u30fc\u30f3\u30b7\u30e7\u30c3\u30c8", "file.export_picture"},
      {"\u30df\u30ea\u30e1\u30fc\u30c8\u30eb", "property.unit"},
  };
  for (const WordsFor& pair : pairs) expect_shown(pair.words, pair.id, *japanese);
}

TEST_F(PaletteWords, EveryOtherNameFindsItsCommand) {
  std::size_t named = 0;
  for (const Command& command : bench_.workbench().commands().all()) {
    std::string_view names = command.other_names;
    named += names.empty() ? 0 : 1;
    while (!names.empty()) {
      const std::size_t end = std::min(names.find(", "), names.size());
      const std::string_view name = names.substr(0, end);
      EXPECT_TRUE(place_of(command.id.c_str(), name)) << name << " for " << command.id;
      names.remove_prefix(std::min(end + 2, names.size()));
    }
  }
  EXPECT_GT(named, 80U);
}

/// Features that the program does not have are not offered either.
TEST_F(PaletteWords, OfWhatIsNotThereFindNothing) {
  const auto found = search_commands(bench_.workbench().commands(), {}, "boolean", {});
  EXPECT_TRUE(found.empty()) << found.front()->id;
  EXPECT_FALSE(place_of("shape.crease", "fillet"));
  EXPECT_FALSE(place_of("mesh.bridge", "loft"));
  EXPECT_FALSE(place_of("object.duplicate", "offset"));
}

}  // namespace
}  // namespace hariko
