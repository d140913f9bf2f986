#pragma once

// Numbers of a skin as JSON, for checks against other implementations.

#include <string>

#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

/// JSON with control mesh, creases, lines, rows, figures and sampled points; docs/cli.md describes the
/// members. Errors: those of `SkinSurfacer::surface`.
Result<std::string> skin_evaluation_json(const Skin& skin);

}  // namespace hariko
