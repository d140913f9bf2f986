#pragma once

// Renderer: draws a scene with OpenGL 3.3 core into a texture of its own.

#include <memory>
#include <optional>

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/scene.hpp"

namespace hariko {

inline constexpr Code e_gl_version{"E_GL_VERSION"};
inline constexpr Code e_gl_shader{"E_GL_SHADER"};
inline constexpr Code e_gl_framebuffer{"E_GL_FRAMEBUFFER"};

/// Options for drawing one picture.
struct DrawOptions {
  PixelSize size;
  int samples = 4;  ///< 1 (none, for moving views on slow machines) to 4; limited to what GL offers
  int picture = 0;  ///< slot of the picture in the renderer: 0 .. most_pictures - 1
  /// Number of bytes of reference pictures that this drawing may upload; the rest follows with later ones.
  std::size_t upload_limit = std::size_t(-1);
  bool timed = false;  ///< measures how long the graphics card takes (FrameStatistics::time)
};

/// Time that the graphics card took for a picture.
struct PictureTime {
  double milliseconds = 0;
  int samples = 0;  ///< number that was asked for
};

/// Statistics of the last drawing.
struct FrameStatistics {
  std::size_t uploaded_bytes = 0;
  std::size_t triangles = 0;
  int draw_calls = 0;
  bool unfinished = false;  ///< reference pictures are not fully sharp yet
  /// Time of an earlier drawing into the same slot that was `timed`: given once, as soon as it is known
  /// without waiting.
  std::optional<PictureTime> time;
};

/// Renderer with its programs, framebuffers and GPU copies of the meshes drawn last. All calls, construction
/// and destruction need the same GL context to be current. Leaves framebuffer 0 bound, and depth test,
/// blending and culling off.
class Renderer {
 public:
  /// Number of picture slots, each with its own texture: one for each view of the window and some to spare.
  /// GPU copies of meshes are shared between them.
  static constexpr int most_pictures = 8;

  /// Creates a renderer. Errors: E_GL_VERSION below 3.3. Shaders are compiled with the first picture, so that
  /// a window without pictures starts without them.
  static Result<Renderer> create();
  /// Renderer of an interface that is never shown: needs no GL context. Drawing is asserted against.
  static Renderer undrawn();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Draws a scene; the picture is then in texture(options.picture). Errors: E_GL_FRAMEBUFFER, E_GL_SHADER.
  Result<Done> draw(const Scene& scene, const Camera& camera, const DrawOptions& options);

  /// GL name of the RGBA8 texture with a picture; rows run upwards, as GL has them (ImGui: uv (0,1)..(1,0)).
  unsigned texture(int picture = 0) const;
  /// Keeps a copy of a picture to fade from, in kept_texture(picture), until the next call or `forget`. False
  /// where memory is lacking.
  bool keep(int picture);
  unsigned kept_texture(int picture) const;
  /// Copies a picture into framebuffer 0 with its lower left corner at (x, y).
  void blit_to_window(int x, int y, int picture = 0) const;
  /// Reads the pixels of a picture.
  Image read(int picture = 0) const;
  /// Frees a picture's texture and the GPU copies that only it uses.
  void forget(int picture);
  /// Waits until the GPU (or the driver's threads) has finished all drawing, for measurements.
  void finish() const;
  /// Statistics of the last drawing.
  const FrameStatistics& statistics() const;

  /// Whether a shader file on disk (HARIKO_SHADERS) changed since it was compiled.
  bool shaders_changed() const;
  /// Compiles the shaders again; keeps the old programs where that fails.
  Result<Done> reload();

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Description of the GL implementation for the about box and error reports: "OpenGL 4.5 (Mesa, llvmpipe)".
/// Needs a current context.
std::string describe_gl();

}  // namespace hariko
