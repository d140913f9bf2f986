#include "render/painter.hpp"

#include <algorithm>
#include <cmath>

namespace hariko::gl {

namespace {

constexpr int coordinate_unit = 0, color_unit = 1, table_unit = 2;
// The ground is drawn this many view heights round the target.
constexpr double grid_reach = 6;

Texture color_texture(ColorScale scale) {
  Texture texture = Texture::make();
  const auto table = color_table(scale);
  glBindTexture(GL_TEXTURE_1D, texture.name());
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, table.data());
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_1D, 0);
  return texture;
}

void set_depth(Depth depth) {
  glEnable(GL_DEPTH_CLAMP);
  if (depth == Depth::any) {
    glDisable(GL_DEPTH_TEST);
    return;
  }
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDepthFunc(depth == Depth::visible ? GL_LEQUAL : GL_GREATER);
}

Color faded(Color color, float opacity) {
  color.a *= opacity;
  return color;
}

glm::vec2 range_uniform(const ValueRange& range) {
  const double extent = range.high - range.low;
  return {static_cast<float>(range.low), static_cast<float>(extent > 0 ? 1 / extent : 0)};
}

/// The modes of surface.frag.glsl.
std::size_t surface_mode(SurfaceMap map, bool with_values) {
  switch (map) {
    case SurfaceMap::shaded:
      return 0;
    case SurfaceMap::patches:
      return 1;
    case SurfaceMap::zebra:
      return 2;
    case SurfaceMap::continuity:
      return 4;
    default:
      return with_values ? 3 : 4;
  }
}

}  // namespace

Frame::Frame(const Scene& scene, const Camera& eye, PixelSize pixels, const Box3& box)
    : camera(eye),
      size(pixels),
      clip(eye.clip_range(box)),
      view(eye.view_matrix()),
      pixel_scale(scene.pixel_scale) {
  if (scene.grid.visible) {
    const double reach = grid_reach * camera.view_height() * std::max(1.0, size.aspect()) + camera.distance;
    clip.far_plane = std::max(clip.far_plane, reach);
    clip.near_plane = camera.orthographic
                          ? std::min(clip.near_plane, camera.distance - reach)
                          : std::min(std::max(clip.near_plane, clip.far_plane / 20'000),
                                     std::max(camera.distance * 0.05, clip.far_plane / 20'000));
  }
  projection = camera.projection_matrix(size, clip);
  pixel_bias = camera.orthographic ? camera.pixel_length(size) : camera.pixel_length(size) / camera.distance;
}

Matrix4 at_origin(const Matrix4& transform, const Vector3& origin) {
  Matrix4 out = transform;
  out.topRightCorner<3, 1>() += transform.topLeftCorner<3, 3>() * origin;
  return out;
}

Result<Painter> Painter::create() {
  Programs programs;
  const auto load = [](Program& program, const char* name, const std::string& defines) -> Result<Done> {
    Result<Program> loaded = Program::load(name, defines);
    if (!loaded) return loaded.error();
    program = std::move(loaded).value();
    return Done{};
  };
  for (const auto& [name, program] : {std::pair{"background", &programs.background},
                                      std::pair{"grid", &programs.grid}, std::pair{"line", &programs.line},
                                      std::pair{"point", &programs.point}, std::pair{"fill", &programs.fill}})
    if (Result<Done> done = load(*program, name, {}); !done) return done.error();
  for (std::size_t i = 0; i < programs.surface.size(); ++i) {
    const std::string defines =
        "#define MODE " + std::to_string(i / 2) + "\n#define HIGHLIGHTS " + std::to_string(i % 2) + "\n";
    if (Result<Done> done = load(programs.surface[i], "surface", defines); !done) return done.error();
  }
  return Painter(std::move(programs));
}

Painter::Painter(Programs programs)
    : programs_(std::move(programs)),
      diverging_(color_texture(ColorScale::diverging)),
      sequential_(color_texture(ColorScale::sequential)),
      empty_(VertexArray::make()),
      stream_lines_(VertexArray::make()),
      stream_points_(VertexArray::make()),
      stream_triangles_(VertexArray::make()),
      stream_(Buffer::make()) {
  glBindVertexArray(stream_lines_.name());
  set_up_line_instances(stream_.name(), 0);
  glBindVertexArray(stream_points_.name());
  glBindBuffer(GL_ARRAY_BUFFER, stream_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribIPointer(0, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t), nullptr);
  glVertexAttribDivisor(0, 1);
  glBindVertexArray(stream_triangles_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(float), nullptr);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Painter::upload_stream(std::size_t bytes, const void* data) {
  glBindBuffer(GL_ARRAY_BUFFER, stream_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Painter::count(std::size_t triangles) {
  if (!statistics_) return;
  ++statistics_->draw_calls;
  statistics_->triangles += triangles;
}

void Painter::set_frame(const Program& program, const Frame& frame, const Matrix4& model,
                        double bias_pixels) const {
  program.use();
  program.set("to_eye", to_float(Matrix4(frame.view * model)));
  program.set("projection", to_float(frame.projection));
  program.set("viewport", glm::vec2(frame.size.width, frame.size.height));
  program.set("perspective", !frame.camera.orthographic);
  // Lines are cut here and clamped in depth beyond: they may leave the range that surfaces need.
  program.set("near_plane", std::min(frame.clip.near_plane, 0.01 * frame.camera.distance));
  program.set("bias", bias_pixels * frame.pixel_scale * frame.pixel_bias);
}

void Painter::background(const Style& style, Background background) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  if (background == Background::transparent) return;
  programs_.background.use();
  programs_.background.set("top", rgb(style.top));
  programs_.background.set("bottom", rgb(style.bottom));
  glBindVertexArray(empty_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  count();
}

void Painter::grid(const Frame& frame, const GridSettings& grid, const Style& style) {
  const double height = frame.camera.view_height();
  // Fine lines between 1/100 and 1/10 of the view; they fade out as the view grows towards the next power.
  const double level = std::log10(height) - 1.35;
  const double power = std::floor(level);
  const double spacing = grid.spacing > 0 ? grid.spacing : std::pow(10.0, power);
  const double weight = grid.spacing > 0 ? 1 : 1 - (level - power);
  const Vector3& target = frame.camera.target;
  const double coarse = 10 * spacing;
  const Vector3 centre(std::round(target.x() / coarse) * coarse, std::round(target.y() / coarse) * coarse,
                       grid.height);
  Matrix4 model = Matrix4::Identity();
  model.topRightCorner<3, 1>() = centre;
  const Program& program = programs_.grid;
  set_frame(program, frame, model, 0);
  program.set("radius", grid_reach * height * std::max(1.0, frame.size.aspect()) * 0.5);
  program.set("spacing", spacing);
  program.set("fine_weight", weight);
  program.set("axes", glm::vec2(static_cast<float>(-centre.y()), static_cast<float>(-centre.x())));
  program.set("line_color", rgb(style.grid));
  program.set("x_color", rgb(style.axis_x));
  program.set("y_color", rgb(style.axis_y));
  program.set("strength", style.grid_strength);
  program.set("line_width", frame.pixel_scale);
  program.set("normal_in_eye", to_float(Vector3(frame.view.topLeftCorner<3, 3>() * Vector3::UnitZ())));
  glEnable(GL_BLEND);
  set_depth(Depth::visible);
  glBindVertexArray(empty_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  count();
}

void Painter::surface(const Frame& frame, const SceneObject& object, const MeshBuffers& mesh,
                      const ZebraSettings& zebra, const Style& style) {
  const Matrix4 model = at_origin(object.transform, object.mesh->origin());
  const Matrix3 rotation = frame.view.topLeftCorner<3, 3>();
  const Matrix3 linear = object.transform.topLeftCorner<3, 3>();
  const bool highlights = !object.selected_patches.empty() || !object.hovered_patches.empty();
  const std::size_t mode = surface_mode(object.map, object.mesh->has_values());
  const Program& program = programs_.surface[2 * mode + (highlights ? 1 : 0)];
  set_frame(program, frame, model, 0);
  program.set("pixel_slope", 2 * std::tan(frame.camera.field_of_view / 2) / frame.size.height);
  program.set("normal_to_eye",
              to_float(Matrix3(rotation * linear / std::cbrt(std::abs(linear.determinant())))));
  program.set("vertices_per_patch", static_cast<int>(object.mesh->vertices_per_patch()));
  program.set("outside_color", rgb(style.clay));
  program.set("inside_color", rgb(style.inside));
  program.set("undefined_color", rgb(style.undefined));
  program.set("up_in_eye", to_float(Vector3(rotation * Vector3::UnitZ())));
  program.set("range", range_uniform(object.range));
  const Vector3 direction = zebra.fixed ? Vector3(rotation * zebra.direction) : zebra.direction;
  program.set("stripe_direction",
              to_float(direction.norm() > 0 ? Vector3(direction.normalized()) : Vector3::UnitZ()));
  program.set("stripes", static_cast<float>(std::clamp(zebra.stripes, 2, 64)));
  program.set("reflection", zebra.reflection);
  program.set("dimming", object.dimmed ? style.dimming : 0.0F);
  program.set("selected_tint", rgb(style.selected_fill));
  program.set("hovered_tint", rgb(style.hovered_fill));
  program.set("patch_colors", color_unit);
  program.set("table", table_unit);
  mesh.patch_colors().bind_texture(color_unit);
  glActiveTexture(GL_TEXTURE0 + table_unit);
  glBindTexture(GL_TEXTURE_1D,
                scale_of(object.map) == ColorScale::diverging ? diverging_.name() : sequential_.name());
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_CLAMP);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glFrontFace(linear.determinant() < 0 ? GL_CW : GL_CCW);
  mesh.bind_vertex_array();
  glVertexAttrib2f(2, 0, 0);  // for meshes without values: undefined
  glDrawElements(GL_TRIANGLES, mesh.index_count(), GL_UNSIGNED_INT, nullptr);
  glFrontFace(GL_CCW);
  count(static_cast<std::size_t>(mesh.index_count() / 3));
}

void Painter::lines(const Frame& frame, const Matrix4& model, const Lines& lines, const LineStyle& style,
                    Depth depth, float opacity, const SceneObject* values_of) {
  if (lines.count == 0) return;
  const Program& program = programs_.line;
  const auto scale = static_cast<float>(frame.pixel_scale);
  const float core = 0.5F * style.width * scale, all = core + style.casing_width * scale;
  // Half the width lies above the curve's own depth on a slanted surface: a bias of a few widths clears
  // slopes up to about 75 degrees.
  set_frame(program, frame, model, 2.0 + 2.0 * (0.5 * style.width + style.casing_width));
  program.set("coordinates", coordinate_unit);
  program.set("table", table_unit);
  program.set("stride", lines.stride);
  program.set("half_width", all);
  program.set("core_width", core);
  program.set("paint", faded(style.paint, opacity));
  program.set("casing", faded(style.casing, opacity));
  program.set("by_value", lines.by_value && values_of);
  if (lines.by_value && values_of) {
    program.set("range", range_uniform(values_of->range));
    program.set("undefined_color", rgb(undefined_color));
    glActiveTexture(GL_TEXTURE0 + table_unit);
    glBindTexture(GL_TEXTURE_1D,
                  scale_of(values_of->map) == ColorScale::diverging ? diverging_.name() : sequential_.name());
  }
  lines.coordinates->bind_texture(coordinate_unit);
  glEnable(GL_BLEND);
  set_depth(depth);
  glBindVertexArray(lines.array);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines.count);
  count();
}

void Painter::some_edges(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
                         const PolyhedronBuffers& buffers, std::span<const Index> edges,
                         const LineStyle& style, Depth depth, float opacity) {
  std::vector<CurveSegment> segments;
  for (const Index e : edges)
    if (e < polyhedron.edges.size())
      segments.push_back(
          {{polyhedron.edges[e][0], polyhedron.edges[e][0], polyhedron.edges[e][1], polyhedron.edges[e][1]}});
  if (segments.empty()) return;
  upload_stream(segments.size() * sizeof(CurveSegment), segments.data());
  lines(frame, model,
        {&buffers.positions(), 3, stream_lines_.name(), static_cast<GLsizei>(segments.size()), false}, style,
        depth, opacity);
}

void Painter::draw_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                          const PointStyle& style, Depth depth, float opacity, GLsizei number,
                          bool numbered) {
  const Program& program = programs_.point;
  const auto scale = static_cast<float>(frame.pixel_scale);
  const float radius = 0.5F * style.diameter * scale;
  set_frame(program, frame, model, 3.0 + 2.0 * style.diameter);
  program.set("coordinates", coordinate_unit);
  program.set("stride", 3);
  program.set("radius", radius);
  program.set("core_radius", radius - style.outline * scale);
  program.set("paint", faded(style.paint, opacity));
  program.set("casing", faded(style.casing, opacity));
  program.set("numbered", numbered);
  buffers.positions().bind_texture(coordinate_unit);
  glEnable(GL_BLEND);
  set_depth(depth);
  glBindVertexArray(numbered ? stream_points_.name() : empty_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, number);
  count();
}

void Painter::points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                     const PointStyle& style, Depth depth, float opacity) {
  if (buffers.point_count() > 0)
    draw_points(frame, model, buffers, style, depth, opacity, buffers.point_count(), false);
}

void Painter::some_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                          std::span<const Index> vertices, const PointStyle& style, Depth depth,
                          float opacity) {
  std::vector<std::uint32_t> numbers;
  for (const Index v : vertices)
    if (v < static_cast<Index>(buffers.point_count())) numbers.push_back(v);
  if (numbers.empty()) return;
  upload_stream(numbers.size() * sizeof(std::uint32_t), numbers.data());
  draw_points(frame, model, buffers, style, depth, opacity, static_cast<GLsizei>(numbers.size()), true);
}

void Painter::faces(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
                    std::span<const Index> faces, const Color& paint) {
  std::vector<std::array<float, 3>> corners;
  for (const Index f : faces) {
    if (f >= polyhedron.face_count()) continue;
    const auto vertices = polyhedron.face(f);
    Vector3 centre = Vector3::Zero();
    for (const Index v : vertices) centre += polyhedron.position(v) / static_cast<double>(vertices.size());
    const std::array<float, 3> middle{static_cast<float>(centre.x()), static_cast<float>(centre.y()),
                                      static_cast<float>(centre.z())};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      corners.push_back(middle);
      corners.push_back(polyhedron.positions[vertices[i]]);
      corners.push_back(polyhedron.positions[vertices[(i + 1) % vertices.size()]]);
    }
  }
  if (corners.empty()) return;
  upload_stream(corners.size() * sizeof(corners[0]), corners.data());
  set_frame(programs_.fill, frame, model, 2.0);
  programs_.fill.set("paint", paint);
  glEnable(GL_BLEND);
  set_depth(Depth::visible);
  glBindVertexArray(stream_triangles_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
  count(corners.size() / 3);
}

void Painter::overlay(const Frame& frame, std::span<const OverlayLine> overlay_lines) {
  if (overlay_lines.empty()) return;
  // Relative to the target, so that world coordinates far from zero keep their digits.
  std::vector<std::array<float, 3>> ends;
  for (const OverlayLine& line : overlay_lines)
    for (const Vector3& end :
         {Vector3(line.begin - frame.camera.target), Vector3(line.end - frame.camera.target)})
      ends.push_back({static_cast<float>(end.x()), static_cast<float>(end.y()), static_cast<float>(end.z())});
  overlay_points_.allocate(ends.size() * sizeof(ends[0]), ends.data(), GL_R32F, GL_STREAM_DRAW);
  Matrix4 model = Matrix4::Identity();
  model.topRightCorner<3, 1>() = frame.camera.target;
  for (std::size_t i = 0; i < overlay_lines.size(); ++i) {
    const auto a = static_cast<Index>(2 * i), b = a + 1;
    const CurveSegment segment{{a, a, b, b}};
    upload_stream(sizeof(segment), &segment);
    const LineStyle style{overlay_lines[i].color, overlay_lines[i].width, {}, 0};
    lines(frame, model, {&overlay_points_, 3, stream_lines_.name(), 1, false}, style,
          overlay_lines[i].on_top ? Depth::any : Depth::visible, 1);
  }
}

}  // namespace hariko::gl
