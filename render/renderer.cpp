#include "render/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/assert.hpp"
#include "render/buffer_cache.hpp"
#include "render/draw_timer.hpp"
#include "render/element_colors.hpp"
#include "render/emphasis.hpp"
#include "render/frame_target.hpp"
#include "render/grid_plane.hpp"
#include "render/painter.hpp"
#include "render/picture_pass.hpp"
#include "render/shader_source.hpp"

namespace hariko {

namespace {

constexpr int least_gl_version = 33;
constexpr int vertex_stride = sizeof(DisplayVertex) / sizeof(float);
constexpr double comb_pixels = 60,
                 longest_comb_pixels = 140;  // typical and greatest length of teeth, design pixels

/// World length of an object's unit.
double scale_of_transform(const SceneObject& object) {
  return std::cbrt(std::abs(object.transform.topLeftCorner<3, 3>().determinant()));
}

}  // namespace

struct Renderer::State {
  struct MeshEntry {
    std::shared_ptr<const DisplayMesh::Curves> curves;  // the key; held so that its address stays unique
    std::unique_ptr<gl::MeshBuffers> buffers;
    unsigned used_by = 0;  // one bit for each picture
  };
  struct SectionEntry {
    std::shared_ptr<const DisplayMesh> mesh;
    LocalPlane plane;
    std::unique_ptr<gl::SectionBuffers> buffers;
    unsigned used_by = 0;  // one bit for each picture
  };

  gl::MeshBuffers& mesh_buffers(const DisplayMesh& mesh);
  gl::SectionBuffers& section_buffers(const std::shared_ptr<const DisplayMesh>& mesh,
                                      const LocalPlane& plane);
  void draw_curves(const gl::Frame& frame, const SceneObject& object, const gl::Style& style);
  void draw_marks(const gl::Frame& frame, const SceneObject& object, const gl::Style& style);
  void draw_combs(const gl::Frame& frame, const SceneObject& object, const gl::Style& style);
  void draw_facet_edges(const gl::Frame& frame, const SceneObject& object, const gl::Style& style);
  void draw_section(const gl::Frame& frame, const SceneObject& object, const SectionPlane& plane,
                    const gl::Style& style);
  void draw_tensions(const gl::Frame& frame, const SceneObject& object, const gl::PolyhedronBuffers& buffers,
                     const gl::Style& style, gl::Depth depth, float opacity);
  void draw_polyhedron(const gl::Frame& frame, const SceneObject& object, const gl::Style& style,
                       gl::Depth depth, float opacity);
  void draw_bodies(const gl::Frame& frame, const SceneObject& object, const gl::Style& style);
  void draw_overlays(const gl::Frame& frame, const Scene& scene, const gl::Style& style);
  void draw_scene_lines(const gl::Frame& frame, const Scene& scene);

  struct Picture {
    gl::FrameTarget target, kept, mask;
    gl::DrawTimer timer;
    Background background = Background::dark;
  };
  /// Releases the cached copies of pictures that are drawn anew or freed; copies without a user are dropped
  /// by `drop_unused`.
  void release(unsigned pictures);
  void drop_unused();

  bool draws = true;                     ///< false: there is no context
  std::unique_ptr<gl::Painter> painter;  ///< null before the first picture is drawn
  std::array<Picture, most_pictures> pictures;
  unsigned bit = 1;  ///< bit of the picture being drawn
  gl::IndexCache indices;
  std::vector<MeshEntry> meshes;
  gl::BufferCache<DisplayPolyhedron, gl::PolyhedronBuffers> polyhedra;
  gl::BufferCache<DisplayPolyhedron, gl::BodyBuffers> bodies;
  gl::BufferCache<EdgeMarks, gl::MarkBuffers> marks;
  gl::BufferCache<CombLines, gl::CombBuffers> combs;
  gl::BufferCache<FacetLines, gl::FacetLineBuffers> facet_edges;
  std::vector<SectionEntry> sections;
  gl::PicturePass references;
  FrameStatistics statistics;
  std::uint64_t stamp = shader_stamp();
};

/// GPU copy for the mesh and its refreshed versions, which share their curves and reuse one buffer.
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

gl::SectionBuffers& Renderer::State::section_buffers(const std::shared_ptr<const DisplayMesh>& mesh,
                                                     const LocalPlane& plane) {
  for (SectionEntry& entry : sections)
    if (entry.mesh == mesh && entry.plane == plane) {
      entry.used_by |= bit;
      return *entry.buffers;
    }
  sections.push_back(
      {mesh, plane, std::make_unique<gl::SectionBuffers>(*mesh, plane, statistics.uploaded_bytes), bit});
  return *sections.back().buffers;
}

void Renderer::State::release(unsigned pictures_released) {
  for (auto& entry : meshes) entry.used_by &= ~pictures_released;
  for (auto& entry : sections) entry.used_by &= ~pictures_released;
  polyhedra.release(pictures_released);
  bodies.release(pictures_released);
  marks.release(pictures_released);
  combs.release(pictures_released);
  facet_edges.release(pictures_released);
  references.release(pictures_released);
}

void Renderer::State::drop_unused() {
  std::erase_if(meshes, [](const auto& entry) { return entry.used_by == 0; });
  std::erase_if(sections, [](const auto& entry) { return entry.used_by == 0; });
  polyhedra.drop_unused();
  bodies.drop_unused();
  marks.drop_unused();
  combs.drop_unused();
  facet_edges.drop_unused();
  references.drop_unused();
}

void Renderer::State::draw_curves(const gl::Frame& frame, const SceneObject& object, const gl::Style& style) {
  const gl::MeshBuffers& mesh = mesh_buffers(*object.mesh);
  const Matrix4 model = gl::at_origin(object.transform, object.mesh->origin());
  const bool values = object.map == SurfaceMap::continuity && mesh.has_curve_values();
  const auto draw = [&](CurveKind kind, const gl::LineStyle& line, bool by_value) {
    gl::LineLook look;
    if (by_value)
      look.values = {scale_for(object.map, object.range, frame.colour_blind_safe), object.range,
                     undefined_color};
    painter->lines(frame, model,
                   {&mesh.vertices(), vertex_stride, mesh.curve_array(kind), mesh.curve_count(kind)}, line,
                   gl::Depth::visible, 1, look);
  };
  if (values || object.wire == PatchWire::borders)
    draw(CurveKind::split, values ? style.continuity : style.split, values);
  const gl::LineStyle& network = object.quiet_network              ? style.quiet_network
                                 : object.map == SurfaceMap::zebra ? style.zebra_network
                                                                   : style.network;
  if (values || object.show_network) draw(CurveKind::network, values ? style.continuity : network, values);
  if (values || object.show_network) {
    draw(CurveKind::boundary, style.boundary, false);
    draw(CurveKind::crease, style.crease, false);
  }
}

void Renderer::State::draw_marks(const gl::Frame& frame, const SceneObject& object, const gl::Style& style) {
  if (!object.marks) return;
  const gl::MeshBuffers& mesh = mesh_buffers(*object.mesh);
  const gl::MarkBuffers& buffers = marks.get(object.marks, bit, statistics.uploaded_bytes);
  const Matrix4 model = gl::at_origin(object.transform, object.mesh->origin());
  // The dash length in the object changes by powers of two, so that dashes keep their place on the curve
  // while the view turns and zooms.
  const double pixel = frame.camera.pixel_length(frame.size) * frame.pixel_scale / scale_of_transform(object);
  for (std::size_t k = style.marks.size(); k-- > 0;) {
    gl::LineLook look;
    const gl::Style::Dash& dash = style.mark_dashes[k];
    if (dash.length > 0) {
      look.dash = std::exp2(std::round(std::log2(static_cast<double>(dash.length) * pixel)));
      look.dash_share = static_cast<double>(dash.share);
    }
    painter->lines(frame, model, {&mesh.vertices(), vertex_stride, buffers.array(k), buffers.count(k)},
                   style.marks[k], gl::Depth::visible, 1, look);
  }
}

void Renderer::State::draw_combs(const gl::Frame& frame, const SceneObject& object, const gl::Style& style) {
  if (!object.combs || !(object.combs->typical > 0)) return;
  const gl::CombBuffers& buffers = combs.get(object.combs, bit, statistics.uploaded_bytes);
  const Matrix4 model = gl::at_origin(object.transform, object.combs->origin);
  gl::LineLook look;
  // Teeth keep their length on the screen at any zoom.
  const double pixel = frame.camera.pixel_length(frame.size) * frame.pixel_scale / scale_of_transform(object);
  look.amplitude =
      object.comb_scale * pixel *
      std::min(comb_pixels / object.combs->typical, longest_comb_pixels / object.combs->greatest);
  constexpr int stride = 6;
  const auto draw = [&](const gl::LineInstances& lines, const gl::LineStyle& line) {
    painter->lines(frame, model, {&buffers.teeth(), stride, lines.array(), lines.count()}, line,
                   gl::Depth::visible, 1, look);
  };
  draw(buffers.tooth_lines(), style.comb_tooth);
  draw(buffers.envelope(), style.comb_envelope);
}

void Renderer::State::draw_facet_edges(const gl::Frame& frame, const SceneObject& object,
                                       const gl::Style& style) {
  if (!object.facet_edges) return;
  const gl::FacetLineBuffers& buffers = facet_edges.get(object.facet_edges, bit, statistics.uploaded_bytes);
  gl::LineLook look;
  look.depth = object.facet_edges->depth;
  painter->lines(frame, gl::at_origin(object.transform, object.facet_edges->origin),
                 {&buffers.points(), 3, buffers.lines().array(), buffers.lines().count()}, style.facet_edge,
                 gl::Depth::visible, 1, look);
}

void Renderer::State::draw_section(const gl::Frame& frame, const SceneObject& object,
                                   const SectionPlane& plane, const gl::Style& style) {
  // Section plane relative to the mesh's origin: normal . (L x + t) = offset.
  const Matrix4 model = gl::at_origin(object.transform, object.mesh->origin());
  const Vector3 normal = model.topLeftCorner<3, 3>().transpose() * plane.normal;
  const double length = normal.norm(),
               offset = plane.offset - plane.normal.dot(Vector3(model.topRightCorner<3, 1>()));
  if (!(length > 0)) return;
  const gl::SectionBuffers& buffers = section_buffers(object.mesh, {normal / length, offset / length});
  painter->lines(frame, model, {&buffers.points(), 3, buffers.lines().array(), buffers.lines().count()},
                 style.section, gl::Depth::visible, 1);
}

void Renderer::State::draw_tensions(const gl::Frame& frame, const SceneObject& object,
                                    const gl::PolyhedronBuffers& buffers, const gl::Style& style,
                                    gl::Depth depth, float opacity) {
  if (!buffers.has_edge_tensions()) return;
  const Matrix4 model = gl::at_origin(object.transform, object.polyhedron->origin);
  gl::LineLook look;
  look.values = {ColorScale::diverging_safe, {0, 1}, {0, 0, 0, 0}};
  for (const EdgeKind kind : {EdgeKind::plain, EdgeKind::crease, EdgeKind::boundary})
    painter->lines(frame, model,
                   {&buffers.positions(), 3, buffers.edge_array(kind), buffers.edge_count(kind)},
                   kind == EdgeKind::plain ? style.tension : style.tension_on_line, depth, opacity, look);
}

void Renderer::State::draw_polyhedron(const gl::Frame& frame, const SceneObject& object,
                                      const gl::Style& style, gl::Depth depth, float opacity) {
  const gl::PolyhedronBuffers& buffers = polyhedra.get(object.polyhedron, bit, statistics.uploaded_bytes);
  const Matrix4 model = gl::at_origin(object.transform, object.polyhedron->origin);
  const auto edges = [&](EdgeKind kind, const gl::LineStyle& line) {
    painter->lines(frame, model,
                   {&buffers.positions(), 3, buffers.edge_array(kind), buffers.edge_count(kind)}, line, depth,
                   opacity);
  };
  if (object.show_polyhedron) {
    edges(EdgeKind::plain, style.polyhedron);
    edges(EdgeKind::boundary, style.boundary);
    edges(EdgeKind::crease, style.crease);
    if (object.show_tensions) draw_tensions(frame, object, buffers, style, depth, opacity);
  }
  const auto points = [&](const std::vector<Index>& vertices, const gl::PointStyle& point) {
    painter->some_points(frame, model, buffers, vertices, point, depth, opacity);
  };
  if (object.show_polyhedron && object.show_points)
    painter->points(frame, model, buffers, style.point, depth, opacity, object.show_tensions);
  if (object.show_polyhedron) {
    points(object.polyhedron->corners, style.corner);
    points(object.polyhedron->smooth, style.smooth);
    // Diamonds over nearly all vertices would hide the form, and tell nothing.
    if (object.show_points && !object.quiet_network) points(object.polyhedron->pinned, style.pinned);
  }
}

/// Draws bodies over the surface that encloses them; over a map's colours only their outlines are tinted.
void Renderer::State::draw_bodies(const gl::Frame& frame, const SceneObject& object, const gl::Style& style) {
  constexpr float faint = 0.45F;
  const gl::BodyBuffers& buffers = bodies.get(object.polyhedron, bit, statistics.uploaded_bytes);
  const bool colours_matter = object.show_surface && object.map != SurfaceMap::shaded;
  const gl::Style::Bodies& look = colours_matter ? style.bodies_over_map : style.bodies;
  const auto has = [](const std::vector<Index>& faces, Index f) {
    return std::binary_search(faces.begin(), faces.end(), f);
  };
  std::vector<Index> plain, hovered;
  for (Index f = 0; f < buffers.face_count(); ++f) {
    if (has(object.selected.faces, f)) continue;
    (has(object.hovered.faces, f) ? hovered : plain).push_back(f);
  }
  const Matrix4 model = gl::at_origin(object.transform, object.polyhedron->origin);
  const float opacity = object.faint_bodies ? faint : 1;
  painter->bodies(frame, model, buffers, plain, look.plain, opacity);
  painter->bodies(frame, model, buffers, hovered, look.hovered, opacity);
  painter->bodies(frame, model, buffers, object.selected.faces, look.selected, opacity);
}

void Renderer::State::draw_scene_lines(const gl::Frame& frame, const Scene& scene) {
  for (const SceneLines& one : scene.curves) {
    const gl::FacetLineBuffers& buffers = facet_edges.get(one.lines, bit, statistics.uploaded_bytes);
    gl::LineLook look;
    look.depth = one.lines->depth;
    painter->lines(frame, gl::at_origin(Matrix4::Identity(), one.lines->origin),
                   {&buffers.points(), 3, buffers.lines().array(), buffers.lines().count()},
                   {one.color, one.width}, gl::Depth::visible, 1, look);
  }
}

void Renderer::State::draw_overlays(const gl::Frame& frame, const Scene& scene, const gl::Style& style) {
  for (const SceneObject& object : scene.objects) {
    if (object.polyhedron && object.show_bodies) {
      painter->cut(frame, true);
      draw_bodies(frame, object, style);
      painter->cut(frame, false);
    }
    if (object.draws_surface()) {
      painter->cut(frame, true);
      draw_facet_edges(frame, object, style);
      draw_curves(frame, object, style);
      draw_marks(frame, object, style);
      draw_combs(frame, object, style);
      painter->cut(frame, false);
      if (scene.section) draw_section(frame, object, *scene.section, style);
    }
    if (!object.polyhedron) continue;
    const bool any = object.show_polyhedron || !object.selected.empty() || !object.hovered.empty() ||
                     !object.failed.empty();
    if (!any) continue;
    const Matrix4 model = gl::at_origin(object.transform, object.polyhedron->origin);
    painter->cut(frame, true);
    // Faces on the surface are tinted by the surface's own colours instead.
    if (!object.show_bodies && !object.elements_on_surface()) {
      painter->faces(frame, model, *object.polyhedron, object.selected.faces, style.selected_fill);
      painter->faces(frame, model, *object.polyhedron, object.hovered.faces, style.hovered_fill);
    }
    painter->faces(frame, model, *object.polyhedron, object.failed.faces, style.failed_fill);
    if (object.x_ray) draw_polyhedron(frame, object, style, gl::Depth::hidden, scene.hidden_opacity);
    draw_polyhedron(frame, object, style, gl::Depth::visible, 1);
    gl::draw_highlights(*painter, frame, object,
                        polyhedra.get(object.polyhedron, bit, statistics.uploaded_bytes),
                        object.draws_surface() ? &mesh_buffers(*object.mesh) : nullptr, style);
    painter->cut(frame, false);
  }
  draw_scene_lines(frame, scene);
  painter->overlay(frame, scene.lines);
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
  return Renderer(std::make_unique<State>());
}

Renderer Renderer::undrawn() {
  auto state = std::make_unique<State>();
  state->draws = false;
  return Renderer(std::move(state));
}

Result<Done> Renderer::draw(const Scene& scene, const Camera& camera, const DrawOptions& options) {
  State& s = *state_;
  HARIKO_ASSERT(s.draws, "nothing is drawn without a context");
  s.statistics = {};
  if (!s.painter)
    if (const Result<Done> made = reload(); !made) return made;
  s.painter->reset(&s.statistics);
  HARIKO_ASSERT(options.picture >= 0 && options.picture < most_pictures, "no such picture");
  State::Picture& picture = s.pictures[std::size_t(options.picture)];
  s.bit = 1U << static_cast<unsigned>(options.picture);
  if (Result<Done> sized = picture.target.resize(options.size, options.samples); !sized) return sized;
  const gl::Style style = gl::style_of(scene.background);
  Result<Done> drawn = scene.pictures.empty() ? Result<Done>(Done{}) : s.references.prepare();
  s.references.begin(options.upload_limit);
  const gl::Frame frame(scene, camera, options.size,
                        scene.world_box().merged(gl::box_of_pictures(scene, camera)));
  const auto draw_references = [&](PictureLayer layer) {
    s.references.draw(frame, scene, layer, s.bit, s.statistics);
  };
  picture.background = scene.background;
  s.release(s.bit);

  const auto measurement = picture.timer.start(options.timed, options.samples, s.statistics.time);
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
  s.painter->background(style, scene.background);
  draw_references(PictureLayer::behind);
  const bool backdrop = grid_place(camera, scene.grid).backdrop;
  if (scene.grid.visible && backdrop) s.painter->grid(frame, scene.grid, style);
  s.painter->cut(frame, true);
  for (const SceneObject& object : scene.objects) {
    if (!object.draws_surface()) continue;
    gl::MeshBuffers& buffers = s.mesh_buffers(*object.mesh);
    buffers.set_patch_colors(patch_color_bytes(object), s.statistics.uploaded_bytes);
    if (Result<Done> done = s.painter->surface(frame, object, buffers, scene, style); !done) drawn = done;
  }
  s.painter->cut(frame, false);
  draw_references(PictureLayer::space);
  if (scene.grid.visible && !backdrop) s.painter->grid(frame, scene.grid, style);
  s.draw_overlays(frame, scene, style);
  draw_references(PictureLayer::front);
  s.painter->overlay(frame, gl::picture_frames(scene, camera, style));
  if (gl::has_silhouettes(scene)) {
    const auto buffers_of = [&s](const DisplayMesh& mesh) -> const gl::MeshBuffers& {
      return s.mesh_buffers(mesh);
    };
    if (Result<Done> done =
            gl::draw_silhouettes(*s.painter, frame, scene, buffers_of, picture.mask, picture.target, style);
        !done)
      drawn = done;
  }

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
  return drawn;
}

unsigned Renderer::texture(int picture) const {
  return state_->pictures[std::size_t(picture)].target.texture();
}

bool Renderer::keep(int picture) {
  State::Picture& p = state_->pictures[std::size_t(picture)];
  const PixelSize size = p.target.size();
  if (!p.kept.resize(size, 1).ok()) return false;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, p.target.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, p.kept.framebuffer());
  glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return true;
}

unsigned Renderer::kept_texture(int picture) const {
  return state_->pictures[std::size_t(picture)].kept.texture();
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
  // Blended over transparent black, colours are multiplied by their alpha
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
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
  state_->painter = std::make_unique<gl::Painter>(std::move(painter).value());
  state_->references.forget_program();
  return Done{};
}

std::string describe_gl() {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value ? std::string(reinterpret_cast<const char*>(value)) : std::string("unknown");
  };
  return "OpenGL " + text(GL_VERSION) + " (" + text(GL_VENDOR) + ", " + text(GL_RENDERER) + ")";
}

}  // namespace hariko
