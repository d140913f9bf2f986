// Scripts that are recorded in the window: run without it they make the same document.

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "app/files/open_file.hpp"
#include "app/scripts/script_recorder.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {
namespace {

namespace fs = std::filesystem;

OpenedFile open_plainly(const fs::path& path) {
  return open_file(path);
}

/// Runs a script as `hariko run` does, from a document or from none.
std::optional<Document> result_of(const Script& script, const std::optional<Document>& from) {
  ScriptSession session(open_plainly);
  if (from) session.editor().open(*from, std::nullopt);
  for (std::size_t i = 0; i < script.steps.size(); ++i) {
    const ScriptStep& step = script.steps[i];
    const Command* command = session.commands().find(step.command);
    if (!command) {
      ADD_FAILURE() << step_text(i, step.command) << " is no command";
      return {};
    }
    const Unit unit = session.editor().has_document ? session.editor().document().unit : Unit::millimetre;
    const auto arguments = read_arguments(command->script.arguments, step.arguments, unit);
    if (!arguments.ok()) {
      ADD_FAILURE() << step_text(i, step.command) << ": " << arguments.error().text;
      return {};
    }
    if (const auto done = session.run(*command, *arguments); !done.ok()) {
      ADD_FAILURE() << step_text(i, step.command) << ": " << done.error().text;
      return {};
    }
  }
  return session.editor().history.current();
}

class ScriptRecording : public ::testing::Test {
 protected:
  explicit ScriptRecording(Document document = {}) : bench_(std::move(document), {1280, 900}, &services_) {
    services_.recorder.emplace(bench_.editor(), bench_.workbench(), open_plainly);
  }
  ~ScriptRecording() override { services_.recorder.reset(); }

  Editor& editor() { return bench_.editor(); }
  void frames(int count = 4) {
    for (int i = 0; i < count; ++i) bench_.frame();
  }
  void run(const char* id) {
    const auto outcome = bench_.workbench().commands().run(id);
    ASSERT_TRUE(outcome.ran) << id << ": " << outcome.reason;
    frames();
  }
  /// Keys, one after the other.
  void press(std::initializer_list<const char*> keys) {
    for (const char* key : keys) bench_.key(key);
    frames();
  }
  /// Through the dialog that asks for the file.
  void record() {
    run("edit.record_script");
    ASSERT_TRUE(bench_.workbench().marks().all().contains("dialog.name"));
    bench_.enter(file().string());
    frames();
    ASSERT_TRUE(editor().script_recording.has_value());
    EXPECT_TRUE(bench_.workbench().marks().all().contains("status.stop_script"));
    bench_.move(640, 450);
  }
  /// By the button in the status line.
  Script stop() {
    frames();
    bench_.click("status.stop_script");
    frames();
    EXPECT_FALSE(editor().script_recording.has_value());
    const auto text = test::must(read_file(file(), 1 << 20));
    return *test::must(read_script(*text));
  }
  void expect_same(const Script& script, const std::optional<Document>& from = {}) {
    EXPECT_EQ(script.left_out, 0U) << (script.notes.empty() ? std::string() : script.notes.back());
    const auto made = result_of(script, from);
    ASSERT_TRUE(made.has_value());
    EXPECT_EQ(*made, editor().history.current()) << write_script(script);
  }
  static std::size_t count_of(const Script& script, const std::string& command) {
    return static_cast<std::size_t>(
        std::count_if(script.steps.begin(), script.steps.end(),
                      [&](const ScriptStep& step) { return step.command == command; }));
  }
  void choose_face(std::uint32_t face) {
    press({"3"});
    editor().selection.select({editor().selection.active, element_of(FaceId{face})}, Selection::How::replace);
    frames();
  }
  fs::path file() const { return folder_.path() / "recorded.json"; }

  struct Services final : test::NoServices {
    void record_script(const fs::path& path) override { recorder->begin(path); }
    void stop_script() override { recorder->finish(); }
    std::optional<ScriptRecorder> recorder;
  };
  test::TemporaryFolder folder_;
  Services services_;
  HeadlessWorkbench bench_;
};

TEST_F(ScriptRecording, WhatKeysDoIsDoneAgainWithoutTheWindow) {
  record();
  run("add.box");
  choose_face(1);
  press({"E", "2", "5", "Enter"});  // extrudes
  press({"G", "X", "1", "0", "Enter"});
  press({"R", "Z", "3", "0", "Enter"});
  press({"S", "0", ".", "5", "Enter"});
  press({"2", "Ctrl+A", "Ctrl+Z"});  // undoes the scaling
  run("mesh.subdivide");
  press({"4", "G", "Z", "7", "Enter"});
  press({"Shift+R"});  // moves once more
  const Script script = stop();
  EXPECT_EQ(script.steps.front().command, "file.new");
  EXPECT_EQ(count_of(script, "mesh.extrude"), 1U);
  EXPECT_EQ(count_of(script, "transform.rotate"), 1U);
  EXPECT_EQ(count_of(script, "transform.scale"), 0U) << "it was undone";
  EXPECT_EQ(count_of(script, "transform.move"), 3U);
  expect_same(script);
}

TEST_F(ScriptRecording, NumbersThatAreAdjustedAreWrittenOnce) {
  record();
  run("add.prism");
  editor().last_operation.adjust(editor(), 0, 9);
  frames();
  editor().last_operation.adjust(editor(), 2, 33);
  frames();
  run("object.array_row");
  editor().last_operation.adjust(editor(), 0, 5);
  frames();
  editor().undo();
  frames();
  editor().redo();
  frames();
  const Script script = stop();
  EXPECT_EQ(count_of(script, "add.prism"), 1U);
  EXPECT_EQ(count_of(script, "object.array_row"), 1U);
  EXPECT_EQ(editor().document().objects.size(), 5U);
  expect_same(script);
}

TEST_F(ScriptRecording, MirrorImagesAreWrittenWithTheirPlane) {
  record();
  run("add.box");
  run("object.mirror_copy_x");
  editor().last_operation.adjust(editor(), 0, 130);
  frames();
  run("object.mirror_copy_y");
  editor().last_operation.adjust(editor(), 0, -75);
  frames();
  editor().last_operation.adjust(editor(), 1, 1);
  frames();
  const Script script = stop();
  EXPECT_EQ(count_of(script, "object.mirror_copy_x"), 1U);
  EXPECT_EQ(count_of(script, "object.mirror_copy_y"), 1U);
  ASSERT_EQ(editor().document().objects.size(), 2U);
  EXPECT_EQ(place_count(*editor().document().objects[0]), 1U);
  EXPECT_EQ(place_count(*editor().document().objects[1]), 2U) << "the image was chosen";
  expect_same(script);
}

/// Whatever commands come one after the other: what the file does not name as missing it repeats.
TEST_F(ScriptRecording, OfRandomCommandsRepeatsThem) {
  constexpr std::array commands{
      "add.box",      "add.torus",        "add.prism",        "mesh.subdivide",     "mesh.poke",
      "mesh.connect", "select.all",       "select.invert",    "select.grow",        "select.none",
      "select.faces", "select.edges",     "select.vertices",  "select.objects",     "select.to_edges",
      "object.hide",  "object.show_all",  "object.duplicate", "object.delete",      "object.move_up",
      "object.lock",  "object.array_row", "edit.undo",        "edit.undo",          "edit.redo",
      "edit.repeat",  "shape.crease",     "object.isolate",   "object.align_x_low", "material.metal"};
  int whole = 0;
  constexpr int sessions = 6;
  test::for_random(4211, sessions, [&](std::mt19937_64& rng) {
    editor().open(Document(), std::nullopt);
    services_.recorder->begin(file());
    for (int i = 0; i < 30; ++i) {
      const int chosen = test::uniform_int(rng, 0, int(commands.size()) - 1);
      const char* id = commands[static_cast<std::size_t>(chosen)];
      ASSERT_NE(bench_.workbench().commands().find(id), nullptr) << id;
      bench_.workbench().commands().run(id);
      bench_.frame();
    }
    const Script script = services_.recorder->script();
    services_.recorder->finish();
    if (script.left_out > 0) return;
    ++whole;
    expect_same(script);
  });
  EXPECT_GT(whole, sessions / 2);
}

/// Begins with an object of another session.
class ScriptRecordingOfAPrism : public ScriptRecording {
 protected:
  ScriptRecordingOfAPrism() : ScriptRecording(prism()) {}
  static Document prism() {
    Document document = document_from_mesh(test::prism(5), "Prism").value();
    return set_frames(document, document.objects[0]->id, Frames::metric).value();
  }
};

TEST_F(ScriptRecordingOfAPrism, FieldsArePropertiesAndTensionsOfElements) {
  record();
  const ObjectId id = editor().selection.active;
  const auto edit = [&](const Result<Document>& result, const char* label) {
    ASSERT_TRUE(editor().commit(result, label));
    frames();
  };
  edit(set_mode(editor().document(), id, Mode::g2), "Surface");
  edit(rename_object(editor().document(), id, "Part"), "Rename object");
  Similarity place = editor().active_object()->transform;
  place.translation = {1.25, 0, -3};
  edit(set_transform(editor().document(), id, place), "Place object");
  const Polyhedron& polyhedron = editor().active_object()->polyhedron()->polyhedron;
  const std::vector<EdgeId> edges{polyhedron.edge_id(0), polyhedron.edge_id(3)};
  edit(set_beta(editor().document(), id, edges, 2.5), "Tension");
  edit(set_visible(editor().document(), id, false), "Hide object");
  const Script script = stop();
  for (const char* command :
       {"property.mode", "object.rename", "property.location.x", "shape.tension", "object.hide"})
    EXPECT_EQ(count_of(script, command), 1U) << command << "\n" << write_script(script);
  ASSERT_FALSE(script.notes.empty());
  EXPECT_NE(script.notes[0].find("--in"), std::string::npos);
  expect_same(script, prism());
}

TEST_F(ScriptRecordingOfAPrism, SwitchesAreWrittenAsTheyAreAfterwards) {
  record();
  press({"2", "Ctrl+A", "C"});
  ASSERT_FALSE(editor().active_object()->polyhedron()->shaping->crease.empty());
  press({"C"});
  ASSERT_TRUE(editor().active_object()->polyhedron()->shaping->crease.empty());
  press({"1", "Ctrl+A", "T", "3", "Enter"});  // tension of vertices, typed
  run("object.lock");
  run("object.lock");
  const Script script = stop();
  EXPECT_EQ(count_of(script, "shape.crease"), 2U);
  EXPECT_EQ(count_of(script, "object.lock"), 2U);
  EXPECT_EQ(count_of(script, "shape.tension"), 1U);
  expect_same(script, prism());
}

TEST_F(ScriptRecordingOfAPrism, WhatHasNoCommandIsToldAndCounted) {
  record();
  choose_face(0);
  run("mesh.poke");
  // As by hand: two vertices, each its own way.
  const ObjectId id = editor().selection.active;
  const std::vector<VertexId> vertices{{1}, {2}};
  const Polyhedron& polyhedron = editor().active_object()->polyhedron()->polyhedron;
  const std::vector<Vector3> places{polyhedron.position(polyhedron.find(vertices[0])) + Vector3(0.1, 0, 0),
                                    polyhedron.position(polyhedron.find(vertices[1])) + Vector3(0, 0.2, 0)};
  ASSERT_TRUE(editor().commit(move_vertices(editor().document(), id, vertices, places), "By hand"));
  frames();
  EXPECT_EQ(editor().script_recording->left_out, 1U);
  EXPECT_NE(editor().notices().back().text.find("By hand"), std::string::npos);
  choose_face(1);
  run("mesh.subdivide");
  const Script script = stop();
  EXPECT_EQ(script.left_out, 1U);
  EXPECT_TRUE(std::any_of(script.notes.begin(), script.notes.end(),
                          [](const std::string& note) { return note.find("By hand") != std::string::npos; }));
  EXPECT_EQ(count_of(script, "mesh.poke"), 1U);
  EXPECT_EQ(count_of(script, "mesh.subdivide"), 1U) << "what can be said is said";
  EXPECT_EQ(editor().notices().back().kind, Notice::Kind::warning);
}

TEST_F(ScriptRecordingOfAPrism, TheButtonThatEndsItStaysInItsPlace) {
  const auto button = [&] { return bench_.workbench().marks().all().at("status.stop_script"); };
  const auto state = [&] { return bench_.workbench().marks().all().at("status.right"); };
  record();
  const auto before = button();
  const int text_before = state().x;
  choose_face(0);
  run("mesh.poke");
  frames(20);
  EXPECT_NE(state().x, text_before) << "the text of the state did not change its length";
  EXPECT_EQ(button(), before);
  bench_.click("status.stop_script");
  frames();
  EXPECT_FALSE(editor().script_recording.has_value());
}

TEST_F(ScriptRecordingOfAPrism, AnUndoneEditIsMissingNoLonger) {
  record();
  const ObjectId id = editor().selection.active;
  const std::vector<VertexId> vertices{{1}, {2}};
  const std::vector<Vector3> places{Vector3(3, 0, 0), Vector3(0, 4, 0)};
  ASSERT_TRUE(editor().commit(move_vertices(editor().document(), id, vertices, places), "By hand"));
  frames();
  EXPECT_EQ(editor().script_recording->left_out, 1U);
  press({"Ctrl+Z"});
  EXPECT_EQ(editor().script_recording->left_out, 0U);
  run("object.duplicate");
  expect_same(stop(), prism());
}

TEST(ScriptText, IsReadAsItWasWritten) {
  Script script;
  script.left_out = 2;
  script.notes = {"one \"quoted\"", "面取り"};
  script.steps = {
      {"add.box", {written("at", Vector3(0.1, -1e-17, 3e20)), written("name", std::string("A\\B"))}},
      {"select.none", {}},
      {"select.edges", {written("ids", std::vector<std::string>{"0-1", "1-2"})}},
      {"view.grid", {written_switch("on", false)}}};
  const auto read = test::must(read_script(write_script(script)));
  EXPECT_EQ(read->steps, script.steps);
  EXPECT_EQ(read->notes, script.notes);
  EXPECT_EQ(read->left_out, 2U);
  EXPECT_FALSE(read_script(R"({"format":"hariko-script","version":1,"steps":[],"left_out":-1})").ok());
  EXPECT_FALSE(read_script(R"({"format":"hariko-script","version":1,"steps":[],"notes":[1]})").ok());
}

}  // namespace
}  // namespace hariko::test
