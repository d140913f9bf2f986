#include "render/program.hpp"

#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "render/renderer.hpp"
#include "render/shader_source.hpp"

namespace hariko::gl {

namespace {

/// Owner of a shader stage, which is deleted on every path.
class Stage {
 public:
  explicit Stage(GLenum type) : name_(glCreateShader(type)) {}
  ~Stage() { glDeleteShader(name_); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

Message shader_error(const std::string& what, const std::string& log) {
  return make_error(e_gl_shader, "The graphics driver rejected the " + what + " shader: " + log,
                    "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1.");
}

Result<Done> compile(const Stage& stage, const std::string& file, const std::string& before) {
  const Result<std::string> source = shader_source(file);
  if (!source) return source.error();
  const std::string text = "#version 330 core\n" + before + "#line 1\n" + *source;
  const char* pointer = text.c_str();
  glShaderSource(stage.name(), 1, &pointer, nullptr);
  glCompileShader(stage.name());
  GLint good = 0;
  glGetShaderiv(stage.name(), GL_COMPILE_STATUS, &good);
  if (good) return Done{};
  std::array<char, 2000> log{};
  glGetShaderInfoLog(stage.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  return shader_error(file, log.data());
}

}  // namespace

Result<Program> Program::load(const std::string& name, const std::string& defines) {
  const Stage vertex(GL_VERTEX_SHADER), fragment(GL_FRAGMENT_SHADER);
  const Result<std::string> common = shader_source("common.glsl");  // for fragment shaders
  if (!common) return common.error();
  if (Result<Done> done = compile(vertex, name + ".vert.glsl", defines); !done) return done.error();
  if (Result<Done> done = compile(fragment, name + ".frag.glsl", defines + *common); !done)
    return done.error();
  Program program;
  program.name_ = ProgramName::make();
  const GLuint id = program.name_.name();
  glAttachShader(id, vertex.name());
  glAttachShader(id, fragment.name());
  glLinkProgram(id);
  glDetachShader(id, vertex.name());
  glDetachShader(id, fragment.name());
  GLint good = 0;
  glGetProgramiv(id, GL_LINK_STATUS, &good);
  std::array<char, 2000> log{};
  if (!good) {
    glGetProgramInfoLog(id, static_cast<GLsizei>(log.size()), nullptr, log.data());
    return shader_error(name, log.data());
  }
  GLint count = 0;
  glGetProgramiv(id, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(id, static_cast<GLuint>(i), static_cast<GLsizei>(log.size()), nullptr, &size, &type,
                       log.data());
    program.locations_[log.data()] = glGetUniformLocation(id, log.data());
  }
  return program;
}

GLint Program::location(std::string_view uniform) const {
  const auto found = locations_.find(uniform);
  return found == locations_.end() ? -1 : found->second;
}

void Program::set(std::string_view uniform, const glm::mat3& m) const {
  glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(m));
}
void Program::set(std::string_view uniform, const glm::mat4& m) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(m));
}

glm::mat4 to_float(const Matrix4& m) {
  glm::mat4 out;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) out[c][r] = static_cast<float>(m(r, c));
  return out;
}

glm::mat3 to_float(const Matrix3& m) {
  glm::mat3 out;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) out[c][r] = static_cast<float>(m(r, c));
  return out;
}

}  // namespace hariko::gl
