#pragma once

// Program: a linked pair of shaders with uniforms by name. Internal to render/.

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/color_map.hpp"
#include "render/gl_object.hpp"

namespace hariko::gl {

/// GL program.
class Program {
 public:
  /// Compiles shaders/<name>.vert.glsl and <name>.frag.glsl, preceded by `defines` (whole lines). Errors:
  /// E_SHADER_SOURCE, E_GL_SHADER with the compiler's log.
  static Result<Program> load(const std::string& name, const std::string& defines = {});

  /// Makes the program current.
  void use() const { glUseProgram(name_.name()); }
  // Uniforms of the program in use. Names that the compiler removed are ignored.
  void set(std::string_view uniform, int value) const { glUniform1i(location(uniform), value); }
  void set(std::string_view uniform, bool value) const { glUniform1i(location(uniform), value ? 1 : 0); }
  void set(std::string_view uniform, float value) const { glUniform1f(location(uniform), value); }
  void set(std::string_view uniform, double value) const { set(uniform, static_cast<float>(value)); }
  void set(std::string_view uniform, const glm::vec2& v) const { glUniform2f(location(uniform), v.x, v.y); }
  void set(std::string_view uniform, const glm::vec3& v) const {
    glUniform3f(location(uniform), v.x, v.y, v.z);
  }
  void set(std::string_view uniform, const glm::vec4& v) const {
    glUniform4f(location(uniform), v.x, v.y, v.z, v.w);
  }
  void set(std::string_view uniform, const Color& c) const { set(uniform, glm::vec4(c.r, c.g, c.b, c.a)); }
  void set(std::string_view uniform, const glm::mat3& m) const;
  void set(std::string_view uniform, const glm::mat4& m) const;

 private:
  GLint location(std::string_view uniform) const;
  ProgramName name_;
  std::map<std::string, GLint, std::less<>> locations_;
};

/// Conversion from double precision to the GPU's floats.
glm::mat4 to_float(const Matrix4& m);
glm::mat3 to_float(const Matrix3& m);
inline glm::vec3 to_float(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}
/// Colour without alpha.
inline glm::vec3 rgb(const Color& c) {
  return {c.r, c.g, c.b};
}

}  // namespace hariko::gl
