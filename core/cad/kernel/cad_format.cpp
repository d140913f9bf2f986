#include "core/base/files/file_ending.hpp"
#include "core/cad/kernel/cad_file.hpp"

namespace hariko {

std::optional<CadFormat> cad_format_of(const std::filesystem::path& path) {
  const std::string extension = lower_ending(path);
  if (extension == ".step" || extension == ".stp") return CadFormat::step_ap214;
  if (extension == ".iges" || extension == ".igs") return CadFormat::iges;
  return {};
}

}  // namespace hariko
