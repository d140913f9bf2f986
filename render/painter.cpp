#include "render/painter.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "render/grid_plane.hpp"

namespace hariko::gl {

namespace {

constexpr int coordinate_unit = 0, color_unit = 1, table_unit = 2, place_unit = 3;
// Radius of the ground grid round the target, in view heights.
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

glm::vec4 range_uniform(ColorScale scale, const ValueRange& range) {
  const ScaleSlopes s = scale_slopes(scale, range);
  return {s.pivot, s.place, s.below, s.above};
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
  colour_blind_safe = scene.colour_blind_safe;
  if (scene.section) {
    has_section = true;
    const Vector3 normal = view.topLeftCorner<3, 3>() * scene.section->normal;
    const double offset = scene.section->offset + normal.dot(Vector3(view.topRightCorner<3, 1>()));
    section = glm::vec4(-to_float(normal), static_cast<float>(offset));
  }
  pixel_bias = camera.orthographic
                   ? camera.pixel_length(size)
                   : camera.pixel_length(size) / camera.distance * std::hypot(1.0, camera.middle_slope());
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
  const auto line_defines = [](int dashed, int comb) {
    return "#define DASHED " + std::to_string(dashed) + "\n#define COMB " + std::to_string(comb) + "\n";
  };
  const std::string plain = plain_surface_defines();
  const std::array<std::tuple<Program*, const char*, std::string>, 11> all{
      {{&programs.background, "background", {}},
       {&programs.grid, "grid", {}},
       {&programs.line, "line", line_defines(0, 0)},
       {&programs.dashed_line, "line", line_defines(1, 0)},
       {&programs.comb_line, "line", line_defines(0, 1)},
       {&programs.point, "point", "#define COLORED 0\n"},
       {&programs.colored_point, "point", "#define COLORED 1\n"},
       {&programs.fill, "fill", {}},
       {&programs.body, "body", {}},
       {&programs.silhouette, "silhouette", {}},
       {&programs.surface[plain], "surface", plain}}};
  for (const auto& [program, name, defines] : all)
    if (Result<Done> done = load(*program, name, defines); !done) return done.error();
  return Painter(std::move(programs));
}

Painter::Painter(Programs programs)
    : programs_(std::move(programs)),
      tables_{color_texture(ColorScale::diverging),       color_texture(ColorScale::sequential),
              color_texture(ColorScale::limit),           color_texture(ColorScale::diverging_safe),
              color_texture(ColorScale::sequential_safe), color_texture(ColorScale::limit_safe)},
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

void Painter::set_frame(const Program& program, const Frame& frame, const Matrix4& model, double bias_pixels,
                        double bias_length) const {
  program.use();
  program.set("to_eye", to_float(Matrix4(frame.view * model)));
  program.set("projection", to_float(frame.projection));
  program.set("viewport", glm::vec2(frame.size.width, frame.size.height));
  // Uncut parts keep a constant distance to the plane, too: otherwise the section line itself would flicker
  // by rounding.
  program.set("section", cutting_ ? frame.section : glm::vec4(0, 0, 0, 1));
  program.set("perspective", !frame.camera.orthographic);
  // Near plane for lines, which are clamped in depth beyond the range that surfaces need.
  program.set("near_plane", std::min(frame.clip.near_plane, 0.01 * frame.camera.distance));
  const double share = frame.camera.orthographic ? bias_length : bias_length / frame.camera.distance;
  // Limited, so that the bias never reaches the eye.
  program.set("bias", bias_pixels * frame.pixel_scale * frame.pixel_bias +
                          (frame.camera.orthographic ? share : std::min(share, 0.5)));
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
  const auto [spacing, weight] = grid_lines(grid, height);
  const GridPlace place = grid_place(frame.camera, grid);
  Matrix4 model = Matrix4::Identity();
  model.topLeftCorner<3, 3>() = place.axes;
  model.topRightCorner<3, 1>() = place.centre;
  const std::array axis_colors{rgb(style.axis_x), rgb(style.axis_y), rgb(style.axis_z)};
  const Program& program = programs_.grid;
  set_frame(program, frame, model, 0);
  program.set("radius", grid_reach * height * std::max(1.0, frame.size.aspect()) * 0.5);
  program.set("spacing", spacing);
  program.set("fine_weight", weight);
  program.set("axes", glm::vec2(static_cast<float>(place.zero.y()), static_cast<float>(place.zero.x())));
  program.set("line_color", rgb(style.grid));
  program.set("x_color", axis_colors[std::size_t(place.colours[0])]);
  program.set("y_color", axis_colors[std::size_t(place.colours[1])]);
  program.set("strength", style.grid_strength);
  program.set("line_width", frame.pixel_scale);
  program.set("normal_in_eye", to_float(Vector3(frame.view.topLeftCorner<3, 3>() * place.axes.col(2))));
  glEnable(GL_BLEND);
  set_depth(place.backdrop ? Depth::any : Depth::visible);
  glBindVertexArray(empty_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  count();
}

void Painter::cut(const Frame& frame, bool on) {
  cutting_ = on && frame.has_section;
  (cutting_ ? glEnable : glDisable)(GL_CLIP_DISTANCE0);
}

void Painter::bind_table(ColorScale scale) const {
  glActiveTexture(GL_TEXTURE0 + table_unit);
  glBindTexture(GL_TEXTURE_1D, tables_[static_cast<std::size_t>(scale)].name());
}

Result<const Program*> Painter::surface_program(const SceneObject& object, const Scene& scene) {
  const std::string defines = surface_defines(object, scene);
  if (const auto found = programs_.surface.find(defines); found != programs_.surface.end())
    return &found->second;
  Result<Program> loaded = Program::load("surface", defines);
  if (!loaded) return loaded.error();
  return &programs_.surface.emplace(defines, std::move(loaded).value()).first->second;
}

Result<Done> Painter::surface(const Frame& frame, const SceneObject& object, const MeshBuffers& mesh,
                              const Scene& scene, const Style& style) {
  const Result<const Program*> found = surface_program(object, scene);
  if (!found) return found.error();
  const Program& program = **found;
  const ZebraSettings& zebra = scene.zebra;
  const Matrix4 model = at_origin(object.transform, object.mesh->origin());
  const Matrix3 rotation = frame.view.topLeftCorner<3, 3>();
  const Matrix3 linear = object.transform.topLeftCorner<3, 3>();
  set_frame(program, frame, model, 0);
  program.set("pixel_slope", 2 * frame.camera.half_slope() / frame.size.height);
  program.set("middle_slope", frame.camera.middle_slope());
  program.set("normal_to_eye",
              to_float(Matrix3(rotation * linear / std::cbrt(std::abs(linear.determinant())))));
  program.set("vertices_per_patch", static_cast<int>(object.mesh->vertices_per_patch()));
  program.set("outside_color", rgb(object.color));
  program.set("inside_color", rgb(style.inside));
  program.set("undefined_color", rgb(style.undefined));
  program.set("up_in_eye", to_float(Vector3(rotation * Vector3::UnitZ())));
  const ColorScale scale = scale_for(object.map, object.range, frame.colour_blind_safe);
  program.set("range", range_uniform(scale, object.range));
  const auto floor = floor_of(object.map, frame.colour_blind_safe);
  program.set("floor_value", floor ? floor->value : -1e37);
  program.set("floor_color", rgb(floor ? floor->color : style.undefined));
  Vector3 direction = zebra.direction;
  if (zebra.lock == StripeLock::object) direction = linear * direction;
  if (zebra.lock != StripeLock::view) direction = rotation * direction;
  program.set("stripe_direction",
              to_float(direction.norm() > 0 ? Vector3(direction.normalized()) : Vector3::UnitZ()));
  program.set("stripes", static_cast<float>(std::clamp(zebra.stripes, 2, 64)));
  program.set("triangles", object.mesh->pattern().domain == Domain::triangle);
  program.set("wire_paint", style.wire);
  program.set("line_width", frame.pixel_scale);
  program.set("grid_places", place_unit);
  program.set("dimming", object.dimmed ? style.dimming : 0.0F);
  program.set("selected_tint", rgb(style.selected_fill));
  program.set("hovered_tint", rgb(style.hovered_fill));
  program.set("patch_colors", color_unit);
  program.set("table", table_unit);
  mesh.patch_colors().bind_texture(color_unit);
  if (object.wire == PatchWire::mesh) mesh.grid_places().bind_texture(place_unit);
  if (mirrors_ceiling(object, scene)) set_ceiling(program, frame.view, scene);
  if (mirrors_environment(object, scene)) {
    const std::size_t uploaded = environment_.set(program, frame.view, scene.environment);
    if (statistics_) statistics_->uploaded_bytes += uploaded;
  }
  bind_table(scale);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_CLAMP);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glFrontFace(linear.determinant() < 0 ? GL_CW : GL_CCW);
  mesh.bind_vertex_array();
  glVertexAttrib2f(2, 0, 0);  // undefined, for meshes without values
  glDrawElements(GL_TRIANGLES, mesh.index_count(), GL_UNSIGNED_INT, nullptr);
  glFrontFace(GL_CCW);
  count(static_cast<std::size_t>(mesh.index_count() / 3));
  return Done{};
}

void Painter::lines(const Frame& frame, const Matrix4& model, const Lines& lines, const LineStyle& style,
                    Depth depth, float opacity, const LineLook& look) {
  if (lines.count == 0) return;
  const Program& program =
      look.amplitude ? programs_.comb_line : (look.dash > 0 ? programs_.dashed_line : programs_.line);
  const auto scale = static_cast<float>(frame.pixel_scale);
  const float core = 0.5F * style.width * scale, all = core + style.casing_width * scale;
  // On a slanted surface half the width lies behind the curve's own depth: a bias of a few widths clears
  // slopes up to about 75 degrees.
  set_frame(program, frame, model, 2.0 + 2.0 * (0.5 * style.width + style.casing_width),
            look.depth * model.topLeftCorner<3, 1>().norm());
  program.set("coordinates", coordinate_unit);
  program.set("table", table_unit);
  program.set("stride", lines.stride);
  program.set("half_width", all);
  program.set("core_width", core);
  program.set("paint", faded(style.paint, opacity));
  program.set("casing", faded(style.casing, opacity));
  program.set("dash", look.dash);
  program.set("dash_share", look.dash_share);
  program.set("amplitude", look.amplitude.value_or(0));
  program.set("by_value", look.values.has_value());
  if (look.values) {
    program.set("range", range_uniform(look.values->scale, look.values->range));
    program.set("undefined_color", look.values->undefined);
    bind_table(look.values->scale);
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
  this->segments(frame, model, buffers.positions(), 3, segments, style, depth, opacity);
}

void Painter::segments(const Frame& frame, const Matrix4& model, const TexturedBuffer& coordinates,
                       int stride, std::span<const CurveSegment> segments, const LineStyle& style,
                       Depth depth, float opacity) {
  if (segments.empty()) return;
  upload_stream(segments.size_bytes(), segments.data());
  lines(frame, model, {&coordinates, stride, stream_lines_.name(), static_cast<GLsizei>(segments.size())},
        style, depth, opacity);
}

void Painter::draw_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                          const PointStyle& style, Depth depth, float opacity, GLsizei number, bool numbered,
                          bool tensions) {
  const Program& program = tensions ? programs_.colored_point : programs_.point;
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
  program.set("shape", static_cast<int>(style.shape));
  if (tensions) {
    program.set("colors", color_unit);
    buffers.point_colors().bind_texture(color_unit);
  }
  buffers.positions().bind_texture(coordinate_unit);
  glEnable(GL_BLEND);
  set_depth(depth);
  glBindVertexArray(numbered ? stream_points_.name() : empty_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, number);
  count();
}

void Painter::points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                     const PointStyle& style, Depth depth, float opacity, bool tensions) {
  if (buffers.point_count() > 0)
    draw_points(frame, model, buffers, style, depth, opacity, buffers.point_count(), false,
                tensions && buffers.has_point_tensions());
}

void Painter::some_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                          std::span<const Index> vertices, const PointStyle& style, Depth depth,
                          float opacity) {
  std::vector<std::uint32_t> numbers;
  for (const Index v : vertices)
    if (v < static_cast<Index>(buffers.point_count())) numbers.push_back(v);
  if (numbers.empty()) return;
  upload_stream(numbers.size() * sizeof(std::uint32_t), numbers.data());
  draw_points(frame, model, buffers, style, depth, opacity, static_cast<GLsizei>(numbers.size()), true,
              false);
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

void Painter::bodies(const Frame& frame, const Matrix4& model, const BodyBuffers& buffers,
                     std::span<const Index> faces, const BodyStyle& style, float opacity) {
  if (faces.empty()) return;
  const Matrix3 linear = (frame.view * model).topLeftCorner<3, 3>();
  set_frame(programs_.body, frame, model, 0);
  programs_.body.set("to_eye_normal", glm::mat3(to_float(Matrix3(linear.inverse().transpose()))));
  programs_.body.set("viewport",
                     glm::vec2(static_cast<float>(frame.size.width), static_cast<float>(frame.size.height)));
  programs_.body.set("pixel_slope", 2 * frame.camera.half_slope() / frame.size.height);
  programs_.body.set("middle_slope", frame.camera.middle_slope());
  programs_.body.set("front", faded(style.front, opacity));
  programs_.body.set("rim", faded(style.rim, opacity));
  programs_.body.set("reach", style.reach);
  glEnable(GL_BLEND);
  set_depth(Depth::any);
  glEnable(GL_CULL_FACE);
  glFrontFace(linear.determinant() < 0 ? GL_CW : GL_CCW);
  glBindVertexArray(buffers.array());
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end] == faces[end - 1] + 1) ++end;
    const auto [first, number] = buffers.corners_of(faces[i], faces[end - 1]);
    glDrawArrays(GL_TRIANGLES, first, number);
    count(static_cast<std::size_t>(number / 3));
    i = end;
  }
  glFrontFace(GL_CCW);
  glDisable(GL_CULL_FACE);
}

void Painter::overlay(const Frame& frame, std::span<const OverlayLine> overlay_lines) {
  if (overlay_lines.empty()) return;
  // Relative to the target, so that world coordinates far from zero keep their precision.
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
    const LineStyle style{overlay_lines[i].color, overlay_lines[i].width};
    lines(frame, model, {&overlay_points_, 3, stream_lines_.name(), 1}, style,
          overlay_lines[i].on_top ? Depth::any : Depth::visible, 1);
  }
}

}  // namespace hariko::gl
