// Commands of the Skin menu: correspondences, sections, the path.

#include <algorithm>
#include <memory>

#include "core/skinning/edit/add_section.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/symmetric_edit.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/skin/skin_tools.hpp"
#include "ui/view/viewport.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

namespace {

WhyNot needs_skin(const Editor& editor) {
  return only_if([&editor] { return shown_skin(editor) != nullptr; },
                 translatable("No skin is active. Click one in the list of objects."));
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
  return only_if(
      needs_skin(editor), [&editor] { return selected_path_points(editor).size() == 1; },
      translatable("Select one point of the path."));
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

using MakeEdit = std::function<Result<SkinEdit>(const Skin&)>;

void run_edit(Editor& editor, const MakeEdit& make, const char* step) {
  const ObjectId object = shown_skin(editor)->id;
  const auto edit = make(skin_of(editor));
  if (commit_skin(editor, object, edit, step)) select_new_points(editor, *edit);
}

/// A row of the menu that makes one edit; the step is called as the row is.
void add_edit(CommandHost& host, const char* id, const char* label, const char* help, const WhyNot& why_not,
              MakeEdit make) {
  MenuRows(host.table, "Skin")
      .add_edit(
          id, label, help,
          [&editor = host.editor, label, make = std::move(make)] { run_edit(editor, make, label); }, why_not);
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
    if (std::ranges::any_of(points, [&](std::uint32_t id) { return find_point(section, id) >= 0; }))
      out.push_back(section.id);
  return out;
}

void insert_point(Editor& editor) {
  const auto insert = [&](const Skin& skin) {
    const std::uint32_t section = selected_section(editor)->id;
    const int span = chosen_span(editor);
    return skin.mirror ? insert_section_point(skin, section, span, *skin.mirror)
                       : insert_section_point(skin, section, span);
  };
  run_edit(editor, insert, translatable("Insert section point"));
}

void add_point_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor), points = needs_points(editor, false),
               one = needs_points(editor, true);
  MenuRows rows(host.table, "Skin");
  rows.add_edit("skin.insert_point", "Insert point",
                "One more point behind the selected one; the section keeps its shape.",
                [&editor] { insert_point(editor); }, one, {.separator_before = true});
  rows.add_edit(
      "skin.delete_points", "Delete points", "The section goes through the points that are left.",
      [&editor] { delete_selected_points(editor); }, points);
  add_edit(host, "skin.refine", "Refine section", "Twice as many points; the section stays exactly as it is.",
           one, [&editor](const Skin& s) { return refine_section(s, selected_section(editor)->id); });
  add_edit(host, "skin.flip_section", "Turn section round", "Swaps the ends of the section.", one,
           [&editor](const Skin& s) { return flip_section(s, selected_section(editor)->id); });
  add_edit(host, "skin.seam", "Begin section here",
           "The selected point becomes the first of its closed section.", one,
           [&editor](const Skin& s) { return move_seam(s, selected_section_points(editor).front()); });
  add_edit(host, "skin.symmetric", "Make symmetric",
           "The halves of the selected sections, or of all, become mirror images of each other.", skin,
           [&editor](const Skin& s) { return make_symmetric(s, chosen_sections(editor), mirror_plane(s)); });
  add_edit(host, "skin.close_sections", "Close or open sections",
           "All sections become closed curves, or open ones.", skin,
           [](const Skin& s) { return set_closed(s, !has_closed_sections(s)); });
}

void add_section_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor), one = needs_points(editor, true);
  MenuRows rows(host.table, "Skin");
  rows.add_edit(
      "skin.add_section", "Add section",
      "A section taken from the surface, in the middle behind the selected one.",
      [&host, &editor] { host.application.add_section(shown_skin(editor)->id, place_for_section(editor)); },
      skin,
      {.separator_before = true,
       .script = {.arguments = {optional(
                      number_argument("place", translatable("Place on the path, 0 to 1"), {}, 0, 1))},
                  .run = [&host, &editor](const Arguments& given) {
                    host.application.add_section(shown_skin(editor)->id, given.has("place")
                                                                             ? given.number("place")
                                                                             : place_for_section(editor));
                  }}});
  const auto tool = [&](const char* id, const char* label, const char* help, const WhyNot& why_not,
                        std::function<std::unique_ptr<Tool>()> make) {
    rows.add(id, label, help, [&host, make = std::move(make)] { host.viewport.start_modal(make()); }, why_not,
             {.needs_window = true});
  };
  tool("skin.section_here", "Add section by click\u2026",
       "A section taken from the surface where it is clicked.", skin, [&host] {
         return make_add_section_tool(
             [&host](ObjectId object, double place) { host.application.add_section(object, place); });
       });
  tool("skin.draw_section", "Draw section\u2026",
       "A section drawn by hand or by points, in a plane across the path.", skin, make_draw_section_tool);
  tool("skin.slide_section", "Slide section\u2026",
       "Moves the section of the selected points along the path.", one,
       [&editor] { return make_slide_section_tool(selected_section(editor)->id, true); });
  add_edit(host, "skin.delete_section", "Delete section", "Deletes the section of the selected points.", one,
           [&editor](const Skin& s) { return delete_section(s, selected_section(editor)->id); });
}

void add_path_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor), point = needs_path_point(editor);
  const auto insert = [&editor](const Skin& s) {
    return insert_path_point(s, std::min(selected_path_points(editor).front(), s.path.spans() - 1));
  };
  MenuRows(host.table, "Skin")
      .add_edit("skin.insert_path_point", "Insert path point",
                "One more point behind the selected one of the path; it keeps its shape.",
                [&editor, insert] { run_edit(editor, insert, translatable("Insert path point")); }, point,
                {.separator_before = true});
  add_edit(host, "skin.delete_path_point", "Delete path point",
           "The path goes through the points that are left.", point,
           [&editor](const Skin& s) { return delete_path_point(s, selected_path_points(editor).front()); });
  add_edit(host, "skin.refine_path", "Refine path", "Twice as many points; the path stays exactly as it is.",
           skin, refine_path);
  add_edit(host, "skin.trim_path", "Trim path", "Cuts the path off at its first and its last section.", skin,
           trim_path);
  add_edit(host, "skin.close_path", "Close or open path",
           "The path runs back to its beginning, or ends at its last section.", skin,
           [](const Skin& s) { return set_path_closed(s, !s.path.closed); });
}

}  // namespace

void add_skin_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot skin = needs_skin(editor);
  MenuRows rows(host.table, "Skin");
  rows.add("skin.draw", "Draw skin\u2026", "Draw a path and two sections, by hand or by points: a new skin.",
           [&host, &editor] {
             begin_document(editor);
             host.viewport.start_modal(make_draw_skin_tool());
           },
           {}, {.needs_window = true});
  rows.add(
      "skin.correspond", "Correspondences\u2026",
      "Draw over the sections which points belong together: a line joins, a closed curve groups, a wedge "
      "merges.",
      [&host] { host.viewport.start_modal(make_correspond_tool()); }, skin, {.needs_window = true});
  add_point_commands(host);
  add_section_commands(host);
  add_path_commands(host);
  rows.add("skin.to_polyhedron", "Convert to polyhedron",
           "A polyhedron through points of the surface, with its tangent planes; the skin is hidden.",
           [&host, &editor] { host.application.convert(shown_skin(editor)->id); }, skin,
           {.separator_before = true});
}

}  // namespace hariko
