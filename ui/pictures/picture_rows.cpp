#include "ui/pictures/picture_rows.hpp"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <vector>

#include "core/base/text/sanitized_utf8.hpp"
#include "ui/widgets/binding.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

const PictureLook* look_of_picture(const Object& object) {
  return object.picture() ? &object.picture()->look : nullptr;
}
constexpr auto look_part = whole_part<PictureLook, &look_of_picture, &set_picture_look>();

constexpr std::array look_properties{
    member_property<&PictureLook::opacity>(
        {"picture_opacity", "Opacity", "How much of what lies behind it shows through",
         "Opacity of the picture", linear_range(0, 1, PictureLook{}.opacity, 2, 0.05)}),
    member_property<&PictureLook::layer>(
        {"picture_layer", "Drawn", "Before or after what is modelled", "Picture behind or in front"}),
};

/// Binds pictures to the one view that each faces, or to none.
Result<Document> bound_to_view(const Document& document, const Objects& pictures, bool only) {
  Result<Document> result = document;
  for (const auto& picture : pictures) {
    PictureLook look = picture->picture()->look;
    look.only_from = only ? faced_side(picture->transform.rotation) : std::nullopt;
    if (result) result = set_picture_look(*result, picture->id, look);
  }
  return result;
}

void picture_file_row(PanelContext& context, const Object& object) {
  const PictureSource& source = *object.picture();
  const std::filesystem::path path(source.path);
  const std::string name = sanitized_utf8(path.filename().string());
  context.editor.show_text(name);
  row_label(context, "File", "");
  aligned_text(name);
  if (ImGui::IsItemHovered())
    show_tip(source.packed() ? context.tr("In the document") : sanitized_utf8(source.path).c_str());
  context.marks.item("picture.file");
  const ReferenceView* view = context.editor.references.of(object.id);
  row_label(context, "", "");
  ImGui::AlignTextToFramePadding();
  std::string state =
      fill(context.tr("{0} x {1} pixels"), {std::to_string(source.columns), std::to_string(source.rows)});
  state += std::string(", ") + context.tr(source.packed() ? "in the document" : "linked");
  if (view && view->error) {
    coloured_lines(palette().warning, context.tr.text_of(*view->error));
    context.marks.item("picture.error");
    return;
  }
  dim_text(state);
  context.marks.item("picture.state");
}

void plane_rows(PanelContext& context, const Objects& pictures) {
  constexpr auto& sides = enum_choices<PictureSide>;
  constexpr int aslant = static_cast<int>(sides.size());
  const auto plane = common<int>(pictures, [](const auto& object) {
    const auto side = faced_side(object->transform.rotation);
    return side ? static_cast<int>(*side) : aslant;
  });
  std::vector<Choice> offered(sides.begin(), sides.end());
  if (plane == aslant) offered.push_back({translatable("Aslant"), translatable("Turned by hand")});
  const auto chosen =
      choose(context, "picture_plane", "Plane", "Which view sees it squarely", offered, plane.value_or(-1));
  if (chosen && *chosen != aslant && chosen != plane) {
    Result<Document> result = context.editor.history.current();
    for (const auto& picture : pictures)
      if (result) result = face_picture(*result, picture->id, static_cast<PictureSide>(*chosen));
    context.editor.commit(result, translatable("Plane of the picture"));
  }
  const auto bound = common<bool>(
      pictures, [](const auto& object) { return object->picture()->look.only_from.has_value(); });
  if (plane == aslant && bound == false) return;
  if (const auto only = check_row(context, "picture_only", "Only this view",
                                  "Hidden in all other views, and while the view turns", bound))
    context.editor.commit(bound_to_view(context.editor.history.current(), pictures, *only),
                          *only ? translatable("Picture in one view") : translatable("Picture in all views"));
}

void picture_button(PanelContext& context, const char* label, const char* id) {
  const Command* command = context.commands.find(id);
  if (command && !(command->why_not && command->why_not())) run_button(context, label, id);
}

}  // namespace

void picture_section(PanelContext& context, const Objects& objects) {
  const Objects pictures = objects_where(objects, &Object::picture);
  if (pictures.empty()) return;
  heading(context,
          pictures.size() == 1
              ? context.tr("Reference picture")
              : fill(context.tr("{0} reference pictures"), {std::to_string(pictures.size())}).c_str());
  if (pictures.size() == 1) picture_file_row(context, *pictures.front());
  bind_part(context, pictures, look_part).rows(look_properties);
  plane_rows(context, pictures);
  picture_button(context, "Find missing pictures\u2026", "picture.find");
  picture_button(context, "Scale by two points", "picture.scale");
  picture_button(context, "Pack into the document", "picture.pack");
  picture_button(context, "Save as a file\u2026", "picture.unpack");
}

ObjectProperties<PictureLook> picture_properties() {
  return {look_part, look_properties};
}

namespace {

bool row_of_picture(const Editor& editor) {
  return editor.active_object()->picture() != nullptr;
}
bool row_of_picture_view(const Editor& editor) {
  const Object& object = *editor.active_object();
  return object.picture() && (faced_side(object.transform.rotation) || object.picture()->look.only_from);
}

constexpr std::array rows_of_pictures{
    PanelRow{"picture_plane", "Plane", "Which view sees it squarely", "Reference picture", row_of_picture},
    PanelRow{"picture_only", "Only this view", "Hidden in all other views, and while the view turns",
             "Reference picture", row_of_picture_view},
};

}  // namespace

std::vector<PanelRow> picture_panel_rows() {
  return {rows_of_pictures.begin(), rows_of_pictures.end()};
}

}  // namespace hariko
