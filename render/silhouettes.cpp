#include "render/silhouettes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hariko::gl {

namespace {

bool has_silhouette(const SceneObject& object) {
  return (object.outlined || object.outlined_as_hovered) && object.draws_surface();
}

/// Rectangle of frame pixels, from the frame's lower left corner.
struct PixelArea {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Pixels that the outlined objects and their lines may cover; the whole frame where a box reaches behind the
/// eye.
PixelArea area_of(const Frame& frame, const Scene& scene, double margin) {
  const Projector projector(frame.camera, frame.size);
  Eigen::AlignedBox2d area;
  const PixelArea whole{0, 0, frame.size.width, frame.size.height};
  for (const SceneObject& object : scene.objects) {
    if (!has_silhouette(object)) continue;
    const Box3 box = object.world_box();
    for (int i = 0; i < 8; ++i) {
      const auto at = projector.project(box.corner(static_cast<Box3::CornerType>(i)));
      if (!at) return whole;
      area.extend(Vector2(at->head<2>()));
    }
  }
  if (area.isEmpty()) return {};
  const auto bound = [](double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
  };
  const int left = bound(std::floor(area.min().x() - margin), whole.width),
            right = bound(std::ceil(area.max().x() + margin), whole.width),
            top = bound(std::floor(area.min().y() - margin), whole.height),
            bottom = bound(std::ceil(area.max().y() + margin), whole.height);
  return {left, whole.height - bottom, right - left, bottom - top};
}

}  // namespace

void Painter::silhouette(const Frame& frame, const Matrix4& model, const MeshBuffers& mesh,
                         const Color& paint) {
  set_frame(programs_.fill, frame, model, 0);
  programs_.fill.set("paint", paint);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_CLAMP);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  mesh.bind_vertex_array();
  glDrawElements(GL_TRIANGLES, mesh.index_count(), GL_UNSIGNED_INT, nullptr);
  count(static_cast<std::size_t>(mesh.index_count() / 3));
}

void Painter::silhouette_lines(const Frame& frame, GLuint mask, const Style& style) {
  programs_.silhouette.use();
  programs_.silhouette.set("mask", 0);
  programs_.silhouette.set("width", double(style.outline_width) * frame.pixel_scale);
  programs_.silhouette.set("selected_paint", style.selected_edge.paint);
  programs_.silhouette.set("hovered_paint", style.hovered_edge.paint);
  programs_.silhouette.set("casing", style.selected_edge.casing);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, mask);
  glEnable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(empty_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindTexture(GL_TEXTURE_2D, 0);
  count();
}

bool has_silhouettes(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), has_silhouette);
}

Result<Done> draw_silhouettes(Painter& painter, const Frame& frame, const Scene& scene,
                              const std::function<const MeshBuffers&(const DisplayMesh&)>& buffers_of,
                              FrameTarget& mask, const FrameTarget& picture, const Style& style) {
  const PixelArea area = area_of(frame, scene, 2 + 2 * double(style.outline_width) * frame.pixel_scale);
  if (area.width <= 0 || area.height <= 0) return Done{};
  if (Result<Done> sized = mask.resize(frame.size, 1); !sized) return sized;
  mask.bind();
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.x, area.y, area.width, area.height);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  painter.cut(frame, true);
  std::size_t number = 0;
  for (const SceneObject& object : scene.objects) {
    if (!has_silhouette(object)) continue;
    // Red distinguishes neighbouring objects, green marks the hovered ones.
    constexpr std::size_t most = 254;
    const float name = static_cast<float>(1 + number++ % most) / 255;
    painter.silhouette(frame, at_origin(object.transform, object.mesh->origin()), buffers_of(*object.mesh),
                       {name, object.outlined_as_hovered && !object.outlined ? 1.0F : 0.0F, 0, 1});
  }
  painter.cut(frame, false);
  picture.bind();
  painter.silhouette_lines(frame, mask.texture(), style);
  glDisable(GL_SCISSOR_TEST);
  return Done{};
}

}  // namespace hariko::gl
