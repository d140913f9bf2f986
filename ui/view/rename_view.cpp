#include "ui/view/rename_view.hpp"

#include <imgui_stdlib.h>

#include <memory>

#include "ui/editor/saved_views.hpp"
#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

Quantity focal_length_quantity() {
  Quantity quantity;
  quantity.unit = "mm";
  quantity.decimals = 1;
  quantity.step = 1;
  quantity.low = SavedView::least_focal_length;
  quantity.high = SavedView::greatest_focal_length;
  return quantity;
}

}  // namespace

void ask_view_name(Editor& editor, CommandServices& services, const std::string& name) {
  const Language& tr = editor.language;
  const auto typed = std::make_shared<std::string>(name);
  const auto first = std::make_shared<bool>(true);
  Prompt::Request request;
  request.title = tr("Rename view");
  request.text = tr("A name that no other saved view has.");
  request.fields = [typed, first](PanelContext& context) {
    ImGui::Dummy({0, context.metrics.px(8)});
    if (*first) ImGui::SetKeyboardFocusHere();
    *first = false;
    ImGui::SetNextItemWidth(context.metrics.px(280));
    ImGui::InputText("###view_name", typed.get(), ImGuiInputTextFlags_AutoSelectAll);
    context.marks.item("view_name");
  };
  request.answers = {{tr("Rename"), "rename", [&editor, typed, name] { name_view(editor, name, *typed); }},
                     {tr("Cancel"), "cancel", {}}};
  services.ask(std::move(request));
}

void ask_focal_length(Editor& editor, CommandServices& services) {
  struct Field {
    double millimetres;
    std::string text = {};
  };
  const Language& tr = editor.language;
  const auto field =
      std::make_shared<Field>(Field{focal_length_of(editor.layout.active_view().goal().field_of_view)});
  const Quantity quantity = focal_length_quantity();
  Prompt::Request request;
  request.title = tr("Focal length");
  request.text = tr("15 to 300 mm, as on film of 36 x 24 mm. The model keeps its size in the view.");
  request.fields = [field, quantity, &tr](PanelContext& context) {
    ImGui::Dummy({0, context.metrics.px(8)});
    option_label(tr, context.metrics, "Focal length");
    option_field("focal_length", tr("Short lenses see wide, long ones flatten"), context.marks,
                 context.metrics.px(140), quantity, field->text, field->millimetres);
  };
  request.answers = {{tr("Set"), "set",
                      [&editor, field] {
                        View& view = editor.layout.active_view();
                        view.remember();
                        view.set(view.goal().with_focal_length(field->millimetres));
                      }},
                     {tr("Cancel"), "cancel", {}}};
  services.ask(std::move(request));
}

}  // namespace hariko
