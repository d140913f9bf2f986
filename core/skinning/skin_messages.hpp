#pragma once

// Error and warning codes of skins.

#include "core/base/message.hpp"

namespace hariko {

inline constexpr Code e_few_sections{"E_FEW_SECTIONS"};
inline constexpr Code e_path_short{"E_PATH_SHORT"};
inline constexpr Code e_section_order{"E_SECTION_ORDER"};
inline constexpr Code e_section_range{"E_SECTION_RANGE"};
inline constexpr Code e_not_finite{"E_NOT_FINITE"};
inline constexpr Code e_few_points{"E_FEW_POINTS"};
inline constexpr Code e_point_section{"E_POINT_SECTION"};
inline constexpr Code e_open_closed{"E_OPEN_CLOSED"};
inline constexpr Code e_skin_index{"E_INDEX"};
inline constexpr Code e_link_cross{"E_LINK_CROSS"};
inline constexpr Code e_merge_v{"E_MERGE_V"};
inline constexpr Code e_merge_small{"E_MERGE_SMALL"};
inline constexpr Code e_merge_gap{"E_MERGE_GAP"};
inline constexpr Code e_merge_overlap{"E_MERGE_OVERLAP"};
inline constexpr Code e_merge_all{"E_MERGE_ALL"};
inline constexpr Code e_few_rows{"E_FEW_ROWS"};
inline constexpr Code e_path_cusp{"E_PATH_CUSP"};
inline constexpr Code e_rail{"E_RAIL"};
/// Error: the skin is so large that its mesh would not fit: too many rows, columns or too high a density.
inline constexpr Code e_skin_size{"E_SKIN_SIZE"};
inline constexpr Code w_spacing{"W_SPACING"};
inline constexpr Code w_section_not_exact{"W_SECTION_NOT_EXACT"};
inline constexpr Code w_skin_fold{"W_FOLD"};
inline constexpr Code w_twist{"W_TWIST"};

}  // namespace hariko
