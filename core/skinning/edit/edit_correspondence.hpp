#pragma once

// Edits of correspondences, as pure functions skin -> skin. A new link or merge replaces those it would
// cross, and the result lists the replaced ones. Moving points never changes correspondences.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

inline constexpr Code e_not_neighbours{"E_NOT_NEIGHBOURS"};
inline constexpr Code e_correspondence_locked{"E_CORRESPONDENCE_LOCKED"};
inline constexpr Code e_no_correspondence{"E_NO_CORRESPONDENCE"};

/// Edited skin with the ids of changed links and merges.
struct CorrespondenceEdit {
  Skin skin;
  std::vector<std::uint32_t> added;    ///< ids of new links and merges
  std::vector<std::uint32_t> removed;  ///< ids of links and merges that were replaced
};

/// Joins points by a straight stroke over one or more sections: points in the order in which it crosses them,
/// each on a neighbour of the section before. Makes one link per strip. Errors: E_NOT_NEIGHBOURS, E_INDEX,
/// E_CORRESPONDENCE_LOCKED (it would cross a locked one).
Result<CorrespondenceEdit> join_points(const Skin& skin, std::span<const std::uint32_t> points);

/// Joins groups of points by a lasso round points of two or more neighbouring sections, consecutive on each:
/// makes one link per strip between them. Errors: as for `join_points`, and E_MERGE_GAP where points of a
/// section are not neighbours.
Result<CorrespondenceEdit> group_points(const Skin& skin, std::span<const std::uint32_t> points);

/// Merges points of one section into one line that runs on to `target`, as drawn by a wedge with its tip at
/// `v` (0 at the strip's first section .. 1) of the strip towards the section of `target`. Where the tip lies
/// at or beyond the other section (`v` 0 or 1 there, or further) the points are linked with the target
/// instead. Errors: as for `join_points`, and E_MERGE_*.
Result<CorrespondenceEdit> merge_points(const Skin& skin, std::span<const std::uint32_t> members,
                                        std::uint32_t target, double v);

/// Replaces an end of a link: its point `from` becomes `to` of the same section. Errors: as for
/// `join_points`.
Result<CorrespondenceEdit> move_link_end(const Skin& skin, std::uint32_t link, std::uint32_t from,
                                         std::uint32_t to);

/// Moves the point where a merge's lines meet, along its line (`v`) and to another target. Errors: as for
/// `merge_points`.
Result<CorrespondenceEdit> move_merge(const Skin& skin, std::uint32_t merge, double v, std::uint32_t target);

/// Moves the end of any line to another point of its section: `from` and `other` are the points that it
/// joins, `to` replaces `from`. Changes the link or merge that the line belongs to: that end of a link; the
/// target of a merge, or, for an outer member, the extent of the group. A line that was matched automatically
/// becomes a link. Errors: as for `merge_points`.
Result<CorrespondenceEdit> move_line_end(const Skin& skin, std::uint32_t from, std::uint32_t other,
                                         std::uint32_t to);

/// Locks the line between two points as it is now: it becomes a locked link, or the link or merge that it
/// belongs to is locked. Errors: E_NOT_NEIGHBOURS, E_NO_CORRESPONDENCE (there is no such line).
Result<CorrespondenceEdit> lock_line(const Skin& skin, std::uint32_t a, std::uint32_t b);
/// Locks or unlocks a link or merge. Error: E_NO_CORRESPONDENCE when there is none.
Result<CorrespondenceEdit> set_locked(const Skin& skin, std::uint32_t id, bool locked);

/// Deletes a link or merge. Error: E_NO_CORRESPONDENCE when there is none.
Result<CorrespondenceEdit> delete_correspondence(const Skin& skin, std::uint32_t id);
/// Deletes all links and merges between two neighbouring sections, including locked ones.
CorrespondenceEdit reset_strip(const Skin& skin, std::uint32_t first, std::uint32_t second);

}  // namespace hariko
