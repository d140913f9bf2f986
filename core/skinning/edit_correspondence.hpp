#pragma once

// What a designer does to correspondences, as pure functions skin -> skin. A new one beats those it would
// cross; which ones gave way is told. Points that move never change what corresponds.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

inline constexpr Code e_not_neighbours{"E_NOT_NEIGHBOURS"};
inline constexpr Code e_correspondence_locked{"E_CORRESPONDENCE_LOCKED"};
inline constexpr Code e_no_correspondence{"E_NO_CORRESPONDENCE"};

struct CorrespondenceEdit {
  Skin skin;
  std::vector<std::uint32_t> added;    ///< ids of new links and merges
  std::vector<std::uint32_t> removed;  ///< ids of those that gave way
};

/// A straight line over one or more sections: points in the order in which it crosses them, each on a
/// neighbour of the one before. One link a strip. Errors: E_NOT_NEIGHBOURS, E_INDEX, E_CORRESPONDENCE_LOCKED
/// (it would cross a locked one).
Result<CorrespondenceEdit> join_points(const Skin& skin, std::span<const std::uint32_t> points);

/// A closed curve round points of two or more neighbouring sections, in a row on each: one link a strip
/// between them. Errors: as above, E_MERGE_GAP where points of a section are not neighbours.
Result<CorrespondenceEdit> group_points(const Skin& skin, std::span<const std::uint32_t> points);

/// A wedge round points of one section with its tip at `v` (0 at the strip's first section .. 1) of the strip
/// towards the section of `target`. At or beyond the other section (`v` 0 or 1 there, or further) the points
/// are joined with the target there. Errors: as above, E_MERGE_*.
Result<CorrespondenceEdit> merge_points(const Skin& skin, std::span<const std::uint32_t> members,
                                        std::uint32_t target, double v);

/// Another end for a link: `from`, one of its points, becomes `to`, of the same section. Errors: as above.
Result<CorrespondenceEdit> move_link_end(const Skin& skin, std::uint32_t link, std::uint32_t from,
                                         std::uint32_t to);

/// The diamond of a merge dragged along its line (`v`) and sideways (`target`). Errors: as above.
Result<CorrespondenceEdit> move_merge(const Skin& skin, std::uint32_t merge, double v, std::uint32_t target);

/// The end of any line dragged to another point of its section: `from` and `other` are the points that it
/// joins, `to` is the new one in the place of `from`. What the line belongs to changes: of a link that end;
/// of a merge its target, or, for an outer member, how far the group reaches. A line that was matched by
/// default becomes a link. Errors: as above; E_MERGE_SMALL.
Result<CorrespondenceEdit> move_line_end(const Skin& skin, std::uint32_t from, std::uint32_t other,
                                         std::uint32_t to);

/// Keeps the line between two points as it is now: it becomes a locked link, or the link or merge that it
/// belongs to is locked. Errors: E_NOT_NEIGHBOURS, E_NO_CORRESPONDENCE (there is no such line).
Result<CorrespondenceEdit> lock_line(const Skin& skin, std::uint32_t a, std::uint32_t b);
/// Locks or unlocks a link or merge. E_NO_CORRESPONDENCE when there is none.
Result<CorrespondenceEdit> set_locked(const Skin& skin, std::uint32_t id, bool locked);

/// E_NO_CORRESPONDENCE when there is none.
Result<CorrespondenceEdit> delete_correspondence(const Skin& skin, std::uint32_t id);
/// Deletes all between two neighbouring sections, locked ones too.
CorrespondenceEdit reset_strip(const Skin& skin, std::uint32_t first, std::uint32_t second);

}  // namespace hariko
