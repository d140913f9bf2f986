#pragma once

// Opening of STEP and IGES files as documents.

#include <filesystem>
#include <optional>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Document of a CAD file.
struct OpenedCad {
  Document document;  ///< in millimetres
  std::vector<Message> warnings;
};

/// Opens a CAD file of the given format or, without one, of that of its ending, STEP or IGES (asserted). Each
/// part becomes an object of exact Bezier patches, and a reference mesh of the faces that are not whole
/// splines or are connected to such faces; in the latter case a hidden object has their patches. Objects get
/// the file's names and colours, and `name` where it gives none. Errors: those of `read_cad_file` and of the
/// sources.
Result<OpenedCad> open_cad(const std::filesystem::path& file, const std::string& name,
                           const CancelToken& cancel = {}, const Progress& progress = {},
                           std::optional<CadFormat> format = {});

}  // namespace hariko
