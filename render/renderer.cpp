#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "core/base/assert.hpp"
#include "render/frame_target.hpp"
#include "render/painter.hpp"
#include "render/shader_source.hpp"

namespace hariko {

namespace {

constexpr int least_gl_version = 33;

/// Colour of a patch: hues far apart for neighbouring numbers (golden angle), a lighter and a darker one in
/// turn within the patches of one source element.
std::array<std::uint8_t, 3> patch_color(std::uint64_t element, std::uint32_t side) {
  const double turn = 0.6180339887498949 * static_cast<double>(element % 100'000);
  const double hue = 6 * (turn - std::floor(turn));
  const double value = side % 2 == 0 ? 0.80 : 0.70, saturation = 0.42;
  std::array<std::uint8_t, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double k = std::fmod(5.0 - 2.0 * static_cast<double>(i) + hue, 6.0);
    const double level = value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    out[i] = static_cast<std::uint8_t>(std::lround(255 * level));
  }
  return out;
}

std::vector<std::uint8_t> patch_color_bytes(const SceneObject& object) {
  const DisplayMesh& mesh = *object.mesh;
  std::vector<std::uint8_t> out(std::size_t(mesh.patch_count()) * 4, 0);
  if (object.map == SurfaceMap::patches)
    for (Index p = 0; p < mesh.patch_count(); ++p) {
      const Provenance& from = mesh.provenance(p);
      const auto color = patch_color(from.element.id, from.side);
      std::copy(color.begin(), color.end(), out.begin() + static_cast<std::ptrdiff_t>(4 * std::size_t(p)));
    }
  for (const Index p : object.hovered_patches)
    if (p < mesh.patch_count()) out[4 * std::size_t(p) + 3] = 128;
  for (const Index p : object.selected_patches)
    if (p < mesh.patch_count()) out[4 * std::size_t(p) + 3] = 255;
  return out;
}

}  // namespace

struct Renderer::State {
  explicit State(gl::Painter p) : painter(std::move(p)), stamp(shader_stamp()) {}

  struct MeshEntry {
    std::shared_ptr<const DisplayMesh::Curves> curves;  // the key; kept so that its address stays unique
    std::unique_ptr<gl::MeshBuffers> buffers;
    unsigned used_by = 0;  // one bit for each picture
  };
  struct PolyhedronEntry {
    std::shared_ptr<const DisplayPolyhedron> polyhedron;
    std::unique_ptr<gl::PolyhedronBuffers> buffers;
    unsigned used_by = 0;  // one bit for each picture
  };

  gl::MeshBuffers& mesh_buffers(const DisplayMesh& mesh);
  gl::PolyhedronBuffers& polyhedron_buffers(const std::shared_ptr<const DisplayPolyhedron>& polyhedron);
  void draw_curves(const gl::Frame& frame, const SceneObject& object, const gl::Style& style);
  void draw_polyhedron(const gl::Frame& frame, const SceneObject& object, const gl::Style& style,
                       gl::Depth depth, float opacity);
  void draw_overlays(const gl::Frame& frame, const Scene& scene, const gl::Style& style);

  struct Picture {
    gl::FrameTarget target;
    Background background = Background::dark;
  };
  /// Says that the picture in `bit` is drawn anew or goes: what it used and no other does is dropped at
  /// `drop_unused`.
  void release(unsigned pictures);
  void drop_unused();

  gl::Painter painter;
  std::array<Picture, most_pictures> pictures;
  unsigned bit = 1;  ///< of the picture that is drawn
  gl::IndexCache indices;
  std::vector<MeshEntry> meshes;
  std::vector<PolyhedronEntry> polyhedra;
  FrameStatistics statistics;
  std::uint64_t stamp = 0;
};

/// The entry of the mesh's family: refreshed versions share their curves, so they follow each other in one
/// buffer.
gl::MeshBuffers& Renderer::State::mesh_buffers(const DisplayMesh& mesh) {
  for (MeshEntry& entry : meshes)
    if (entry.curves == mesh.curves()) {
      entry.used_by |= bit;
      entry.buffers->update(mesh, statistics.uploaded_bytes);
      return *entry.buffers;
    }
  meshes.push_back(
      {mesh.curves(), std::make_unique<gl::MeshBuffers>(mesh, indices, statistics.uploaded_bytes), bit});
  return *meshes.back().buffers;
}

gl::PolyhedronBuffers& Renderer::State::polyhedron_buffers(
    const std::shared_ptr<const DisplayPolyhedron>& polyhedron) {
  for (PolyhedronEntry& entry : polyhedra)
    if (entry.polyhedron == polyhedron) {
      entry.used_by |= bit;
      return *entry.buffers;
    }
  polyhedra.push_back(
      {polyhedron, std::make_unique<gl::PolyhedronBuffers>(*polyhedron, statistics.uploaded_bytes), bit});
  return *polyhedra.back().buffers;
}

void Renderer::State::release(unsigned pictures_released) {
  for (auto& entry : meshes) entry.used_by &= ~pictures_released;
  for (auto& entry : polyhedra) entry.used_by &= ~pictures_released;
}

void Renderer::State::drop_unused() {
  std::erase_if(meshes, [](const auto& entry) { return entry.used_by == 0; });
  std::erase_if(polyhedra, [](const auto& entry) { return entry.used_by == 0; });
}

void Renderer::State::draw_curves(const gl::Frame& frame, const SceneObject& object, const gl::Style& style) {
  const gl::MeshBuffers& mesh = mesh_buffers(*object.mesh);
  const Matrix4 model = gl::at_origin(object.transform, object.mesh->origin());
  const bool values = object.map == SurfaceMap::continuity && mesh.has_curve_values();
  const auto draw = [&](CurveKind kind, const gl::LineStyle& line, bool by_value) {
    painter.lines(frame, model,
                  {&mesh.vertices(), int(sizeof(DisplayVertex) / sizeof(float)), mesh.curve_array(kind),
                   mesh.curve_count(kind), by_value},
                  line, gl::Depth::visible, 1, by_value ? &object : nullptr);
  };
  if (values || object.show_split_edges)
    draw(CurveKind::split, values ? style.continuity : style.split, values);
  const gl::LineStyle& network = object.map == SurfaceMap::zebra ? style.zebra_network : style.network;
  if (values || object.show_network) draw(CurveKind::network, values ? style.continuity : network, values);
  if (values || object.show_network) {
    draw(CurveKind::boundary, style.boundary, false);
    draw(CurveKind::crease, style.crease, false);
  }
}

void Renderer::State::draw_polyhedron(const gl::Frame& frame, const SceneObject& object,
                                      const gl::Style& style, gl::Depth depth, float opacity) {
  const gl::PolyhedronBuffers& buffers = polyhedron_buffers(object.polyhedron);
  const Matrix4 model = gl::at_origin(object.transform, object.polyhedron->origin);
  const auto edges = [&](EdgeKind kind, const gl::LineStyle& line) {
    painter.lines(frame, model,
                  {&buffers.positions(), 3, buffers.edge_array(kind), buffers.edge_count(kind), false}, line,
                  depth, opacity);
  };
  const auto some = [&](const Highlights& elements, const gl::LineStyle& line) {
    painter.some_edges(frame, model, *object.polyhedron, buffers, elements.edges, line, depth, opacity);
  };
  if (object.show_polyhedron) {
    edges(EdgeKind::plain, style.polyhedron);
    edges(EdgeKind::boundary, style.boundary);
    edges(EdgeKind::crease, style.crease);
  }
  some(object.selected, style.selected_edge);
  some(object.hovered, style.hovered_edge);
  if (object.show_polyhedron && object.show_points)
    painter.points(frame, model, buffers, style.point, depth, opacity);
  painter.some_points(frame, model, buffers, object.selected.vertices, style.selected_point, depth, opacity);
  painter.some_points(frame, model, buffers, object.hovered.vertices, style.hovered_point, depth, opacity);
}

void Renderer::State::draw_overlays(const gl::Frame& frame, const Scene& scene, const gl::Style& style) {
  for (const SceneObject& object : scene.objects) {
    if (object.mesh && object.show_surface && object.mesh->patch_count() > 0)
      draw_curves(frame, object, style);
    if (!object.polyhedron) continue;
    const bool any = object.show_polyhedron || !object.selected.empty() || !object.hovered.empty();
    if (!any) continue;
    const Matrix4 model = gl::at_origin(object.transform, object.polyhedron->origin);
    painter.faces(frame, model, *object.polyhedron, object.selected.faces, style.selected_fill);
    painter.faces(frame, model, *object.polyhedron, object.hovered.faces, style.hovered_fill);
    if (object.x_ray) draw_polyhedron(frame, object, style, gl::Depth::hidden, style.hidden);
    draw_polyhedron(frame, object, style, gl::Depth::visible, 1);
  }
  painter.overlay(frame, scene.lines);
}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create() {
  const int version = epoxy_gl_version();
  if (!epoxy_is_desktop_gl() || version < least_gl_version)
    return make_error(e_gl_version,
                      "This program needs OpenGL 3.3; the graphics driver offers " + describe_gl() + ".",
                      "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1.");
  Result<gl::Painter> painter = gl::Painter::create();
  if (!painter) return painter.error();
  return Renderer(std::make_unique<State>(std::move(painter).value()));
}

Result<Done> Renderer::draw(const Scene& scene, const Camera& camera, const FrameOptions& options) {
  State& s = *state_;
  s.statistics = {};
  s.painter.reset(&s.statistics);
  HARIKO_ASSERT(options.picture >= 0 && options.picture < most_pictures, "no such picture");
  State::Picture& picture = s.pictures[std::size_t(options.picture)];
  s.bit = 1U << static_cast<unsigned>(options.picture);
  if (Result<Done> sized = picture.target.resize(options.size, options.samples); !sized) return sized;
  const gl::Style style = gl::style_of(scene.background);
  const gl::Frame frame(scene, camera, options.size, scene.world_box());
  picture.background = scene.background;
  s.release(s.bit);

  picture.target.bind();
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBlendEquation(GL_FUNC_ADD);
  s.painter.background(style, scene.background);
  for (const SceneObject& object : scene.objects) {
    if (!object.mesh || !object.show_surface || object.mesh->patch_count() == 0) continue;
    gl::MeshBuffers& buffers = s.mesh_buffers(*object.mesh);
    buffers.set_patch_colors(patch_color_bytes(object), s.statistics.uploaded_bytes);
    s.painter.surface(frame, object, buffers, scene.zebra, style);
  }
  if (scene.grid.visible) s.painter.grid(frame, scene.grid, style);
  s.draw_overlays(frame, scene, style);

  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_DEPTH_CLAMP);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glActiveTexture(GL_TEXTURE0);
  picture.target.resolve();
  s.drop_unused();
  return Done{};
}

unsigned Renderer::texture(int picture) const {
  return state_->pictures[std::size_t(picture)].target.texture();
}

void Renderer::forget(int picture) {
  state_->pictures[std::size_t(picture)] = {};
  state_->release(1U << static_cast<unsigned>(picture));
  state_->drop_unused();
}

void Renderer::finish() const {
  glFinish();
}

void Renderer::blit_to_window(int x, int y, int picture) const {
  const gl::FrameTarget& target = state_->pictures[std::size_t(picture)].target;
  const PixelSize size = target.size();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, size.width, size.height, x, y, x + size.width, y + size.height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Image Renderer::read(int picture) const {
  const gl::FrameTarget& target = state_->pictures[std::size_t(picture)].target;
  const PixelSize size = target.size();
  Image image(size.width, size.height);
  if (image.rgba.empty()) return image;
  std::vector<std::uint8_t> upward(image.rgba.size());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const std::size_t row = std::size_t(size.width) * 4;
  for (int y = 0; y < size.height; ++y)
    std::copy_n(upward.begin() + static_cast<std::ptrdiff_t>(std::size_t(size.height - 1 - y) * row), row,
                image.pixel(0, y));
  if (state_->pictures[std::size_t(picture)].background != Background::transparent) return image;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {  // blended over nothing, colours carry their alpha
    const unsigned alpha = image.rgba[i + 3];
    for (std::size_t c = 0; c < 3 && alpha > 0; ++c)
      image.rgba[i + c] =
          static_cast<std::uint8_t>(std::min(255U, (image.rgba[i + c] * 255U + alpha / 2) / alpha));
  }
  return image;
}

const FrameStatistics& Renderer::statistics() const {
  return state_->statistics;
}

bool Renderer::shaders_changed() const {
  return shader_stamp() != state_->stamp;
}

Result<Done> Renderer::reload() {
  state_->stamp = shader_stamp();
  Result<gl::Painter> painter = gl::Painter::create();
  if (!painter) return painter.error();
  state_->painter = std::move(painter).value();
  return Done{};
}

std::string describe_gl() {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value ? std::string(reinterpret_cast<const char*>(value)) : std::string("unknown");
  };
  return "OpenGL " + text(GL_VERSION) + " (" + text(GL_RENDERER) + ")";
}

}  // namespace hariko
