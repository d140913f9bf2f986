#include "ui/skin/skin_properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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
#include "ui/skin/section_rows.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array skin_mirror_choices{
    Choice{"None", "Sections are edited point by point"},
    Choice{"Across X", "What is done to a point of a section is done to its image, too"},
    Choice{"Across Y", "What is done to a point of a section is done to its image, too"},
    Choice{"Across Z", "What is done to a point of a section is done to its image, too"},
};

/// Changes the skin of the active object.
Result<Document> changed(const Document& document, ObjectId object,
                         const std::function<void(Skin&)>& change) {
  const Object* found = document.find(object);
  if (!found || !found->skin()) return document;
  Skin skin = *found->skin()->skin;
  change(skin);
  return set_skin(document, object, skin);
}

/// Over the rest of the row. Mark: "button.<id>".
bool button(PanelContext& context, const std::string& id, const char* label, const char* help) {
  const bool pressed = ImGui::Button((context.tr(label) + ("###" + id)).c_str(), {-1, 0});
  if (ImGui::IsItemHovered()) show_tip(context.tr(help));
  context.marks.item("button." + id);
  return pressed;
}

class Rows {
 public:
  Rows(PanelContext& context, const Object& object)
      : context_(context), object_(object.id), skin_(*object.skin()->skin) {}

  template <class Set>
  void choice(const char* id, const char* label, const char* help, std::span<const Choice> choices,
              int current, const char* step, const Set& set) {
    if (const auto chosen = choose(context_, id, label, help, choices, current))
      commit(step, [&](Skin& skin) { set(skin, *chosen); });
  }

  /// Among all enumerators; `get` gives a reference to the member.
  template <class Get>
  void choice(const char* id, const char* label, const char* help, const char* step, const Get& get) {
    if (const auto chosen = choose(context_, id, label, help, std::optional(get(skin_))))
      commit(step, [&](Skin& skin) { get(skin) = *chosen; });
  }

  void check(const char* id, const char* label, const char* help, const char* step, bool Skin::*member) {
    if (const auto on = check_row(context_, id, label, help, skin_.*member))
      commit(step, [&](Skin& skin) { skin.*member = *on; });
  }
  void check(const char* id, const char* label, const char* help, const char* step,
             bool PleatOptions::*member) {
    if (const auto on = check_row(context_, id, label, help, skin_.pleat.*member))
      commit(step, [&](Skin& skin) { skin.pleat.*member = *on; });
  }

  void slider(const char* id, const char* label, const char* help, double low, double high, double standard,
              double PleatOptions::*member) {
    Quantity quantity = plain_quantity(3, 0.1);
    quantity.low = low, quantity.high = high, quantity.standard = standard;
    quantity.multiplies = true;
    slider_row(context_, {id, label, help, label, quantity}, low, high, true, skin_.pleat.*member,
               [object = object_, quantity, member](const Document& document, const ValueChange& change) {
                 return changed(document, object, [&](Skin& skin) {
                   skin.pleat.*member = change.apply(quantity, skin.pleat.*member);
                 });
               });
  }

  void count(const char* id, const char* label, const char* help, int SmoothOptions::*member) {
    Quantity quantity = plain_quantity(0, 1);
    quantity.low = 0, quantity.high = 500, quantity.standard = 0;
    value_row(context_, {id, label, help, label, quantity}, double(skin_.smooth.*member),
              [object = object_, quantity, member](const Document& document, const ValueChange& change) {
                return changed(document, object, [&](Skin& skin) {
                  skin.smooth.*member = int(std::lround(change.apply(quantity, double(skin.smooth.*member))));
                });
              });
  }

  /// The plane of symmetric edits, and what makes the sections symmetric about it.
  void mirror(const Object& object) {
    choice("skin_mirror", "Mirror", "Edits of sections change both halves", skin_mirror_choices,
           skin_.mirror ? skin_.mirror->axis + 1 : 0, "Mirror of the skin", [](Skin& skin, int chosen) {
             skin.mirror.reset();
             if (chosen > 0) skin.mirror = mirror_plane(skin, chosen - 1);
           });
    if (!skin_.mirror) return;
    const Box3 box = box_at_own_place(object);
    const Quantity quantity =
        length_quantity(context_.editor.document().unit, box.isEmpty() ? 1 : box.sizes().maxCoeff());
    value_row(context_,
              {"skin_mirror_at", "At", "Where the mirror is on the axis of the object", "Mirror of the skin",
               quantity},
              skin_.mirror->position,
              [id = object_, quantity](const Document& document, const ValueChange& change) {
                return changed(document, id, [&](Skin& skin) {
                  if (skin.mirror) skin.mirror->position = change.apply(quantity, skin.mirror->position);
                });
              });
    row_label(context_, "", "");
    if (button(context_, "skin_symmetric", "Make symmetric",
               "The halves of the selected sections, or of all, become mirror images of each other."))
      context_.run("skin.symmetric");
  }

 private:
  void commit(const char* step, const std::function<void(Skin&)>& change) {
    context_.editor.commit(changed(context_.editor.history.current(), object_, change), step);
  }

  PanelContext& context_;
  ObjectId object_;
  Skin skin_;
};

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

/// How pleated skins span their sections.
void pleat_rows(Rows& rows, const Skin& skin) {
  rows.slider("skin_density", "Density", "Rows for each span of the path", 0.25, 8, 1,
              &PleatOptions::density);
  rows.choice(
      "skin_fit", "Fit sections", "Whether the surface goes through the sections between the ends",
      "Fit of the skin", [](auto& s) -> auto& { return s.pleat.fit; });
  if (skin.pleat.fit == SectionFit::fair)
    rows.slider("skin_tension", "Tension",
                "Low flows like a spline, high runs straight from section to section", 5, 1e4, 200,
                &PleatOptions::tension);
  rows.choice(
      "skin_match", "Match by", "How points find those of the next section where no line is drawn",
      "Matching of the skin", [](auto& s) -> auto& { return s.pleat.cost; });
  rows.check("skin_quads", "Quads in fans", "Pairs of triangles become quads: rounder where lines merge",
             "Quads in fans", &PleatOptions::quad_fans);
  rows.check("skin_collars", "Collars", "Rows of their own beside sections, so that these can be exact",
             "Collars", &PleatOptions::collars);
}

/// How regular grids span them.
void grid_rows(Rows& rows, const Skin& skin) {
  rows.count("skin_columns", "Columns", "Control points across; 0: as many as the sections suggest",
             &SmoothOptions::columns);
  rows.count("skin_rows", "Rows", "Control points along; 0: as many as the path suggests",
             &SmoothOptions::rows);
  rows.choice(
      "skin_blend", "Blend", "How one section becomes the next", "Blend of the skin",
      [](auto& s) -> auto& { return s.smooth.blend; });
  if (skin.method == SkinMethod::smooth)
    rows.choice(
        "skin_placed", "Place columns", "Where the columns cross the sections", "Place columns",
        [](auto& s) -> auto& { return s.smooth.parameters; });
}

/// Rows that are needed once, if ever.
void more_rows(PanelContext& context, Rows& rows, const Object& object) {
  const Skin& skin = *object.skin()->skin;
  rows.mirror(object);
  if (const auto on = check_row(context, "skin_closed_path", "Closed path",
                                "The path runs back to its beginning", skin.path.closed))
    commit_skin(context.editor, object.id, set_path_closed(skin, *on), "Close or open path");
  skin.method == SkinMethod::pleat ? pleat_rows(rows, skin) : grid_rows(rows, skin);
  rows.check("skin_creases", "Creases", "Corners of sections become sharp edges of the surface",
             "Creases of the skin", &Skin::creases);
  rows.check("skin_flip", "Inside out", "Swaps the outside and the inside", "Turn the skin inside out",
             &Skin::flip_normals);
  if (selected_section(context.editor) &&
      button(context, "skin_turn", "Turn section round", "Swaps the ends of the section."))
    context.run("skin.flip_section");
}

/// Rows of the skin that do not stand under "More".
constexpr std::array<std::string_view, 4> first_rows{"skin_method", "skin_closed", "skin_caps", "skin_frame"};

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
  Rows rows(context, shown);
  rows.choice(
      "skin_method", "Method", "How the surface spans the sections", "Method of the skin",
      [](auto& s) -> auto& { return s.method; });
  const bool closed = has_closed_sections(skin);
  if (const auto on = check_row(context, "skin_closed", "Tube",
                                "Sections are closed curves and the skin is a tube", closed))
    commit_skin(context.editor, shown.id, set_closed(skin, *on), "Close or open sections");
  if (closed && !skin.path.closed)
    rows.choice(
        "skin_caps", "Ends", "What closes a tube", "Ends of the skin",
        [](auto& s) -> auto& { return s.caps; });
  if (const auto chosen = choose(context, "skin_frame", "Rails", "How sections turn along the path",
                                 std::optional(skin.frame)))
    set_frame(context.editor, shown, *chosen);
  const std::string& wanted = context.state.wanted_row;
  if (wanted.starts_with("skin_") &&
      std::find(first_rows.begin(), first_rows.end(), wanted) == first_rows.end())
    ImGui::SetNextItemOpen(true);
  const bool more = ImGui::TreeNodeEx("##skin_more",
                                      ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen,
                                      "%s", context.tr("More"));
  context.marks.item("section.skin_more");
  if (more) more_rows(context, rows, shown);
  draw_section_rows(context, shown);
}

std::vector<SkinChoice> skin_choices() {
  std::vector<SkinChoice> out;
  const auto list = [&](const char* id, const char* name, std::span<const Choice> choices,
                        const auto& choose) {
    for (std::size_t i = 0; i < choices.size(); ++i)
      out.push_back({std::string(id) + "." + std::to_string(i), name, choices[i].label, choices[i].help,
                     [choose, i](Editor& editor, const Object& object) { choose(editor, object, int(i)); }});
  };
  list("skin_method", "Method", enum_choices<SkinMethod>,
       [](Editor& editor, const Object& object, int chosen) {
         editor.commit(changed(editor.history.current(), object.id,
                               [&](Skin& skin) { skin.method = SkinMethod(chosen); }),
                       "Method of the skin");
       });
  list("skin_frame", "Rails", enum_choices<FrameMode>, [](Editor& editor, const Object& object, int chosen) {
    set_frame(editor, object, FrameMode(chosen));
  });
  list("skin_caps", "Ends", enum_choices<Caps>, [](Editor& editor, const Object& object, int chosen) {
    editor.commit(changed(editor.history.current(), object.id, [&](Skin& skin) { skin.caps = Caps(chosen); }),
                  "Ends of the skin");
  });
  return out;
}

void draw_skin_fix(PanelContext& context, const Object& object, const SurfaceView& view) {
  if (!object.skin() || object.locked) return;
  const Skin& skin = *object.skin()->skin;
  if (view.error && view.error->code == e_section_range && !skin.path.closed) {
    if (button(context, "skin_trim", "Trim path", "Cuts the path off at its first and its last section."))
      commit_skin(context.editor, object.id, trim_path(skin), "Trim path");
  } else if (const SkinSection* section = twisted_section(skin, view.warnings)) {
    if (button(context, "skin_untwist", "Turn section round", "Swaps the ends of the section."))
      commit_skin(context.editor, object.id, flip_section(skin, section->id), "Turn section round");
  }
}

}  // namespace hariko
