#pragma once

// The lines of one strip with all their rows: where lines share vertices, and the offset of each vertex.

#include <vector>

#include "core/skinning/skin_plan.hpp"

namespace hariko {

/// A run of neighbouring lines that share one vertex a row, up to a row from the first section, or from a row
/// on to the second.
struct LineGroup {
  std::vector<int> lines;
  int row = 0;                       ///< where they meet
  StripSide tip = StripSide::a;      ///< the section at which all are one point
  Vector3 offset = Vector3::Zero();  ///< of the point where they meet
};

/// The surface goes on on both sides of a section: it is not an end, or a dome is on it.
bool inside_surface(const Skin& skin, const SkinPlan& plan, int section);

struct StripRows {
  std::vector<double> v;                    ///< of the rows, ends included
  std::vector<LineGroup> groups;            ///< merges first, in the strip's order, then those of collars
  std::vector<int> start_group, end_group;  ///< of each line, -1 for none

  int last() const { return int(v.size()) - 1; }
  /// Group whose vertex line p uses on row q; -1 when it has its own.
  int shared(int p, int q) const;
};

/// Rows by options.rows and density; with collars interior sections get private rows and groups beside them.
StripRows strip_rows(const Skin& skin, const SkinPlan& plan, int strip);

/// Offset of line p on row q, 0 < q < last, where lines run straight.
Vector3 line_offset(const SkinPlan& plan, const PlannedStrip& strip, const StripRows& rows, int p, int q);

/// Addition of a line that twists to its offsets.
struct LineBow {
  std::vector<Vector3> rows;  ///< on each row, beside the straight line between its points
  /// On the first and the last row inside, beside the straight line from the line's point there to what
  /// belongs to that point on the other section.
  Vector3 first = Vector3::Zero(), last = Vector3::Zero();
};

/// Each line's places on the blend of the two sections, solved so that limits lie there. Empty where
/// lines run straight. O(lines x rows).
std::vector<LineBow> line_bows(const SkinPlan& plan, const PlannedStrip& strip, const StripRows& rows);

}  // namespace hariko
