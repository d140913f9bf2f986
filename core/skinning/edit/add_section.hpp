#pragma once

// Adding and deleting sections.

#include <cstdint>
#include <vector>

#include "core/skinning/columns/skin_context.hpp"
#include "core/skinning/edit/skin_edit.hpp"

namespace hariko {

/// Adds a section taken from the present surface, at a place of the path without a section: its curve passes
/// through the surface at v, once for every point of the neighbour with more points (points that have merged
/// there count once, points of a merge of the other side that is still open count separately). Links and
/// merges of the strip move to the part where they take effect. Errors: E_SECTION_ORDER where there is a
/// section already, E_SECTION_RANGE outside of the path, E_FEW_POINTS where nearly all lines have merged,
/// E_CANCELLED, and those of `SkinSurfacer::surface`. A pleated skin is skinned once, so this is too slow for
/// the user interface's thread.
Result<SkinEdit> add_section(const Skin& skin, double v, const SkinWork& work = {});

/// Adds a section drawn by the designer, with these control points and open or closed. Links and merges of
/// the strip that it divides are removed. May be the first or second section of a skin.
Result<SkinEdit> draw_section(const Skin& skin, double v, const std::vector<Vector3>& points, bool closed);

/// Deletes a section with its links and merges; deleting one at an end of an open path also removes that part
/// of the path. Errors: E_FEW_SECTIONS where fewer than two would be left.
Result<SkinEdit> delete_section(const Skin& skin, std::uint32_t section);

}  // namespace hariko
