// Commands on the paper model.

#include <numbers>

#include "core/unfolding/edit_unfolding.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/paper_edits.hpp"
#include "ui/view/view_room.hpp"
#include "ui/widgets/command_services.hpp"

namespace hariko {

namespace {

WhyNot needs_pages(const Editor& editor) {
  return [&editor, document = needs_document(editor)]() -> Reason {
    if (auto reason = document()) return reason;
    if (editor.paper.shown && editor.paper.layout) return {};
    return translatable("There are no pages yet. Unfold the model first.");
  };
}

WhyNot needs_piece(const Editor& editor) {
  return [&editor, pages = needs_pages(editor)]() -> Reason {
    if (auto reason = pages()) return reason;
    if (editor.paper.selected_piece() != no_index) return {};
    return translatable("No piece is selected. Click one in the paper view.");
  };
}

/// The selected piece, or else the first that is too large.
Index piece_to_split(const Editor& editor) {
  const PaperState& state = editor.paper;
  if (const Index piece = state.selected_piece(); piece != no_index) return piece;
  return state.layout->off_page.empty() ? no_index : state.layout->off_page.front();
}

void add_view_commands_of_paper(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  host.table.add({.id = "paper.show",
                  .menu = "Paper",
                  .label = "Paper view",
                  .help = "Show the pages of a paper model beside the model.",
                  .keys = "Ctrl+P",
                  .run =
                      [&editor] {
                        // What is seen as a whole may be the paper, as long as it shows.
                        if (editor.paper.shown) change_room_of_views(editor, false);
                        editor.paper.shown = !editor.paper.shown;
                        editor.paper.wants_framing = true;
                        if (editor.paper.shown) change_room_of_views(editor, true);
                      },
                  .why_not = document,
                  .checked = [&editor] { return editor.paper.shown; }});
  host.table.add({.id = "paper.in_space",
                  .menu = "Paper",
                  .label = "Paper in the view",
                  .help = "The view of the model shows the paper instead of the objects.",
                  .run = [&editor] { editor.paper.in_space = !editor.paper.in_space; },
                  .why_not = needs_pages(editor),
                  .checked = [&editor] { return editor.paper.in_space; }});
  host.table.add({.id = "paper.frame",
                  .menu = "Paper",
                  .label = "All pages",
                  .help = "Show all pages in the paper view.",
                  .run = [&editor] { editor.paper.wants_framing = true; },
                  .why_not = needs_pages(editor)});
}

void add_piece_commands(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add({.id = "paper.straighten",
                  .menu = "Paper",
                  .label = "Straighten",
                  .help = "Turn the piece so that it takes the least room.",
                  .changes_document = true,
                  .separator_before = true,
                  .run =
                      [&editor] {
                        commit_paper(
                            editor,
                            straighten_piece(editor.paper.layout->unfolding, editor.paper.selected_piece()),
                            translatable("Straighten a piece"));
                      },
                  .why_not = needs_piece(editor)});
  host.table.add({.id = "paper.turn",
                  .menu = "Paper",
                  .label = "Turn by 90\u00b0",
                  .help = "Turn the piece to the left.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        commit_paper(editor,
                                     turn_piece(editor.paper.layout->unfolding, editor.paper.selected_piece(),
                                                std::numbers::pi / 2),
                                     translatable("Turn a piece"));
                      },
                  .why_not = needs_piece(editor)});
  host.table.add({.id = "paper.split_to_fit",
                  .menu = "Paper",
                  .label = "Split to fit the page",
                  .help = "Cut the piece into parts that fit the page.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        Unfolding next = editor.paper.layout->unfolding;
                        const Index selected = editor.paper.selected_piece();
                        if (selected != no_index) {
                          next = split_to_fit(next, selected);
                        } else {
                          // From the last to the first: parts get the numbers behind.
                          const auto& large = editor.paper.layout->off_page;
                          for (auto piece = large.rbegin(); piece != large.rend(); ++piece)
                            next = split_to_fit(next, *piece);
                        }
                        commit_paper(editor, rearrange(next), translatable("Split to fit the page"));
                      },
                  .why_not = [&editor, pages = needs_pages(editor)]() -> Reason {
                    if (auto reason = pages()) return reason;
                    if (piece_to_split(editor) != no_index) return {};
                    return translatable("No piece is selected. Click one in the paper view.");
                  }});
  host.table.add({.id = "paper.scale_to_fit",
                  .menu = "Paper",
                  .label = "Scale to fit the page",
                  .help = "Make the paper model so small that every piece fits the page.",
                  .changes_document = true,
                  .run = [&editor] { scale_to_fit(editor); },
                  .why_not = [&editor, pages = needs_pages(editor)]() -> Reason {
                    if (auto reason = pages()) return reason;
                    if (editor.paper.layout->fitting < 1) return {};
                    return translatable("Every piece fits the page.");
                  }});
}

}  // namespace

namespace {

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
                 {tr("Arrange"), "arrange",
                  [&editor] {
                    commit_paper(editor, rearrange(editor.paper.layout->unfolding),
                                 translatable("Arrange the pages"));
                  }},
                 {tr("Export anyway"), "export", [&services] { services.export_pages(); }}}});
}

}  // namespace

void add_paper_commands(CommandHost& host) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  add_view_commands_of_paper(host);
  host.table.add({.id = "paper.unfold",
                  .menu = "Paper",
                  .label = "Unfold",
                  .help = "Look for cuts, so that the model lies flat on few pages.",
                  .keys = "Ctrl+Shift+U",
                  .changes_document = true,
                  .separator_before = true,
                  .run =
                      [&editor] {
                        editor.paper.shown = true;
                        editor.paper.wants_unfolding = true;
                      },
                  .why_not = [&editor, document = needs_document(editor)]() -> Reason {
                    if (auto reason = document()) return reason;
                    if (!unfoldable_objects(editor.document()).empty()) return {};
                    return translatable("There is no visible surface to unfold. Show an object or add one.");
                  }});
  host.table.add({.id = "paper.arrange",
                  .menu = "Paper",
                  .label = "Arrange",
                  .help = "Pack all pieces and strips on the pages anew.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        commit_paper(editor, rearrange(editor.paper.layout->unfolding),
                                     translatable("Arrange the pages"));
                      },
                  .why_not = needs_pages(editor)});
  add_piece_commands(host);
  host.table.add({.id = "paper.forget",
                  .menu = "Paper",
                  .label = "Remove the paper model",
                  .help = "Forget its cuts, places and settings.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        editor.commit(remove_paper(editor.history.current()),
                                      translatable("Remove the paper model"));
                      },
                  .why_not = [&editor, document = needs_document(editor)]() -> Reason {
                    if (auto reason = document()) return reason;
                    if (editor.document().paper) return {};
                    return translatable("There are no pages yet. Unfold the model first.");
                  }});
  host.table.add({.id = "paper.export",
                  .menu = "Paper",
                  .label = "Export pages\u2026",
                  .help = "Write the pages as PDF, SVG, DXF or PNG.",
                  .separator_before = true,
                  .run = [&editor, &services] { export_pages(editor, services); },
                  .why_not = needs_pages(editor)});
}

}  // namespace hariko
