#include "render/frame_target.hpp"

#include <algorithm>
#include <string>

#include "render/renderer.hpp"

namespace hariko::gl {

Result<Done> FrameTarget::resize(PixelSize size, int samples) {
  GLint most_samples = 1, most_pixels = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most_pixels);
  samples = std::clamp(samples, 1, std::max(1, most_samples));
  if (size == size_ && samples == samples_) return Done{};
  const auto failed = [&](const std::string& why) {
    *this = FrameTarget();
    return make_error(e_gl_framebuffer,
                      "A picture of " + std::to_string(size.width) + " by " + std::to_string(size.height) +
                          " pixels cannot be drawn: " + why + ".",
                      "Use a smaller window or picture.");
  };
  if (size.width < 1 || size.height < 1) return failed("it has no pixels");
  if (std::max(size.width, size.height) > most_pixels)
    return failed("the graphics driver offers at most " + std::to_string(most_pixels) + " a side");
  while (glGetError() != GL_NO_ERROR) {
  }
  texture_ = Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  plain_ = Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  depth_ = Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  if (samples > 1) {
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, size.width, size.height);
    color_ = Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, color_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, size.width, size.height);
    multisampled_ = Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.name());
  } else {
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    color_ = Renderbuffer();
    multisampled_ = Framebuffer();
  }
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!complete || glGetError() != GL_NO_ERROR) return failed("the graphics driver refused the memory");
  size_ = size;
  samples_ = samples;
  return Done{};
}

void FrameTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, multisampled_ ? multisampled_.name() : plain_.name());
  glViewport(0, 0, size_.width, size_.height);
}

void FrameTarget::resolve() const {
  if (multisampled_) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.name());
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace hariko::gl
