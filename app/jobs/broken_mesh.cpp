#include "app/jobs/broken_mesh.hpp"

#include <algorithm>
#include <utility>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/polyhedron/message_summary.hpp"

namespace hariko {

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

void ask_about_broken_mesh(Editor& editor, Workbench& workbench, const std::filesystem::path& path,
                           const std::shared_ptr<const OpenedFile>& opened,
                           std::function<void(const Document&, const std::string& note)> accept) {
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
    const std::string done = repair_text(tr, opened->repair);
    request.text += "\n\n" + fill(tr("The repair: {0}."), {done});
    request.answers.push_back({tr("Repair and open"), "repair", [opened, accept, name, done, &tr] {
                                 accept(*opened->repaired, fill(tr("{0} was repaired: {1}."), {name, done}));
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
