#pragma once

// What the meshing panel shows of an object. For a worker.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "ui/editor/meshing.hpp"

namespace hariko {

/// Meshes an object of the document as the settings say and maps the errors. Errors become part of the
/// result; cancelled work gives one without meshes.
MeshingResult preview_mesh(const Document& document, const std::shared_ptr<const Object>& object,
                           const MeshingSettings& settings, const CancelToken& cancel = {},
                           const Progress& progress = {});

}  // namespace hariko
