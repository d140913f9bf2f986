#pragma once

// Textures of the interface: names that OpenGL gave, 0 for none, and how Dear ImGui takes them.

#include <imgui.h>

#include <cstdint>

namespace hariko {

/// The texture of a name, for draw lists. A cast of C, as Dear ImGui takes a pointer in some versions and an
/// integer in others.
inline ImTextureID imgui_texture(unsigned name) {
  return (ImTextureID) static_cast<std::uintptr_t>(name);  // NOLINT
}

}  // namespace hariko
