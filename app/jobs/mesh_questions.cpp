#include "app/jobs/mesh_questions.hpp"

#include <utility>

#include "app/files/prepare_meshes.hpp"
#include "app/files/reading.hpp"
#include "core/base/assert.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/polyhedron/message_summary.hpp"
#include "ui/files/import_questions.hpp"

namespace hariko {

MeshAnswers with_repair(MeshAnswers answers) {
  answers.repair = answers.join.split_edges = true;
  return answers;
}

OpenedFile open_as_answered(const std::filesystem::path& path, const MeshAnswers& answers,
                            const MeshImport& choice, const CancelToken& cancel, const Progress& progress) {
  OpenedFile opened = open_file(path, cancel, progress, answers.join);
  if (answers.turn_parts) turn_outwards(opened);
  prepare_meshes(opened, choice);
  return opened;
}

void ask_about_faults(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                      const std::shared_ptr<const OpenedFile>& opened, const MeshAnswers& answers,
                      const MeshReactions& reactions) {
  HARIKO_ASSERT(opened->document.has_value(), "only a file that opens is asked about");
  const std::string name = shortened(path.filename().string(), 200);
  const CleanReport& cleaned = opened->cleaned;
  if (cleaned.near > 0 && !answers.about_corners) {
    MeshAnswers decided = answers;
    decided.about_corners = true;
    reactions.asked("near_corners");
    return workbench.ask(join_request(
        editor.language, name, cleaned, opened->document->unit,
        [decided, reactions](const JoinChoice& chosen) {
          MeshAnswers joined = decided;
          joined.join = chosen;
          reactions.read_again(joined);
        },
        [&editor, &workbench, path, opened, decided, reactions] {
          ask_about_faults(editor, workbench, path, opened, decided, reactions);
        }));
  }
  if (answers.about_faults || cleaned.on_edges + opened->inside_out == 0) return reactions.accept();
  reactions.asked("repairable");
  workbench.ask(repair_request(
      editor.language, name, {cleaned.on_edges, opened->inside_out},
      [answers, reactions](const RepairChoice& chosen) {
        MeshAnswers decided = answers;
        decided.about_faults = true;
        decided.join.split_edges = chosen.split_edges;
        decided.turn_parts = chosen.turn_parts;
        reactions.read_again(decided);
      },
      reactions.accept));
}

namespace {

/// Line about an error: "face 3: The face has 2 corners."
std::string line_of(const Language& tr, const Message& message) {
  const std::string text = tr.text_of(message), element = to_string(message.element);
  // Translations by code name the element themselves.
  return element.empty() || text != message.text ? text : element + ": " + text;
}

/// List of errors, one line for each of the first few kinds.
std::string list_of_errors(const Language& tr, const OpenedFile& opened) {
  constexpr std::size_t most = 4;
  std::string list;
  std::size_t count = 0;
  for (const MessageSummary& summary : summarised(opened.messages)) {
    if (summary.first.severity != Severity::error) continue;
    if (++count > most) continue;
    list += "\n\u2022 " + line_of(tr, summary.first);
    if (summary.count > 1)
      list += " " + fill(tr("({0} in all: {1})"), {std::to_string(summary.count), summary.list()});
  }
  if (count > most) list += "\n" + fill(tr("and {0} more"), {std::to_string(count - most)});
  return list;
}

}  // namespace

std::string repair_text(const Language& tr, const RepairReport& report) {
  std::string text;
  const auto part = [&](const char* sentence, std::size_t count) {
    if (count == 0) return;
    if (!text.empty()) text += tr(", ");
    text += fill(tr(sentence), {std::to_string(count)});
  };
  part(translatable("vertices merged: {0}"), report.merged_vertices);
  part(translatable("faces turned: {0}"), report.turned_faces);
  part(translatable("faces dropped: {0}"), report.dropped_faces);
  part(translatable("faces cut into several: {0}"), report.cut_faces);
  part(translatable("vertices added where it was cut apart: {0}"), report.split_vertices);
  part(translatable("unused vertices removed: {0}"), report.removed_vertices);
  return text;
}

void forget_errors(OpenedFile& opened) {
  std::erase_if(opened.messages, [](const Message& message) { return message.severity == Severity::error; });
}

void ask_about_dense_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                          const std::shared_ptr<const OpenedFile>& opened,
                          std::function<void(const Document&)> accept) {
  if (opened->dense_faces == 0 || !opened->reference) return accept(*opened->document);
  const Language& tr = editor.language;
  workbench.ask(
      {tr("A mesh of many faces"),
       fill(tr("{0} has {1} faces. Reference facets show at once, to be traced and measured. As a cage "
               "each face becomes a curved patch, which takes long and is hard to edit."),
            {shortened(path.filename().string(), 200), std::to_string(opened->dense_faces)}),
       {{tr("Open as reference facets"), "reference", [opened, accept] { accept(*opened->reference); }},
        {tr("Open as a cage"), "cage", [opened, accept] { accept(*opened->document); }},
        {tr("Cancel"), "cancel", {}}}});
}

std::string repair_note(const Language& tr, const std::filesystem::path& path, const RepairReport& report) {
  return fill(tr("{0} was repaired: {1}."),
              {shortened(path.filename().string(), 200), repair_text(tr, report)});
}

void ask_about_broken_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                           const std::shared_ptr<const OpenedFile>& opened,
                           std::function<void(const Document&, const std::string& note)> accept,
                           std::function<void()> split_edges) {
  const Language& tr = editor.language;
  const std::string name = shortened(path.filename().string(), 200);
  if (!opened->repaired && !opened->reference) {
    Message error = *opened->error();
    error.text = name + ": " + line_of(tr, error);
    return editor.notify(error);
  }
  Prompt::Request request;
  request.title = tr("The mesh is no valid polyhedron");
  request.text = fill(tr("{0} cannot become a surface as it is:"), {name}) + list_of_errors(tr, *opened);
  if (opened->repaired) {
    std::string done = repair_text(tr, opened->repair);
    if (opened->cleaned.on_edges > 0)
      done += (done.empty() ? "" : tr(", ")) +
              fill(tr("edges split: {0}"), {std::to_string(opened->cleaned.on_edges)});
    request.text += "\n\n" + fill(tr("The repair: {0}."), {done});
    request.answers.push_back({tr("Repair and open"), "repair", [opened, accept, split_edges, path, &tr] {
                                 if (opened->cleaned.on_edges > 0) return split_edges();
                                 accept(*opened->repaired, repair_note(tr, path, opened->repair));
                               }});
  }
  if (opened->reference)
    request.answers.push_back({tr("Open as reference facets"), "reference", [opened, accept, name, &tr] {
                                 accept(*opened->reference,
                                        fill(tr("{0} shows as facets, without a surface."), {name}));
                               }});
  request.answers.push_back({tr("Cancel"), "cancel", {}});
  workbench.ask(std::move(request));
}

}  // namespace hariko
