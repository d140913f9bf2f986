// Anything a user may do, in any order: documents stay valid, and undo and redo give back what was there.

#include <array>
#include <map>

#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "core/document/format/format.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {
namespace {

PolygonMesh some_mesh(std::mt19937_64& rng) {
  switch (uniform_int(rng, 0, 3)) {
    case 0:
      return test::prism(uniform_int(rng, 3, 8));
    case 1:
      return test::torus(uniform_int(rng, 3, 6), uniform_int(rng, 3, 5));
    case 2:
      return test::grid(uniform_int(rng, 1, 5), uniform_int(rng, 1, 5));
    default:
      return test::genus_box(uniform_int(rng, 0, 2));
  }
}

Document some_patches(std::mt19937_64& rng) {
  BicubicNet net{chance(rng, 0.5) ? 1U : 2U, chance(rng, 0.5) ? 1U : 2U, {}};
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 0; i < net.width(); ++i)
      net.points.emplace_back(i / 3.0, j / 3.0, test::uniform(rng, 0, 0.3));
  return add_object({}, "Patches", PatchSource::from_net(net).value())->document;
}

Document some_sample(std::mt19937_64& rng) {
  static constexpr std::array names{"solids_one", "solids_t",   "solids_touching", "skin_smooth",
                                    "skin_car",   "sphere_cap", "saddle"};
  return load_document(test::source_folder() + "/assets/samples/" + names[rng() % names.size()] + ".hariko")
      .value();
}

/// A polyhedron, and in half of all cases an object of any kind.
Document some_document(std::mt19937_64& rng) {
  const Document document = document_from_mesh(some_mesh(rng), "First").value();
  switch (uniform_int(rng, 0, 7)) {
    case 0:
    case 1:
      return add_object(document, "Second", PolyhedronSource::from_mesh(some_mesh(rng)).value())->document;
    case 2:
      return append_document(document, some_patches(rng)).value();
    case 3:
      return append_document(document, some_sample(rng)).value();
    default:
      return document;
  }
}

class RandomUser {
 public:
  RandomUser(HeadlessWorkbench& bench, std::mt19937_64& rng) : bench_(bench), rng_(rng) {}

  void act() {
    switch (uniform_int(rng_, 0, 9)) {
      case 0:
      case 1:
      case 2:
        return command();
      case 3:
      case 4:
        return select();
      case 5:
        return click();
      case 6:
        return drag();
      case 7:
        return type();
      case 8:
        return bench_.key(chance(rng_, 0.5) ? "Ctrl+Z" : "Ctrl+Shift+Z");
      default:
        return bench_.wheel(uniform_int(rng_, -2, 2));
    }
  }

  /// Last action, for messages.
  const std::string& last() const { return last_; }

 private:
  void command() {
    const auto& all = bench_.workbench().commands().all();
    std::vector<const Command*> candidates;
    const bool edits_only = chance(rng_, 0.6);
    for (const Command& command : all)
      if (!edits_only || (command.changes_document && !(command.why_not && command.why_not())))
        candidates.push_back(&command);
    if (candidates.empty()) return;
    const Command& chosen = *candidates[rng_() % candidates.size()];
    if (chosen.id == "file.close" || chosen.id == "file.quit") return;
    last_ = chosen.id;
    bench_.workbench().commands().run(chosen);
    bench_.frame();
    // Dialogs would keep all that follows from the document.
    const bool dialog = chosen.id.starts_with("file.");
    if (dialog || chance(rng_, 0.3)) bench_.key("Esc");
  }

  void select() {
    Editor& editor = bench_.editor();
    const Object* object = editor.active_object();
    const Polyhedron* cage = object ? object->cage() : nullptr;
    if (!cage || !object->visible || object->locked || editor.history.in_gesture() ||
        bench_.workbench().viewport().tool_active())
      return;
    last_ = "select";
    editor.mode = static_cast<ElementMode>(uniform_int(rng_, 0, 2));
    const Polyhedron& polyhedron = *cage;
    for (int i = uniform_int(rng_, 1, 4); i > 0; --i) {
      Element element;
      if (editor.mode == ElementMode::vertex)
        element = element_of(polyhedron.vertex_id(index(polyhedron.vertex_count())));
      else if (editor.mode == ElementMode::edge)
        element = element_of(polyhedron.edge_id(index(polyhedron.edge_count())));
      else
        element = element_of(polyhedron.face_id(index(polyhedron.face_count())));
      editor.selection.select({object->id, element}, Selection::How::add);
    }
    bench_.frame();
  }

  void click() {
    last_ = "click";
    modifiers();
    somewhere();
    const int button = uniform_int(rng_, 0, 4) / 2 == 2 ? 1 : 0;
    bench_.press(button);
    bench_.release(button);
    bench_.hold(false, false, false);
  }

  void drag() {
    last_ = "drag";
    modifiers();
    somewhere();
    const int button = uniform_int(rng_, 0, 5) == 5 ? 2 : 0;
    bench_.press(button);
    for (int i = 0; i < 3; ++i) somewhere();
    if (chance(rng_, 0.2)) bench_.key("Esc");
    bench_.release(button);
    bench_.hold(false, false, false);
  }

  void type() {
    static constexpr std::array keys{"X",     "Y",   "Z", "1", "2", "3",   "0",        ".",
                                     "Enter", "Esc", "G", "R", "S", "Tab", "Backspace"};
    last_ = keys[rng_() % keys.size()];
    bench_.key(last_);
  }

  void modifiers() { bench_.hold(chance(rng_, 0.2), chance(rng_, 0.2), chance(rng_, 0.1)); }
  void somewhere() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    bench_.move(test::uniform(rng_, 0, size.x), test::uniform(rng_, 0, size.y));
  }
  Index index(Index count) { return static_cast<Index>(rng_() % count); }

  HeadlessWorkbench& bench_;
  std::mt19937_64& rng_;
  std::string last_;
};

/// The document survives writing and reading, which checks every invariant there is.
void expect_valid(const Document& document) {
  const auto read = test::must(read_document(write_document(document)));
  ASSERT_TRUE(*read == document);
}

TEST(RandomCommands, UndoAndRedoGiveBackEqualDocuments) {
  int steps = 0;
  test::for_random(20261121, 3, [&](std::mt19937_64& rng) {
    HeadlessWorkbench bench(some_document(rng));
    RandomUser user(bench, rng);
    const Editor& editor = bench.editor();
    // Serials begin anew with each document that is opened.
    std::map<std::pair<std::uint64_t, std::uint64_t>, Document> states;
    for (int i = 0; i < 250; ++i) {
      user.act();
      if (!editor.has_document) break;
      const auto [state, fresh] =
          states.try_emplace({editor.documents, editor.history.serial()}, editor.history.current());
      ASSERT_TRUE(state->second == editor.history.current())
          << "another document under the same name, after " << user.last();
      if (fresh) expect_valid(editor.history.current());
      // Hidden and locked objects can be chosen in the list.
      Document seen = editor.history.current();
      for (auto& object : seen.objects) {
        auto copy = std::make_shared<Object>(*object);
        copy->visible = true;
        copy->locked = false;
        object = std::move(copy);
      }
      Selection there = editor.selection;
      there.prune(seen);
      ASSERT_TRUE(there == editor.selection)
          << "the selection has what the document has not, after " << user.last();
      if (::testing::Test::HasFatalFailure()) {
        ADD_FAILURE() << "after " << user.last();
        return;
      }
    }
    steps += static_cast<int>(states.size());
    bench.key("Esc");
    bench.key("Esc");
    bench.key("Esc");
    History& history = bench.editor().history;
    const auto expect_known = [&] {
      const auto state = states.find({editor.documents, history.serial()});
      if (state != states.end()) {
        ASSERT_TRUE(state->second == history.current());
      }
    };
    while (history.undo()) expect_known();
    while (history.redo()) expect_known();
  });
  EXPECT_GT(steps, 50) << "the random user changes too little for the test to mean anything";
  RecordProperty("states", steps);
}

}  // namespace
}  // namespace hariko::test
