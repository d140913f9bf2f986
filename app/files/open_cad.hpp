#pragma once

// STEP and IGES files as documents.

#include <filesystem>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"

namespace hariko {

struct OpenedCad {
  Document document;  ///< in millimetres
  std::vector<Message> warnings;
};

/// Each part of the file becomes an object of Bezier patches, exactly, and a reference mesh of the faces that
/// are no whole splines, or hang together with such; in that case a hidden object has the patches. With the
/// file's names and colours, and `name` where it gives none. The ending is one of STEP or IGES (asserted).
/// Errors: those of `read_cad_file` and of the sources.
Result<OpenedCad> open_cad(const std::filesystem::path& file, const std::string& name,
                           const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko
