#include "ui/shell/outliner_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "core/document/edits/edit_groups.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/overlay_window.hpp"

namespace hariko {

namespace {

constexpr const char* row_payload = "rows";

ImU32 packed_colour(const Colour& colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, 255);
}

/// Place that the pointer means, `share` of the row's height below its upper end.
MemberPlace place_of_drop(const GroupTree& tree, const OutlinerState& state, const Member& member,
                          float share) {
  if (const GroupId* own = std::get_if<GroupId>(&member)) {
    if (share > 0.25F && share < 0.75F) return {*own, {}};
    if (share >= 0.75F && !state.folded.contains(*own)) return {*own, tree.members(*own).front()};
  }
  const GroupId group = tree.group_of(member);
  if (share < 0.5F) return {group, member};
  const std::span<const Member> siblings = tree.members(group);
  const auto next = std::find(siblings.begin(), siblings.end(), member) + 1;
  return {group, next == siblings.end() ? std::nullopt : std::optional(*next)};
}

/// Takes up the dragged rows where they are let go.
void accept_rows(PanelContext& context, const GroupTree& tree, const MemberPlace& place) {
  Editor& editor = context.editor;
  if (!ImGui::AcceptDragDropPayload(row_payload, ImGuiDragDropFlags_AcceptNoDrawDefaultRect)) return;
  const auto moved = tree.members_of(chosen_ids(editor), context.state.outliner.dragged);
  const bool stays =
      std::ranges::all_of(moved, [&](const Member& member) { return tree.group_of(member) == place.group; });
  editor.commit(move_members(editor.history.current(), moved, place), stays ? "Reorder objects"
                                                                      : place.group == GroupId{}
                                                                          ? "Move out of a group"
                                                                          : "Move into a group");
}

/// A line where rows would go, or a frame round the group that they would go into.
void show_drop(const PanelContext& context, ImVec2 low, ImVec2 high, const MemberPlace& place,
               const Member& member, float share) {
  ImDrawList& draw = *ImGui::GetForegroundDrawList();
  const float width = context.metrics.px(2);
  const ImU32 colour = palette().secondary;
  if (member == Member(place.group) && !place.before) return draw.AddRect(low, high, colour, 0, 0, width);
  const float y = share < 0.5F ? low.y : high.y;
  draw.AddLine({low.x, y}, {high.x, y}, colour, width);
}

struct NamedColour {
  const char* name;
  Colour colour;
};
constexpr std::array mark_colours{NamedColour{translatable("Red"), {0xe5, 0x48, 0x4d}},
                                  NamedColour{translatable("Orange"), {0xf7, 0x6b, 0x15}},
                                  NamedColour{translatable("Yellow"), {0xff, 0xc5, 0x3d}},
                                  NamedColour{translatable("Green"), {0x46, 0xa7, 0x58}},
                                  NamedColour{translatable("Blue"), {0x3e, 0x82, 0xf7}},
                                  NamedColour{translatable("Violet"), {0x8e, 0x4e, 0xc6}},
                                  NamedColour{translatable("Grey"), {0x8b, 0x8d, 0x98}}};

void colour_menu(PanelContext& context, const Group& group) {
  const OpenScope menu = menu_scope(context.marks, "outliner.group.colour", context.tr("Colour"));
  if (!menu) return;
  const auto set = [&](std::optional<Colour> colour) {
    context.editor.commit(set_group_colour(context.editor.history.current(), group.id, colour),
                          "Colour of the group");
  };
  if (menu_row(context.marks, "outliner.group.colour.none", context.tr("No colour"), !group.colour))
    set(std::nullopt);
  for (std::size_t i = 0; i < mark_colours.size(); ++i) {
    const NamedColour& one = mark_colours[i];
    if (menu_row(context.marks, "outliner.group.colour." + std::to_string(i), context.tr(one.name),
                 group.colour == one.colour))
      set(one.colour);
  }
}

void group_menu(PanelContext& context, const Group& group) {
  const OpenScope menu = item_menu_scope();
  if (!menu) return;
  Editor& editor = context.editor;
  if (editor.chosen_group.chosen(editor) != group.id) editor.chosen_group.choose(editor, group.id);
  if (menu_row(context.marks, "outliner.group.rename", context.tr("Rename group")))
    rename_in_row(context.state.outliner, group);
  draw_menu_items(context, {"group.make", "group.dissolve", "object.delete", ""}, "outliner.");
  colour_menu(context, group);
}

void group_name_field(PanelContext& context, const Group& group, float width) {
  OutlinerState& state = context.state.outliner;
  if (!row_name_field(context, width)) return;
  state.renaming_group = {};
  if (state.name != group.name)
    context.editor.commit(rename_group(context.editor.history.current(), group.id, state.name),
                          "Rename group");
}

/// Lock and eye at the right end of the row.
void group_switches(PanelContext& context, const Group& group, bool hovered, float right) {
  Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  const std::string number = std::to_string(group.id.value);
  if (group.locked || hovered || (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0) {
    ImGui::SameLine(right - m.px(52));
    if (icon_button(context, group.locked ? icon::locked : icon::unlocked, "group.lock." + number,
                    group.locked ? "Unlock" : "Lock", false, 24))
      editor.commit(set_group_locked(editor.history.current(), group.id, !group.locked),
                    group.locked ? "Unlock group" : "Lock group");
  }
  ImGui::SameLine(right - m.px(26));
  if (icon_button(context, group.visible ? icon::shown : icon::hidden, "group.eye." + number,
                  group.visible ? "Hide" : "Show", false, 24))
    editor.commit(set_group_visible(editor.history.current(), group.id, !group.visible),
                  group.visible ? "Hide group" : "Show group");
}

}  // namespace

bool row_name_field(PanelContext& context, float width) {
  OutlinerState& state = context.state.outliner;
  if (state.focus_name) focus_next_field();
  text_field(context.marks, "outliner.name", state.name, width, "", ImGuiInputTextFlags_AutoSelectAll);
  const bool ended = ImGui::IsItemDeactivated();
  // The keyboard comes a frame or two after it was asked for.
  if (ImGui::IsItemActive()) state.focus_name = false;
  if (state.focus_name) context.state.field_opening = true;
  return ended;
}

const OutlinerTree& outliner_tree(const Document& document, OutlinerState& state) {
  OutlinerTree& known = state.tree;
  if (known.tree && known.objects == document.objects && known.groups == document.groups) return known;
  known = {document.objects, document.groups, std::make_shared<const GroupTree>(document), {}};
  for (std::size_t i = 0; i < document.objects.size(); ++i) known.places[document.objects[i]->id] = i;
  return known;
}

std::vector<OutlinerRow> rows_by_groups(const Document& document, OutlinerState& state) {
  const OutlinerTree& known = outliner_tree(document, state);
  std::vector<OutlinerRow> rows;
  const auto walk = [&](const auto& self, GroupId group, int depth) -> void {
    for (const Member& member : known.tree->members(group)) {
      if (const ObjectId* object = std::get_if<ObjectId>(&member)) {
        rows.push_back({member, known.places.at(*object), depth});
        continue;
      }
      rows.push_back({member, 0, depth});
      const GroupId inner = std::get<GroupId>(member);
      if (!state.folded.contains(inner)) self(self, inner, depth + 1);
    }
  };
  walk(walk, GroupId{}, 0);
  return rows;
}

void unfold_round(const Document& document, OutlinerState& state, ObjectId object) {
  const Object* found = document.find(object);
  for (const Group* group = found ? find_group(*document.groups, found->group) : nullptr; group;
       group = find_group(*document.groups, group->parent))
    state.folded.erase(group->id);
}

float row_indent(const Metrics& metrics, int depth) {
  return metrics.px(14.0F * static_cast<float>(depth));
}

void draw_group_mark(const PanelContext& context, const Document& document, GroupId id) {
  const Group* group = find_group(*document.groups, id);
  while (group && !group->colour) group = find_group(*document.groups, group->parent);
  if (!group) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + context.metrics.px(3), high.y},
                                            packed_colour(*group->colour));
}

void drag_row(PanelContext& context, const Document& document, const Member& member,
              const std::string& name) {
  OutlinerState& state = context.state.outliner;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  if (ImGui::BeginDragDropSource()) {
    state.dragged = member;
    ImGui::SetDragDropPayload(row_payload, nullptr, 0);
    plain_text(name);
    ImGui::EndDragDropSource();
  }
  if (!ImGui::BeginDragDropTarget()) return;
  const GroupTree& tree = *outliner_tree(document, state).tree;
  const float share = (ImGui::GetMousePos().y - low.y) / (high.y - low.y);
  const MemberPlace place = place_of_drop(tree, state, member, share);
  const GroupId* group = state.dragged ? std::get_if<GroupId>(&*state.dragged) : nullptr;
  // A group cannot be dropped in itself, so that no place is shown there.
  if (!group || !tree.is_within(place.group, *group)) {
    show_drop(context, low, high, place, member, share);
    accept_rows(context, tree, place);
  }
  ImGui::EndDragDropTarget();
}

void drop_below_rows(PanelContext& context, const Document& document) {
  const ImGuiPayload* payload = ImGui::GetDragDropPayload();
  if (!payload || !payload->IsDataType(row_payload)) return;
  const float room = std::max(ImGui::GetContentRegionAvail().y, context.metrics.px(10));
  pointer_button(context.marks, "outliner.below", {ImGui::GetContentRegionAvail().x, room});
  if (!ImGui::BeginDragDropTarget()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::GetForegroundDrawList()->AddLine(low, {high.x, low.y}, palette().secondary, context.metrics.px(2));
  accept_rows(context, *outliner_tree(document, context.state.outliner).tree, {});
  ImGui::EndDragDropTarget();
}

void rename_in_row(OutlinerState& state, const Group& group) {
  state.renaming_group = group.id;
  state.name = group.name;
  state.focus_name = true;
}

void draw_group_row(PanelContext& context, const Document& document, const OutlinerRow& row) {
  Editor& editor = context.editor;
  OutlinerState& state = context.state.outliner;
  const Metrics& m = context.metrics;
  const Group& group = *find_group(*document.groups, std::get<GroupId>(row.member));
  const std::string number = std::to_string(group.id.value);
  ImGui::PushID(("group " + number).c_str());
  const float left = ImGui::GetCursorPosX(), right = left + ImGui::GetContentRegionAvail().x;
  const float begin = left + row_indent(m, row.depth);
  const bool chosen = editor.chosen_group.chosen(editor) == group.id;
  if (selectable_row(context.marks, "group." + number, "", chosen, {0, m.px(26)},
                     ImGuiSelectableFlags_AllowItemOverlap | ImGuiSelectableFlags_AllowDoubleClick)) {
    editor.chosen_group.choose(editor, group.id);
    // The group stays folded although an object in it is the active one now.
    state.shown_active = editor.selection.active;
    if (ImGui::IsMouseDoubleClicked(0)) rename_in_row(state, group);
  }
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  ImGui::SetItemAllowOverlap();
  draw_group_mark(context, document, group.id);
  drag_row(context, document, group.id, group.name);
  if (state.dragged == Member(group.id) && !chosen && ImGui::IsItemActive() && ImGui::GetDragDropPayload()) {
    editor.chosen_group.choose(editor, group.id);
    state.shown_active = editor.selection.active;
  }
  group_menu(context, group);
  const bool folded = state.folded.contains(group.id);
  ImGui::SameLine(begin);
  if (icon_button(context, folded ? icon::current : icon::unfolded, "group.fold." + number,
                  folded ? "Open group" : "Fold group", false, 20)) {
    if (!state.folded.erase(group.id)) state.folded.insert(group.id);
  }
  ImGui::SameLine(begin + m.px(24));
  ImGui::AlignTextToFramePadding();
  const TextColour colour(is_visible(document, group.id) ? palette().text : palette().dim_text);
  plain_text(icon::folder);
  ImGui::SameLine(begin + m.px(46));
  const float width = right - m.px(84) - ImGui::GetCursorPosX();
  if (state.renaming_group == group.id)
    group_name_field(context, group, width);
  else
    plain_text(elided(group.name, width));
  group_switches(context, group, hovered, right);
  ImGui::PopID();
}

}  // namespace hariko
