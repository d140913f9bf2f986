// Commands as scripts run them, each in a session without a window.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "app/scripts/script_session.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

OpenedFile open_plainly(const std::filesystem::path& path) {
  return open_file(path);
}

/// A box with everything selected in a mode, or a sample.
void prepare(ScriptSession& session, const std::string& sample, ElementMode mode) {
  if (sample.empty()) {
    const Command& box = *session.commands().find("add.box");
    const auto arguments = test::must(read_arguments(box.script.arguments, {}, Unit::millimetre));
    ASSERT_TRUE(session.run(box, *arguments).ok());
  } else {
    ASSERT_TRUE(session.open_document(test::source_folder() + "/assets/samples/" + sample).ok());
    session.editor().path.reset();  // the sample is not to be saved
  }
  Editor& editor = session.editor();
  editor.mode = mode;
  if (const Object* object = editor.active_object()) editor.selection.select_all(*object, mode);
}

/// Value for an argument that must be written.
WrittenValue some_value(const ArgumentSpec& spec) {
  switch (spec.type) {
    case ArgumentType::number:
    case ArgumentType::whole:
      return std::isfinite(spec.low) ? spec.low : std::isfinite(spec.high) ? spec.high : 1.0;
    case ArgumentType::point:
      return std::vector<WrittenScalar>{1.0, 2.0, 3.0};
    case ArgumentType::on_off:
      return true;
    case ArgumentType::word:
      return spec.words.front();
    case ArgumentType::list:
      return std::vector<WrittenScalar>{std::string("0")};
    default:
      return std::string("nowhere/there.is");
  }
}

TEST(ScriptCommands, DefaultsLieInTheirRangesInEveryUnit) {
  const ScriptSession session(open_plainly);
  std::set<std::string> ids;
  for (const Command& command : session.commands().all()) {
    EXPECT_TRUE(ids.insert(command.id).second) << command.id;
    for (const ArgumentSpec& spec : command.script.arguments) {
      if (!spec.standard) continue;
      for (const Unit unit : {Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch}) {
        const ArgumentValue value = standard_in(spec, unit);
        if (const double* number = std::get_if<double>(&value)) {
          EXPECT_TRUE(*number >= spec.low && *number <= spec.high) << command.id << " " << spec.name;
        } else if (const std::string* word = std::get_if<std::string>(&value)) {
          EXPECT_TRUE(std::ranges::find(spec.words, *word) != spec.words.end())
              << command.id << " " << spec.name;
        }
      }
    }
  }
  EXPECT_GT(ids.size(), 150U);
}

/// A document, what is selected of it, and beginnings of the ids of commands that are tried on it.
struct Stage {
  const char* sample;
  ElementMode mode;
  std::vector<std::string> families;
};

std::vector<Stage> stages() {
  const std::vector<std::string> elements{"mesh.", "shape.", "select.", "transform."};
  return {{"", ElementMode::object, {""}},
          {"", ElementMode::face, elements},
          {"", ElementMode::edge, elements},
          {"", ElementMode::vertex, elements},
          {"solids_one.hariko", ElementMode::vertex, {"solid.", "property."}},
          {"skin_smooth.hariko", ElementMode::vertex, {"skin.", "property."}},
          {"saddle.hariko", ElementMode::vertex, {"outline."}}};
}

std::vector<std::string> ids_for(const Stage& stage) {
  const ScriptSession session(open_plainly);
  std::vector<std::string> out;
  for (const Command& command : session.commands().all())
    if (command.scriptable() && std::ranges::any_of(stage.families, [&](const std::string& family) {
          return command.id.starts_with(family);
        }))
      out.push_back(command.id);
  return out;
}

/// Runs one command on a stage of its own; true where it was not refused.
bool runs_on(const Stage& stage, const std::string& id) {
  ScriptSession session(open_plainly);
  prepare(session, stage.sample, stage.mode);
  const Command& command = *session.commands().find(id);
  std::vector<WrittenArgument> written;
  for (const ArgumentSpec& spec : command.script.arguments)
    if (spec.required()) written.push_back({spec.name, some_value(spec)});
  const auto arguments = test::must(read_arguments(command.script.arguments, written, Unit::millimetre));
  const auto done = session.run(command, *arguments);
  if (done.ok()) return true;
  EXPECT_GT(done.error().text.size(), 8U);
  // A tool or a dialog that its row does not tell of.
  EXPECT_EQ(done.error().text.find(needs_the_window), std::string::npos);
  return false;
}

TEST(ScriptCommands, EveryCommandRunsWithItsDefaultsOrSaysWhyNot) {
  std::set<std::string> ran;
  for (const Stage& stage : stages())
    for (const std::string& id : ids_for(stage)) {
      SCOPED_TRACE(id + " " + stage.sample);
      if (runs_on(stage, id)) ran.insert(id);
    }
  for (const char* id : {"add.box", "transform.move", "select.all", "object.duplicate", "mesh.subdivide",
                         "solid.row", "property.scale", "outline.convert", "skin.add_section"})
    EXPECT_TRUE(ran.contains(id)) << id;
}

/// Values that an argument may have: both states, every word, or numbers at the low end of the range.
std::vector<WrittenValue> values_of(const ArgumentSpec& spec) {
  std::vector<WrittenValue> out;
  if (spec.type == ArgumentType::on_off) {
    out = {true, false};
  } else if (spec.type == ArgumentType::word) {
    for (const std::string& word : spec.words) out.push_back(word);
  } else {
    const double low = std::isfinite(spec.low) ? spec.low : 0;
    out = {low, std::min(low + 1, 0.5 * (low + std::min(spec.high, low + 2)))};
  }
  return out;
}

/// Sets the property of an object of a sample to each of its values; true where one of them was taken.
bool keeps_values(const std::string& sample, const std::string& id) {
  ScriptSession session(open_plainly);
  prepare(session, sample, ElementMode::object);
  const Command& command = *session.commands().find(id);
  const ArgumentSpec& spec = command.script.arguments.front();
  bool taken = false;
  for (const WrittenValue& value : values_of(spec)) {
    const std::vector<WrittenArgument> wanted{{spec.name, value}};
    const auto arguments = read_arguments(command.script.arguments, wanted, Unit::millimetre);
    EXPECT_TRUE(arguments.ok()) << id;
    if (!arguments.ok() || !session.run(command, *arguments).ok()) continue;
    const Object* object = session.editor().active_object();
    EXPECT_TRUE(object && command.script.read(*object) == wanted) << id << " " << sample;
    taken = true;
  }
  return taken;
}

/// Properties with one argument; not edits of sections, paths and halves, which may not be possible.
std::vector<std::string> plain_properties() {
  const std::set<std::string> edits{"property.mirror", "property.skin_frame", "property.skin_closed",
                                    "property.skin_closed_path"};
  const ScriptSession session(open_plainly);
  std::vector<std::string> out;
  for (const Command& command : session.commands().all())
    if (command.id.starts_with("property.") && command.script.read && !edits.contains(command.id) &&
        command.script.arguments.size() == 1)
      out.push_back(command.id);
  return out;
}

/// Rows of panels, commands and scripts share the tables of properties.
TEST(ScriptCommands, APropertyIsAfterwardsWhatAScriptSetItTo) {
  std::set<std::string> kept;
  for (const std::string& id : plain_properties())
    for (const char* sample : {"", "solids_one.hariko", "skin_smooth.hariko"})
      if (keeps_values(sample, id)) kept.insert(id);
  for (const char* id :
       {"property.scale", "property.map", "property.material", "property.density", "property.split_concave",
        "property.merge_coplanar", "property.automatic_tension", "property.envelope_method",
        "property.clearance", "property.envelope_symmetry", "property.skin_method", "property.skin_columns",
        "property.skin_placed", "property.skin_mirror", "property.skin_flip"})
    EXPECT_TRUE(kept.contains(id)) << id;
}

TEST(ScriptCommands, TheWindowIsNeededWhereHandsAre) {
  ScriptSession session(open_plainly);
  prepare(session, "", ElementMode::face);
  for (const char* id : {"mesh.knife", "select.box", "help.palette", "skin.draw", "solid.place_box"}) {
    const Command* command = session.commands().find(id);
    ASSERT_TRUE(command) << id;
    EXPECT_FALSE(command->scriptable()) << id;
    const auto done = session.run(*command, {});
    ASSERT_FALSE(done.ok()) << id;
    EXPECT_EQ(done.error().text, needs_the_window);
  }
}

}  // namespace
}  // namespace hariko
