#pragma once

// Rows of the list of objects: the tree of groups as rows, the row of a group, dragging rows.

#include <vector>

#include "core/document/group_tree.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

struct OutlinerRow {
  Member member;
  std::size_t index = 0;  ///< place of an object in the document
  int depth = 0;          ///< groups that it lies in
};

/// Tree of the document, made anew where its objects or groups are others than before.
const OutlinerTree& outliner_tree(const Document& document, OutlinerState& state);

/// All rows of a document with groups, without those in folded groups.
std::vector<OutlinerRow> rows_by_groups(const Document& document, OutlinerState& state);

/// Unfolds the groups round an object.
void unfold_round(const Document& document, OutlinerState& state, ObjectId object);

/// Distance of the contents of a row from its left end.
float row_indent(const Metrics& metrics, int depth);

/// The mark at the left end of a row in the colour of its group, or of the next group round it that has one.
void draw_group_mark(const PanelContext& context, const Document& document, GroupId group);

/// Lets the item drawn last, which is the row of a member, be dragged and dropped at.
void drag_row(PanelContext& context, const Document& document, const Member& member, const std::string& name);
/// The place below all rows, where what is dropped leaves its group. Shows while rows are dragged.
void drop_below_rows(PanelContext& context, const Document& document);

/// Field for the name in `OutlinerState`; true in the frame in which it ends.
bool row_name_field(PanelContext& context, float width);
void draw_group_row(PanelContext& context, const Document& document, const OutlinerRow& row);
/// Makes the name of a group a field.
void rename_in_row(OutlinerState& state, const Group& group);

}  // namespace hariko
