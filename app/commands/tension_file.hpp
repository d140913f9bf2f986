#pragma once

// Tension files: {"beta": {"a-b": 10}, "alpha": {"a": 10}, "crease": [[a, b]], "corner": [a], "smooth": [a]}.

#include <string_view>

#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

inline constexpr Code e_tension_file{"E_TENSION_FILE"};

/// `shaping` with the file's settings added; vertices are named by their ids, for mesh files the position in
/// the file from 0. Every member may be missing. Errors: E_TENSION_FILE for text that is no such file and for
/// elements that the polyhedron does not have.
Result<Shaping> read_tensions(std::string_view text, const Polyhedron& polyhedron, Shaping shaping);

}  // namespace hariko
