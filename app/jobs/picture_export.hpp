#pragma once

// Writing of ordered pictures, line drawings and section curves, on a worker.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "ui/files/picture_order.hpp"

namespace hariko {

/// Draws the pictures in a GL context of its own and writes them one after the other, each file atomically.
/// Errors: those of PictureDrawer and `write_png`; E_CANCELLED. Files of an incomplete series are removed.
Result<Done> write_pictures(const PictureOrder& order, const CancelToken& cancel, const Progress& progress);

/// Writes a line drawing atomically: the file is the old or the whole new one. Errors: those of `draw_lines`
/// and `write_file_atomic`.
Result<Done> write_drawing(const DrawingOrder& order, const CancelToken& cancel, const Progress& progress);

/// Writes section curves likewise, in the format that the file's name says. Errors: those of `section_set`
/// and `write_file_atomic`.
Result<Done> write_sections(const SectionOrder& order, const CancelToken& cancel, const Progress& progress);

}  // namespace hariko
