#include "app/window/window_options.hpp"

namespace hariko {

std::string to_string(const WindowOptions& options) {
  std::string out;
  for (const std::filesystem::path& file : options.files) out += file.filename().string() + ", ";
  out += std::to_string(options.width) + " x " + std::to_string(options.height);
  if (options.scale > 0) out += ", scale " + std::to_string(options.scale);
  return options.record.empty() ? out : out + ", recording";
}

}  // namespace hariko
