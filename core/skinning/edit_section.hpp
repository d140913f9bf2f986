#pragma once

// What a designer does to the points of sections, as pure functions skin -> skin. Ids stay; links and merges
// refer to ids and follow. All refuse with the reason what would break a sound skin, and with E_INDEX what
// does not exist.

#include <cstdint>
#include <span>

#include "core/skinning/skin_edit.hpp"

namespace hariko {

struct MovedPoint {
  std::uint32_t id = 0;
  Vector3 position = Vector3::Zero();
};

/// Control points, of one or more sections.
Result<SkinEdit> move_section_points(const Skin& skin, std::span<const MovedPoint> points);

/// The point of the curve that belongs to a control point goes to `position`, the other ones stay: drawing
/// through points.
Result<SkinEdit> move_limit_point(const Skin& skin, std::uint32_t point, const Vector3& position);

/// One more point in the middle of a span (between points `span` and `span` + 1). The curve goes through the
/// same points as before; between them it changes by `deviation`, as uniform curves have no exact insertion
/// of one knot. Groups and merges with both neighbours take the point in.
Result<SkinEdit> insert_section_point(const Skin& skin, std::uint32_t section, int span);

/// A point in the middle of every span. The curve stays exactly what it is.
Result<SkinEdit> refine_section(const Skin& skin, std::uint32_t section);

/// The curve goes through the points that are left. Links and merges that lose theirs go. Errors:
/// E_FEW_POINTS where fewer than two (closed: three) would be left.
Result<SkinEdit> delete_section_points(const Skin& skin, std::span<const std::uint32_t> points);

/// Corners: the curve passes through the control point, with a kink.
Result<SkinEdit> set_sharp(const Skin& skin, std::span<const std::uint32_t> points, bool sharp);

/// Turns a section round, for good (`direction_chosen`). Links that cross then go. The first point of a
/// closed section stays the first.
Result<SkinEdit> flip_section(const Skin& skin, std::uint32_t section);

/// The point becomes the first of its closed section, for good (`start_chosen`): it belongs to the first one
/// of the section before. E_OPEN_CLOSED for open sections.
Result<SkinEdit> move_seam(const Skin& skin, std::uint32_t point);

/// Whether a closed section begins at its first point, or where it is nearest to the section before.
Result<SkinEdit> set_start_chosen(const Skin& skin, std::uint32_t section, bool chosen);

/// Whether sections with more than one point are closed.
bool has_closed_sections(const Skin& skin);
/// Opens or closes all sections with more than one point. E_FEW_POINTS where one has only two.
Result<SkinEdit> set_closed(const Skin& skin, bool closed);

/// Point i of a section of n points is the image of point `partner`[i].
/// Open: n - 1 - i; closed: the pairing that a mirror plane nearest to the points gives.
std::vector<int> mirror_partners(const SkinSection& section, const Vector3& plane_point,
                                 const Vector3& plane_normal);

/// Makes a section its own mirror image: of each pair the point on the side of `plane_normal` is taken, and
/// points without a partner go into the plane. Corners follow.
Result<SkinEdit> make_symmetric(const Skin& skin, std::uint32_t section, const Vector3& plane_point,
                                const Vector3& plane_normal);

/// The whole skin in a mirror.
Skin mirrored(Skin skin, const Vector3& plane_point, const Vector3& plane_normal);

}  // namespace hariko
