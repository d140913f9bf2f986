#pragma once

// Content of the meshing panel, on a worker.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "ui/editor/meshing.hpp"

namespace hariko {

/// Meshes an object of the document with the given settings and maps the errors. Errors are part of the
/// result; cancelled work returns one without meshes.
MeshingResult preview_mesh(const Document& document, const std::shared_ptr<const Object>& object,
                           const MeshingSettings& settings, const CancelToken& cancel = {},
                           const Progress& progress = {});

}  // namespace hariko
