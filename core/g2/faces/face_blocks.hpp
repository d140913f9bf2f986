#pragma once

// Face blocks: exact inverses of the whole matrix restricted to the unknowns of one face; the overlapping
// blocks of mode G2's preconditioner (g2.md section 6).

#include <memory>
#include <vector>

#include "core/g2/faces/face_elements.hpp"

namespace hariko {

/// Computes the block of each face, in the face's own controls; equal blocks are shared.
std::vector<std::shared_ptr<const PaddedMatrix>> face_blocks(const G2Layout& layout,
                                                             const FaceElements& elements);

}  // namespace hariko
