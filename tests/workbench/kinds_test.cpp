// Commands times kinds of objects: whatever can be told to do does something that can be noticed on every
// kind, or says why not. With HARIKO_COMMAND_TABLE=FILE the table is written as Markdown. Selecting is tested
// kind by kind.

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
#include "ui/editor/object_kind.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko::test {
namespace {

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
      << editor.has_document << ' ' << editor.settings.language << ' ' << editor.camera().field_of_view
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

/// Commands in their order, each with what it says to an object of one kind: that it acts, or why it does
/// not.
using Answers = std::vector<std::pair<std::string, std::string>>;

/// Runs every command on a document, and expects that it does something or says why not.
Answers answers_of(const Document& document) {
  HeadlessWorkbench bench(document, {1000, 640});
  bench.wait_for_surfaces();
  Answers answers;
  for (const Command& command : bench.workbench().commands().all())
    if (command.id != "file.quit" && command.id != "help.log") answers.emplace_back(command.id, "");
  bool fresh = false;
  for (auto& [id, answer] : answers) {
    if (!fresh) begin_anew(bench, document);
    const bool quiet = may_be_quiet(*bench.workbench().commands().find(id));
    const std::string before = noticed(bench);
    const auto outcome = bench.workbench().commands().run(id);
    fresh = !outcome.ran;
    if (!outcome.ran) {
      EXPECT_GT(outcome.reason.size(), 8U) << id;
      answer = outcome.reason;
      continue;
    }
    for (int i = 0; i < 3; ++i) bench.frame();
    const bool acts = noticed(bench) != before;
    EXPECT_TRUE(acts || quiet) << id << " can be run, and nothing happens";
    answer = acts || quiet ? "yes" : "**nothing happens**";
    for (int i = 0; i < 4; ++i) bench.key("Esc");
  }
  return answers;
}

/// One kind of object.
class EveryCommandOnAKind : public testing::TestWithParam<std::string> {};

TEST_P(EveryCommandOnAKind, DoesSomethingOrSaysWhyNot) {
  EXPECT_GT(answers_of(documents_of_kinds().at(GetParam())).size(), 300U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryCommandOnAKind,
                         testing::Values("polyhedron", "patches", "mesh", "solids", "skin", "outline"),
                         [](const testing::TestParamInfo<std::string>& info) { return info.param; });

TEST(Kinds, TableOfCommandsIsWrittenWhereItIsAskedFor) {
  const char* path = std::getenv("HARIKO_COMMAND_TABLE");
  if (!path || !*path) GTEST_SKIP() << "HARIKO_COMMAND_TABLE names no file";
  std::map<std::string, Answers> columns;
  for (const auto& [kind, document] : documents_of_kinds()) columns[kind] = answers_of(document);
  std::ofstream file(path);
  file << "| command | ";
  for (const auto& [kind, answers] : columns) file << kind << " | ";
  file << "\n|---|" << std::string(columns.size() * 4, '-') << "|\n";
  const Answers& rows = columns.begin()->second;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    file << "| " << rows[i].first << " | ";
    for (const auto& [kind, answers] : columns) file << answers[i].second << " | ";
    file << '\n';
  }
  EXPECT_TRUE(file.good());
}

/// The same with several solids, of which one can be selected.
std::map<std::string, Document> documents_to_select_in() {
  auto out = documents_of_kinds();
  out["solids"] = sample_of_kind("solids_four");
  return out;
}

/// All of the active object that can be selected as points.
ElementSelection all_points(const Editor& editor) {
  const Object& object = *editor.active_object();
  return object_kind(object).all(object, ElementMode::vertex);
}

TEST(Kinds, InvertSelectsWhatIsNotSelectedOrSaysWhyNot) {
  for (const auto& [kind, document] : documents_to_select_in()) {
    SCOPED_TRACE(kind);
    HeadlessWorkbench bench(document);
    Selection& selection = bench.editor().selection;
    const ElementSelection all = all_points(bench.editor());
    const auto outcome = bench.workbench().commands().run("select.invert");
    EXPECT_EQ(outcome.ran, kind != "mesh") << outcome.reason;
    EXPECT_EQ(selection.of_active(), all);
    if (all.empty()) continue;
    ASSERT_GT(all.size(), 1U);
    const VertexId first = *all.vertices.begin();
    selection.select({selection.active, element_of(first)}, Selection::How::replace);
    bench.key("Ctrl+Shift+I");
    EXPECT_EQ(selection.of_active().size(), all.size() - 1);
    EXPECT_FALSE(selection.of_active().vertices.contains(first));
    bench.key("Ctrl+Shift+I");
    EXPECT_EQ(selection.of_active().vertices, std::set<VertexId>{first});
    EXPECT_FALSE(bench.editor().history.can_undo()) << "selecting became a step";
  }
}

TEST(Kinds, WhatGoesOnFromTheSelectionChangesItOrSaysWhyNot) {
  using Ids = std::set<std::string>;
  const Ids shaped{"select.similar_valence", "select.similar_place"};
  const auto with = [](Ids ids, const Ids& more) {
    ids.insert(more.begin(), more.end());
    return ids;
  };
  const Ids of_cages = with(shaped, {"select.grow", "select.shrink"});
  const Ids of_linked = with(of_cages, {"select.linked", "select.all_linked"});
  const Ids commands = with(of_linked, {"select.all", "select.invert"});
  const std::map<std::string, Ids> refused{{"polyhedron", Ids()}, {"patches", shaped}, {"mesh", commands},
                                           {"solids", of_linked}, {"skin", of_cages},  {"outline", of_cages}};
  for (const auto& [kind, document] : documents_to_select_in()) {
    HeadlessWorkbench bench(document);
    Selection& selection = bench.editor().selection;
    ElementSelection one = all_points(bench.editor());
    if (!one.empty()) one.vertices = {*one.vertices.begin()};
    for (const std::string& id : commands) {
      SCOPED_TRACE(kind + " " + id);
      selection.set(selection.active, one);
      const auto outcome = bench.workbench().commands().run(id);
      EXPECT_EQ(outcome.ran, !refused.at(kind).contains(id)) << outcome.reason;
      EXPECT_EQ(selection.of_active() == one, !outcome.ran);
      EXPECT_EQ(outcome.reason.size() > 8, !outcome.ran) << outcome.reason;
    }
  }
}

/// Points that L selects, beginning with one.
std::set<VertexId> linked_points(const Document& document, std::uint32_t begin) {
  HeadlessWorkbench bench(document);
  Selection& selection = bench.editor().selection;
  selection.select({selection.active, element_of(VertexId{begin})}, Selection::How::replace);
  bench.key("L");
  return selection.of_active().vertices;
}

std::set<VertexId> points_from(std::uint32_t first, std::size_t count) {
  std::set<VertexId> out;
  for (std::uint32_t i = 0; i < count; ++i) out.insert(VertexId{first + i});
  return out;
}

TEST(Kinds, LinkedArePartsOfAPolyhedronAndTheNetOfPatches) {
  const PolygonMesh parts = test::together(test::cube(), test::octahedron(), {0, 0, 10});
  EXPECT_EQ(linked_points(document_from_mesh(parts, "Two").value(), 9), points_from(8, 6));
  const Document patches = documents_of_kinds().at("patches");
  EXPECT_EQ(linked_points(patches, 3), points_from(0, patches.objects[0]->patches()->net.vertex_count()));
}

TEST(Kinds, LinkedIsTheLoopOfAnOutline) {
  const Document document = sample_of_kind("sphere_holes");
  const std::vector<OutlineLoop>& loops = document.objects[0]->outline()->outline->loops;
  ASSERT_EQ(loops.size(), 3U);
  const auto begin = static_cast<std::uint32_t>(loops[0].points.size());
  EXPECT_EQ(linked_points(document, begin + 4), points_from(begin, loops[1].points.size()));
}

TEST(Kinds, LinkedIsTheSectionOrThePathOfASkin) {
  const Document document = sample_of_kind("skin_smooth");
  const Skin& skin = *document.objects[0]->skin()->skin;
  std::set<VertexId> section;
  for (const SectionPoint& point : skin.sections[1].points) section.insert(VertexId{point.id});
  EXPECT_EQ(linked_points(document, skin.sections[1].points[2].id), section);
  const auto path = points_from(path_point_ids, skin.path.points.size());
  EXPECT_EQ(linked_points(document, path_point_ids + 2), path);
}

TEST(Kinds, SolidsSayThatTheyAreNotLinked) {
  const Document document = sample_of_kind("solids_four");
  const std::uint32_t first = document.objects[0]->solids()->input->solids[0].id;
  EXPECT_EQ(linked_points(document, first), points_from(first, 1));
  HeadlessWorkbench bench(document);
  bench.key("Ctrl+A");
  EXPECT_EQ(bench.workbench().commands().run("select.linked").reason,
            "Solids are not connected with each other. Shift+click takes one more.");
}

}  // namespace
}  // namespace hariko::test
