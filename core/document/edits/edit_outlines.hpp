#pragma once

// Edits of outline objects.

#include <functional>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_outline_limit{"E_LIMIT"};
inline constexpr Code e_outline_settings{"E_OUTLINE_SETTINGS"};

/// Replaces an object's outline by change(outline) (core/gaussmap/outlines/edit_outline.hpp). The outline may
/// be unfinished: its faults are errors of its surface. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND (no
/// outline), E_NONFINITE, E_LIMIT (more than `max_outline_points`), and those of `change`.
Result<Document> edit_outline(const Document& document, ObjectId object,
                              const std::function<Result<Outline>(const Outline&)>& change);

/// Sets how the surface inside an outline is made. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND,
/// E_OUTLINE_SETTINGS (radius, gap or count out of their ranges).
Result<Document> set_outline_settings(const Document& document, ObjectId object,
                                      const OutlineSettings& settings);

}  // namespace hariko
