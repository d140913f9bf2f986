#pragma once

// SkinEdit: the result of an edit of sections or of the path: the new skin, and notes for the designer.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Warning: links and merges were removed because an edit took their points, or because they would have
/// crossed.
inline constexpr Code w_correspondence_lost{"W_CORRESPONDENCE_LOST"};

/// Edited skin with its deviation and notes.
struct SkinEdit {
  Skin skin;
  /// Largest distance between the edited curve and the old one, where its shape should stay and uniform
  /// curves cannot keep it exactly.
  double deviation = 0;
  std::vector<std::uint32_t> points;  ///< ids of new points
  std::vector<std::uint32_t> lost;    ///< ids of links and merges that were removed
  std::vector<Message> notes;         ///< W_CORRESPONDENCE_LOST
};

}  // namespace hariko

namespace hariko::detail {

/// Removes points from all links and merges; those without enough points left are removed and added to
/// `lost`.
void forget_points(Skin& skin, const std::vector<std::uint32_t>& points, std::vector<std::uint32_t>& lost);
/// Removes the links and merges of a section.
void forget_section(Skin& skin, std::uint32_t section, std::vector<std::uint32_t>& lost);

/// Maps the parameters of all anchors on one section.
void map_anchors(Skin& skin, int section, const std::function<double(double)>& map);

/// Maps a parameter of a subdivision curve after the insertion of a control point in the middle of a span.
/// `spans` is the number before. On closed curves whole turns are kept.
double inserted_parameter(double u, int spans, int span, bool closed);
/// Maps a parameter after the deletion of a control point: the two spans that met at it become one, later
/// ones are renumbered. `spans` is the number before, at least 2. On closed curves whole turns are kept;
/// where the first point is deleted, the seam moves to the next.
double deleted_parameter(double u, int spans, int point, bool closed);

/// Finishes an edit: removes links and merges that cross now, oldest first and locked ones last, and writes
/// notes. An edit that breaks a valid skin is refused with the reason (an error of `plan_skin`); an invalid
/// skin may be edited, so that it can be repaired.
Result<SkinEdit> accepted(const Skin& before, SkinEdit edit);

/// Index of the section that has a point; -1 when none has.
int section_with(const Skin& skin, std::uint32_t point);
/// Error E_INDEX for a section or point that does not exist.
Message no_such_section();
Message no_such_point();

}  // namespace hariko::detail
