#pragma once

// Rows of the dialogs that open files: what meshes become.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Marks: "import.use", "import.use.<number>", "import.creases", "import.crease_angle".
void draw_mesh_options(Editor& editor, Marks& marks, const Metrics& metrics);

}  // namespace hariko
