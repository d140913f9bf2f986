#pragma once

// Outlines from JSON: as parts of documents, and as files of their own.

#include <string_view>

#include "core/document/json_cursor.hpp"
#include "core/gaussmap/outline_settings.hpp"

namespace hariko {

/// More points than any drawn outline has; checks of convexity compare all pairs.
inline constexpr std::size_t max_outline_points = 20000;

/// An outline's own layout: {"loops": [{"points": [[x, y, z], ...], "normals": [...], "K": [...]}]}; K, the
/// Gaussian curvature, may be missing. Errors: E_LIMIT, E_PARSE, E_SCHEMA. What the numbers mean is checked
/// by `check_outline`.
Result<Outline> read_outline(std::string_view text);

namespace detail {

/// The loops within an object that may have other members.
Outline read_loops(JsonReader& reader, const JsonCursor& at);

/// The settings beside the loops; every member may be missing.
OutlineSettings read_outline_settings(JsonReader& reader, const JsonCursor& at);

}  // namespace detail

}  // namespace hariko
