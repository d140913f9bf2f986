#pragma once

// Tension files: {"beta": {"a-b": 10}, "alpha": {"a": 10}, "crease": [[a, b]], "corner": [a], "smooth": [a]}.

#include <string_view>

#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

inline constexpr Code e_tension_file{"E_TENSION_FILE"};

/// Adds a file's settings to `shaping`. Vertices are named by their ids, which for mesh files are the
/// positions in the file from 0. Every member may be missing. Errors: E_TENSION_FILE for other texts and for
/// elements that the polyhedron does not have. O(size log elements).
Result<Shaping> read_tensions(std::string_view text, const Polyhedron& polyhedron, Shaping shaping);

}  // namespace hariko
