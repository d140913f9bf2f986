// Replacement where the program is built without OpenCASCADE: every function returns E_NO_CAD_KERNEL.

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

std::optional<Message> why_no_cad_files() {
  return make_error(e_no_cad_kernel, "This build of Hariko has no OpenCASCADE, which STEP and IGES need.",
                    "Run scripts/dependencies.sh cad in the folder with Hariko's sources and build again.");
}

Result<CadFile> make_cad_file(std::span<const CadObject>, const CadFileOptions&, const CancelToken&,
                              const Progress&) {
  return *why_no_cad_files();
}

Result<CadScene> read_cad_file(const std::filesystem::path&, const CadReadOptions&, const CancelToken&,
                               const Progress&) {
  return *why_no_cad_files();
}

}  // namespace hariko
