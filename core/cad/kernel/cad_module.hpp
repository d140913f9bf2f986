#pragma once

// The interface between the module with OpenCASCADE and the program that loads it. The module is a library of
// its own because the seventy libraries behind it take longer to load than all else that the program needs to
// start.

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

struct CadModule {
  Result<CadFile> (*make_cad_file)(std::span<const CadObject> objects, const CadFileOptions& options,
                                   const CancelToken& cancel, const Progress& progress);
  Result<CadScene> (*read_cad_file)(const std::filesystem::path& path, const CadReadOptions& options,
                                    const CancelToken& cancel, const Progress& progress);
};

/// The one function that the module exports, and its type: the table lives as long as the process.
inline constexpr const char* cad_module_entry = "hariko_cad_module";
using CadModuleEntry = const CadModule* (*)();

}  // namespace hariko
