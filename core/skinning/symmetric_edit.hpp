#pragma once

// Edits of sections that keep both halves each other's mirror image.

#include <cstdint>
#include <span>
#include <vector>

#include "core/skinning/edit_section.hpp"

namespace hariko {

/// Across an axis (0 .. 2), through the middle of the path's points.
MirrorPlane mirror_plane(const Skin& skin, int axis);

/// The skin's own, else of the three planes through the middle of the path that about which sections and path
/// are most nearly symmetric. O(points of the skin).
MirrorPlane mirror_plane(const Skin& skin);

/// `move_section_points` with the partners of the points going to their images. A point without a partner
/// stays in the plane; of two partners that both move the first one decides.
Result<SkinEdit> move_section_points(const Skin& skin, std::span<const MovedPoint> points,
                                     const MirrorPlane& plane);

/// `move_limit_point` of a point and of its partner.
Result<SkinEdit> move_limit_point(const Skin& skin, std::uint32_t point, const Vector3& position,
                                  const MirrorPlane& plane);

/// One more point in the middle of a span and one in that of its image, both taken from the curve as it was.
Result<SkinEdit> insert_section_point(const Skin& skin, std::uint32_t section, int span,
                                      const MirrorPlane& plane);

/// The points with their partners, each once, in the order of the sections: what a symmetric edit deletes or
/// makes corners. Ids that do not exist stay.
std::vector<std::uint32_t> with_partners(const Skin& skin, std::span<const std::uint32_t> points,
                                         const MirrorPlane& plane);

/// Sections, all when none are named, become their own images: see the other `make_symmetric`.
Result<SkinEdit> make_symmetric(const Skin& skin, std::span<const std::uint32_t> sections,
                                const MirrorPlane& plane);

}  // namespace hariko
