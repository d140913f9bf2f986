#pragma once

// FrameTarget: the framebuffers that a picture is drawn into and resolved to. Internal to render/.

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/gl_object.hpp"

namespace hariko::gl {

class FrameTarget {
 public:
  /// Makes the framebuffers fit; does nothing when they do. Errors: E_GL_FRAMEBUFFER.
  Result<Done> resize(PixelSize size, int samples);
  /// Binds for drawing, with the viewport set.
  void bind() const;
  /// After drawing: the picture is in texture().
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
