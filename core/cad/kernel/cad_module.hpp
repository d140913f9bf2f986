#pragma once

// Interface between the program and the module with OpenCASCADE, a shared library of its own: the seventy
// libraries behind it take longer to load than all else that the program needs to start.

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

/// Table of the module's functions; they mean what cad_file.hpp and read_cad_file.hpp say.
struct CadModule {
  Result<CadFile> (*make_cad_file)(std::span<const CadObject> objects, const CadFileOptions& options,
                                   const CancelToken& cancel, const Progress& progress);
  Result<CadScene> (*read_cad_file)(const std::filesystem::path& path, const CadReadOptions& options,
                                    const CancelToken& cancel, const Progress& progress);
};

/// Name and type of the one function that the module exports. The table that it returns lives as long as the
/// process.
inline constexpr const char* cad_module_entry = "hariko_cad_module";
using CadModuleEntry = const CadModule* (*)();

}  // namespace hariko
