// Commands on the paper model.

#include <numbers>

#include "core/unfolding/edit_unfolding.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/paper_edits.hpp"
#include "ui/view/view_panes.hpp"
#include "ui/widgets/application_services.hpp"
#include "ui/widgets/command_services.hpp"

namespace hariko {

namespace {

WhyNot needs_pages(const Editor& editor) {
  return only_if(
      needs_document(editor), [&editor] { return editor.paper.shown && editor.paper.layout; },
      translatable("There are no pages yet. Unfold the model first."));
}

WhyNot needs_piece(const Editor& editor) {
  return only_if(
      needs_pages(editor), [&editor] { return editor.paper.selected_piece() != no_index; },
      translatable("No piece is selected. Click one in the paper view."));
}

/// The selected piece, or else the first that is too large.
Index piece_to_split(const Editor& editor) {
  const PaperState& state = editor.paper;
  if (const Index piece = state.selected_piece(); piece != no_index) return piece;
  return state.layout->off_page.empty() ? no_index : state.layout->off_page.front();
}

void show_paper(Editor& editor) {
  // Views may frame the paper as a whole while it shows.
  if (editor.paper.shown) change_room_of_views(editor, false);
  editor.paper.shown = !editor.paper.shown;
  editor.paper.wants_framing = true;
  if (editor.paper.shown) change_room_of_views(editor, true);
}

void add_view_commands_of_paper(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, "Paper");
  rows.add("paper.show", "Paper view", "Show the pages of a paper model beside the model.",
           [&editor] { show_paper(editor); }, needs_document(editor),
           {.keys = "Ctrl+P", .checked = [&editor] { return editor.paper.shown; }});
  rows.add_switch("paper.in_space", "Paper in the view",
                  "The view of the model shows the paper instead of the objects.", editor.paper.in_space,
                  {.why_not = needs_pages(editor)});
  rows.add(
      "paper.frame", "All pages", "Show all pages in the paper view.",
      [&editor] { editor.paper.wants_framing = true; }, needs_pages(editor));
}

void arrange_pages(Editor& editor) {
  commit_paper(editor, rearrange(editor.paper.layout->unfolding), translatable("Arrange the pages"));
}

void straighten_selected(Editor& editor) {
  commit_paper(editor, straighten_piece(editor.paper.layout->unfolding, editor.paper.selected_piece()),
               translatable("Straighten a piece"));
}

void turn_selected(Editor& editor) {
  commit_paper(
      editor, turn_piece(editor.paper.layout->unfolding, editor.paper.selected_piece(), std::numbers::pi / 2),
      translatable("Turn a piece"));
}

/// The selected piece, or else all that are too large.
void split_to_pages(Editor& editor) {
  Unfolding next = editor.paper.layout->unfolding;
  const Index selected = editor.paper.selected_piece();
  if (selected != no_index) {
    next = split_to_fit(next, selected);
  } else {
    // From the last to the first: parts get the numbers behind.
    const auto& large = editor.paper.layout->off_page;
    for (auto piece = large.rbegin(); piece != large.rend(); ++piece) next = split_to_fit(next, *piece);
  }
  commit_paper(editor, rearrange(next), translatable("Split to fit the page"));
}

/// A row of the menu that changes the pages or their pieces.
void add_paper_edit(CommandHost& host, const char* id, const char* label, const char* help,
                    void (*edit)(Editor&), WhyNot why_not, bool first = false) {
  MenuRows(host.table, "Paper")
      .add_edit(id, label, help, [&editor = host.editor, edit] { edit(editor); }, std::move(why_not),
                {.separator_before = first});
}

void add_piece_commands(CommandHost& host) {
  Editor& editor = host.editor;
  add_paper_edit(host, "paper.straighten", "Straighten", "Turn the piece so that it takes the least room.",
                 straighten_selected, needs_piece(editor), true);
  add_paper_edit(host, "paper.turn", "Turn by 90\u00b0", "Turn the piece to the left.", turn_selected,
                 needs_piece(editor));
  add_paper_edit(host, "paper.split_to_fit", "Split to fit the page",
                 "Cut the piece into parts that fit the page.", split_to_pages,
                 only_if(
                     needs_pages(editor), [&editor] { return piece_to_split(editor) != no_index; },
                     translatable("No piece is selected. Click one in the paper view.")));
  add_paper_edit(host, "paper.scale_to_fit", "Scale to fit the page",
                 "Make the paper model so small that every piece fits the page.", scale_to_fit,
                 only_if(
                     needs_pages(editor), [&editor] { return editor.paper.layout->fitting < 1; },
                     translatable("Every piece fits the page.")));
}

void forget_paper(Editor& editor) {
  editor.commit(remove_paper(editor.history.current()), translatable("Remove the paper model"));
}

/// Asks first where the pages cannot be built as they are.
void export_pages(Editor& editor, CommandServices& services) {
  const PaperLayout& layout = *editor.paper.layout;
  if (layout.overlaps == 0 && layout.off_page.empty()) return services.export_pages();
  const Language& tr = editor.language;
  std::string text(tr("The pages cannot be built as they are."));
  if (layout.overlaps > 0) text += "\n\u2022 " + fill(tr("overlaps: {0}"), {std::to_string(layout.overlaps)});
  if (!layout.off_page.empty())
    text +=
        "\n\u2022 " + fill(tr("pieces that pass the margins: {0}"), {std::to_string(layout.off_page.size())});
  services.ask({tr("Export pages"),
                text,
                {{tr("Go back"), "back"},
                 {tr("Arrange"), "arrange", [&editor] { arrange_pages(editor); }},
                 {tr("Export anyway"), "export", [&services] { services.export_pages(); }}}});
}

}  // namespace

void add_paper_commands(CommandHost& host) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  add_view_commands_of_paper(host);
  MenuRows rows(host.table, "Paper");
  rows.add_edit(
      "paper.unfold", "Unfold", "Look for cuts, so that the model lies flat on few pages.",
      [&paper = editor.paper] { paper.shown = paper.wants_unfolding = true; },
      only_if(
          needs_document(editor), [&editor] { return !unfoldable_objects(editor.document()).empty(); },
          translatable("There is no visible surface to unfold. Show an object or add one.")),
      {.keys = "Ctrl+Shift+U", .separator_before = true});
  add_paper_edit(host, "paper.arrange", "Arrange", "Pack all pieces and strips on the pages anew.",
                 arrange_pages, needs_pages(editor));
  add_piece_commands(host);
  add_paper_edit(host, "paper.forget", "Remove the paper model", "Forget its cuts, places and settings.",
                 forget_paper,
                 only_if(
                     needs_document(editor), [&editor] { return editor.document().paper != nullptr; },
                     translatable("There are no pages yet. Unfold the model first.")));
  rows.add("paper.export", "Export pages\u2026", "Write the pages as PDF, SVG, DXF or PNG.",
           [&editor, &services] { export_pages(editor, services); }, needs_pages(editor),
           {.separator_before = true,
            .needs_window = true,
            .script = {.arguments = {path_argument("path", translatable("File"))},
                       .run = [&host](const Arguments& given) {
                         host.application.export_pages(given.text("path"));
                       }}});
}

}  // namespace hariko
