// The interface by the keyboard alone, names, and dialogs that stay inside of the window.

#include <imgui_internal.h>

#include <set>

#include "tests/workbench/bench_hands.hpp"
#include "ui/base/settings_members.hpp"
#include "ui/editor/command_search.hpp"
#include "ui/shell/preference_rows.hpp"

namespace hariko::test {
namespace {

class Keyboard : public BenchHands {
 protected:
  Keyboard() : BenchHands(test::box(), {1280, 800}) {}
  std::string last_command() { return bench_.workbench().command_log().last.first; }
};

TEST_F(Keyboard, F10OpensTheFirstMenuAndArrowsAndEnterRunACommand) {
  tap("F10");
  ASSERT_TRUE(marks().contains("command.file.open"));
  bench_.tap("Down");
  tap("Enter");
  EXPECT_FALSE(marks().contains("command.file.open")) << "the menu is still open";
  EXPECT_TRUE(last_command().starts_with("file.")) << last_command();
}

TEST_F(Keyboard, AltAndALetterOpenAMenuAndEscClosesIt) {
  tap("Alt+F");
  EXPECT_TRUE(marks().contains("command.file.open"));
  tap("Esc");
  EXPECT_FALSE(marks().contains("command.file.open"));
}

TEST_F(Keyboard, AQuestionHasADefaultThatEnterTakesAndArrowsChange) {
  std::string answer;
  const auto ask = [&] {
    bench_.workbench().ask({"Title",
                            "Text",
                            {{"One", "one", [&] { answer = "one"; }},
                             {"Two", "two", [&] { answer = "two"; }},
                             {"Three", "three", [&] { answer = "three"; }}}});
    frames();
  };
  ask();
  tap("Enter");
  EXPECT_EQ(answer, "one");
  EXPECT_EQ(bench_.workbench().question(), nullptr);
  ask();
  bench_.tap("Right");
  bench_.tap("Tab");
  tap("Enter");
  EXPECT_EQ(answer, "three");
  ask();
  bench_.tap("Shift+Tab");
  bench_.tap("Shift+Tab");
  tap("Space");
  EXPECT_EQ(answer, "two");
}

TEST_F(Keyboard, F6GoesFromPanelToPanelAndKeysChangeWhatIsThere) {
  tap("F6");
  EXPECT_EQ(std::string(GImGui->NavWindow->RootWindow->Name), "Objects");
  tap("F6");
  EXPECT_EQ(std::string(GImGui->NavWindow->RootWindow->Name), "Properties");
  EXPECT_FALSE(GImGui->NavDisableHighlight) << "no focus can be seen";
  const ElementMode mode = editor().mode;
  bench_.tap("Down");
  EXPECT_NE(GImGui->NavId, 0U);
  tap("Esc");
  EXPECT_TRUE(GImGui->NavDisableHighlight);
  EXPECT_EQ(editor().mode, mode);
  bench_.key("2");
  EXPECT_EQ(editor().mode, ElementMode::edge) << "keys are commands again";
}

TEST_F(Keyboard, PreferencesStayInsideOfTheWindowAtEveryScale) {
  bench_.workbench().commands().run("edit.preferences");
  frames();
  for (const double width : {1280.0, 800.0}) {
    ImGui::GetIO().DisplaySize = {float(width), width == 800 ? 600.0F : 800.0F};
    for (const float scale : {1.0F, 1.5F, 2.5F, 1.0F}) {
      SCOPED_TRACE(scale);
      bench_.set_scale(scale);
      frames();
      const Marks::Rect rect = marks().at("preferences");
      EXPECT_GE(rect.x, 0);
      EXPECT_GE(rect.y, 0);
      EXPECT_LE(rect.x + rect.width, int(width));
      EXPECT_LE(rect.y + rect.height, width == 800 ? 600 : 800);
    }
  }
}

/// Visitor of settings.
struct MemberNames {
  template <class Value>
  void choice(const char* name, const Value&) {
    all.insert(name);
  }
  template <class Value>
  void texts(const char* name, const Value&) {
    all.insert(name);
  }
  void text(const char* name, const std::string&) { all.insert(name); }
  void flag(const char* name, bool) { all.insert(name); }
  void number(const char* name, double, double, double) { all.insert(name); }
  std::set<std::string> all;
};

/// The rows are data, and name the members as the file of the settings does.
TEST_F(Keyboard, EveryRowOfThePreferencesShowsAMemberOfTheSettings) {
  MemberNames names;
  visit_settings(names, editor().settings);
  for (const PreferenceRow& row : preference_rows())
    EXPECT_TRUE(names.all.contains(row.member)) << row.member;
}

TEST_F(Keyboard, APageOfThePreferencesIsResetAlone) {
  Settings& settings = editor().settings;
  settings.trackball = settings.colour_blind_maps = true;
  settings.orbit_speed = 3;
  settings.unit = Unit::inch;
  reset_preferences(settings, Preferences::Page::navigation);
  EXPECT_FALSE(settings.trackball);
  EXPECT_EQ(settings.orbit_speed, 1);
  EXPECT_TRUE(settings.colour_blind_maps);
  EXPECT_EQ(settings.unit, Unit::inch);
}

/// At 250 % in a small window the way back to another scale was out of reach.
TEST_F(Keyboard, PreferencesCanBeReachedAtEveryScale) {
  bench_.workbench().commands().run("edit.preferences");
  ImGui::GetIO().DisplaySize = {800, 600};
  for (const float scale : {1.0F, 1.5F, 2.5F}) {
    SCOPED_TRACE(scale);
    bench_.set_scale(scale);
    frames();
    for (const auto& [page, fields] :
         {std::pair("interface", std::set<std::string>{"theme.dark", "scale.100", "scale.250"}),
          {"navigation", {"navigation.rhino", "turntable", "orbit_speed"}}}) {
      SCOPED_TRACE(page);
      click(std::string("preferences.page.") + page);
      const Marks::Rect dialog = marks().at("preferences");
      for (const std::string& field : fields) {
        ASSERT_TRUE(marks().contains("preferences." + field)) << field;
        const Marks::Rect rect = marks().at("preferences." + field);
        EXPECT_GE(rect.x, dialog.x) << field;
        EXPECT_LE(rect.x + rect.width, dialog.x + dialog.width) << field;
        EXPECT_GE(rect.width, int(20 * scale)) << field;
      }
    }
  }
}

TEST_F(Keyboard, CopiesAreCountedAndHiddenOnesAreNotSelected) {
  editor().mode = ElementMode::object;
  for (int i = 0; i < 3; ++i) bench_.workbench().commands().run("object.duplicate");
  std::vector<std::string> names;
  for (const auto& object : editor().document().objects) names.push_back(object->name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"Box", "Box 2", "Box 3", "Box 4"}));
  frames(2);
  ASSERT_EQ(editor().selection.objects().size(), 1U);
  ASSERT_TRUE(marks().contains("gizmo.move.x"));
  bench_.workbench().commands().run("object.hide");
  frames(2);
  EXPECT_TRUE(editor().selection.objects().empty());
  EXPECT_FALSE(marks().contains("gizmo.move.x")) << "a gizmo in the void";
  EXPECT_FALSE(bench_.workbench().commands().run("transform.move").ran);
  bench_.workbench().commands().run("object.show_all");
  editor().selection.select({editor().selection.active, element_of(editor().selection.active)},
                            Selection::How::replace);
  bench_.workbench().commands().run("object.lock");
  frames(2);
  EXPECT_TRUE(editor().selection.objects().empty());
  EXPECT_FALSE(marks().contains("gizmo.move.x"));
}

TEST_F(Keyboard, TheListOfManyObjectsGrowsIsSearchedAndSorted) {
  for (int i = 0; i < 19; ++i) bench_.workbench().commands().run("object.duplicate");
  frames();
  int rows = 0;
  for (const auto& [mark, rect] : marks()) rows += mark.starts_with("object.") ? 1 : 0;
  EXPECT_GE(rows, 9) << "of 20 at a height of 800";
  // By hand it becomes taller.
  const Marks::Rect end = marks().at("outliner.end");
  bench_.move(end.x + 60, end.y + 2);
  bench_.press();
  bench_.move(end.x + 60, end.y + 60);
  bench_.move(end.x + 60, end.y + 150);
  bench_.release();
  frames();
  int more = 0;
  for (const auto& [mark, rect] : marks()) more += mark.starts_with("object.") ? 1 : 0;
  EXPECT_GE(more, rows + 3);
  bench_.click("outliner.search");
  bench_.type("Box 12");
  tap("Enter");
  int found = 0;
  for (const auto& [mark, rect] : marks()) found += mark.starts_with("object.") ? 1 : 0;
  EXPECT_EQ(found, 1);
  bench_.click("outliner.search");
  for (int i = 0; i < 8; ++i) bench_.tap("Backspace");
  bench_.tap("Enter");
  click("outliner.order");
  click("outliner.order.1");
  // By their numbers: Box, Box 2, Box 3 ... and not Box 10 before Box 2.
  const auto id_of = [&](const std::string& name) {
    for (const auto& object : editor().document().objects)
      if (object->name == name) return "object." + std::to_string(object->id.value);
    return std::string();
  };
  EXPECT_LT(marks().at(id_of("Box")).y, marks().at(id_of("Box 2")).y);
  EXPECT_LT(marks().at(id_of("Box 2")).y, marks().at(id_of("Box 3")).y);
  // A range with Shift takes the rows between, as they stand.
  bench_.click(id_of("Box"));
  bench_.hold(true, false, false);
  bench_.click(id_of("Box 4"));
  bench_.hold(false, false, false);
  EXPECT_EQ(editor().selection.objects().size(), 4U);
}

TEST_F(Keyboard, RenamingBringsTheRowIntoSight) {
  for (int i = 0; i < 39; ++i) bench_.workbench().commands().run("object.duplicate");
  frames();
  const ObjectId active = editor().selection.active;
  const std::string row = "object." + std::to_string(active.value);
  ASSERT_TRUE(marks().contains(row));
  // The wheel goes away from it, whichever end of the list it is at.
  const Marks::Rect place = marks().at(row);
  bench_.move(place.x + 40, place.y + 4);
  for (const double way : {30.0, -30.0})
    if (marks().contains(row)) {
      bench_.wheel(way);
      frames();
    }
  ASSERT_FALSE(marks().contains(row));
  tap("F2");
  bench_.type("Shelf");
  tap("Enter");
  EXPECT_EQ(editor().document().find(active)->name, "Shelf");
}

TEST_F(Keyboard, ThePaletteFindsSettingsAndNotWhatMerelySoundsAlike) {
  const CommandTable& table = bench_.workbench().commands();
  const auto found = [&](const char* query) {
    std::vector<std::string> ids;
    for (const Command* command : search_commands(table, Language(), query, {})) ids.push_back(command->id);
    return ids;
  };
  const auto has = [&](const char* query, const char* id) {
    const auto ids = found(query);
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  EXPECT_TRUE(has("two rails", "property.skin_frame.3"));
  EXPECT_TRUE(has("tightness", "property.tightness"));
  EXPECT_TRUE(has("mirror", "property.mirror"));
  EXPECT_TRUE(has("orbit speed", "property.preferences.orbit_speed"));
  EXPECT_FALSE(has("boolean", "shape.separate_patches"));
  EXPECT_FALSE(has("draft", "solid.row"));
  EXPECT_TRUE(has("draft", "analyse.draft"));
  EXPECT_FALSE(has("group", "skin.correspond"));
  EXPECT_TRUE(found("boolean").empty()) << found("boolean").front();
}

TEST_F(Keyboard, ThePaletteRunsASettingAndShowsNothingForWhatIsNotThere) {
  const auto rows = [&] {
    std::set<std::string> out;
    for (const auto& [mark, rect] : marks())
      if (mark.starts_with("palette.") && mark != "palette.input") out.insert(mark);
    return out;
  };
  const auto ask = [&](const char* text) {
    tap("F3");
    bench_.type(text);
    frames();
  };
  ask("boolean");
  EXPECT_TRUE(rows().empty()) << *rows().begin();
  tap("Esc");
  ask("orbit speed");
  EXPECT_TRUE(rows().contains("palette.selected.property.preferences.orbit_speed"));
  bench_.tap("Enter");
  frames(8);
  EXPECT_TRUE(marks().contains("preferences.orbit_speed")) << "the page with the setting";
}

}  // namespace
}  // namespace hariko::test
