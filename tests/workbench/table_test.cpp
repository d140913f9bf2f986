// The command table as the program has it: complete, translated, and every command runs or says why not.

#include <gtest/gtest.h>

#include <set>

#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/command_search.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {
namespace {

using test::HeadlessWorkbench;

Document box() {
  return document_from_mesh(test::prism(4), "Box").value();
}

TEST(Table, EveryCommandIsNamedExplainedAndTranslated) {
  HeadlessWorkbench bench(box());
  const auto japanese = Language::load(test::source_folder() + "/assets/languages/ja.po");
  ASSERT_TRUE(japanese.ok());
  std::map<std::string, std::string> keys;
  for (const Command& command : bench.workbench().commands().all()) {
    SCOPED_TRACE(command.id);
    EXPECT_FALSE(command.label.empty());
    EXPECT_FALSE(command.help.empty());
    EXPECT_NE(command.id.find('.'), std::string::npos);
    EXPECT_FALSE(menu_folders(command.menu).empty());
    for (const std::string& folder : menu_folders(command.menu)) EXPECT_TRUE(japanese->has(folder)) << folder;
    const bool own_name = command.id.starts_with("language.");
    EXPECT_TRUE(own_name || japanese->has(command.label)) << command.label;
    EXPECT_TRUE(japanese->has(command.help)) << command.help;
    EXPECT_TRUE(own_name || command.other_names.empty() || japanese->has(command.other_names))
        << command.other_names;
    const auto chords = parse_keys(command.keys).value();
    for (const KeyChord& chord : chords) {
      const auto [it, fresh] = keys.emplace(chord.to_string(), command.id);
      EXPECT_TRUE(fresh) << chord.to_string() << " is also the key of " << it->second;
    }
  }
}

TEST(Table, EveryLanguageWithACatalogueCanBeChosenAndFound) {
  HeadlessWorkbench bench(box());
  const CommandTable& commands = bench.workbench().commands();
  ASSERT_FALSE(bench.editor().languages.empty());
  for (const LanguageFile& each : bench.editor().languages) {
    const std::string id = "language." + each.id;
    ASSERT_TRUE(commands.run(id).ran) << id;
    EXPECT_EQ(bench.editor().settings.language, each.id);
    EXPECT_TRUE(commands.find(id)->checked());
    const auto found = search_commands(commands, Language(), each.english_name, {});
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front()->id, id);
  }
  ASSERT_TRUE(commands.run("language.english").ran);
  EXPECT_EQ(bench.editor().settings.language, english_id);
}

/// Besides, what is caught can change in the middle of a tool, and a script can end; the working plane and
/// saved views, which are part of the document, stay.
TEST(Table, WhileAToolRunsKeysOfTheViewAndOfHelpWorkAndNoOthers) {
  HeadlessWorkbench bench(box());
  for (const Command& command : bench.workbench().commands().all()) {
    const std::string menu = menu_folders(command.menu).front();
    const bool beside = command.id.starts_with("snap.") || command.id == "edit.stop_script";
    const bool places = command.id.starts_with("plane.") && command.id != "plane.look";
    const bool edits = command.id == "view.save" || command.id == "view.update" ||
                       command.id == "view.rename" || command.id == "view.delete";
    EXPECT_EQ(command.while_tool_runs, ((menu == "View" || menu == "Help") && !places && !edits) || beside)
        << command.id;
  }
  ASSERT_TRUE(bench.workbench().commands().run("select.box").ran);
  bench.frame();
  const bool grid = bench.editor().view.grid, lasso = bench.editor().selecting.lasso;
  for (const bool running : {true, false}) {
    SCOPED_TRACE(running);
    ASSERT_EQ(bench.workbench().viewport().tool_active(), running);
    bench.key("Shift+G");
    bench.key("Q");
    EXPECT_EQ(bench.editor().view.grid, running ? !grid : grid);
    EXPECT_EQ(bench.editor().selecting.lasso, running ? lasso : !lasso);
    if (running) bench.key("Esc");
  }
}

TEST(Table, EveryContextOffersSomething) {
  HeadlessWorkbench bench(box());
  for (const Context context :
       {Context::vertex, Context::edge, Context::face, Context::object, Context::empty})
    EXPECT_GE(context_menu_tree(bench.workbench().commands(), context).size(), 3U)
        << static_cast<unsigned>(context);
}

/// Runs everything, each on the start page or on a new box; gives the ids of what ran.
std::set<std::string> run_everything(HeadlessWorkbench& bench, bool document) {
  std::set<std::string> ran;
  std::vector<std::string> ids;
  for (const Command& command : bench.workbench().commands().all()) ids.push_back(command.id);
  for (const std::string& id : ids) {
    SCOPED_TRACE(id);
    // Several begin or close a document.
    bench.editor().open(document ? box() : Document(), {});
    bench.editor().has_document = document;
    if (document) bench.editor().selection.select_all(*bench.editor().active_object(), ElementMode::vertex);
    const auto outcome = bench.workbench().commands().run(id);
    if (outcome.ran)
      ran.insert(id);
    else
      EXPECT_GT(outcome.reason.size(), 8U);
    for (int i = 0; i < 2; ++i) bench.frame();
    for (int i = 0; i < 4; ++i) bench.key("Esc");
  }
  return ran;
}

TEST(Table, EveryCommandRunsOrSaysWhyNotWithoutADocument) {
  HeadlessWorkbench bench(box());
  const auto ran = run_everything(bench, false);
  EXPECT_FALSE(ran.contains("file.save"));
  EXPECT_TRUE(ran.contains("file.open"));
}

TEST(Table, EveryCommandRunsOrSaysWhyNotOnADocument) {
  HeadlessWorkbench bench(box());
  const auto ran = run_everything(bench, true);
  EXPECT_TRUE(ran.contains("file.save"));
  EXPECT_TRUE(ran.contains("select.all"));
}

TEST(Table, ThePaletteRunsWhatItFinds) {
  HeadlessWorkbench bench(box());
  bench.key("F3");
  bench.frame();
  EXPECT_TRUE(bench.workbench().marks().all().contains("palette.input"));
  // The first row: Enter runs it after the palette has gone.
  std::string first;
  for (const auto& [name, rect] : bench.workbench().marks().all())
    if (name.starts_with("palette.selected.")) first = name.substr(17);
  ASSERT_FALSE(first.empty());
  bench.key("Enter");
  bench.frame();
  bench.frame();
  EXPECT_FALSE(bench.workbench().marks().all().contains("palette.input"));
  EXPECT_EQ(bench.workbench().command_log().last.first, first);
}

TEST(Table, ARightPressWithoutADragOpensTheContextMenu) {
  HeadlessWorkbench bench(box());
  const auto shown = [&] {
    bench.frame();
    return bench.workbench().marks().all().contains("context.title");
  };
  bench.move(200, 300);
  bench.press(1);
  bench.release(1);
  EXPECT_TRUE(shown());
  bench.key("Esc");
  EXPECT_FALSE(shown());
  bench.press(1);
  bench.move(230, 310);
  bench.release(1);
  EXPECT_FALSE(shown());
  bench.key("Menu");
  EXPECT_TRUE(shown());
}

TEST(Table, KeysOfTheSettingsAreTakenUp) {
  HeadlessWorkbench bench(box());
  bench.editor().settings.keys = {{"view.frame_all", "F9"}, {"no.such", "F10"}};
  bench.frame();
  EXPECT_EQ(bench.workbench().commands().find("view.frame_all")->keys, "F9");
  ASSERT_FALSE(bench.editor().notices().empty());
  EXPECT_EQ(bench.editor().notices().back().kind, Notice::Kind::warning);
  bench.editor().settings.keys.clear();
  bench.frame();
  EXPECT_EQ(bench.workbench().commands().find("view.frame_all")->keys,
            bench.workbench().commands().find("view.frame_all")->default_keys);
}

TEST(Table, ARefusedKeySaysWhyAtThePointer) {
  HeadlessWorkbench bench(box());
  bench.move(300, 300);
  bench.key("Ctrl+Z");
  ASSERT_TRUE(bench.editor().cursor_note.has_value());
  EXPECT_EQ(bench.editor().cursor_note->text, "There is nothing to undo.");
  EXPECT_EQ(bench.editor().cursor_note->x, 300);
  for (int i = 0; i < 80; ++i) bench.frame();
  EXPECT_FALSE(bench.editor().cursor_note.has_value());
}

}  // namespace
}  // namespace hariko
