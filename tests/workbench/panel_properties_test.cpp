// Every property that a panel shows is a command: the panels are drawn for every kind of object and
// selection, and the rows looked for in the palette.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/document/edits/edit_copies.hpp"
#include "core/document/edits/edit_outlines.hpp"
#include "core/document/edits/edit_pictures.hpp"
#include "core/document/edits/edit_skin.hpp"
#include "core/document/edits/edit_solids.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "core/document/words.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/modeling/objects/parabolic_grid.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/command_search.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {
namespace {

using test::HeadlessWorkbench;

/// Rows that commands of other menus switch.
const std::map<std::string, std::string>& commands_of_rows() {
  static const std::map<std::string, std::string> known{
      {"name", "object.rename"},
      {"surface", "show.surface"},
      {"polyhedron", "show.polyhedron"},
      {"network", "show.network"},
      {"points", "show.points"},
      {"tensions", "analyse.tensions"},
      {"marks", "analyse.marks"},
      {"bodies", "view.solids"},
      {"combs", "analyse.combs"},
      {"section", "analyse.section"},
      {"section_flipped", "analyse.section_flip"},
      {"section_curves", "analyse.section_curves"},
      {"section_combs", "analyse.section_combs"},
      {"section_scale", "analyse.section_longer"},
  };
  return known;
}

/// The row that a mark is of, by its id; empty for what is no row. Of three numbers that is the first.
std::string row_of_mark(const std::string& mark) {
  static const std::map<std::string, std::string> of_several{
      {"y", "x"},
      {"z", "x"},
      {"solid.depth", "solid.width"},
      {"range_high", "range_low"},
      {"tolerance_angle", "tolerance"},
      {"tolerance_jump", "tolerance"},
  };
  if (mark.starts_with("meshing.") && mark.ends_with(".on")) return mark.substr(0, mark.size() - 3);
  for (const std::string_view start : {"label.", "field.", "slider.", "check.", "combo.", "drag."})
    if (mark.starts_with(start)) {
      std::string id = mark.substr(start.size());
      if (const auto first = of_several.find(id); first != of_several.end()) return first->second;
      for (const char* end : {".y", ".z", "_y", "_z"})
        if (id.ends_with(end)) id.back() = 'x';
      return id;
    }
  return {};
}

class PanelProperties : public ::testing::Test {
 protected:
  Editor& editor() { return bench_.editor(); }
  const CommandTable& table() { return bench_.workbench().commands(); }
  ObjectId id() { return editor().selection.active; }
  const Object& object() { return *editor().active_object(); }
  void open(const Document& document) {
    editor().open(document, {});
    frames();
  }
  void frames() {
    for (int i = 0; i < 4; ++i) bench_.frame();
  }
  void commit(const Result<Document>& result) {
    ASSERT_TRUE(result.ok()) << result.error().text;
    editor().commit(result, "Change");
  }

  /// Expects that everything in the panels now is in the palette, and that the palette leads there.
  void look(const std::string& where) {
    SCOPED_TRACE(where);
    unfold();
    for (const auto& [mark, rect] : bench_.workbench().marks().all())
      if (const std::string row = row_of_mark(mark); !row.empty()) expect_found(row);
  }

  /// All elements of the object, and the object itself.
  void look_at_elements(const std::string& where) {
    for (const ElementMode mode :
         {ElementMode::vertex, ElementMode::edge, ElementMode::face, ElementMode::object}) {
      editor().mode = mode;
      editor().selection.select_all(object(), mode);
      look(where + ", selected " + std::to_string(int(mode)));
    }
  }

  std::set<std::string> seen_;
  HeadlessWorkbench bench_{Document(), {1280, 1000}};

 private:
  void unfold() {
    for (const char* property : {"property.location.x", "property.skin_flip"})
      if (table().run(property).ran) frames();
    frames();
  }

  void expect_found(const std::string& row) {
    const auto other = commands_of_rows().find(row);
    const Command* command =
        table().find(other != commands_of_rows().end() ? other->second : "property." + row);
    ASSERT_TRUE(command) << "no command for the row " << row;
    if (seen_.insert(row).second) {
      const auto found = search_commands(table(), {}, command->label, {});
      EXPECT_NE(std::find(found.begin(), found.end(), command), found.end()) << command->label;
    }
    if (other != commands_of_rows().end() || !command->why_not) return;
    const auto reason = command->why_not();
    EXPECT_FALSE(reason) << row << " shows, but: " << reason.value_or("");
  }
};

Document document_of(const char* name, Source source) {
  return add_object({}, name, std::move(source))->document;
}
Document document_of_sample(const char* name) {
  return load_document(test::source_folder() + "/assets/samples/" + name + ".hariko").value();
}

TEST_F(PanelProperties, OfEveryKindAndElementAreCommands) {
  const std::map<std::string, Document> kinds{
      {"polyhedron", document_from_mesh(test::prism(5), "Prism").value()},
      {"patches", document_of("Patches", PatchSource::from_net(parabolic_grid(2, 2, 2, 2, 0.4)).value())},
      {"mesh", document_of("Mesh", MeshSource::from_mesh(test::prism(5)).value())},
      {"solids", document_of_sample("solids_one")},
      {"skin", document_of_sample("skin_smooth")},
      {"outline", document_of_sample("sphere_cap")},
  };
  for (const auto& [kind, document] : kinds) {
    open(document);
    look_at_elements(kind);
  }
  for (const char* row :
       {"size.x", "location.x", "scale", "mode", "merge_coplanar", "alpha", "beta", "crease", "solid.x",
        "skin_method", "skin_sharp", "outline_mode", "outline_tilt", "map", "density", "unit"})
    EXPECT_TRUE(seen_.contains(row)) << row << " was not looked at";
}

TEST_F(PanelProperties, OfEveryMapAreCommands) {
  open(document_from_mesh(test::prism(5), "Prism").value());
  editor().view.section.shown = editor().view.x_ray = editor().view.environment = true;
  editor().sections.shown = true;
  for (const SurfaceMap map : enum_values<SurfaceMap>()) {
    DisplaySettings display = object().display;
    display.map = map;
    display.marks = display.combs.shown = true;
    if (range_slot(map)) range_of(display, map).mode = RangeMode::manual;
    commit(set_display(editor().history.current(), id(), display));
    look("map " + std::string(enum_word(map)));
  }
  for (const char* row : {"colour", "range", "range_low", "tolerance", "comb_density", "stripes", "lock",
                          "environment", "environment_turn", "draft_limit", "radius_limit", "thickness_limit",
                          "reference", "section_offset", "x_ray", "section_count", "section_first"})
    EXPECT_TRUE(seen_.contains(row)) << row << " was not looked at";
}

TEST_F(PanelProperties, OfEverySolidAreCommands) {
  open(document_of_sample("solids_one"));
  for (const SolidKind kind : enum_values<SolidKind>()) {
    if (kind == SolidKind::polyhedron) continue;
    commit(change_envelope(editor().history.current(), id(), [&](EnvelopeInput& input) {
      Solid solid;
      solid.kind = kind;
      solid.id = input.solids.front().id;
      solid.roundness = 0.5;
      solid.bridge = Bridge{{998, 999}, 10.0};
      solid.pulls = {Pull{}};
      input.solids.front() = solid;
      choose_ball(input);
    }));
    editor().mode = ElementMode::vertex;
    editor().selection.select_all(object(), ElementMode::vertex);
    look("solid " + std::string(enum_word(kind)));
  }
  for (const char* row : {"solid.width", "solid.radius", "solid.length", "solid.tube", "solid.height",
                          "solid.sides", "solid.scale_x", "own_roundness", "solid.roundness", "own_ball",
                          "solid.ball_radius", "solid.pull_radius", "rounding"})
    EXPECT_TRUE(seen_.contains(row)) << row << " was not looked at";
}

TEST_F(PanelProperties, OfSkinsAndOutlinesInOtherModesAreCommands) {
  open(document_of_sample("skin_smooth"));
  Skin skin = *object().skin()->skin;
  skin.method = SkinMethod::pleat;
  skin.pleat.fit = SectionFit::fair;
  skin.mirror = MirrorPlane{0, 0};
  commit(set_skin(editor().history.current(), id(), skin));
  look("pleated skin");
  editor().mode = ElementMode::vertex;
  editor().selection.select({id(), element_of(VertexId{path_point_ids})}, Selection::How::replace);
  look("point of the path");
  open(document_of_sample("sphere_cap"));
  OutlineSettings settings = object().outline()->settings;
  settings.mode = GaussMode::umbilic;
  settings.gap = 0.1;
  commit(set_outline_settings(editor().history.current(), id(), settings));
  look("outline with a gap");
  for (const char* row :
       {"skin_tension", "skin_mirror_at", "skin_path_sharp", "outline_gap_limited", "outline_gap"})
    EXPECT_TRUE(seen_.contains(row)) << row << " was not looked at";
}

TEST_F(PanelProperties, OfOthersThatAreChosenAreCommands) {
  const Document prism = document_from_mesh(test::prism(5), "Prism").value();
  open(add_object(prism, "Facets", Source(MeshSource::from_mesh(test::prism(5)).value()))->document);
  editor().mode = ElementMode::object;
  for (const auto& each : editor().document().objects)
    editor().selection.select({each->id, element_of(each->id)}, Selection::How::add);
  frames();
  ASSERT_TRUE(object().mesh());
  for (const char* row : {"density", "merge_coplanar", "mode", "frames"})
    EXPECT_FALSE(table().find(std::string("property.") + row)->why_not()) << row << " of the prism shows";
  EXPECT_TRUE(table().find("property.rounding")->why_not());
}

TEST_F(PanelProperties, OfPicturesAndCopiesAreCommands) {
  PictureSource picture;
  picture.path = "/nowhere/view.png";
  open(add_picture({}, "View", picture, {})->document);
  look("picture");
  const std::map<std::string, CopyArray> arrays{
      {"row", RowOfCopies{}}, {"ring", RingOfCopies{}}, {"mirror", MirrorOfCopies{}}};
  for (const auto& [kind, array] : arrays) {
    open(document_from_mesh(test::prism(5), "Prism").value());
    commit(set_copies(editor().history.current(), id(), {array}));
    look("copies in a " + kind);
  }
  for (const char* row : {"picture_opacity", "picture_layer", "picture_plane", "picture_only", "copies_count",
                          "copies_step.x", "copies_angle", "copies_plane"})
    EXPECT_TRUE(seen_.contains(row)) << row << " was not looked at";
}

TEST_F(PanelProperties, OfPaperAndTrianglesAreCommands) {
  open(document_from_mesh(test::prism(5), "Prism").value());
  editor().paper.shown = true;
  look("paper");
  editor().paper.shown = false;
  editor().meshing.open = true;
  look("triangles");
  for (const char* row : {"paper_width", "paper_page", "page_width", "paper_margin", "paper_tab",
                          "paper_distance", "paper_goal", "paper_steps", "paper_flat", "paper_side",
                          "paper_angles", "meshing.distance", "meshing.start"})
    EXPECT_TRUE(seen_.contains(row)) << row << " was not looked at";
}

/// It would take the keyboard when it comes.
TEST_F(PanelProperties, ThatDoNotShowAreNotWaitedFor) {
  open(document_of_sample("skin_smooth"));
  Skin skin = *object().skin()->skin;
  skin.method = SkinMethod::pleat;
  skin.pleat.fit = SectionFit::none;
  commit(set_skin(editor().history.current(), id(), skin));
  ASSERT_TRUE(table().run("property.skin_tension").ran);
  const std::size_t before = editor().notices().size();
  for (int i = 0; i < 30; ++i) bench_.frame();
  EXPECT_GT(editor().notices().size(), before) << "nothing says why nothing happened";
  skin.pleat.fit = SectionFit::fair;
  commit(set_skin(editor().history.current(), id(), skin));
  frames();
  EXPECT_FALSE(ImGui::GetIO().WantTextInput) << "the field took the keyboard long afterwards";
}

TEST_F(PanelProperties, OfThePlacementUnfoldIt) {
  open(document_from_mesh(test::prism(5), "Prism").value());
  ASSERT_FALSE(bench_.workbench().marks().all().contains("field.location.x"));
  ASSERT_TRUE(table().run("property.location.x").ran);
  for (int i = 0; i < 6; ++i) bench_.frame();
  EXPECT_TRUE(bench_.workbench().marks().all().contains("field.location.x"));
  bench_.type("7");
  bench_.tap("Enter");
  EXPECT_EQ(object().transform.translation.x(), 7);
}

}  // namespace
}  // namespace hariko
