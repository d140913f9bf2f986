#pragma once

// Renderer: draws a scene with OpenGL 3.3 core into a texture of its own.

#include <memory>

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/scene.hpp"

namespace hariko {

inline constexpr Code e_gl_version{"E_GL_VERSION"};
inline constexpr Code e_gl_shader{"E_GL_SHADER"};
inline constexpr Code e_gl_framebuffer{"E_GL_FRAMEBUFFER"};

struct DrawOptions {
  PixelSize size;
  int samples = 4;  ///< 1 (none, for moving views on slow machines) to 4; clamped to what GL offers
  int picture = 0;  ///< which of the pictures that the renderer keeps is drawn: 0 .. most_pictures - 1
  /// Bytes of reference pictures that this drawing may upload: the rest comes with the next ones.
  std::size_t upload_limit = std::size_t(-1);
};

struct FrameStatistics {
  std::size_t uploaded_bytes = 0;
  std::size_t triangles = 0;
  int draw_calls = 0;
  bool unfinished = false;  ///< reference pictures are not as sharp yet as they will be
};

/// Owns programs, framebuffers and the GPU copies of the meshes it drew last. Every call, construction and
/// destruction need the same GL context to be current. Leaves framebuffer 0 bound and depth test, blending
/// and culling off.
class Renderer {
 public:
  /// Pictures kept side by side, each with a texture of its own: one for each view of the window and some to
  /// spare. GPU copies of meshes are shared between them.
  static constexpr int most_pictures = 8;

  /// Errors: E_GL_VERSION below 3.3. Shaders are compiled when the first picture is drawn: a window that
  /// shows none starts without them.
  static Result<Renderer> create();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Draws; the picture is then in texture(options.picture). Errors: E_GL_FRAMEBUFFER, E_GL_SHADER.
  Result<Done> draw(const Scene& scene, const Camera& camera, const DrawOptions& options);

  /// GL name of the RGBA8 texture with a picture; rows run upwards, as GL has them (ImGui: uv (0,1)..(1,0)).
  unsigned texture(int picture = 0) const;
  /// Keeps what a picture shows now beside the next ones, to fade from: it is in kept_texture(picture) until
  /// the next call or `forget`. False where there is no memory.
  bool keep(int picture);
  unsigned kept_texture(int picture) const;
  /// Copies a picture into framebuffer 0 with its lower left corner at (x, y).
  void blit_to_window(int x, int y, int picture = 0) const;
  /// Reads a picture back.
  Image read(int picture = 0) const;
  /// Frees a picture's texture and what only it was drawn from.
  void forget(int picture);
  /// Waits until the GPU (or the driver's threads) has drawn everything: for measuring.
  void finish() const;
  const FrameStatistics& statistics() const;

  /// True when a shader file on disk (HARIKO_SHADERS) changed since it was compiled; then reload() compiles
  /// again and keeps the old program where that fails.
  bool shaders_changed() const;
  Result<Done> reload();

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// "OpenGL 4.5 (Mesa, llvmpipe)": for the about box and error reports. Needs a current context.
std::string describe_gl();

}  // namespace hariko
