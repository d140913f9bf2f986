#pragma once

// Photo orientation: which side of a photograph is up, as its camera noted (EXIF). Internal to render/.

#include <string_view>

#include "render/camera.hpp"
#include "render/image.hpp"

namespace hariko {

/// Orientation of EXIF notes (tag 0x0112), 1 .. 8: position of the file's first row and column; 1 where none
/// is noted or the notes are damaged. `notes`: from the header of TIFF on.
int exif_orientation(std::string_view notes);
/// Size of a picture of that orientation as it stands upright.
PixelSize upright_size(PixelSize file, int orientation);
/// The picture of that orientation upright.
Image upright_image(Image file, int orientation);

}  // namespace hariko
