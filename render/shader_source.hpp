#pragma once

// Shader sources: embedded into the program, or read from a folder while developing.

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_shader_source{"E_SHADER_SOURCE"};

struct EmbeddedShader {
  std::string_view name, source;
};

/// All of shaders/*.glsl as they were when the program was built.
std::span<const EmbeddedShader> embedded_shaders();

/// The source of shaders/<name>. When the environment variable HARIKO_SHADERS names a folder, the file there
/// is read instead. Errors: E_SHADER_SOURCE when there is none.
Result<std::string> shader_source(std::string_view name);

/// A number that changes when a file in HARIKO_SHADERS is written; 0 when embedded shaders are used.
std::uint64_t shader_stamp();

}  // namespace hariko
