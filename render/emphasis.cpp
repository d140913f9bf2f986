#include "render/emphasis.hpp"

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
  const double width = double(style.outline_width) * frame.pixel_scale, margin = 2 + 2 * width;
  const PixelArea area = area_of(frame, scene, margin);
  if (area.width <= 0 || area.height <= 0) return Done{};
  // Lines are searched for beyond their own area, where the mask must not hold objects of earlier pictures.
  const PixelArea searched = area_of(frame, scene, margin + std::ceil(width) + 3);
  if (Result<Done> sized = mask.resize(frame.size, 1); !sized) return sized;
  mask.bind();
  glEnable(GL_SCISSOR_TEST);
  glScissor(searched.x, searched.y, searched.width, searched.height);
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
  glScissor(area.x, area.y, area.width, area.height);
  painter.silhouette_lines(frame, mask.texture(), style);
  glDisable(GL_SCISSOR_TEST);
  return Done{};
}

namespace {

constexpr float hidden_share = 0.32F;  // opacity relative to visible parts
constexpr int mesh_stride = sizeof(DisplayVertex) / sizeof(float);

class HighlightPass {
 public:
  HighlightPass(Painter& painter, const Frame& frame, const SceneObject& object,
                const PolyhedronBuffers& polyhedron, const MeshBuffers* surface)
      : painter_(painter), frame_(frame), object_(object), polyhedron_(polyhedron), surface_(surface) {}

  void edges(const std::vector<Index>& edges, const LineStyle& style) const {
    if (edges.empty()) return;
    std::vector<CurveSegment> on_surface;
    std::vector<Index> lines, bare;
    for (const Index e : edges) {
      if (e >= object_.polyhedron->edges.size()) continue;
      const bool curve = surface_ && object_.edge_curves->covers(e);
      if (curve)
        for (const EdgeCurves::Run& run : object_.edge_curves->of(e)) {
          const auto segments = object_.edge_curves->segments(run);
          on_surface.insert(on_surface.end(), segments.begin(), segments.end());
        }
      if (!curve) bare.push_back(e);
      if (curve && object_.show_polyhedron) lines.push_back(e);
    }
    const Matrix4 model = at_origin(object_.transform, object_.polyhedron->origin);
    for (const Depth depth : {Depth::hidden, Depth::visible}) {
      const float opacity = depth == Depth::hidden ? hidden_share : 1;
      painter_.some_edges(frame_, model, *object_.polyhedron, polyhedron_, bare, style, depth, opacity);
      // The straight line of an edge with a curve is drawn only where visible: inside the surface it would
      // confuse.
      if (depth == Depth::visible)
        painter_.some_edges(frame_, model, *object_.polyhedron, polyhedron_, lines, style, depth, opacity);
      if (surface_)
        painter_.segments(frame_, at_origin(object_.transform, object_.mesh->origin()), surface_->vertices(),
                          mesh_stride, on_surface, style, depth, opacity);
    }
  }

  void points(const std::vector<Index>& vertices, const PointStyle& style) const {
    const Matrix4 model = at_origin(object_.transform, object_.polyhedron->origin);
    painter_.some_points(frame_, model, polyhedron_, vertices, style, Depth::hidden, hidden_share);
    painter_.some_points(frame_, model, polyhedron_, vertices, style, Depth::visible, 1);
  }

 private:
  Painter& painter_;
  const Frame& frame_;
  const SceneObject& object_;
  const PolyhedronBuffers& polyhedron_;
  const MeshBuffers* surface_;
};

}  // namespace

void draw_highlights(Painter& painter, const Frame& frame, const SceneObject& object,
                     const PolyhedronBuffers& polyhedron, const MeshBuffers* surface, const Style& style) {
  const HighlightPass pass(painter, frame, object, polyhedron,
                           object.elements_on_surface() ? surface : nullptr);
  pass.edges(object.selected.edges, style.selected_edge);
  pass.edges(object.hovered.edges, style.hovered_edge);
  pass.edges(object.failed.edges, style.failed_edge);
  pass.points(object.selected.vertices, style.selected_point);
  pass.points(object.hovered.vertices, style.hovered_point);
  pass.points(object.failed.vertices, style.failed_point);
}

}  // namespace hariko::gl
