#include "ui/widgets/value_fields.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

namespace hariko {

namespace {

constexpr float label_width = 88;
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
  const OpenScope menu = item_menu_scope(id);
  if (!menu) return;
  const Language& tr = context.tr;
  const bool known = spec.quantity.standard.has_value();
  const bool differs = known && value != spec.quantity.standard;
  if (menu_row(context.marks, "value.reset", tr("Reset to default"), false, differs))
    commit(context, spec, {ValueChange::Kind::set, *spec.quantity.standard}, edit);
  if (menu_row(context.marks, "value.copy", tr("Copy value"), false, value.has_value()))
    ImGui::SetClipboardText(exact_text(spec.quantity, *value).c_str());
  const char* clipboard = ImGui::GetClipboardText();
  const auto pasted = parse_change(clipboard ? clipboard : "", spec.quantity);
  if (menu_row(context.marks, "value.paste", tr("Paste value"), false, pasted.ok()))
    commit(context, spec, *pasted, edit);
}

/// The label of a number: dragging it to the side changes the value.
void drag_label(PanelContext& context, const FieldSpec& spec, std::optional<double> value,
                const EditValues& edit) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = context.metrics.px(label_width);
  // Keys type into the field.
  pointer_button(context.marks, std::string("label.") + spec.id, {width, ImGui::GetFrameHeight()});
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

/// The slider of a number, of the given width in pixels.
void value_slider(PanelContext& context, const FieldSpec& spec, std::optional<double> value, float width,
                  const EditValues& edit) {
  Editor& editor = context.editor;
  const double low = spec.quantity.low, high = spec.quantity.high;
  ImGui::SetNextItemWidth(width);
  double shown = value.value_or(low);
  ImGuiSliderFlags flags = ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat;
  if (spec.slider == SliderKind::logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
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
std::optional<std::string> text_after_step(const Quantity& quantity, const std::string& text, int direction) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto typed = parse_change(text, quantity);
  if (!typed.ok() || typed->kind != ValueChange::Kind::set) return {};
  const ValueChange step = stepped(quantity, direction, io.KeyShift, io.KeyCtrl);
  return format_quantity(quantity, step.apply(quantity, typed->amount));
}

}  // namespace

void later(PanelContext& context, Result<Document> result, std::string step) {
  if (result.ok() && *result == context.editor.history.current()) return;
  context.state.steps.push_back([&editor = context.editor, result = std::move(result),
                                 step = std::move(step)] { editor.commit(result, step); });
}

void row_label(const PanelContext& context, const char* label, const char* help) {
  const TextColour colour(palette().dim_text);
  aligned_text(context.tr(label));
  if (*help && ImGui::IsItemHovered()) {
    const TextColour bright(palette().text);
    show_tip(context.tr(help));
  }
  ImGui::SameLine(context.metrics.px(label_width + 12));
}

void text_row(PanelContext& context, const char* mark, const char* label, const char* help,
              const std::string& text) {
  row_label(context, label, help);
  plain_text(text);
  context.marks.item(mark);
}

bool row_button(PanelContext& context, const std::string& id, const char* label, const char* help) {
  const bool pressed = text_button(context.marks, "button." + id, context.tr(label), -1);
  tooltip(context, help);
  return pressed;
}

void run_button(PanelContext& context, const char* label, const char* command) {
  const Command* known = context.commands.find(command);
  if (row_button(context, command, label, known ? known->help.c_str() : "")) context.run(command);
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
  coloured_lines(palette().dim_text, context.tr(english));
}

void value_row(PanelContext& context, const FieldSpec& spec, std::optional<double> value,
               const EditValues& edit) {
  ImGui::PushID(spec.id);
  drag_label(context, spec, value, edit);
  float width = ImGui::GetContentRegionAvail().x;
  if (spec.slider != SliderKind::none) {
    const float slider = width - context.metrics.px(number_field_width) - ImGui::GetStyle().ItemSpacing.x;
    value_slider(context, spec, value, slider, edit);
    ImGui::SameLine();
    width = context.metrics.px(number_field_width);
  }
  number_field(context, spec, value, width, edit);
  ImGui::PopID();
}

void vector_row(PanelContext& context, const VectorSpec& spec,
                const std::array<std::optional<double>, 3>& values, const EditAxis& edit) {
  static constexpr std::array axis_names{"X", "Y", "Z"};
  // One number a row: three beside each other have no room for their units.
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const FieldSpec field{spec.ids[i], axis == 0 ? spec.label : "", spec.help, spec.step, spec.quantity};
    ImGui::PushID(field.id);
    const EditValues edit_axis = [&edit, axis](const Document& document, const ValueChange& change) {
      return edit(document, axis, change);
    };
    drag_label(context, field, values[i], edit_axis);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + ImGui::GetStyle().FramePadding.y}, axis_colour(axis),
                                        axis_names[i]);
    ImGui::SetCursorScreenPos({at.x + context.metrics.px(18), at.y});
    number_field(context, field, values[i], ImGui::GetContentRegionAvail().x, edit_axis);
    ImGui::PopID();
  }
}

void number_field(PanelContext& context, const FieldSpec& spec, std::optional<double> value, float width,
                  const EditValues& edit) {
  ImGui::PushID(spec.id);
  const std::string shown = value ? format_quantity(spec.quantity, *value) : std::string();
  const std::string mark = std::string("field.") + spec.id;
  const ImGuiID id = ImGui::GetID(("##" + mark).c_str());
  PanelState& state = context.state;
  const auto typed_into = [](ImGuiID field) {
    return field != 0 && (GImGui->ActiveId == field || GImGui->ActiveIdPreviousFrame == field);
  };
  // A field that went while one typed lost its text: it must not come back with the next one like it.
  if (!typed_into(state.typing)) state.typing = 0;
  std::string text = state.typing == id ? state.typed_text : shown;
  const bool asked = state.wanted_row == spec.id;
  if (asked) focus_next_field();
  text_field(context.marks, mark, text, width, context.tr("mixed"), ImGuiInputTextFlags_AutoSelectAll,
             [&spec](const std::string& typed, int direction) {
               return text_after_step(spec.quantity, typed, direction);
             });
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
    state.typing_row = mark;
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
  value_menu(context, spec, value, edit);
  ImGui::PopID();
}

std::optional<bool> check_row(PanelContext& context, const char* id, const char* label, const char* help,
                              std::optional<bool> value) {
  row_label(context, label, help);
  const auto changed = mixed_check(context.marks, std::string("check.") + id, "", value);
  point_out(context, id);
  tooltip(context, help);
  if (!value) {
    ImGui::SameLine();
    dim_text(context.tr("mixed"));
  }
  return changed;
}

}  // namespace hariko
