#pragma once

// Rows of the lines of one strip: the vertices that lines share, and the offset of each vertex.

#include <vector>

#include "core/skinning/columns/skin_plan.hpp"

namespace hariko {

/// Run of neighbouring lines that share one vertex per row, from the first section up to a row, or from a row
/// on to the second section.
struct LineGroup {
  std::vector<int> lines;
  int row = 0;                       ///< row where the lines meet
  StripSide tip = StripSide::a;      ///< the section at which all lines are one point
  Vector3 offset = Vector3::Zero();  ///< offset of the point where the lines meet
};

/// Whether the surface continues on both sides of a section: it is not an end, or has a dome.
bool inside_surface(const Skin& skin, const SkinPlan& plan, int section);

/// Rows of a strip and the groups of its lines.
struct StripRows {
  std::vector<double> v;                    ///< places of the rows on the path, ends included
  std::vector<LineGroup> groups;            ///< merges first, in the strip's order, then groups of collars
  std::vector<int> start_group, end_group;  ///< groups of each line, -1 for none

  int last() const { return int(v.size()) - 1; }
  /// Group whose vertex line p uses on row q; -1 when the line has its own vertex.
  int shared(int p, int q) const;
};

/// Makes the rows by options.rows and density; with collars, interior sections get additional rows and groups
/// beside them.
StripRows strip_rows(const Skin& skin, const SkinPlan& plan, int strip);

/// Offset of line p on row q, 0 < q < last, for straight lines.
Vector3 line_offset(const SkinPlan& plan, const PlannedStrip& strip, const StripRows& rows, int p, int q);

/// Displacement of a twisted line from a straight one.
struct LineBow {
  std::vector<Vector3> rows;  ///< on each row, relative to the straight line between its points
  /// Displacement on the first and the last interior row, relative to the straight line from the line's point
  /// there to its counterpart on the other section.
  Vector3 first = Vector3::Zero(), last = Vector3::Zero();
};

/// Displacements of each line onto the blend of the two sections, solved so that the limit points lie there.
/// Empty where lines are straight. O(lines x rows).
std::vector<LineBow> line_bows(const SkinPlan& plan, const PlannedStrip& strip, const StripRows& rows);

}  // namespace hariko
