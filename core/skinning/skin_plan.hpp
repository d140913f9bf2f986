#pragma once

// A skin that has been checked: its frames, and for every strip the lines that join the points of its
// sections.

#include <vector>

#include "core/skinning/correspondence.hpp"
#include "core/skinning/section_starts.hpp"
#include "core/skinning/skin.hpp"
#include "core/skinning/skin_frames.hpp"

namespace hariko {

struct PlannedMerge {
  StripSide side = StripSide::a;
  std::vector<int> members;  ///< ascending, or around the seam in order
  int target = 0;
  double v = 0.5;
};

/// Where a line comes from.
enum class LineOrigin : std::uint8_t { matched, link, merge };

/// Between sections a and b, which is 0 after the last on a closed path; v1 is then above 1.
struct PlannedStrip {
  int a = 0, b = 0;
  double v0 = 0, v1 = 1;
  /// Closed sections: the parameter of b that belongs to parameter 0 of a.
  StartMatch match;
  bool start_found = false;  ///< not chosen by the designer
  /// Rest of `match.start` that lines from point to point leave over, since it lies between the points: while
  /// it runs from a to b, a line goes back by so much along the sections. 0 where lines go straight.
  double twist = 0;
  std::vector<PointPair> lines;
  std::vector<LineOrigin> origins;  ///< one a line
  std::vector<PlannedMerge> merges;
};

struct SkinPlan {
  SkinFrames frames;
  bool closed_sections = false;
  std::vector<PlannedStrip> strips;
  /// F(v_k)^-1 (P_i - C(v_k)) of every point.
  std::vector<std::vector<Vector3>> offsets;
  /// Parameters of the sections that belong together, that of the first being 0 (all 0 for open sections).
  std::vector<double> starts;
  /// Section k through its offsets.
  SubdivisionCurve offset_curve(const Skin& skin, int k) const;
};

/// Checks in the order of skin_messages.hpp; the first error is given. For method `pleat` and `anchored`
/// links count; merges for `pleat` only. Errors: E_FEW_SECTIONS, E_PATH_SHORT, E_SECTION_ORDER,
/// E_SECTION_RANGE, E_NOT_FINITE, E_FEW_POINTS, E_POINT_SECTION, E_OPEN_CLOSED, E_INDEX, E_LINK_CROSS,
/// E_MERGE_V, E_MERGE_SMALL, E_MERGE_GAP, E_MERGE_OVERLAP, E_MERGE_ALL, E_PATH_CUSP, E_RAIL, E_SKIN_SIZE.
Result<SkinPlan> plan_skin(const Skin& skin);

/// The pairs that a link makes lines of: all where a side has one point, else the two outer ones. Nothing
/// when a point is gone.
std::vector<PointPair> forced_pairs(const Skin& skin, const SkinLink& link);
std::vector<PointPair> forced_pairs(const Skin& skin, const SkinMerge& merge);

}  // namespace hariko
