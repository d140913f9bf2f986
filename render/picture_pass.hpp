#pragma once

// PicturePass: drawing of a scene's reference pictures. Internal to render/.

#include "render/buffer_cache.hpp"
#include "render/gl_object.hpp"
#include "render/painter.hpp"
#include "render/program.hpp"
#include "render/scene.hpp"

namespace hariko::gl {

/// Texture that is filled from its smallest mipmap level on, so that it shows at once and becomes sharper
/// from frame to frame.
class PictureTexture {
 public:
  PictureTexture(const ReferenceImage& image, std::size_t& uploaded);
  /// Uploads about `budget` bytes at most and reduces it by them. True when everything is uploaded.
  bool fill(const ReferenceImage& image, std::size_t& budget, std::size_t& uploaded);
  GLuint name() const { return texture_.name(); }

 private:
  Texture texture_;
  int first_ = 0;  ///< image level that is the texture's largest
  int next_ = -1;  ///< image level being filled; below `first_` all are filled
  int row_ = 0;    ///< next row of that level
};

/// Program and textures of reference pictures.
class PicturePass {
 public:
  /// Compiles the program unless that is done. Errors: E_GL_SHADER.
  Result<Done> prepare();
  /// Draws the pictures of one layer, farthest first. Pictures with the same image share a texture.
  void draw(const Frame& frame, const Scene& scene, PictureLayer layer, unsigned picture_bit,
            FrameStatistics& statistics);
  /// Sets the number of bytes that the next drawing may upload.
  void begin(std::size_t budget) { budget_ = budget; }
  /// Removes the marks of pictures from their textures.
  void release(unsigned picture_bits) { textures_.release(picture_bits); }
  void drop_unused() { textures_.drop_unused(); }
  /// Frees the program, to be compiled again.
  void forget_program() { program_.reset(); }

 private:
  std::optional<Program> program_;
  VertexArray empty_;
  BufferCache<ReferenceImage, PictureTexture> textures_;
  std::size_t budget_ = 0;
};

/// Frames round pictures that are selected, hovered or missing.
std::vector<OverlayLine> picture_frames(const Scene& scene, const Camera& camera, const Style& style);

/// Bounding box of the pictures among the surfaces that the camera sees.
Box3 box_of_pictures(const Scene& scene, const Camera& camera);

}  // namespace hariko::gl
