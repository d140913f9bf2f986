#pragma once

// A context for tests that collects what the driver complains about.

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "render/offscreen.hpp"
#include "render/renderer.hpp"

namespace hariko::test {

class GlTest : public ::testing::Test {
 protected:
  void SetUp() override {
    Result<OffscreenContext> context = OffscreenContext::create();
    ASSERT_TRUE(context.ok()) << to_string(context.error());
    context_.emplace(std::move(context).value());
    if (epoxy_has_gl_extension("GL_KHR_debug")) {
      glEnable(GL_DEBUG_OUTPUT);
      glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
      glDebugMessageCallback(&GlTest::note, this);
    }
    Result<Renderer> renderer = Renderer::create();
    ASSERT_TRUE(renderer.ok()) << to_string(renderer.error());
    renderer_.emplace(std::move(renderer).value());
  }
  void TearDown() override {
    if (!context_) return;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    renderer_.reset();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    for (const std::string& complaint : complaints_) ADD_FAILURE() << complaint;
    if (epoxy_has_gl_extension("GL_KHR_debug")) glDebugMessageCallback(nullptr, nullptr);
  }
  Image draw(const Scene& scene, const Camera& camera, PixelSize size, int samples = 4) {
    const Result<Done> done = renderer_->draw(scene, camera, {size, samples});
    EXPECT_TRUE(done.ok()) << to_string(done.error());
    return renderer_->read();
  }

  std::optional<OffscreenContext> context_;
  std::optional<Renderer> renderer_;

 private:
  static void note(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text,
                   const void* self) {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
        severity == GL_DEBUG_SEVERITY_HIGH)
      const_cast<GlTest*>(static_cast<const GlTest*>(self))->complaints_.push_back(text);
  }
  std::vector<std::string> complaints_;
};

}  // namespace hariko::test
