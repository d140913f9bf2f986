#include "ui/widgets/value_fields.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/widgets/tips.hpp"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <cmath>

namespace hariko {

namespace {

constexpr float label_width = 88, field_width = 78;
constexpr float pixels_per_step = 8;

/// Carries a gesture of the last item to its end.
void end_gesture(Editor& editor, const std::string& step) {
  if (ImGui::IsItemDeactivatedAfterEdit())
    editor.commit_preview(step);
  else if (ImGui::IsItemDeactivated())
    editor.cancel_preview();
}

void tooltip(const PanelContext& context, const char* help) {
  if (*help && ImGui::IsItemHovered()) show_tip(context.tr(help));
}

/// Changes without a gesture, after all rows of this frame.
void commit(PanelContext& context, const FieldSpec& spec, const ValueChange& change, const EditValues& edit) {
  later(context, edit(context.editor.history.current(), change), spec.step);
}

/// Right click on the last item: default, copy, paste.
void value_menu(PanelContext& context, const FieldSpec& spec, std::optional<double> value,
                const EditValues& edit, const char* id = "##value_menu") {
  if (!ImGui::BeginPopupContextItem(id)) return;
  const Language& tr = context.tr;
  const bool known = spec.quantity.standard.has_value();
  const bool differs = known && value != spec.quantity.standard;
  if (ImGui::MenuItem(tr("Reset to default"), nullptr, false, differs))
    commit(context, spec, {ValueChange::Kind::set, *spec.quantity.standard}, edit);
  context.marks.item("value.reset");
  if (ImGui::MenuItem(tr("Copy value"), nullptr, false, value.has_value()))
    ImGui::SetClipboardText(exact_text(spec.quantity, *value).c_str());
  context.marks.item("value.copy");
  const char* clipboard = ImGui::GetClipboardText();
  const auto pasted = parse_change(clipboard ? clipboard : "", spec.quantity);
  if (ImGui::MenuItem(tr("Paste value"), nullptr, false, pasted.ok())) commit(context, spec, *pasted, edit);
  context.marks.item("value.paste");
  ImGui::EndPopup();
}

/// The label of a number: dragging it to the side changes the value.
void drag_label(PanelContext& context, const FieldSpec& spec, std::optional<double> value,
                const EditValues& edit) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = context.metrics.px(label_width);
  pointer_button("label", {width, ImGui::GetFrameHeight()});  // keys type into the field
  context.marks.item(std::string("label.") + spec.id);
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  if (hovered || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (held && ImGui::IsMouseDragging(0, 3)) {
    const ImGuiIO& io = ImGui::GetIO();
    const float steps = ImGui::GetMouseDragDelta(0, 3).x / (pixels_per_step * context.metrics.scale);
    context.editor.preview(edit(context.editor.history.current(),
                                stepped(spec.quantity, static_cast<double>(steps), io.KeyShift, io.KeyCtrl)));
  }
  if (ImGui::IsItemDeactivated()) {
    context.editor.commit_preview(spec.step);
  }
  tooltip(context, spec.help);
  value_menu(context, spec, value, edit);
  ImGui::GetWindowDrawList()->AddText({at.x, at.y + ImGui::GetStyle().FramePadding.y},
                                      hovered || held ? palette().text : palette().dim_text,
                                      context.tr(spec.label));
  ImGui::SameLine(context.metrics.px(label_width + 12));
}

/// A number that was typed over `from`. Esc brings the text back, which has fewer digits than the value: only
/// another text is an edit.
void take_typed(PanelContext& context, const FieldSpec& spec, const std::string& text,
                const std::string& from, const EditValues& edit) {
  if (text == from) return;
  const auto change = parse_change(text, spec.quantity);
  change.ok() ? commit(context, spec, *change, edit) : context.editor.notify(change.error());
}

/// Arrow keys in a field: what has been typed so far is changed by a step.
int arrow_keys(ImGuiInputTextCallbackData* data) {
  const auto& quantity = *static_cast<const Quantity*>(data->UserData);
  const ImGuiIO& io = ImGui::GetIO();
  const auto typed = parse_change({data->Buf, static_cast<std::size_t>(data->BufTextLen)}, quantity);
  if (!typed.ok() || typed->kind != ValueChange::Kind::set) return 0;
  const double direction = data->EventKey == ImGuiKey_UpArrow ? 1 : -1;
  const double value = stepped(quantity, direction, io.KeyShift, io.KeyCtrl).apply(quantity, typed->amount);
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, format_quantity(quantity, value).c_str());
  data->SelectAll();
  return 0;
}

}  // namespace

void later(PanelContext& context, Result<Document> result, std::string step) {
  if (result.ok() && *result == context.editor.history.current()) return;
  context.state.steps.push_back([&editor = context.editor, result = std::move(result),
                                 step = std::move(step)] { editor.commit(result, step); });
}

void row_label(const PanelContext& context, const char* label, const char* help) {
  const TextColour colour(palette().dim_text);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(context.tr(label));
  if (*help && ImGui::IsItemHovered()) {
    const TextColour bright(palette().text);
    show_tip(context.tr(help));
  }
  ImGui::SameLine(context.metrics.px(label_width + 12));
}

void point_out(PanelContext& context, const char* id) {
  constexpr double seconds = 2;
  PanelState& state = context.state;
  if (state.wanted_row == id) {
    state.wanted_row.clear();
    state.pointed_row = id;
    state.pointed_until = context.editor.now + seconds;
    ImGui::SetScrollHereY(0.4F);
  }
  if (state.pointed_row != id || context.editor.now > state.pointed_until) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRect(low, high, palette().secondary, ImGui::GetStyle().FrameRounding, 0,
                                      context.metrics.px(2));
}

void hint_text(const PanelContext& context, const char* english) {
  const TextColour dim(palette().dim_text);
  text_in_lines(context.tr(english));
}

void value_row(PanelContext& context, const FieldSpec& spec, std::optional<double> value,
               const EditValues& edit) {
  ImGui::PushID(spec.id);
  drag_label(context, spec, value, edit);
  number_field(context, spec, value, ImGui::GetContentRegionAvail().x, edit);
  ImGui::PopID();
}

void slider_row(PanelContext& context, const FieldSpec& spec, double low, double high, bool logarithmic,
                std::optional<double> value, const EditValues& edit) {
  Editor& editor = context.editor;
  ImGui::PushID(spec.id);
  drag_label(context, spec, value, edit);
  const float field = context.metrics.px(field_width);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - field - ImGui::GetStyle().ItemSpacing.x);
  double shown = value.value_or(low);
  ImGuiSliderFlags flags = ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat;
  if (logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
  if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &shown, &low, &high,
                          value ? "" : context.tr("mixed"), flags)) {
    // Four digits are enough for a hand on a slider and read better than sixteen.
    const double digits = std::pow(10, 3 - std::floor(std::log10(std::max(std::abs(shown), 1e-9))));
    const double rounded = spec.quantity.whole ? std::round(shown) : std::round(shown * digits) / digits;
    editor.preview(edit(editor.history.current(), {ValueChange::Kind::set, rounded}));
  }
  tooltip(context, spec.help);
  end_gesture(editor, spec.step);
  context.marks.item(std::string("slider.") + spec.id);
  value_menu(context, spec, value, edit, "##slider_menu");
  ImGui::SameLine();
  number_field(context, spec, value, field, edit);
  ImGui::PopID();
}

void vector_row(PanelContext& context, const char* label, const char* help,
                const std::array<FieldSpec, 3>& specs, const std::array<std::optional<double>, 3>& values,
                const std::function<Result<Document>(const Document&, int axis, const ValueChange&)>& edit) {
  static constexpr ImU32 axis_colours[] = {IM_COL32(0xe5, 0x48, 0x4d, 255), IM_COL32(0x46, 0xa7, 0x58, 255),
                                           IM_COL32(0x3e, 0x82, 0xf7, 255)};
  // One number a row: three beside each other have no room for their units.
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    FieldSpec spec = specs[i];
    spec.label = axis == 0 ? label : "";
    spec.help = help;
    ImGui::PushID(spec.id);
    const EditValues edit_axis = [&edit, axis](const Document& document, const ValueChange& change) {
      return edit(document, axis, change);
    };
    drag_label(context, spec, values[i], edit_axis);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + ImGui::GetStyle().FramePadding.y}, axis_colours[axis],
                                        specs[i].label);
    ImGui::SetCursorScreenPos({at.x + context.metrics.px(18), at.y});
    number_field(context, spec, values[i], ImGui::GetContentRegionAvail().x, edit_axis);
    ImGui::PopID();
  }
}

void number_field(PanelContext& context, const FieldSpec& spec, std::optional<double> value, float width,
                  const EditValues& edit) {
  ImGui::PushID(spec.id);
  ImGui::SetNextItemWidth(width);
  const std::string shown = value ? format_quantity(spec.quantity, *value) : std::string();
  const ImGuiID id = ImGui::GetID("##number");
  PanelState& state = context.state;
  std::string text = state.typing == id ? state.typed_text : shown;
  Quantity quantity = spec.quantity;
  const bool asked = state.wanted_row == spec.id;
  if (asked) focus_next_field();
  ImGui::InputTextWithHint("##number", context.tr("mixed"), &text,
                           ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackHistory,
                           &arrow_keys, &quantity);
  if (ImGui::IsItemActivated()) {
    if (state.typing != 0 && state.typing != id)
      state.left = {state.typing, state.typed_text, state.typed_from};
    state.typing = id;
    state.typed_from = shown;
  }
  // The keyboard comes a frame or two after it was asked for.
  if (asked && !ImGui::IsItemActive()) state.field_opening = true;
  if (asked && ImGui::IsItemActive()) {
    state.wanted_row.clear();
    ImGui::SetScrollHereY(0.4F);
  }
  if (ImGui::IsItemActive()) {
    state.typed_text = text;
    state.typing_row = std::string("field.") + spec.id;
  }
  if (ImGui::IsItemDeactivated() && state.typing == id) {
    state.typing = 0;
    take_typed(context, spec, text, state.typed_from, edit);
  } else if (state.left.id == id) {
    const LeftField left = std::exchange(state.left, {});
    take_typed(context, spec, left.text, left.from, edit);
  }
  if (ImGui::IsItemHovered()) {
    const char* how = context.tr("Type a number, 1/4in or sqrt(2); +=, *= and /= change each value.");
    show_tip(*spec.help ? std::string(context.tr(spec.help)) + "\n" + how : std::string(how));
  }
  context.marks.item(std::string("field.") + spec.id);
  value_menu(context, spec, value, edit);
  ImGui::PopID();
}

std::optional<bool> check_row(PanelContext& context, const char* id, const char* label, const char* help,
                              std::optional<bool> value) {
  row_label(context, label, help);
  ImGui::PushID(id);
  bool on = value.value_or(false);
  ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, !value);
  const bool changed = ImGui::Checkbox("##check", &on);
  ImGui::PopItemFlag();
  context.marks.item(std::string("check.") + id);
  point_out(context, id);
  tooltip(context, help);
  if (!value) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s", context.tr("mixed"));
  }
  ImGui::PopID();
  return changed ? std::optional(on) : std::nullopt;
}

}  // namespace hariko
