// The outliner: objects of the document in order. Rename, hide, lock, choose and drag them.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "core/base/text/natural_order.hpp"
#include "ui/base/fuzzy.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

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
void choose_range(Editor& editor, const std::vector<ObjectId>& rows, ObjectId from, ObjectId to) {
  bool inside = false;
  editor.selection.clear_objects();
  editor.selection.clear_elements();
  for (const ObjectId id : rows) {
    const bool end = id == from || id == to;
    if (end || inside) editor.selection.select({id, object_element(id)}, Selection::How::add);
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
  const auto has_row = [&](ObjectId row) {
    return std::find(state.shown.begin(), state.shown.end(), row) != state.shown.end();
  };
  // A choice in the view is an end of the range, too.
  const ObjectId from =
      has_row(state.anchor) && chosen(editor, state.anchor) ? state.anchor : editor.selection.active;
  if (modifiers.shift && has_row(from)) {
    choose_range(editor, state.shown, from, id);
    state.anchor = from;
    return;
  }
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
  show_tip(text);
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
    show_tip(context.tr(mirror_names[static_cast<std::size_t>(object.polyhedron()->mirror->axis)]));
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
      show_tip(context.tr.phrase(*reason));
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
  // Another order is for finding, and has no places to drop at.
  if (state.order == OutlinerState::Order::document && state.search.empty())
    drag_and_drop(context, object, index);
  context_menu(context, object);
  ImGui::SameLine(left + m.px(6));
  ImGui::AlignTextToFramePadding();
  const TextColour colour(object.visible ? palette().text : palette().dim_text);
  ImGui::TextUnformatted(object.picture() ? icon::picture : object.mesh() ? icon::mesh : icon::object);
  ImGui::SameLine(left + m.px(28));
  const bool mirrored = object.polyhedron() && object.polyhedron()->mirror;
  const float name_end = right - m.px(mirrored ? 106.0F : 84.0F);
  if (renaming) {
    name_field(context, object, name_end - ImGui::GetCursorPosX());
  } else {
    ImGui::TextUnformatted(elided(object.name, name_end - ImGui::GetCursorPosX()).c_str());
  }
  if (mirrored) mirror_badge(context, object, right - m.px(100));
  badge(context, editor.view_of(object.id), right - m.px(78));
  // The keyboard finds it as well: what comes with the pointer alone would be gone again under its ring.
  const bool has_lock =
      object.locked || hovered || (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0;
  if (row_switch(context, object.locked ? icon::locked : icon::unlocked, "lock",
                 object.locked ? "Unlock" : "Lock", has_lock, right - m.px(52)))
    editor.commit(set_locked(editor.history.current(), object.id, !object.locked),
                  object.locked ? "Unlock object" : "Lock object");
  if (has_lock) context.marks.item("lock." + std::to_string(object.id.value));
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
  // Then they go from item to item.
  if ((ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0) return;
  const int by = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) -
                 ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow));
  const std::vector<ObjectId>& rows = context.state.outliner.shown;
  const auto active = std::find(rows.begin(), rows.end(), editor.selection.active);
  if (by == 0 || active == rows.end()) return;
  const auto next = (active - rows.begin()) + by;
  if (next < 0 || next >= static_cast<std::ptrdiff_t>(rows.size())) return;
  click_row(context, rows[static_cast<std::size_t>(next)], {ImGui::GetIO().KeyShift, false});
}

/// The rows that are shown, in their order: places in the document.
std::vector<std::size_t> rows_of(const Document& document, const OutlinerState& state) {
  using Order = OutlinerState::Order;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < document.objects.size(); ++i)
    if (state.search.empty() || fuzzy_score(state.search, document.objects[i]->name) > 0) rows.push_back(i);
  const auto before = [&](std::size_t a, std::size_t b) {
    const Object &first = *document.objects[a], &second = *document.objects[b];
    switch (state.order) {
      case Order::name:
        return natural_less(first.name, second.name);
      case Order::kind:
        return first.source.index() < second.source.index();
      case Order::newest:
        return first.id.value > second.id.value;
      default:
        return a < b;
    }
  };
  std::stable_sort(rows.begin(), rows.end(), before);
  return rows;
}

constexpr std::array order_names{translatable("In order"), translatable("By name"), translatable("By kind"),
                                 translatable("Newest first")};
/// From so many objects on the list can be searched and sorted.
constexpr std::size_t many_objects = 8;

/// A field to search in, and the order of the rows.
void search_row(PanelContext& context) {
  OutlinerState& state = context.state.outliner;
  const float order = context.metrics.px(112);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - order - ImGui::GetStyle().ItemSpacing.x);
  ImGui::InputTextWithHint("##search", context.tr("Search objects"), &state.search,
                           ImGuiInputTextFlags_AutoSelectAll);
  context.marks.item("outliner.search");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(order);
  const auto current = static_cast<std::size_t>(state.order);
  const bool open = ImGui::BeginCombo("##order", context.tr(order_names[current]));
  context.marks.item("outliner.order");
  if (!open) return;
  for (std::size_t i = 0; i < order_names.size(); ++i) {
    if (ImGui::Selectable(context.tr(order_names[i]), i == current))
      state.order = static_cast<OutlinerState::Order>(i);
    context.marks.item("outliner.order." + std::to_string(i));
  }
  ImGui::EndCombo();
}

bool many(const Document& document) {
  return document.objects.size() >= many_objects;
}

}  // namespace

float objects_height(const PanelContext& context, float available) {
  const Metrics& m = context.metrics;
  constexpr float heading = 48, search = 34, row = 32, least = 96;  // design pixels
  const float wanted = context.editor.settings.objects_height;
  // Properties need their room: what is drawn by hand may take more of it.
  constexpr float by_itself = 0.5F, by_hand = 0.75F;
  if (wanted > 0) return std::clamp(m.px(wanted), m.px(least), std::max(m.px(least), by_hand * available));
  const Document& document = context.editor.document();
  const float rows =
      m.px(heading + row * static_cast<float>(document.objects.size()) + (many(document) ? search : 0));
  return std::clamp(rows, m.px(least), std::max(m.px(240), by_itself * available));
}

void draw_objects(PanelContext& context, const PanelRect& rect) {
  Editor& editor = context.editor;
  OutlinerState& state = context.state.outliner;
  const Metrics& m = context.metrics;
  if (begin_panel("Objects", rect, palette().panel, {m.px(12), m.px(8)})) {
    heading(context, "Objects");
    // Edits replace the document under the panel: what is drawn is this frame's value.
    const Document document = editor.document();
    if (many(document)) {
      search_row(context);
    } else {
      state.search.clear();
      state.order = OutlinerState::Order::document;
    }
    const std::vector<std::size_t> rows = rows_of(document, state);
    state.shown.clear();
    for (const std::size_t i : rows) state.shown.push_back(document.objects[i]->id);
    if (editor.rename_wanted) {
      editor.rename_wanted = false;
      state.shown_active = {};  // its row comes into sight
      if (const Object* object = document.find(editor.selection.active)) start_renaming(context, *object);
    }
    if (document.objects.empty())
      hint_text(context, "Nothing here yet. Add a shape, or drop a mesh on the window.");
    else if (rows.empty())
      hint_text(context, "Nothing is called like that.");
    ImGui::BeginChild("rows", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(m.px(4), m.px(2)));
    const float row = m.px(28);
    const auto active = std::find(state.shown.begin(), state.shown.end(), editor.selection.active);
    // What was chosen in the view comes into sight here.
    if (state.shown_active != editor.selection.active && active != state.shown.end()) {
      const float y = row * static_cast<float>(active - state.shown.begin());
      if (y < ImGui::GetScrollY() || y + row > ImGui::GetScrollY() + ImGui::GetWindowHeight())
        ImGui::SetScrollY(y - ImGui::GetWindowHeight() / 2);
    }
    state.shown_active = editor.selection.active;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), row);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const std::size_t index = rows[static_cast<std::size_t>(i)];
        object_row(context, *document.objects[index], index);
      }
    arrow_keys(context);
    ImGui::PopStyleVar();
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace hariko
