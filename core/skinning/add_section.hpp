#pragma once

// Sections that come and go.

#include <cstdint>
#include <vector>

#include "core/skinning/skin_edit.hpp"
#include "core/skinning/skin_work.hpp"

namespace hariko {

/// A section at a place of the path that none has, taken from the present surface: its curve passes through
/// the surface at v, once for every point of the neighbour with more points (points that have merged there
/// are one, points of a merge of the other side that has not happened yet are several). Links and merges of
/// the strip go to the part where they have their effect. Errors: E_SECTION_ORDER where there is a section,
/// E_SECTION_RANGE outside of the path, E_FEW_POINTS where nearly all lines have merged, E_CANCELLED, and
/// those of `SkinSurfacer::surface`. A pleated skin is skinned once: not for the thread of a window.
Result<SkinEdit> add_section(const Skin& skin, double v, const SkinWork& work = {});

/// A section that the designer drew, through or by these control points. Links and merges of the strip that
/// it divides go. May be the first or second section of a skin.
Result<SkinEdit> draw_section(const Skin& skin, double v, const std::vector<Vector3>& points, bool closed);

/// Takes a section with its links and merges away; one at an end of an open path takes that part of the path
/// with it. Errors: E_FEW_SECTIONS where fewer than two would be left.
Result<SkinEdit> delete_section(const Skin& skin, std::uint32_t section);

}  // namespace hariko
