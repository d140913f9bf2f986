#pragma once

// FrameTarget: multisampled framebuffer for drawing and its resolved texture. Internal to render/.

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/gl_object.hpp"

namespace hariko::gl {

/// Framebuffers of one picture.
class FrameTarget {
 public:
  /// Allocates the framebuffers unless they have the size already. Errors: E_GL_FRAMEBUFFER.
  Result<Done> resize(PixelSize size, int samples);
  /// Binds the framebuffer for drawing and sets the viewport.
  void bind() const;
  /// Resolves the samples after drawing; the picture is then in texture().
  void resolve() const;

  GLuint texture() const { return texture_.name(); }
  GLuint framebuffer() const { return plain_.name(); }
  PixelSize size() const { return size_; }

 private:
  PixelSize size_{0, 0};
  int samples_ = 0;
  Texture texture_;
  Renderbuffer color_, depth_;
  Framebuffer plain_, multisampled_;
};

}  // namespace hariko::gl
