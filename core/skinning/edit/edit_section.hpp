#pragma once

// Edits of the points of sections, as pure functions skin -> skin. Ids stay; links and merges refer to ids
// and so stay valid. All functions refuse edits that would break a valid skin, with the error of `plan_skin`,
// and E_INDEX for points or sections that do not exist.

#include <cstdint>
#include <span>

#include "core/skinning/edit/skin_edit.hpp"

namespace hariko {

struct MovedPoint {
  std::uint32_t id = 0;
  Vector3 position = Vector3::Zero();
};

/// Moves control points of one or more sections.
Result<SkinEdit> move_section_points(const Skin& skin, std::span<const MovedPoint> points);

/// Moves the limit point of a control point to `position`; the other limit points stay. Used for drawing
/// through points.
Result<SkinEdit> move_limit_point(const Skin& skin, std::uint32_t point, const Vector3& position);

/// Inserts a control point in the middle of a span (between points `span` and `span` + 1). The curve passes
/// through the same points as before; between them it changes by `deviation`, because uniform curves have no
/// exact insertion of one knot. Links and merges that contain both neighbours also get the new point.
Result<SkinEdit> insert_section_point(const Skin& skin, std::uint32_t section, int span);

/// Inserts a control point in the middle of every span. The curve stays exactly the same.
Result<SkinEdit> refine_section(const Skin& skin, std::uint32_t section);

/// Deletes control points; the curve then passes through the remaining limit points. Links and merges that
/// lose their points are removed. Errors: E_FEW_POINTS where fewer than two (closed: three) would be left.
Result<SkinEdit> delete_section_points(const Skin& skin, std::span<const std::uint32_t> points);

/// Makes points corners, where the curve passes through the control point with a kink, or smooth again.
Result<SkinEdit> set_sharp(const Skin& skin, std::span<const std::uint32_t> points, bool sharp);

/// Reverses a section permanently (`direction_chosen`). Links that cross then are removed. The first point of
/// a closed section stays the first.
Result<SkinEdit> flip_section(const Skin& skin, std::uint32_t section);

/// Makes the point the first of its closed section permanently (`start_chosen`), so that it corresponds to
/// the first point of the section before. Error: E_OPEN_CLOSED for open sections.
Result<SkinEdit> move_seam(const Skin& skin, std::uint32_t point);

/// Sets whether a closed section begins at its first point, or where it is nearest to the section before.
Result<SkinEdit> set_start_chosen(const Skin& skin, std::uint32_t section, bool chosen);

/// Whether sections with more than one point are closed.
bool has_closed_sections(const Skin& skin);
/// Opens or closes all sections with more than one point. Error: E_FEW_POINTS where one has only two.
Result<SkinEdit> set_closed(const Skin& skin, bool closed);

/// Mirror pairing of a section's points: point i of n is the image of point `partner`[i]. Open: n - 1 - i;
/// closed: the cyclic pairing for which the mirror plane comes nearest to the points.
std::vector<int> mirror_partners(const SkinSection& section, const Vector3& plane_point,
                                 const Vector3& plane_normal);

/// Makes a section its own mirror image: of each pair the point on the side of `plane_normal` is kept, and
/// points without a partner move into the plane. Corners are treated likewise.
Result<SkinEdit> make_symmetric(const Skin& skin, std::uint32_t section, const Vector3& plane_point,
                                const Vector3& plane_normal);

/// Mirror image of the whole skin.
Skin mirrored(Skin skin, const Vector3& plane_point, const Vector3& plane_normal);

}  // namespace hariko
