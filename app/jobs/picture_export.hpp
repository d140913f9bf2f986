#pragma once

// Writing ordered pictures. For a worker.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "ui/files/picture_order.hpp"

namespace hariko {

/// Draws the pictures in a context of its own and writes them one after the other; each file is the old or
/// the whole new one. Errors: those of PictureDrawer and `write_png`; E_CANCELLED. What was written of a
/// series that did not come to its end is removed.
Result<Done> write_pictures(const PictureOrder& order, const CancelToken& cancel, const Progress& progress);

}  // namespace hariko
