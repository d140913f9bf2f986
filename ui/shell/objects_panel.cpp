// The outliner: objects of the document in their groups. Rename, hide, lock, choose and drag them.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/text/natural_order.hpp"
#include "ui/base/fuzzy.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/shell/outliner_rows.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

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

void object_name_field(PanelContext& context, const Object& object, float width) {
  Editor& editor = context.editor;
  OutlinerState& state = context.state.outliner;
  if (!row_name_field(context, width)) return;
  state.renaming = {};
  if (state.name != object.name)
    editor.commit(rename_object(editor.history.current(), object.id, state.name), "Rename object");
}

/// A small button at the right end of a row: shown when it says something, or under the pointer.
bool row_switch(PanelContext& context, const char* symbol, const std::string& mark, const char* tooltip,
                bool always, float x) {
  if (!always) return false;
  ImGui::SameLine(x);
  return icon_button(context, symbol, mark, tooltip, false, 24);
}

/// A mark behind the name of an object.
void draw_badge(const char* text, ImU32 colour, float x) {
  ImGui::SameLine(x);
  ImGui::AlignTextToFramePadding();
  coloured_text(colour, text);
}

void badge(PanelContext& context, const SurfaceView* view, float x) {
  if (!view || (!view->error && view->warnings.empty())) return;
  draw_badge(view->error ? icon::error : icon::warning, view->error ? palette().error : palette().warning, x);
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
  draw_badge(icon::mirror, palette().secondary, x);
  context.marks.item("mirror." + std::to_string(object.id.value));
  if (ImGui::IsItemHovered())
    show_tip(context.tr(mirror_names[static_cast<std::size_t>(object.live_mirror()->axis)]));
}

/// Number of places of an object with live copies, as its row shows it; empty for others.
std::string text_of_places(const Object& object) {
  return object.copies->empty() ? std::string() : "\u00d7" + std::to_string(place_count(object));
}

/// Says that the object stands at more places than one.
void places_badge(PanelContext& context, const Object& object, const std::string& text, float x) {
  draw_badge(text.c_str(), palette().secondary, x);
  context.marks.item("copies." + std::to_string(object.id.value));
  if (ImGui::IsItemHovered())
    show_tip(fill(context.tr("Live copies: {0} places in all"), {std::to_string(place_count(object))}));
}

void context_menu(PanelContext& context, const Object& object) {
  const OpenScope menu = item_menu_scope();
  if (!menu) return;
  if (!chosen(context.editor, object.id)) click_row(context, object.id);
  draw_menu_items(context,
                  {"object.rename", "object.duplicate", "object.delete", "", "object.hide", "object.isolate",
                   "object.show_all", "object.lock", "", "object.move_up", "object.move_down", "",
                   "view.frame_selection"},
                  "outliner.");
}

/// Lock and eye at the right end of a row: the object's own switches.
void object_switches(PanelContext& context, const Object& object, bool hovered, float right) {
  Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  const bool locked = object.locked_itself(), visible = object.visible_itself();
  // The keyboard finds it as well: what comes with the pointer alone would be gone again under its ring.
  const bool has_lock =
      locked || hovered || (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0;
  const std::string number = std::to_string(object.id.value);
  if (row_switch(context, locked ? icon::locked : icon::unlocked, "lock." + number,
                 locked ? "Unlock" : "Lock", has_lock, right - m.px(52)))
    editor.commit(set_locked(editor.history.current(), object.id, !locked),
                  locked ? "Unlock object" : "Lock object");
  ImGui::SameLine(right - m.px(26));
  if (icon_button(context, visible ? icon::shown : icon::hidden, "eye." + number, visible ? "Hide" : "Show",
                  false, 24))
    editor.commit(set_visible(editor.history.current(), object.id, !visible),
                  visible ? "Hide object" : "Show object");
}

/// An object that is dragged is chosen, if it is not yet.
void drag_object_row(PanelContext& context, const Document& document, const Object& object) {
  drag_row(context, document, object.id, object.name);
  const bool carried = ImGui::IsItemActive() && ImGui::GetDragDropPayload();
  if (carried && !chosen(context.editor, object.id)) click_row(context, object.id);
}

void object_row(PanelContext& context, const Document& document, const OutlinerRow& row) {
  const Object& object = *document.objects[row.index];
  Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  OutlinerState& state = context.state.outliner;
  ImGui::PushID(static_cast<int>(object.id.value));
  const float side = m.px(26);
  const float left = ImGui::GetCursorPosX(), right = left + ImGui::GetContentRegionAvail().x;
  const float begin = left + row_indent(m, row.depth);
  const bool renaming = state.renaming == object.id;
  const bool pressed = selectable_row(
      context.marks, "object." + std::to_string(object.id.value), "", chosen(editor, object.id), {0, side},
      ImGuiSelectableFlags_AllowItemOverlap | ImGuiSelectableFlags_AllowDoubleClick);
  const Modifiers modifiers = modifiers_of_press();
  if (pressed) {
    click_row(context, object.id, modifiers);
    if (ImGui::IsMouseDoubleClicked(0)) start_renaming(context, object);
  }
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  ImGui::SetItemAllowOverlap();
  // Another order is for finding, and has no places to drop at.
  draw_group_mark(context, document, object.group);
  if (state.order == OutlinerState::Order::document && state.search.empty())
    drag_object_row(context, document, object);
  context_menu(context, object);
  ImGui::SameLine(begin + m.px(6));
  ImGui::AlignTextToFramePadding();
  const TextColour colour(object.visible ? palette().text : palette().dim_text);
  plain_text(object_kind(object).list_icon());
  ImGui::SameLine(begin + m.px(28));
  const bool mirrored = object.live_mirror() != nullptr;
  const std::string places = text_of_places(object);
  const float marks_begin = right - m.px(mirrored ? 106.0F : 84.0F);
  const float places_begin = marks_begin - ImGui::CalcTextSize(places.c_str()).x;
  const float name_end = places.empty() ? marks_begin : places_begin - m.px(6);
  if (renaming) {
    object_name_field(context, object, name_end - ImGui::GetCursorPosX());
  } else {
    plain_text(elided(object.name, name_end - ImGui::GetCursorPosX()));
  }
  if (!places.empty()) places_badge(context, object, places, places_begin);
  if (mirrored) mirror_badge(context, object, right - m.px(100));
  badge(context, editor.view_of(object.id), right - m.px(78));
  object_switches(context, object, hovered, right);
  ImGui::PopID();
}

/// Up and down choose the neighbour while the list has the keyboard.
void arrow_keys(PanelContext& context) {
  Editor& editor = context.editor;
  if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) || ImGui::GetIO().WantTextInput) return;
  // Then they go from item to item.
  if ((ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0) return;
  const int by = arrow_step();
  const std::vector<ObjectId>& rows = context.state.outliner.shown;
  const auto active = std::find(rows.begin(), rows.end(), editor.selection.active);
  if (by == 0 || active == rows.end()) return;
  const auto next = (active - rows.begin()) + by;
  if (next < 0 || next >= static_cast<std::ptrdiff_t>(rows.size())) return;
  click_row(context, rows[static_cast<std::size_t>(next)], {ImGui::GetIO().KeyShift, false});
}

/// The rows that are shown, in their order. Where they are searched or sorted, groups do not show.
std::vector<OutlinerRow> rows_of(const Document& document, OutlinerState& state) {
  using Order = OutlinerState::Order;
  if (!document.groups->empty() && state.search.empty() && state.order == Order::document)
    return rows_by_groups(document, state);
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
  std::vector<OutlinerRow> out;
  for (const std::size_t i : rows) out.push_back({document.objects[i]->id, i, 0});
  return out;
}

constexpr std::array order_names{translatable("In order"), translatable("By name"), translatable("By kind"),
                                 translatable("Newest first")};
/// From so many objects on the list can be searched and sorted.
constexpr std::size_t many_objects = 8;

/// A field to search in, and the order of the rows.
void search_row(PanelContext& context) {
  OutlinerState& state = context.state.outliner;
  constexpr float order_width = 112;
  text_field(
      context.marks, "outliner.search", state.search,
      ImGui::GetContentRegionAvail().x - context.metrics.px(order_width) - ImGui::GetStyle().ItemSpacing.x,
      context.tr("Search objects"), ImGuiInputTextFlags_AutoSelectAll);
  ImGui::SameLine();
  std::vector<std::string> orders;
  for (const char* name : order_names) orders.emplace_back(context.tr(name));
  if (const auto order =
          option_list(context, "outliner.order", order_width, orders, static_cast<std::size_t>(state.order)))
    state.order = static_cast<OutlinerState::Order>(*order);
}

std::size_t row_count(const Document& document) {
  return document.objects.size() + document.groups->size();
}

bool many(const Document& document) {
  return document.objects.size() >= many_objects;
}

/// Makes the name of the chosen group, else that of the active object, a field.
void start_wanted_renaming(PanelContext& context, const Document& document) {
  Editor& editor = context.editor;
  OutlinerState& state = context.state.outliner;
  editor.rename_wanted = false;
  if (const Group* group = find_group(*document.groups, editor.chosen_group.chosen(editor)))
    return rename_in_row(state, *group);
  state.shown_active = {};  // its row comes into sight
  if (const Object* object = document.find(editor.selection.active)) start_renaming(context, *object);
}

/// Scrolls to what was chosen in the view.
void bring_into_sight(const Editor& editor, OutlinerState& state, const std::vector<OutlinerRow>& rows,
                      float row) {
  const auto active = std::ranges::find_if(
      rows, [&](const OutlinerRow& one) { return one.member == Member(editor.selection.active); });
  if (state.shown_active != editor.selection.active && active != rows.end()) {
    const float y = row * static_cast<float>(active - rows.begin());
    if (y < ImGui::GetScrollY() || y + row > ImGui::GetScrollY() + ImGui::GetWindowHeight())
      ImGui::SetScrollY(y - ImGui::GetWindowHeight() / 2);
  }
  state.shown_active = editor.selection.active;
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
      m.px(heading + row * static_cast<float>(row_count(document)) + (many(document) ? search : 0));
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
    // Another document has other groups under the same ids.
    if (std::exchange(state.documents, editor.documents) != editor.documents) state.folded.clear();
    if (editor.rename_wanted) start_wanted_renaming(context, document);
    if (state.shown_active != editor.selection.active) unfold_round(document, state, editor.selection.active);
    const std::vector<OutlinerRow> rows = rows_of(document, state);
    state.shown.clear();
    for (const OutlinerRow& row : rows)
      if (const ObjectId* object = std::get_if<ObjectId>(&row.member)) state.shown.push_back(*object);
    if (document.objects.empty())
      hint_text(context, "Nothing here yet. Add a shape, or drop a mesh on the window.");
    else if (rows.empty())
      hint_text(context, "Nothing is called like that.");
    ImGui::BeginChild("rows", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(m.px(4), m.px(2)));
    const float row = m.px(28);
    bring_into_sight(editor, state, rows, row);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), row);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const OutlinerRow& one = rows[static_cast<std::size_t>(i)];
        if (std::holds_alternative<GroupId>(one.member))
          draw_group_row(context, document, one);
        else
          object_row(context, document, one);
      }
    if (!document.groups->empty()) drop_below_rows(context, document);
    arrow_keys(context);
    ImGui::PopStyleVar();
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace hariko
