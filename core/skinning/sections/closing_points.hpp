#pragma once

// Closed sections that repeat their first point at their end, as some programs write them.

#include <cstddef>

#include "core/skinning/skin.hpp"

namespace hariko {

/// Removes the last point of closed sections of more than three points where it lies at the first one, nearer
/// than 1e-9 of the section's size. Links and merges of the removed point go to the first one, which is sharp
/// where one of both was. Returns the number of such sections. O(points + links).
std::size_t drop_closing_points(Skin& skin);

}  // namespace hariko
