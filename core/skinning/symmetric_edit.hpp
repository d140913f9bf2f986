#pragma once

// Edits of sections that keep both halves each other's mirror image.

#include <cstdint>
#include <span>

#include "core/skinning/edit_section.hpp"

namespace hariko {

/// The skin's own, else across an axis through the middle of the path: of the three planes that about which
/// sections and path are most nearly symmetric. O(points of the skin).
MirrorPlane mirror_plane(const Skin& skin);

/// `move_section_points` with the partners of the points going to their images. A point without a partner
/// stays in the plane; of two partners that both move the first one decides.
Result<SkinEdit> move_section_points(const Skin& skin, std::span<const MovedPoint> points,
                                     const MirrorPlane& plane);

/// `move_limit_point` of a point and of its partner.
Result<SkinEdit> move_limit_point(const Skin& skin, std::uint32_t point, const Vector3& position,
                                  const MirrorPlane& plane);

/// Sections, all when none are named, become their own images: see the other `make_symmetric`.
Result<SkinEdit> make_symmetric(const Skin& skin, std::span<const std::uint32_t> sections,
                                const MirrorPlane& plane);

}  // namespace hariko
