#pragma once

// PicturePass: draws the reference pictures of a scene. Internal to render/.

#include "render/buffer_cache.hpp"
#include "render/gl_object.hpp"
#include "render/painter.hpp"
#include "render/program.hpp"
#include "render/scene.hpp"

namespace hariko::gl {

/// A texture that is filled from its smallest level on: it shows from the beginning, and sharper frame by
/// frame.
class PictureTexture {
 public:
  PictureTexture(const ReferenceImage& image, std::size_t& uploaded);
  /// Uploads at most about `budget` bytes, which goes down by them. True when nothing is left.
  bool fill(const ReferenceImage& image, std::size_t& budget, std::size_t& uploaded);
  GLuint name() const { return texture_.name(); }

 private:
  Texture texture_;
  int first_ = 0;  ///< the level of the image that is the texture's largest
  int next_ = -1;  ///< the level of the image that is filled now; below `first_`: all are
  int row_ = 0;    ///< of that level
};

class PicturePass {
 public:
  /// Compiles its program where it has none yet. Errors: E_GL_SHADER.
  Result<Done> prepare();
  /// The pictures of one layer, the farthest first. Those that share an image share a texture.
  void draw(const Frame& frame, const Scene& scene, PictureLayer layer, unsigned picture_bit,
            FrameStatistics& statistics);
  /// Sets the bytes that one drawing may upload from here on.
  void begin(std::size_t budget) { budget_ = budget; }
  void release(unsigned picture_bits) { textures_.release(picture_bits); }
  void drop_unused() { textures_.drop_unused(); }
  void forget_program() { program_.reset(); }

 private:
  std::optional<Program> program_;
  VertexArray empty_;
  BufferCache<ReferenceImage, PictureTexture> textures_;
  std::size_t budget_ = 0;
};

/// Lines round pictures that are chosen, pointed at, or not there.
std::vector<OverlayLine> picture_frames(const Scene& scene, const Camera& camera, const Style& style);

/// Box of the pictures that lie among the surfaces and that the camera sees.
Box3 box_of_pictures(const Scene& scene, const Camera& camera);

}  // namespace hariko::gl
