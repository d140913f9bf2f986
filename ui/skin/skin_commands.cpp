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
#include "ui/view/viewport.hpp"
#include "ui/widgets/application_services.hpp"
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
  host.table.add({"skin.insert_point", "Skin", "Insert point",
                  "One more point behind the selected one; the section keeps its shape.", "", "", true, true,
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
                  one});
  host.table.add({"skin.delete_points", "Skin", "Delete points",
                  "The section goes through the points that are left.", "", "", true, false,
                  [&editor] { delete_selected_points(editor); }, points});
  host.table.add({"skin.refine", "Skin", "Refine section",
                  "Twice as many points; the section stays exactly as it is.", "", "", true, false,
                  [&editor] {
                    run_edit(
                        editor, [&] { return refine_section(skin_of(editor), selected_section(editor)->id); },
                        translatable("Refine section"));
                  },
                  one});
  host.table.add({"skin.flip_section", "Skin", "Turn section round", "Swaps the ends of the section.", "", "",
                  true, false,
                  [&editor] {
                    run_edit(
                        editor, [&] { return flip_section(skin_of(editor), selected_section(editor)->id); },
                        translatable("Turn section round"));
                  },
                  one});
  host.table.add({"skin.seam", "Skin", "Begin section here",
                  "The selected point becomes the first of its closed section.", "", "", true, false,
                  [&editor] {
                    run_edit(
                        editor,
                        [&] { return move_seam(skin_of(editor), selected_section_points(editor).front()); },
                        translatable("Begin section here"));
                  },
                  one});
  host.table.add({"skin.symmetric", "Skin", "Make symmetric",
                  "The halves of the selected sections, or of all, become mirror images of each other.", "",
                  "", true, false,
                  [&editor] {
                    run_edit(
                        editor,
                        [&] {
                          const Skin& skin = skin_of(editor);
                          return make_symmetric(skin, chosen_sections(editor), mirror_plane(skin));
                        },
                        translatable("Make symmetric"));
                  },
                  needs_skin(editor)});
  host.table.add({"skin.close_sections", "Skin", "Close or open sections",
                  "All sections become closed curves, or open ones.", "", "", true, false,
                  [&editor] {
                    run_edit(
                        editor,
                        [&] { return set_closed(skin_of(editor), !has_closed_sections(skin_of(editor))); },
                        translatable("Close or open sections"));
                  },
                  needs_skin(editor)});
}

void add_section_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor);
  host.table.add(
      {"skin.add_section", "Skin", "Add section",
       "A section taken from the surface, in the middle behind the selected one.", "", "", true, true,
       [&host, &editor] { host.application.add_section(shown_skin(editor)->id, place_for_section(editor)); },
       skin});
  host.table.add({"skin.section_here", "Skin", "Add section by click\u2026",
                  "A section taken from the surface where it is clicked.", "", "", false, false,
                  [&host] {
                    host.viewport.start_modal(make_add_section_tool([&host](ObjectId object, double place) {
                      host.application.add_section(object, place);
                    }));
                  },
                  skin});
  host.table.add({"skin.draw_section", "Skin", "Draw section\u2026",
                  "A section drawn by hand or by points, in a plane across the path.", "", "", false, false,
                  [&host] { host.viewport.start_modal(make_draw_section_tool()); }, skin});
  host.table.add({"skin.slide_section", "Skin", "Slide section\u2026",
                  "Moves the section of the selected points along the path.", "", "", false, false,
                  [&host, &editor] {
                    host.viewport.start_modal(make_slide_section_tool(selected_section(editor)->id, true));
                  },
                  needs_points(editor, true)});
  host.table.add({"skin.delete_section", "Skin", "Delete section",
                  "Deletes the section of the selected points.", "", "", true, false,
                  [&editor] {
                    run_edit(
                        editor, [&] { return delete_section(skin_of(editor), selected_section(editor)->id); },
                        translatable("Delete section"));
                  },
                  needs_points(editor, true)});
}

void add_path_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor);
  host.table.add({"skin.insert_path_point", "Skin", "Insert path point",
                  "One more point behind the selected one of the path; it keeps its shape.", "", "", true,
                  true,
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
                  needs_path_point(editor)});
  host.table.add(
      {"skin.delete_path_point", "Skin", "Delete path point",
       "The path goes through the points that are left.", "", "", true, false,
       [&editor] {
         run_edit(
             editor, [&] { return delete_path_point(skin_of(editor), selected_path_points(editor).front()); },
             translatable("Delete path point"));
       },
       needs_path_point(editor)});
  host.table.add({"skin.refine_path", "Skin", "Refine path",
                  "Twice as many points; the path stays exactly as it is.", "", "", true, false,
                  [&editor] {
                    run_edit(
                        editor, [&] { return refine_path(skin_of(editor)); }, translatable("Refine path"));
                  },
                  skin});
  host.table.add({"skin.trim_path", "Skin", "Trim path",
                  "Cuts the path off at its first and its last section.", "", "", true, false,
                  [&editor] {
                    run_edit(
                        editor, [&] { return trim_path(skin_of(editor)); }, translatable("Trim path"));
                  },
                  skin});
  host.table.add({"skin.close_path", "Skin", "Close or open path",
                  "The path runs back to its beginning, or ends at its last section.", "", "", true, false,
                  [&editor] {
                    run_edit(
                        editor,
                        [&] { return set_path_closed(skin_of(editor), !skin_of(editor).path.closed); },
                        translatable("Close or open path"));
                  },
                  skin});
}

}  // namespace

void add_skin_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor);
  host.table.add({"skin.draw", "Skin", "Draw skin\u2026",
                  "Draw a path and two sections, by hand or by points: a new skin.", "", "", false, false,
                  [&host, &editor] {
                    begin_document(editor);
                    host.viewport.start_modal(make_draw_skin_tool());
                  }});
  host.table.add(
      {"skin.correspond", "Skin", "Correspondences\u2026",
       "Draw over the sections which points belong together: a line joins, a closed curve groups, a "
       "wedge merges.",
       "", "", false, false, [&host] { host.viewport.start_modal(make_correspond_tool()); }, skin});
  add_point_commands(host);
  add_section_commands(host);
  add_path_commands(host);
  host.table.add({"skin.to_polyhedron", "Skin", "Convert to polyhedron",
                  "A polyhedron through points of the surface, with its tangent planes; the skin is hidden.",
                  "", "", false, true, [&host, &editor] { host.application.convert(shown_skin(editor)->id); },
                  skin});
}

}  // namespace hariko
