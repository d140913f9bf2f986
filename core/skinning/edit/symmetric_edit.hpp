#pragma once

// Symmetric edits of sections, which keep the two halves mirror images of each other.

#include <cstdint>
#include <span>
#include <vector>

#include "core/skinning/edit/edit_section.hpp"

namespace hariko {

/// Mirror plane perpendicular to an axis (0 .. 2), through the mean of the path's points.
MirrorPlane mirror_plane(const Skin& skin, int axis);

/// Mirror plane of the skin: its own, else of the three planes through the mean of the path the one about
/// which sections and path are most nearly symmetric. O(points of the skin).
MirrorPlane mirror_plane(const Skin& skin);

/// Moves points and their mirror partners (see `move_section_points`). A point without a partner stays in the
/// plane; of two partners that both move the first one determines both.
Result<SkinEdit> move_section_points(const Skin& skin, std::span<const MovedPoint> points,
                                     const MirrorPlane& plane);

/// Moves the limit points of a point and of its partner (see `move_limit_point`).
Result<SkinEdit> move_limit_point(const Skin& skin, std::uint32_t point, const Vector3& position,
                                  const MirrorPlane& plane);

/// Inserts a point in the middle of a span and one in that of its image, both taken from the old curve.
Result<SkinEdit> insert_section_point(const Skin& skin, std::uint32_t section, int span,
                                      const MirrorPlane& plane);

/// Points with their partners, each once, in the order of the sections, for symmetric deletion and corners.
/// Ids that do not exist are kept.
std::vector<std::uint32_t> with_partners(const Skin& skin, std::span<const std::uint32_t> points,
                                         const MirrorPlane& plane);

/// Makes sections symmetric, all when none are named: see the other `make_symmetric`.
Result<SkinEdit> make_symmetric(const Skin& skin, std::span<const std::uint32_t> sections,
                                const MirrorPlane& plane);

}  // namespace hariko
