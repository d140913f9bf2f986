#pragma once

// SkinPlan: a checked skin with its frames, and for every strip the lines that join the points of its
// sections.

#include <vector>

#include "core/skinning/columns/correspondence.hpp"
#include "core/skinning/sections/section_starts.hpp"
#include "core/skinning/sections/skin_frames.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Merge of a strip by point indices.
struct PlannedMerge {
  StripSide side = StripSide::a;
  std::vector<int> members;  ///< ascending, or in order across the seam
  int target = 0;
  double v = 0.5;
};

/// Origin of a line.
enum class LineOrigin : std::uint8_t { matched, link, merge };

/// Strip between sections a and b; after the last section of a closed path b is 0 and v1 is above 1.
struct PlannedStrip {
  int a = 0, b = 0;
  double v0 = 0, v1 = 1;
  /// Closed sections: the parameter of b that corresponds to parameter 0 of a.
  StartMatch match;
  bool start_found = false;  ///< found automatically, not chosen by the designer
  /// Part of `match.start` that lines from point to point cannot represent, because it lies between points:
  /// from a to b a line moves back by this parameter along the sections. 0 where lines are straight.
  double twist = 0;
  std::vector<PointPair> lines;
  std::vector<LineOrigin> origins;  ///< one per line
  std::vector<PlannedMerge> merges;
};

/// Frames, strips and offsets of a valid skin.
struct SkinPlan {
  SkinFrames frames;
  bool closed_sections = false;
  std::vector<PlannedStrip> strips;
  /// Offset F(v_k)^-1 (P_i - C(v_k)) of every point.
  std::vector<std::vector<Vector3>> offsets;
  /// Corresponding start parameters of the sections, that of the first being 0 (all 0 for open sections).
  std::vector<double> starts;
  /// Curve of section k through its offsets.
  SubdivisionCurve offset_curve(const Skin& skin, int k) const;
};

/// Checks a skin in the order of skin_messages.hpp, returning the first error, and plans its strips. Links
/// are used by methods `pleat` and `anchored`; merges by `pleat` only. Errors: E_FEW_SECTIONS, E_PATH_SHORT,
/// E_SECTION_ORDER, E_SECTION_RANGE, E_NOT_FINITE, E_FEW_POINTS, E_POINT_SECTION, E_OPEN_CLOSED, E_INDEX,
/// E_LINK_CROSS, E_MERGE_V, E_MERGE_SMALL, E_MERGE_GAP, E_MERGE_OVERLAP, E_MERGE_ALL, E_PATH_CUSP, E_RAIL,
/// E_SKIN_SIZE.
Result<SkinPlan> plan_skin(const Skin& skin);

/// Pairs of points that a link or merge forces to be lines: all where a side has one point, else the two
/// outer ones. Empty when a point no longer exists.
std::vector<PointPair> forced_pairs(const Skin& skin, const SkinLink& link);
std::vector<PointPair> forced_pairs(const Skin& skin, const SkinMerge& merge);

}  // namespace hariko
