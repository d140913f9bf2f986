// The outliner: objects of the document in order. Rename, hide, lock, choose and drag them.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "ui/icons.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/selected_items.hpp"
#include "ui/panels/value_fields.hpp"

namespace hariko {

namespace {

constexpr const char* drag_kind = "objects";

bool chosen(const Editor& editor, ObjectId id) {
  return id == editor.selection.active || editor.selection.objects().contains(id);
}

Element object_element(ObjectId id) {
  return {Element::Kind::object, id.value};
}

/// Objects between two rows, both included, as Shift chooses them.
void choose_range(Editor& editor, ObjectId from, ObjectId to) {
  bool inside = false;
  editor.selection.clear_objects();
  editor.selection.clear_elements();
  for (const auto& object : editor.document().objects) {
    const bool end = object->id == from || object->id == to;
    if (end || inside) editor.selection.select({object->id, object_element(object->id)}, Selection::How::add);
    if (end && from != to) inside = !inside;
  }
  editor.selection.active = to;
}

struct Modifiers {
  bool shift = false, control = false;
};

/// Those that were held when the last item was pressed: they may be up again when it is released.
Modifiers modifiers_of_press() {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID("modifiers");
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) storage.SetInt(id, (io.KeyShift ? 1 : 0) + (io.KeyCtrl ? 2 : 0));
  const int held = storage.GetInt(id);
  return {(held & 1) != 0, (held & 2) != 0};
}

void click_row(PanelContext& context, ObjectId id, Modifiers modifiers = {}) {
  Editor& editor = context.editor;
  OutlinerState& state = context.state.outliner;
  using How = Selection::How;
  if (modifiers.shift && editor.document().find(state.anchor)) return choose_range(editor, state.anchor, id);
  state.anchor = id;
  if (modifiers.control) {
    const bool on = editor.selection.objects().contains(id);
    // The active object counts as chosen, so the first Ctrl click adds to it.
    if (const ObjectId active = editor.selection.active; editor.document().find(active) && active != id)
      editor.selection.select({active, object_element(active)}, How::add);
    editor.selection.select({id, object_element(id)}, on ? How::remove : How::add);
    if (!on) editor.selection.active = id;
    return;
  }
  // Elements of the active object stay selected when its own row is clicked.
  if (editor.selection.active == id && editor.selection.objects().size() <= 1) return;
  editor.selection.clear_elements();
  editor.selection.select({id, object_element(id)}, How::replace);
  editor.selection.active = id;
}

void start_renaming(PanelContext& context, const Object& object) {
  OutlinerState& state = context.state.outliner;
  state.renaming = object.id;
  state.name = object.name;
  state.focus_name = true;
}

/// The name as a text field.
void name_field(PanelContext& context, const Object& object, float width) {
  Editor& editor = context.editor;
  OutlinerState& state = context.state.outliner;
  ImGui::SetNextItemWidth(width);
  if (state.focus_name) focus_next_field();
  ImGui::InputText("##name", &state.name, ImGuiInputTextFlags_AutoSelectAll);
  context.marks.item("outliner.name");
  if (ImGui::IsItemDeactivated()) {
    state.renaming = {};
    if (state.name != object.name)
      editor.commit(rename_object(editor.history.current(), object.id, state.name), "Rename object");
  }
  // The keyboard comes a frame or two after it was asked for.
  if (ImGui::IsItemActive()) state.focus_name = false;
  if (state.focus_name) context.state.field_opening = true;
}

/// A small button at the right end of a row: shown when it says something, or under the pointer.
bool row_switch(PanelContext& context, const char* symbol, const char* id, const char* tooltip, bool always,
                float x) {
  if (!always) return false;
  ImGui::SameLine(x);
  const bool pressed = icon_button(context, symbol, id, tooltip, false, 24);
  return pressed;
}

void badge(PanelContext& context, const SurfaceView* view, float x) {
  if (!view || (!view->error && view->warnings.empty())) return;
  ImGui::SameLine(x);
  ImGui::AlignTextToFramePadding();
  const TextColour colour(view->error ? palette().error : palette().warning);
  ImGui::TextUnformatted(view->error ? icon::error : icon::warning);
  if (!ImGui::IsItemHovered()) return;
  const TextColour bright(palette().text);
  const Message& message = view->error ? *view->error : view->warnings.front();
  std::string text = context.tr.text_of(message);
  if (!view->error && view->warnings.size() > 1)
    text += "\n" + fill(context.tr("and {0} more"), {std::to_string(view->warnings.size() - 1)});
  ImGui::SetTooltip("%s", text.c_str());
}

constexpr std::array mirror_names{translatable("Live mirror X"), translatable("Live mirror Y"),
                                  translatable("Live mirror Z")};

/// Says that what is modelled is half of what is seen.
void mirror_badge(PanelContext& context, const Object& object, float x) {
  ImGui::SameLine(x);
  ImGui::AlignTextToFramePadding();
  {
    const TextColour colour(palette().secondary);
    ImGui::TextUnformatted(icon::mirror);
  }
  context.marks.item("mirror." + std::to_string(object.id.value));
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s",
                      context.tr(mirror_names[static_cast<std::size_t>(object.polyhedron()->mirror->axis)]));
}

void context_menu(PanelContext& context, const Object& object) {
  if (!ImGui::BeginPopupContextItem("menu")) return;
  if (!chosen(context.editor, object.id)) click_row(context, object.id);
  for (const char* id : {"object.rename", "object.duplicate", "object.delete", "", "object.hide",
                         "object.isolate", "object.show_all", "object.lock", "", "object.move_up",
                         "object.move_down", "", "view.frame_selection"}) {
    const Command* command = *id ? context.commands.find(id) : nullptr;
    if (!command) {
      ImGui::Separator();
      continue;
    }
    const auto reason = command->why_not ? command->why_not() : std::nullopt;
    if (ImGui::MenuItem(context.tr(command->label).c_str(), command->keys.c_str(),
                        command->checked && command->checked(), !reason))
      context.run(id);
    context.marks.item(std::string("outliner.") + id);
    if (reason && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
      ImGui::SetTooltip("%s", context.tr.phrase(*reason).c_str());
  }
  ImGui::EndPopup();
}

/// Carries rows to another place: the upper half of a row means before it, the lower half after it.
void drag_and_drop(PanelContext& context, const Object& object, std::size_t index) {
  Editor& editor = context.editor;
  const float height = ImGui::GetItemRectSize().y;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  if (ImGui::BeginDragDropSource()) {
    if (!chosen(editor, object.id)) click_row(context, object.id);
    ImGui::SetDragDropPayload(drag_kind, nullptr, 0);
    ImGui::TextUnformatted(object.name.c_str());
    ImGui::EndDragDropSource();
  }
  if (!ImGui::BeginDragDropTarget()) return;
  const bool after = ImGui::GetMousePos().y > low.y + height / 2;
  const float y = after ? high.y : low.y;
  ImGui::GetForegroundDrawList()->AddLine({low.x, y}, {high.x, y}, palette().secondary,
                                          context.metrics.px(2));
  if (ImGui::AcceptDragDropPayload(drag_kind, ImGuiDragDropFlags_AcceptNoDrawDefaultRect)) {
    const auto ids = chosen_ids(editor);
    editor.commit(reorder_objects(editor.history.current(), ids, after ? index + 1 : index),
                  "Reorder objects");
  }
  ImGui::EndDragDropTarget();
}

void object_row(PanelContext& context, const Object& object, std::size_t index) {
  Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  OutlinerState& state = context.state.outliner;
  ImGui::PushID(static_cast<int>(object.id.value));
  const float side = m.px(26);
  const float left = ImGui::GetCursorPosX(), right = left + ImGui::GetContentRegionAvail().x;
  const bool renaming = state.renaming == object.id;
  const bool pressed = ImGui::Selectable(
      "##row", chosen(editor, object.id),
      ImGuiSelectableFlags_AllowItemOverlap | ImGuiSelectableFlags_AllowDoubleClick, {0, side});
  const Modifiers modifiers = modifiers_of_press();
  if (pressed) {
    click_row(context, object.id, modifiers);
    if (ImGui::IsMouseDoubleClicked(0)) start_renaming(context, object);
  }
  context.marks.item("object." + std::to_string(object.id.value));
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  ImGui::SetItemAllowOverlap();
  drag_and_drop(context, object, index);
  context_menu(context, object);
  ImGui::SameLine(left + m.px(6));
  ImGui::AlignTextToFramePadding();
  const TextColour colour(object.visible ? palette().text : palette().dim_text);
  ImGui::TextUnformatted(object.mesh() ? icon::mesh : icon::object);
  ImGui::SameLine(left + m.px(28));
  const bool mirrored = object.polyhedron() && object.polyhedron()->mirror;
  const float name_end = right - m.px(mirrored ? 106.0F : 84.0F);
  if (renaming) {
    name_field(context, object, name_end - ImGui::GetCursorPosX());
  } else {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float cut = at.x + name_end - ImGui::GetCursorPosX();
    ImGui::PushClipRect({at.x, at.y - m.px(6)}, {cut, at.y + side}, true);
    ImGui::TextUnformatted(object.name.c_str());
    ImGui::PopClipRect();
  }
  if (mirrored) mirror_badge(context, object, right - m.px(100));
  badge(context, editor.view_of(object.id), right - m.px(78));
  if (row_switch(context, object.locked ? icon::locked : icon::unlocked, "lock",
                 object.locked ? "Unlock" : "Lock", object.locked || hovered, right - m.px(52)))
    editor.commit(set_locked(editor.history.current(), object.id, !object.locked),
                  object.locked ? "Unlock object" : "Lock object");
  if (object.locked || hovered) context.marks.item("lock." + std::to_string(object.id.value));
  ImGui::SameLine(right - m.px(26));
  if (icon_button(context, object.visible ? icon::shown : icon::hidden, "visible",
                  object.visible ? "Hide" : "Show", false, 24))
    editor.commit(set_visible(editor.history.current(), object.id, !object.visible),
                  object.visible ? "Hide object" : "Show object");
  context.marks.item("eye." + std::to_string(object.id.value));
  ImGui::PopID();
}

/// Up and down choose the neighbour while the list has the keyboard.
void arrow_keys(PanelContext& context) {
  Editor& editor = context.editor;
  if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) || ImGui::GetIO().WantTextInput) return;
  const int by = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) -
                 ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow));
  const auto& objects = editor.document().objects;
  const auto active = std::find_if(objects.begin(), objects.end(),
                                   [&](const auto& object) { return object->id == editor.selection.active; });
  if (by == 0 || active == objects.end()) return;
  const auto next = (active - objects.begin()) + by;
  if (next < 0 || next >= static_cast<std::ptrdiff_t>(objects.size())) return;
  click_row(context, objects[static_cast<std::size_t>(next)]->id);
}

}  // namespace

void draw_objects(PanelContext& context, const PanelRect& rect) {
  Editor& editor = context.editor;
  OutlinerState& state = context.state.outliner;
  const Metrics& m = context.metrics;
  if (begin_panel("Objects", rect, palette().panel, {m.px(12), m.px(8)})) {
    heading(context, "Objects");
    // Edits replace the document under the panel: what is drawn is this frame's value.
    const Document document = editor.document();
    if (editor.rename_wanted) {
      editor.rename_wanted = false;
      if (const Object* object = document.find(editor.selection.active)) start_renaming(context, *object);
    }
    if (document.objects.empty())
      hint_text(context, "Nothing here yet. Add a shape, or drop a mesh on the window.");
    ImGui::BeginChild("rows");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(m.px(4), m.px(2)));
    const float row = m.px(28);
    const auto active =
        std::find_if(document.objects.begin(), document.objects.end(),
                     [&](const auto& object) { return object->id == editor.selection.active; });
    // What was chosen in the view comes into sight here.
    if (state.shown_active != editor.selection.active && active != document.objects.end()) {
      const float y = row * static_cast<float>(active - document.objects.begin());
      if (y < ImGui::GetScrollY() || y + row > ImGui::GetScrollY() + ImGui::GetWindowHeight())
        ImGui::SetScrollY(y - ImGui::GetWindowHeight() / 2);
    }
    state.shown_active = editor.selection.active;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(document.objects.size()), row);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const auto index = static_cast<std::size_t>(i);
        object_row(context, *document.objects[index], index);
      }
    arrow_keys(context);
    ImGui::PopStyleVar();
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace hariko
