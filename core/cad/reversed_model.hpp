#pragma once

// CAD models turned inside out: the same faces, seen from their other sides.

#include "core/cad/cad_model.hpp"

namespace hariko {

/// Exchanges s and t of all faces, so that their outside is on the other side. With all points reflected that
/// is the mirror image of a model, with the outside kept. The pieces have no cells then, which are those of a
/// surface that looks the other way. O(control points).
CadModel reversed(CadModel model);

}  // namespace hariko
