#pragma once

// Shader sources: embedded in the program, or read from a folder during development.

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_shader_source{"E_SHADER_SOURCE"};

/// Shader file embedded in the program.
struct EmbeddedShader {
  std::string_view name, source;
};

/// All files shaders/*.glsl as of the program's build.
std::span<const EmbeddedShader> embedded_shaders();

/// Source of shaders/<name>. Where the environment variable HARIKO_SHADERS names a folder, the file there is
/// read instead. Errors: E_SHADER_SOURCE where there is none.
Result<std::string> shader_source(std::string_view name);

/// Stamp that changes when a file in HARIKO_SHADERS is written; 0 for embedded shaders.
std::uint64_t shader_stamp();

}  // namespace hariko
