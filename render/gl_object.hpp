#pragma once

// Owners of GL objects: created by `make`, deleted on destruction; movable. Internal to render/.

#include <epoxy/gl.h>

#include <cstddef>
#include <utility>

namespace hariko::gl {

/// Owner of a GL name. Traits has create(GLuint&) and destroy(GLuint).
template <class Traits>
class Object {
 public:
  Object() = default;
  /// Creates a GL object; the default constructor creates none.
  static Object make() {
    Object object;
    Traits::create(object.name_);
    return object;
  }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Object() {
    if (name_) Traits::destroy(name_);
  }
  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

/// Creation and deletion of buffers; likewise the traits below for their kinds of objects.
struct BufferTraits {
  static void create(GLuint& name) { glGenBuffers(1, &name); }
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayTraits {
  static void create(GLuint& name) { glGenVertexArrays(1, &name); }
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureTraits {
  static void create(GLuint& name) { glGenTextures(1, &name); }
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct RenderbufferTraits {
  static void create(GLuint& name) { glGenRenderbuffers(1, &name); }
  static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct FramebufferTraits {
  static void create(GLuint& name) { glGenFramebuffers(1, &name); }
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct ProgramTraits {
  static void create(GLuint& name) { name = glCreateProgram(); }
  static void destroy(GLuint name) { glDeleteProgram(name); }
};
struct QueryTraits {
  static void create(GLuint& name) { glGenQueries(1, &name); }
  static void destroy(GLuint name) { glDeleteQueries(1, &name); }
};

using Buffer = Object<BufferTraits>;
using VertexArray = Object<VertexArrayTraits>;
using Texture = Object<TextureTraits>;
using Renderbuffer = Object<RenderbufferTraits>;
using Framebuffer = Object<FramebufferTraits>;
using ProgramName = Object<ProgramTraits>;
using Query = Object<QueryTraits>;

/// Offset into a bound buffer, as GL takes it.
inline const void* byte_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace hariko::gl
