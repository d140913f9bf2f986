#pragma once

// Implementation, by OpenCASCADE, of the functions of cad_file.hpp and read_cad_file.hpp. Private to the
// module.

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko::by_opencascade {

/// See cad_file.hpp.
Result<CadFile> make_cad_file(std::span<const CadObject> objects, const CadFileOptions& options,
                              const CancelToken& cancel, const Progress& progress);
/// See read_cad_file.hpp.
Result<CadScene> read_cad_file(const std::filesystem::path& path, const CadReadOptions& options,
                               const CancelToken& cancel, const Progress& progress);

}  // namespace hariko::by_opencascade
