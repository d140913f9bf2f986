#pragma once

// Writing of ordered pictures, on a worker.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "ui/files/picture_order.hpp"

namespace hariko {

/// Draws the pictures in a GL context of its own and writes them one after the other, each file atomically.
/// Errors: those of PictureDrawer and `write_png`; E_CANCELLED. Files of an incomplete series are removed.
Result<Done> write_pictures(const PictureOrder& order, const CancelToken& cancel, const Progress& progress);

}  // namespace hariko
