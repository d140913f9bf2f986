// Loader of the module with OpenCASCADE, when a STEP or IGES file is first written or read.

#include <dlfcn.h>

#include <mutex>
#include <string>
#include <system_error>

#include "core/cad/kernel/cad_module.hpp"

namespace hariko {

namespace {

namespace fs = std::filesystem;

/// Path of the module: `lib/hariko/modules` beside the folder of the program, in an installed prefix as in a
/// build folder; empty where it is missing.
fs::path module_path() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  fs::path module = program.parent_path().parent_path() / "lib" / "hariko" / "modules" / "hariko_cad.so";
  return fs::is_regular_file(module, error) ? module : fs::path();
}

Message missing(const std::string& why) {
  return make_error(e_no_cad_kernel, "OpenCASCADE, which STEP and IGES need, cannot be loaded: " + why + ".",
                    "Install Hariko again, with its part for CAD files.");
}

Result<const CadModule*> load() {
  const fs::path path = module_path();
  if (path.empty()) return missing("its part of Hariko is not installed");
  // Never closed: the kernel keeps settings for the whole process.
  void* const library = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const entry = library ? ::dlsym(library, cad_module_entry) : nullptr;
  if (!entry) {
    const char* const why = ::dlerror();
    return missing(why ? why : "it is not what it should be");
  }
  return reinterpret_cast<CadModuleEntry>(entry)();
}

/// Loads the module once. A failure is not remembered: the libraries may be installed meanwhile.
Result<const CadModule*> module() {
  static const CadModule* loaded = nullptr;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  if (loaded) return loaded;
  auto result = load();
  if (result.ok()) loaded = *result;
  return result;
}

}  // namespace

std::optional<Message> why_no_cad_files() {
  if (module_path().empty()) return missing("its part of Hariko is not installed");
  return {};
}

Result<CadFile> make_cad_file(std::span<const CadObject> objects, const CadFileOptions& options,
                              const CancelToken& cancel, const Progress& progress) {
  const auto kernel = module();
  if (!kernel) return kernel.error();
  return (*kernel)->make_cad_file(objects, options, cancel, progress);
}

Result<CadScene> read_cad_file(const fs::path& path, const CadReadOptions& options, const CancelToken& cancel,
                               const Progress& progress) {
  const auto kernel = module();
  if (!kernel) return kernel.error();
  return (*kernel)->read_cad_file(path, options, cancel, progress);
}

}  // namespace hariko
