#include "render/highlights.hpp"

namespace hariko::gl {

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
