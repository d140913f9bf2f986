// Every menu, dialog and panel by the keyboard alone: where it is can be seen, and Esc leads back.

#include <imgui_internal.h>

#include <fstream>
#include <set>

#include "app/pictures/samples.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "ui/base/key_chord.hpp"

namespace hariko::test {
namespace {

class Focus : public BenchHands {
 protected:
  Focus() : BenchHands(test::box(), {1280, 800}) {
    // A colour that nothing else has.
    ImGui::GetStyle().Colors[ImGuiCol_NavHighlight] = {1, 0, 1, 1};
    bench_.workbench().samples() = find_samples(test::source_folder() + "/assets");
    std::ofstream(folder_.path() / "model.hariko") << "x";
    RecentFile file;
    file.path = folder_.path() / "model.hariko";
    bench_.workbench().offers().recent.push_back(file);
    bench_.editor().path = folder_.path() / "model.hariko";
    frames();
  }
  /// Whether the ring of the keyboard is drawn, or a field takes what is typed.
  static bool can_be_seen() {
    if (GImGui->ActiveId != 0 && GImGui->ActiveId == GImGui->InputTextState.ID) return true;
    const ImU32 ring = ImGui::GetColorU32(ImGuiCol_NavHighlight);
    const ImDrawData* drawn = ImGui::GetDrawData();
    for (int i = 0; i < drawn->CmdListsCount; ++i)
      for (const ImDrawVert& vertex : drawn->CmdLists[i]->VtxBuffer)
        if (vertex.col == ring) return true;
    return false;
  }
  /// Presses a key some times; the items that it went to, all of which can be seen.
  std::set<ImGuiID> go(const char* key, int times, const std::string& where) {
    std::set<ImGuiID> items;
    for (int i = 0; i < times; ++i) {
      bench_.tap(key);
      frames(3);
      if (GImGui->NavId == 0 && GImGui->ActiveId == 0) continue;
      items.insert(GImGui->ActiveId != 0 ? GImGui->ActiveId : GImGui->NavId);
      EXPECT_TRUE(can_be_seen()) << where << ", " << key << " number " << i << ": " << stop();
    }
    return items;
  }
  /// Place of the keyboard, for messages: the window and the rectangle there, or the mark that is at it.
  std::string stop() {
    const ImGuiWindow* window = GImGui->NavWindow;
    if (!window) return "no window";
    const ImRect rect =
        ImGui::WindowRectRelToAbs(const_cast<ImGuiWindow*>(window), window->NavRectRel[GImGui->NavLayer]);
    std::string out = std::string(window->Name) + " " + std::to_string(int(rect.Min.x)) + "," +
                      std::to_string(int(rect.Min.y));
    for (const auto& [mark, place] : marks())
      if (std::abs(float(place.x) - rect.Min.x) < 2 && std::abs(float(place.y) - rect.Min.y) < 2)
        out += " " + mark;
    return out;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Focus, EveryMenuHasALetterOfItsOwn) {
  const std::vector<std::string> menus = bench_.workbench().commands().menus();
  const std::vector<char> letters = menu_letters(menus);
  const std::set<char> different(letters.begin(), letters.end());
  EXPECT_EQ(different.size(), menus.size());
  EXPECT_FALSE(different.contains('\0'));
  EXPECT_EQ(letters.front(), 'F');
  for (std::size_t i = 0; i < menus.size(); ++i) {
    tap("F10");
    tap(std::string(1, letters[i]));
    std::string first;
    for (const Command& command : bench_.workbench().commands().all())
      if (first.empty() && command.in_menu && command.menu == menus[i]) first = command.id;
    EXPECT_TRUE(marks().contains("command." + first)) << menus[i] << " by " << letters[i];
    // Some menus have only one command for a box.
    EXPECT_GE(go("Down", 3, menus[i]).size(), 1U) << "arrows do not go through " << menus[i];
    tap("Esc");
    EXPECT_FALSE(marks().contains("command." + first)) << menus[i];
  }
}

TEST_F(Focus, WithAltALetterOpensItsMenuWhereNoCommandHasTheChord) {
  const CommandTable& table = bench_.workbench().commands();
  const std::vector<std::string> menus = table.menus();
  const std::vector<char> letters = menu_letters(menus);
  int opened = 0;
  for (std::size_t i = 0; i < menus.size(); ++i) {
    const std::string chord = std::string("Alt+") + letters[i];
    const Command* owner = table.find(KeyChord::parse(chord).value());
    const auto before = bench_.workbench().command_log().number;
    tap(chord);
    const bool open = !GImGui->OpenPopupStack.empty();
    EXPECT_EQ(open, owner == nullptr) << chord;
    if (owner) EXPECT_GT(bench_.workbench().command_log().number, before) << chord;
    opened += open ? 1 : 0;
    tap("Esc");
  }
  EXPECT_GE(opened, 7);
}

TEST_F(Focus, TabGoesThroughEveryDialogAndEscCloses) {
  const std::vector<std::pair<const char*, std::size_t>> dialogs{
      {"file.open", 8},    {"file.import", 8},         {"file.save_as", 6},          {"file.save_copy", 6},
      {"file.export", 10}, {"file.export_picture", 8}, {"file.export_turntable", 8}, {"file.samples", 8},
      {"file.recent", 2}};
  for (const auto& [id, least] : dialogs) {
    SCOPED_TRACE(id);
    ASSERT_TRUE(bench_.workbench().commands().run(id).ran);
    frames(6);
    EXPECT_GE(go("Tab", 24, id).size(), least);
    EXPECT_GE(go("Shift+Tab", 4, id).size(), 2U);
    tap("Esc");
    EXPECT_TRUE(GImGui->OpenPopupStack.empty());
  }
}

TEST_F(Focus, EnterTakesTheOfferThatTheKeyboardIsAt) {
  ASSERT_TRUE(bench_.workbench().commands().run("file.recent").ran);
  frames();
  EXPECT_TRUE(can_be_seen()) << "no card has the keyboard";
  tap("Enter");
  EXPECT_TRUE(GImGui->OpenPopupStack.empty()) << "Enter did nothing";
}

TEST_F(Focus, TabGoesThroughEveryPageOfThePreferences) {
  for (const char* page : {"interface", "navigation", "units", "files", "colours", "keys"}) {
    SCOPED_TRACE(page);
    ASSERT_TRUE(bench_.workbench().commands().run("edit.preferences").ran);
    frames(6);
    click(std::string("preferences.page.") + page);
    // Six pages and the way back to the defaults stand beside each.
    EXPECT_GE(go("Tab", 24, page).size(), 8U);
    EXPECT_GE(go("Shift+Tab", 4, page).size(), 2U);
    tap("Esc");
    if (marks().contains("preferences")) bench_.tap("Esc");  // the first one left a field
    frames();
    EXPECT_FALSE(marks().contains("preferences"));
  }
}

TEST_F(Focus, TabGoesPastWhatCannotBeChangedNow) {
  bench_.tap("Ctrl+Alt+T");
  bench_.wait_for_surfaces();
  std::string panel;
  for (int i = 0; i < 6 && panel != "Meshing"; ++i) {
    tap("F6");
    panel = GImGui->NavWindow->RootWindow->Name;
  }
  ASSERT_EQ(panel, "Meshing");
  ASSERT_TRUE(marks().contains("meshing.edge"));
  const auto& tolerances = bench_.editor().meshing.settings;
  ASSERT_FALSE(tolerances.of(MeshCriterion::edge).on);
  bool reached = false;
  for (int i = 0; i < 16; ++i) {
    go("Tab", 1, panel);
    const std::string at = stop();
    reached = reached || at.ends_with("meshing.edge.on");
    EXPECT_FALSE(at.ends_with("meshing.edge")) << at;
  }
  EXPECT_TRUE(reached);
}

TEST_F(Focus, F6AndTabGoThroughEveryPanel) {
  std::set<std::string> seen;
  for (int i = 0; i < 12; ++i) {
    tap("F6");
    if (!GImGui->NavWindow || GImGui->NavDisableHighlight) break;
    const std::string name = GImGui->NavWindow->RootWindow->Name;
    seen.insert(name);
    EXPECT_GE(go("Tab", 6, name).size(), name == "History" ? 1U : 2U) << name;
    if (GImGui->ActiveId != 0) {
      tap("Enter");
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"Objects", "Properties", "History", "Tools"}));
}

TEST_F(Focus, TabBeginsWithTheFirstItemWhereItsOwnIsGone) {
  bench_.workbench().commands().run("select.all");
  frames();
  for (int i = 0; i < 6 && std::string(GImGui->NavWindow->RootWindow->Name) != "Properties"; ++i) {
    tap("F6");
  }
  ASSERT_STREQ(GImGui->NavWindow->RootWindow->Name, "Properties");
  // Some rows belong to the selection alone, some stay.
  int gone = 0;
  for (int i = 1; i <= 12; ++i) {
    ASSERT_TRUE(bench_.workbench().commands().run("select.all").ran);
    frames();
    go("Tab", 1, "Properties");
    if (GImGui->ActiveId != 0) bench_.tap("Enter");
    ASSERT_TRUE(bench_.workbench().commands().run("select.none").ran);
    frames();
    if (GImGui->NavIdIsAlive) continue;
    ++gone;
    go("Tab", 1, "Properties");
    EXPECT_TRUE(GImGui->NavIdIsAlive) << "Tab number " << i << " went nowhere";
  }
  EXPECT_GT(gone, 0);
}

TEST_F(Focus, APanelThatClosesGivesTheKeyboardBack) {
  tap("Ctrl+Alt+T");
  for (int i = 0; i < 6 && std::string(GImGui->NavWindow->RootWindow->Name) != "Meshing"; ++i) {
    tap("F6");
  }
  ASSERT_STREQ(GImGui->NavWindow->RootWindow->Name, "Meshing");
  tap("Ctrl+Alt+T");
  EXPECT_FALSE(ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard);
  EXPECT_FALSE(can_be_seen());
}

}  // namespace
}  // namespace hariko::test
