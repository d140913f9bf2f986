#pragma once

// What an edit of sections or of the path gives: the next skin, and what the designer should know about it.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Links and merges went because an edit took their points, or because they would have crossed.
inline constexpr Code w_correspondence_lost{"W_CORRESPONDENCE_LOST"};

struct SkinEdit {
  Skin skin;
  /// Largest distance between the edited curve and what it was, where its shape was to be kept and uniform
  /// curves cannot keep it exactly.
  double deviation = 0;
  std::vector<std::uint32_t> points;  ///< ids of new points
  std::vector<std::uint32_t> lost;    ///< ids of links and merges that went
  std::vector<Message> notes;         ///< W_CORRESPONDENCE_LOST
};

}  // namespace hariko

namespace hariko::detail {

/// Takes points out of all links and merges; those without enough points left go, and are added to `lost`.
void forget_points(Skin& skin, const std::vector<std::uint32_t>& points, std::vector<std::uint32_t>& lost);
/// The same for links and merges of a section.
void forget_section(Skin& skin, std::uint32_t section, std::vector<std::uint32_t>& lost);

/// Changes the parameters that anchors have on one section.
void map_anchors(Skin& skin, int section, const std::function<double(double)>& map);

/// The last step of an edit: links and merges that cross now go, those drawn first before later ones and
/// locked ones last; notes are written. An edit that breaks a skin that was sound is refused with the reason
/// (one of `plan_skin`); a broken skin may be edited, so that it can be mended.
Result<SkinEdit> accepted(const Skin& before, SkinEdit edit);

/// Index of the section that has a point; -1 when none has.
int section_with(const Skin& skin, std::uint32_t point);
/// E_INDEX.
Message no_such_section();
Message no_such_point();

}  // namespace hariko::detail
