#pragma once

// Looks of a surface: which program draws it, and what it mirrors. Internal to render/.

#include <memory>
#include <string>

#include "render/program.hpp"
#include "render/scene.hpp"

namespace hariko::gl {

/// Whether a surface mirrors the scene's environment, or the ceiling of tubes of its zebra stripes.
bool mirrors_environment(const SceneObject& object, const Scene& scene);
bool mirrors_ceiling(const SceneObject& object, const Scene& scene);

/// Defines of the program for the look of a surface (surface.frag.glsl): whole lines.
std::string surface_defines(const SceneObject& object, const Scene& scene);
/// Defines of a clay surface.
std::string plain_surface_defines();

/// Sets the uniforms of the ceiling of tubes, which lies half a diagonal of the scene above its top. `view`:
/// world to camera axes.
void set_ceiling(const Program& program, const Matrix4& view, const Scene& scene);

/// Texture with the levels of the environment that was drawn last.
class EnvironmentTexture {
 public:
  /// Binds the texture and sets the uniforms of a program that mirrors it; `levels` are not null. Returns the
  /// number of bytes that were uploaded.
  std::size_t set(const Program& program, const Matrix4& view, const Environment& environment);

 private:
  Texture texture_;
  std::shared_ptr<const EnvironmentLevels> levels_;  ///< contents of the texture
};

}  // namespace hariko::gl
