// Commands times kinds of objects: whatever can be told to do does something that can be noticed on every
// kind, or says why not. With HARIKO_COMMAND_TABLE=FILE the table is written as Markdown.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "core/modeling/objects/parabolic_grid.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko {
namespace {

using test::HeadlessWorkbench;

Document sample_of_kind(const char* name) {
  return load_document(test::source_folder() + "/assets/samples/" + name + ".hariko").value();
}

Document with_one_object(const char* name, Source source) {
  return add_object({}, name, std::move(source))->document;
}

/// A document a kind, with one object.
std::map<std::string, Document> documents_of_kinds() {
  std::map<std::string, Document> out;
  out["polyhedron"] = document_from_mesh(test::prism(5), "Prism").value();
  out["patches"] = with_one_object("Patches", PatchSource::from_net(parabolic_grid(2, 2, 2, 2, 0.4)).value());
  out["mesh"] = with_one_object("Mesh", MeshSource::from_mesh(test::prism(5)).value());
  out["solids"] = sample_of_kind("solids_one");
  out["skin"] = sample_of_kind("skin_smooth");
  out["outline"] = sample_of_kind("sphere_cap");
  return out;
}

/// Everything of the window and the document that a designer could notice, as text to compare.
std::string noticed(HeadlessWorkbench& bench) {
  const Editor& editor = bench.editor();
  std::ostringstream out;
  out << editor.history.serial() << ' ' << editor.history.current().objects.size() << ' '
      << bench.workbench().viewport().scene().version() << ' ' << int(editor.mode) << ' '
      << editor.notices().size() << ' ' << bench.workbench().status() << ' '
      << (bench.workbench().question() != nullptr) << bench.workbench().viewport().tool_active()
      << editor.has_document << ' ' << int(editor.settings.language) << ' ' << editor.camera().field_of_view
      << ' ';
  for (const auto& [object, elements] : editor.selection.elements())
    out << object.value << ':' << elements.vertices.size() << ',' << elements.edges.size() << ','
        << elements.faces.size() << ' ';
  for (const ObjectId object : editor.selection.objects()) out << object.value << ' ';
  for (const Command& command : bench.workbench().commands().all())
    if (command.checked) out << command.checked();
  for (const auto& [mark, rect] : bench.workbench().marks().all())
    out << mark << ' ' << rect.x << ' ' << rect.y << ' ' << rect.width << ' ' << rect.height << '\n';
  return out.str();
}

/// Commands that leave everything as it is where it is so already, act outside of the window, or point at a
/// row.
bool may_be_quiet(const Command& command) {
  static const std::set<std::string> known{"file.open",
                                           "file.save",
                                           "file.save_copy",
                                           "file.revert",
                                           "edit.copy_shaping",
                                           "view.frame_all",
                                           "view.frame_selection",
                                           "view.frame_all_views",
                                           "view.iso",
                                           "view.keep_probe",
                                           "view.go",
                                           "view.next_saved",
                                           "view.previous_saved",
                                           "view.update",
                                           "view.frame_times",
                                           "analyse.section_spread",
                                           "paper.unfold",
                                           "plane.look",
                                           "recompute.now",
                                           "outline.select_loops",
                                           "shape.reset_tension",
                                           "shape.preset_relaxed",
                                           "shape.preset_neutral",
                                           "shape.copy_tension",
                                           "shape.paste_tension",
                                           "solid.to_polyhedron",
                                           "skin.to_polyhedron",
                                           "skin.add_section"};
  return known.contains(command.id) || command.id.starts_with("property.") ||
         (command.checked && command.checked());
}

/// The document with all elements of its object selected, whatever was done before.
void begin_anew(HeadlessWorkbench& bench, const Document& document) {
  bench.editor().settings = {};
  bench.editor().open(document, {});
  bench.settle();
  bench.editor().selection.select_all(*bench.editor().active_object(), ElementMode::vertex);
  for (int i = 0; i < 2; ++i) bench.frame();
}

TEST(Kinds, EveryCommandDoesSomethingToEveryKindOrSaysWhyNot) {
  std::map<std::string, std::map<std::string, std::string>> table;  // by command, by kind
  std::vector<std::string> order;
  for (const auto& [kind, document] : documents_of_kinds()) {
    SCOPED_TRACE(kind);
    HeadlessWorkbench bench(document, {1000, 640});
    bench.wait_for_surfaces();
    order.clear();
    for (const Command& command : bench.workbench().commands().all()) order.push_back(command.id);
    bool fresh = false;
    for (const std::string& id : order) {
      if (id == "file.quit" || id == "help.log") continue;
      if (!fresh) begin_anew(bench, document);
      const Command& command = *bench.workbench().commands().find(id);
      const bool quiet = may_be_quiet(command);
      const std::string before = noticed(bench);
      const auto outcome = bench.workbench().commands().run(id);
      fresh = !outcome.ran;
      if (!outcome.ran) {
        EXPECT_GT(outcome.reason.size(), 8U) << id;
        table[id][kind] = outcome.reason;
        continue;
      }
      for (int i = 0; i < 3; ++i) bench.frame();
      const bool acts = noticed(bench) != before;
      EXPECT_TRUE(acts || quiet) << id << " can be run, and nothing happens";
      table[id][kind] = acts || quiet ? "yes" : "**nothing happens**";
      for (int i = 0; i < 4; ++i) bench.key("Esc");
    }
  }
  const char* path = std::getenv("HARIKO_COMMAND_TABLE");
  if (!path || !*path) return;
  std::ofstream file(path);
  file << "| command | ";
  for (const auto& [kind, answer] : table.begin()->second) file << kind << " | ";
  file << "\n|---|" << std::string(table.begin()->second.size() * 4, '-') << "|\n";
  for (const std::string& id : order) {
    if (!table.contains(id)) continue;
    file << "| " << id << " | ";
    for (const auto& [kind, answer] : table[id]) file << answer << " | ";
    file << '\n';
  }
}

}  // namespace
}  // namespace hariko
