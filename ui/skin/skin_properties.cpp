#include "ui/skin/skin_properties.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "core/document/edits/edit_skin.hpp"
#include "core/document/object_box.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "core/skinning/edit/symmetric_edit.hpp"
#include "core/skinning/sections/make_rails.hpp"
#include "core/skinning/skin_messages.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/widgets/binding.hpp"

namespace hariko {

namespace {

constexpr std::array skin_mirror_choices{
    Choice{"None", "Sections are edited point by point"},
    Choice{"Across X", "What is done to a point of a section is done to its image, too"},
    Choice{"Across Y", "What is done to a point of a section is done to its image, too"},
    Choice{"Across Z", "What is done to a point of a section is done to its image, too"},
};

const Skin* skin_of_object(const Object& object) {
  return object.skin() ? object.skin()->skin.get() : nullptr;
}
constexpr auto skin_part = whole_part<Skin, &skin_of_object, &set_skin>();

bool is_pleated(const Skin& skin) {
  return skin.method == SkinMethod::pleat;
}
bool is_grid(const Skin& skin) {
  return !is_pleated(skin);
}

constexpr PropertyRange grid_lines = whole_range(0, 500, 0);

/// Rows that stand alone among others which have more to say.
constexpr auto skin_method = member_property<&Skin::method>(
    {"skin_method", "Method", "How the surface spans the sections", "Method of the skin"});
constexpr auto skin_caps = member_property<&Skin::caps>(
    {"skin_caps", "Ends", "What closes a tube", "Ends of the skin"}, {},
    [](const Skin& skin) { return has_closed_sections(skin) && !skin.path.closed; });
constexpr Property<Skin> skin_mirror{
    list_row("skin_mirror", "Mirror", "Edits of sections change both halves", "Mirror of the skin",
             skin_mirror_choices, enum_words<SymmetryPlane>),
    [](const Skin& skin) { return skin.mirror ? skin.mirror->axis + 1.0 : 0.0; },
    [](Skin& skin, double chosen) {
      skin.mirror.reset();
      if (chosen > 0) skin.mirror = mirror_plane(skin, static_cast<int>(chosen) - 1);
    }};

/// All of them, those of pleated skins before those of regular grids.
constexpr std::array all_skin_properties{
    skin_method,
    skin_caps,
    skin_mirror,
    member_property<&Skin::pleat, &PleatOptions::density>(
        {"skin_density", "Density", "Rows for each span of the path", "Density",
         logarithmic_range(0.25, 8, 1, 3, 0.1)},
        &is_pleated),
    member_property<&Skin::pleat, &PleatOptions::fit>(
        {"skin_fit", "Fit sections", "Whether the surface goes through the sections between the ends",
         "Fit of the skin"},
        &is_pleated),
    member_property<&Skin::pleat, &PleatOptions::tension>(
        {"skin_tension", "Tension", "Low flows like a spline, high runs straight from section to section",
         "Tension", logarithmic_range(5, 1e4, 200, 3, 0.1)},
        &is_pleated, [](const Skin& skin) { return skin.pleat.fit == SectionFit::fair; }),
    member_property<&Skin::pleat, &PleatOptions::cost>(
        {"skin_match", "Match by", "How points find those of the next section where no line is drawn",
         "Matching of the skin"},
        &is_pleated),
    member_property<&Skin::pleat, &PleatOptions::quad_fans>(
        {"skin_quads", "Quads in fans", "Pairs of triangles become quads: rounder where lines merge",
         "Quads in fans"},
        &is_pleated),
    member_property<&Skin::pleat, &PleatOptions::collars>(
        {"skin_collars", "Collars", "Rows of their own beside sections, so that these can be exact",
         "Collars"},
        &is_pleated),
    member_property<&Skin::smooth, &SmoothOptions::columns>(
        {"skin_columns", "Columns", "Control points across; 0: as many as the sections suggest", "Columns",
         grid_lines},
        &is_grid),
    member_property<&Skin::smooth, &SmoothOptions::rows>(
        {"skin_rows", "Rows", "Control points along; 0: as many as the path suggests", "Rows", grid_lines},
        &is_grid),
    member_property<&Skin::smooth, &SmoothOptions::blend>(
        {"skin_blend", "Blend", "How one section becomes the next", "Blend of the skin"}, &is_grid),
    member_property<&Skin::smooth, &SmoothOptions::parameters>(
        {"skin_placed", "Place columns", "Where the columns cross the sections", "Place columns"}, &is_grid,
        [](const Skin& skin) { return skin.method == SkinMethod::smooth; }),
    member_property<&Skin::creases>({"skin_creases", "Creases",
                                     "Corners of sections become sharp edges of the surface",
                                     "Creases of the skin"}),
    member_property<&Skin::flip_normals>(
        {"skin_flip", "Inside out", "Swaps the outside and the inside", "Turn the skin inside out"}),
};

/// Rows that are needed once, if ever.
constexpr auto later_skin_properties = std::span(all_skin_properties).subspan(3);

void set_frame(Editor& editor, const Object& object, FrameMode frame) {
  const Skin& skin = *object.skin()->skin;
  SkinEdit plain{skin, 0, {}, {}, {}};
  plain.skin.frame = frame;
  commit_skin(editor, object.id, frame == FrameMode::two_rail ? make_rails(skin) : plain,
              translatable("Frames of the skin"));
}

/// Corners of the path.
void path_section(PanelContext& context, const Object& object) {
  const auto chosen = selected_path_points(context.editor);
  if (chosen.size() != 1) return;
  heading(context, "Path point");
  const Skin& skin = *object.skin()->skin;
  const int point = chosen.front();
  if (const auto on = check_row(context, "skin_path_sharp", "Corner", "The path has a corner here",
                                skin.path.is_sharp(point)))
    commit_skin(context.editor, object.id, set_path_sharp(skin, PathCurve::path, point, *on),
                *on ? "Corner" : "Smooth point");
}

void point_section(PanelContext& context, const Object& object) {
  const auto ids = selected_section_points(context.editor);
  if (ids.empty()) return;
  heading(context, ids.size() == 1
                       ? context.tr("Section point")
                       : fill(context.tr("{0} section points"), {std::to_string(ids.size())}).c_str());
  const Skin& skin = *object.skin()->skin;
  const auto sharp = common<bool>(ids, [&](std::uint32_t id) {
    for (const SkinSection& section : skin.sections)
      if (const int i = find_point(section, id); i >= 0) return section.points[std::size_t(i)].sharp;
    return false;
  });
  if (const auto on = check_row(context, "skin_sharp", "Corner",
                                "The section has a corner here, and the surface a crease", sharp))
    commit_skin(context.editor, object.id, set_sharp(skin, with_mirrored(skin, ids), *on),
                *on ? "Corner" : "Smooth point");
  const SkinSection* section = selected_section(context.editor);
  if (!section) return;
  if (section->closed && section->size() > 2)
    if (const auto on = check_row(context, "skin_start", "Own start",
                                  "The first point belongs to the first point of the section before; "
                                  "otherwise the section begins where the two are nearest",
                                  section->start_chosen))
      commit_skin(context.editor, object.id, set_start_chosen(skin, section->id, *on),
                  *on ? "Own start of the section" : "Nearest start of the section");
}

/// The section whose lines run round the path.
const SkinSection* twisted_section(const Skin& skin, const std::vector<Message>& warnings) {
  for (const Message& warning : warnings)
    for (const SkinSection& section : skin.sections)
      if (warning.code == w_twist && find_point(section, std::uint32_t(warning.element.id)) >= 0)
        return &section;
  return nullptr;
}

/// The plane of symmetric edits, and what makes the sections symmetric about it.
void mirror_rows(PanelContext& context, const Binding<Skin>& rows, const Skin& skin) {
  rows.row(skin_mirror);
  if (!skin.mirror) return;
  rows.row(
      {"skin_mirror_at",
       "At",
       "Where the mirror is on the axis of the object",
       "Mirror of the skin",
       {.unit = PropertyUnit::length}},
      [](const Skin& shown) { return shown.mirror ? shown.mirror->position : 0; },
      [](Skin& changed, double position) {
        if (changed.mirror) changed.mirror->position = position;
      });
  row_label(context, "", "");
  if (row_button(context, "skin_symmetric", "Make symmetric",
                 "The halves of the selected sections, or of all, become mirror images of each other."))
    context.run("skin.symmetric");
}

void more_rows(PanelContext& context, const Binding<Skin>& rows, const Object& object) {
  const Skin& skin = *object.skin()->skin;
  mirror_rows(context, rows, skin);
  if (const auto on = check_row(context, "skin_closed_path", "Closed path",
                                "The path runs back to its beginning", skin.path.closed))
    commit_skin(context.editor, object.id, set_path_closed(skin, *on), "Close or open path");
  rows.rows(later_skin_properties);
  if (selected_section(context.editor) &&
      row_button(context, "skin_turn", "Turn section round", "Swaps the ends of the section."))
    context.run("skin.flip_section");
}

/// Rows of the skin that do not stand under "More".
constexpr std::array<std::string_view, 7> first_rows{
    "skin_method", "skin_closed", "skin_caps", "skin_frame", "skin_sharp", "skin_start", "skin_path_sharp"};

}  // namespace

void draw_skin_properties(PanelContext& context) {
  const Object* object = shown_skin(context.editor);
  if (!object) return;
  // Edits replace the document under the panel.
  const Object shown = *object;
  const Skin& skin = *shown.skin()->skin;
  point_section(context, shown);
  path_section(context, shown);
  heading(context, "Skin");
  const Box3 box = box_at_own_place(shown);
  const Binding<Skin> rows =
      bind_part(context, shown, skin_part, box.isEmpty() ? 1.0 : box.sizes().maxCoeff());
  rows.row(skin_method);
  if (const auto on =
          check_row(context, "skin_closed", "Tube", "Sections are closed curves and the skin is a tube",
                    has_closed_sections(skin)))
    commit_skin(context.editor, shown.id, set_closed(skin, *on), "Close or open sections");
  rows.row(skin_caps);
  if (const auto chosen = choose(context, "skin_frame", "Rails", "How sections turn along the path",
                                 std::optional(skin.frame)))
    set_frame(context.editor, shown, *chosen);
  const std::string& wanted = context.state.wanted_row;
  if (wanted.starts_with("skin_") &&
      std::find(first_rows.begin(), first_rows.end(), wanted) == first_rows.end())
    ImGui::SetNextItemOpen(true);
  if (folding_heading(context, "skin_more", translatable("More"))) more_rows(context, rows, shown);
  draw_section_rows(context, shown);
}

ObjectProperties<Skin> skin_properties() {
  return {skin_part, all_skin_properties};
}

std::vector<SkinChoice> skin_choices() {
  std::vector<SkinChoice> out;
  const auto list = [&](const char* id, const char* name, std::span<const Choice> choices,
                        const auto& choose) {
    for (std::size_t i = 0; i < choices.size(); ++i)
      out.push_back({std::string(id) + "." + std::to_string(i), name, choices[i].label, choices[i].help,
                     [choose, i](Editor& editor, const Object& object) { choose(editor, object, int(i)); }});
  };
  const auto property = [&](const Property<Skin>& of) {
    list(of.row.id, of.row.label, of.row.choices, [of](Editor& editor, const Object& object, int chosen) {
      editor.commit(
          skin_part.edit(editor.history.current(), object.id, [&](Skin& skin) { of.set(skin, chosen); }),
          of.row.step);
    });
  };
  property(skin_method);
  list("skin_frame", "Rails", enum_choices<FrameMode>, [](Editor& editor, const Object& object, int chosen) {
    set_frame(editor, object, FrameMode(chosen));
  });
  property(skin_caps);
  return out;
}

void draw_skin_fix(PanelContext& context, const Object& object, const SurfaceView& view) {
  if (!object.skin() || object.locked) return;
  const Skin& skin = *object.skin()->skin;
  if (view.error && view.error->code == e_section_range && !skin.path.closed) {
    if (row_button(context, "skin_trim", "Trim path", "Cuts the path off at its first and its last section."))
      commit_skin(context.editor, object.id, trim_path(skin), "Trim path");
  } else if (const SkinSection* section = twisted_section(skin, view.warnings)) {
    if (row_button(context, "skin_untwist", "Turn section round", "Swaps the ends of the section."))
      commit_skin(context.editor, object.id, flip_section(skin, section->id), "Turn section round");
  }
}

}  // namespace hariko
