#include "core/cad/kernel/cad_file.hpp"

namespace hariko {

std::optional<CadFormat> cad_format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".step" || extension == ".stp") return CadFormat::step_ap214;
  if (extension == ".iges" || extension == ".igs") return CadFormat::iges;
  return {};
}

}  // namespace hariko
