#pragma once

// Mapped items of STEP files that scale or mirror their shape. Private to this folder.

#include <STEPCAFControl_Reader.hxx>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Transfers the mapped items of a loaded STEP model whose operator scales or mirrors, and binds their right
/// shapes in the reader, whose transfer into a document then takes them: the kernel applies the rigid part of
/// such operators alone. Returns W_CAD_PLACED for items that could not be transformed. Without such items
/// nothing is transferred, O(size); else each level of them, one inside the other, costs a transfer.
std::vector<Message> transform_mapped_items(STEPCAFControl_Reader& reader);

}  // namespace hariko
