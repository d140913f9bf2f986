#include "ui/pictures/picture_rows.hpp"

#include <imgui.h>

#include <filesystem>
#include <vector>

#include "core/base/text/sanitized_utf8.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

using ChangeLook = std::function<void(const Object&, PictureLook&)>;

Result<Document> edit_looks(const Document& document, const Objects& pictures, const ChangeLook& change) {
  Result<Document> result = document;
  for (const auto& picture : pictures) {
    const Object* found = result ? result->find(picture->id) : nullptr;
    if (!found || !found->picture()) continue;
    PictureLook look = found->picture()->look;
    change(*found, look);
    result = set_picture_look(*result, picture->id, look);
  }
  return result;
}

void set_looks(PanelContext& context, const Objects& pictures, const std::string& step,
               const ChangeLook& change) {
  context.editor.commit(edit_looks(context.editor.history.current(), pictures, change), step);
}

void picture_file_row(PanelContext& context, const Object& object) {
  const PictureSource& source = *object.picture();
  const std::filesystem::path path(source.path);
  const std::string name = sanitized_utf8(path.filename().string());
  context.editor.show_text(name);
  row_label(context, "File", "");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name.c_str());
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
    const TextColour colour(palette().warning);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(context.tr.text_of(*view->error).c_str());
    ImGui::PopTextWrapPos();
    context.marks.item("picture.error");
    return;
  }
  const TextColour colour(palette().dim_text);
  ImGui::TextUnformatted(state.c_str());
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
    set_looks(context, pictures,
              *only ? translatable("Picture in one view") : translatable("Picture in all views"),
              [&](const Object& object, PictureLook& look) {
                look.only_from = *only ? faced_side(object.transform.rotation) : std::nullopt;
              });
}

void picture_button(PanelContext& context, const char* label, const char* id) {
  const Command* command = context.commands.find(id);
  if (!command || (command->why_not && command->why_not())) return;
  if (ImGui::Button((std::string(context.tr(label)) + "###" + id).c_str(), {-1, 0})) context.run(id);
  if (ImGui::IsItemHovered()) show_tip(context.tr(command->help.c_str()));
  context.marks.item(std::string("button.") + id);
}

}  // namespace

void picture_section(PanelContext& context, const Objects& objects) {
  Objects pictures;
  for (const auto& object : objects)
    if (object->picture()) pictures.push_back(object);
  if (pictures.empty()) return;
  heading(context,
          pictures.size() == 1
              ? context.tr("Reference picture")
              : fill(context.tr("{0} reference pictures"), {std::to_string(pictures.size())}).c_str());
  if (pictures.size() == 1) picture_file_row(context, *pictures.front());
  Quantity opacity = plain_quantity(2, 0.05);
  opacity.low = 0;
  opacity.high = 1;
  opacity.standard = PictureLook{}.opacity;
  slider_row(context,
             {"picture_opacity", "Opacity", "How much of what lies behind it shows through",
              translatable("Opacity of the picture"), opacity},
             0, 1, false,
             common<double>(pictures, [](const auto& object) { return object->picture()->look.opacity; }),
             [pictures, opacity](const Document& document, const ValueChange& change) {
               return edit_looks(document, pictures, [&](const Object&, PictureLook& look) {
                 look.opacity = change.apply(opacity, look.opacity);
               });
             });
  const auto layer =
      common<PictureLayer>(pictures, [](const auto& object) { return object->picture()->look.layer; });
  if (const auto chosen =
          choose(context, "picture_layer", "Drawn", "Before or after what is modelled", layer))
    set_looks(context, pictures, translatable("Picture behind or in front"),
              [&](const Object&, PictureLook& look) { look.layer = *chosen; });
  plane_rows(context, pictures);
  picture_button(context, "Find missing pictures\u2026", "picture.find");
  picture_button(context, "Scale by two points", "picture.scale");
  picture_button(context, "Pack into the document", "picture.pack");
  picture_button(context, "Save as a file\u2026", "picture.unpack");
}

}  // namespace hariko
