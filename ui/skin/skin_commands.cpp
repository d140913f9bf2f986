// Commands of the Skin menu: correspondences, sections, the path.

#include <algorithm>

#include "core/skinning/edit/add_section.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/symmetric_edit.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/skin/add_section_tool.hpp"
#include "ui/skin/correspond_tool.hpp"
#include "ui/skin/draw_skin_tool.hpp"
#include "ui/skin/skin_commands.hpp"
#include "ui/skin/slide_section_tool.hpp"
#include "ui/widgets/command_services.hpp"

namespace hariko {

namespace {

WhyNot needs_skin(const Editor& editor) {
  return [&editor]() -> Reason {
    if (shown_skin(editor)) return {};
    return translatable("No skin is active. Click one in the list of objects.");
  };
}

WhyNot needs_points(const Editor& editor, bool one_section) {
  return [&editor, one_section, skin = needs_skin(editor)]() -> Reason {
    if (auto reason = skin()) return reason;
    if (selected_section_points(editor).empty())
      return translatable("No point of a section is selected. Click one in the view.");
    if (one_section && !selected_section(editor))
      return translatable("Points of several sections are selected. Select those of one.");
    return {};
  };
}

WhyNot needs_path_point(const Editor& editor) {
  return [&editor, skin = needs_skin(editor)]() -> Reason {
    if (auto reason = skin()) return reason;
    if (selected_path_points(editor).size() == 1) return {};
    return translatable("Select one point of the path.");
  };
}

const Skin& skin_of(const Editor& editor) {
  return *shown_skin(editor)->skin()->skin;
}

/// The span between two selected neighbours, or after the one that is selected; before it at an open end.
int chosen_span(const Editor& editor) {
  const SkinSection& section = *selected_section(editor);
  std::vector<int> chosen;
  for (const std::uint32_t id : selected_section_points(editor)) chosen.push_back(find_point(section, id));
  std::sort(chosen.begin(), chosen.end());
  const int last = section.size() - 1;
  if (section.closed && chosen.size() > 1 && chosen.front() == 0 && chosen.back() == last) return last;
  return section.closed ? chosen.front() : std::min(chosen.front(), last - 1);
}

using MakeEdit = std::function<Result<SkinEdit>()>;

void run_edit(Editor& editor, const MakeEdit& make, const char* label) {
  const ObjectId object = shown_skin(editor)->id;
  const auto edit = make();
  if (commit_skin(editor, object, edit, label)) select_new_points(editor, *edit);
}

/// The middle of the strip behind the selected section, of the longest one where none is selected.
double place_for_section(const Editor& editor) {
  const Skin& skin = skin_of(editor);
  const auto strip = [&](int k) {
    const double next = skin.sections[std::size_t((k + 1) % skin.section_count())].v;
    const double v = skin.sections[std::size_t(k)].v;
    return std::pair(v, next > v ? next : next + 1);
  };
  int best = 0;
  for (int k = 1; k < skin.strip_count(); ++k)
    if (strip(k).second - strip(k).first > strip(best).second - strip(best).first + 1e-9) best = k;
  if (const SkinSection* section = selected_section(editor))
    best = std::min(skin.find_section(section->id), skin.strip_count() - 1);
  return (strip(best).first + strip(best).second) / 2;
}

/// Sections that have selected points; none when nothing is selected.
std::vector<std::uint32_t> chosen_sections(const Editor& editor) {
  const auto points = selected_section_points(editor);
  std::vector<std::uint32_t> out;
  for (const SkinSection& section : skin_of(editor).sections)
    if (std::any_of(points.begin(), points.end(),
                    [&](std::uint32_t id) { return find_point(section, id) >= 0; }))
      out.push_back(section.id);
  return out;
}

void add_point_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot points = needs_points(editor, false), one = needs_points(editor, true);
  host.table.add({.id = "skin.insert_point",
                  .menu = "Skin",
                  .label = "Insert point",
                  .help = "One more point behind the selected one; the section keeps its shape.",
                  .changes_document = true,
                  .separator_before = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor,
                            [&] {
                              const Skin& s = skin_of(editor);
                              const std::uint32_t section = selected_section(editor)->id;
                              const int span = chosen_span(editor);
                              return s.mirror ? insert_section_point(s, section, span, *s.mirror)
                                              : insert_section_point(s, section, span);
                            },
                            translatable("Insert section point"));
                      },
                  .why_not = one});
  host.table.add({.id = "skin.delete_points",
                  .menu = "Skin",
                  .label = "Delete points",
                  .help = "The section goes through the points that are left.",
                  .changes_document = true,
                  .run = [&editor] { delete_selected_points(editor); },
                  .why_not = points});
  host.table.add({.id = "skin.refine",
                  .menu = "Skin",
                  .label = "Refine section",
                  .help = "Twice as many points; the section stays exactly as it is.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor,
                            [&] { return refine_section(skin_of(editor), selected_section(editor)->id); },
                            translatable("Refine section"));
                      },
                  .why_not = one});
  host.table.add({.id = "skin.flip_section",
                  .menu = "Skin",
                  .label = "Turn section round",
                  .help = "Swaps the ends of the section.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor,
                            [&] { return flip_section(skin_of(editor), selected_section(editor)->id); },
                            translatable("Turn section round"));
                      },
                  .why_not = one});
  host.table.add(
      {.id = "skin.seam",
       .menu = "Skin",
       .label = "Begin section here",
       .help = "The selected point becomes the first of its closed section.",
       .changes_document = true,
       .run =
           [&editor] {
             run_edit(
                 editor, [&] { return move_seam(skin_of(editor), selected_section_points(editor).front()); },
                 translatable("Begin section here"));
           },
       .why_not = one});
  host.table.add(
      {.id = "skin.symmetric",
       .menu = "Skin",
       .label = "Make symmetric",
       .help = "The halves of the selected sections, or of all, become mirror images of each other.",
       .changes_document = true,
       .run =
           [&editor] {
             run_edit(
                 editor,
                 [&] {
                   const Skin& skin = skin_of(editor);
                   return make_symmetric(skin, chosen_sections(editor), mirror_plane(skin));
                 },
                 translatable("Make symmetric"));
           },
       .why_not = needs_skin(editor)});
  host.table.add(
      {.id = "skin.close_sections",
       .menu = "Skin",
       .label = "Close or open sections",
       .help = "All sections become closed curves, or open ones.",
       .changes_document = true,
       .run =
           [&editor] {
             run_edit(
                 editor, [&] { return set_closed(skin_of(editor), !has_closed_sections(skin_of(editor))); },
                 translatable("Close or open sections"));
           },
       .why_not = needs_skin(editor)});
}

void add_section_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor);
  host.table.add(
      {.id = "skin.add_section",
       .menu = "Skin",
       .label = "Add section",
       .help = "A section taken from the surface, in the middle behind the selected one.",
       .changes_document = true,
       .separator_before = true,
       .run = [&host,
               &editor] { host.services.add_section(shown_skin(editor)->id, place_for_section(editor)); },
       .why_not = skin});
  host.table.add(
      {.id = "skin.section_here",
       .menu = "Skin",
       .label = "Add section by click\u2026",
       .help = "A section taken from the surface where it is clicked.",
       .run =
           [&host] {
             host.viewport.start_modal(make_add_section_tool(
                 [&host](ObjectId object, double place) { host.services.add_section(object, place); }));
           },
       .why_not = skin});
  host.table.add({.id = "skin.draw_section",
                  .menu = "Skin",
                  .label = "Draw section\u2026",
                  .help = "A section drawn by hand or by points, in a plane across the path.",
                  .run = [&host] { host.viewport.start_modal(make_draw_section_tool()); },
                  .why_not = skin});
  host.table.add({.id = "skin.slide_section",
                  .menu = "Skin",
                  .label = "Slide section\u2026",
                  .help = "Moves the section of the selected points along the path.",
                  .run =
                      [&host, &editor] {
                        host.viewport.start_modal(
                            make_slide_section_tool(selected_section(editor)->id, true));
                      },
                  .why_not = needs_points(editor, true)});
  host.table.add({.id = "skin.delete_section",
                  .menu = "Skin",
                  .label = "Delete section",
                  .help = "Deletes the section of the selected points.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor,
                            [&] { return delete_section(skin_of(editor), selected_section(editor)->id); },
                            translatable("Delete section"));
                      },
                  .why_not = needs_points(editor, true)});
}

void add_path_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor);
  host.table.add({.id = "skin.insert_path_point",
                  .menu = "Skin",
                  .label = "Insert path point",
                  .help = "One more point behind the selected one of the path; it keeps its shape.",
                  .changes_document = true,
                  .separator_before = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor,
                            [&] {
                              const Skin& s = skin_of(editor);
                              return insert_path_point(
                                  s, std::min(selected_path_points(editor).front(), s.path.spans() - 1));
                            },
                            translatable("Insert path point"));
                      },
                  .why_not = needs_path_point(editor)});
  host.table.add(
      {.id = "skin.delete_path_point",
       .menu = "Skin",
       .label = "Delete path point",
       .help = "The path goes through the points that are left.",
       .changes_document = true,
       .run =
           [&editor] {
             run_edit(
                 editor,
                 [&] { return delete_path_point(skin_of(editor), selected_path_points(editor).front()); },
                 translatable("Delete path point"));
           },
       .why_not = needs_path_point(editor)});
  host.table.add({.id = "skin.refine_path",
                  .menu = "Skin",
                  .label = "Refine path",
                  .help = "Twice as many points; the path stays exactly as it is.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor, [&] { return refine_path(skin_of(editor)); },
                            translatable("Refine path"));
                      },
                  .why_not = skin});
  host.table.add({.id = "skin.trim_path",
                  .menu = "Skin",
                  .label = "Trim path",
                  .help = "Cuts the path off at its first and its last section.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor, [&] { return trim_path(skin_of(editor)); }, translatable("Trim path"));
                      },
                  .why_not = skin});
  host.table.add({.id = "skin.close_path",
                  .menu = "Skin",
                  .label = "Close or open path",
                  .help = "The path runs back to its beginning, or ends at its last section.",
                  .changes_document = true,
                  .run =
                      [&editor] {
                        run_edit(
                            editor,
                            [&] { return set_path_closed(skin_of(editor), !skin_of(editor).path.closed); },
                            translatable("Close or open path"));
                      },
                  .why_not = skin});
}

}  // namespace

void add_skin_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor);
  host.table.add({.id = "skin.draw",
                  .menu = "Skin",
                  .label = "Draw skin\u2026",
                  .help = "Draw a path and two sections, by hand or by points: a new skin.",
                  .run = [&host, &editor] {
                    begin_document(editor);
                    host.viewport.start_modal(make_draw_skin_tool());
                  }});
  host.table.add(
      {.id = "skin.correspond",
       .menu = "Skin",
       .label = "Correspondences\u2026",
       .help = "Draw over the sections which points belong together: a line joins, a closed curve groups, a "
               "wedge merges.",
       .run = [&host] { host.viewport.start_modal(make_correspond_tool()); },
       .why_not = skin});
  add_point_commands(host);
  add_section_commands(host);
  add_path_commands(host);
  host.table.add(
      {.id = "skin.to_polyhedron",
       .menu = "Skin",
       .label = "Convert to polyhedron",
       .help = "A polyhedron through points of the surface, with its tangent planes; the skin is hidden.",
       .separator_before = true,
       .run = [&host, &editor] { host.services.convert(shown_skin(editor)->id); },
       .why_not = skin});
}

}  // namespace hariko
