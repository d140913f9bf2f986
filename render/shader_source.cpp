#include "render/shader_source.hpp"

#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "core/base/files/file_io.hpp"

namespace hariko {

namespace {

std::filesystem::path folder() {
  const char* value = std::getenv("HARIKO_SHADERS");
  return value ? std::filesystem::path(value) : std::filesystem::path();
}

constexpr std::uint64_t largest_source = 1 << 20;

}  // namespace

Result<std::string> shader_source(std::string_view name) {
  if (const std::filesystem::path from = folder(); !from.empty()) {
    Result<std::string> text = read_file(from / name, largest_source);
    if (text) return text;
    return make_error(e_shader_source, "The shader could not be read: " + text.error().text,
                      "Unset HARIKO_SHADERS to use the built-in shaders.");
  }
  for (const EmbeddedShader& shader : embedded_shaders())
    if (shader.name == name) return std::string(shader.source);
  return make_error(e_shader_source, "The program has no shader named " + std::string(name) + ".");
}

std::uint64_t shader_stamp() {
  const std::filesystem::path from = folder();
  std::uint64_t stamp = 0;
  std::error_code error;
  if (from.empty()) return stamp;
  for (const auto& entry : std::filesystem::directory_iterator(from, error)) {
    const auto time = entry.last_write_time(error);
    if (!error) stamp = stamp * 31 + static_cast<std::uint64_t>(time.time_since_epoch().count());
  }
  return stamp;
}

}  // namespace hariko
