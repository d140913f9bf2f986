#include <array>

#include "ui/outline/gauss_panel.hpp"

namespace hariko {

namespace {

constexpr double arrow_pixels = 46;  // design pixels
constexpr std::size_t most_edges = 6000;

class GaussOverlay {
 public:
  GaussOverlay(const Editor& editor, const GaussView& view, const Projector& projector, ImDrawList& list,
               ImVec2 corner, const Metrics& metrics)
      : editor_(editor),
        view_(view),
        transform_(view.object->transform),
        projector_(projector),
        list_(list),
        corner_(corner),
        metrics_(metrics) {}

  void draw() const {
    if (view_.made_step) polyhedron();
    if (const auto newest = view_.newest()) site(*newest, palette().good);
    if (view_.has(view_.selected)) site(*view_.selected, palette().accent);
    if (view_.has(view_.hovered)) site(*view_.hovered, palette().hot);
  }

 private:
  std::optional<ImVec2> at(const Vector3& world) const {
    const auto pixel = projector_.project(world);
    if (!pixel || pixel->head<2>().cwiseAbs().maxCoeff() > 1e5) return {};
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    return ImVec2(corner_.x + static_cast<float>(pixel->x()) / scale.x,
                  corner_.y + static_cast<float>(pixel->y()) / scale.y);
  }
  void line(const Vector3& a, const Vector3& b, ImU32 colour, float width) const {
    const auto from = at(a), to = at(b);
    if (from && to) list_.AddLine(*from, *to, colour, metrics_.px(width));
  }

  /// The control points that there are so far.
  void polyhedron() const {
    const ControlPoints& points = *view_.sphere->points;
    if (points.triangles.size() > most_edges / 3) return;
    const auto world = [&](Index i) { return transform_.apply(points.points[i]); };
    for (const auto& triangle : points.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        line(world(triangle[k]), world(triangle[(k + 1) % 3]), with_alpha(palette().secondary, 0.45F), 1);
    for (Index i = points.boundary_count; i < points.points.size(); ++i)
      if (const auto p = at(world(i))) list_.AddCircleFilled(*p, metrics_.px(2.6F), palette().secondary);
  }

  /// The control point, its normal, and the facet of its tangent plane.
  void site(Index number, ImU32 colour) const {
    const ControlPoints& points = *view_.sphere->points;
    std::vector<ImVec2> facet;
    for (const Vector3& corner : tangent_facet(*view_.sphere, number)) {
      const auto p = at(transform_.apply(corner));
      if (!p) {
        facet.clear();
        break;
      }
      facet.push_back(*p);
    }
    const Vector3 point = transform_.apply(points.points[number]);
    if (const auto middle = at(point); middle && facet.size() >= 3)
      for (std::size_t k = 0; k < facet.size(); ++k)
        list_.AddTriangleFilled(*middle, facet[k], facet[(k + 1) % facet.size()], with_alpha(colour, 0.22F));
    if (facet.size() >= 3)
      list_.AddPolyline(facet.data(), static_cast<int>(facet.size()), with_alpha(colour, 0.9F),
                        ImDrawFlags_Closed, metrics_.px(1.5F));
    const double length = arrow_pixels * editor_.pixel_scale * projector_.pixel_length_at(point);
    line(point, point + length * (transform_.rotation * points.normals[number]), colour, 2.2F);
    if (const auto p = at(point)) {
      list_.AddCircleFilled(*p, metrics_.px(5), with_alpha(palette().window, 0.7F));
      list_.AddCircleFilled(*p, metrics_.px(4), colour);
    }
  }

  const Editor& editor_;
  const GaussView& view_;
  const Similarity& transform_;
  const Projector& projector_;
  ImDrawList& list_;
  ImVec2 corner_;
  const Metrics& metrics_;
};

class GaussLayer final : public ViewLayer {
 public:
  void draw(const ToolContext& context, const LayerPane& pane) override {
    const Editor& editor = context.editor;
    const GaussView& view = editor.gauss;
    if (!view.shown || !view.sphere || !view.sphere->points || !view.object || editor.paper.covers_model())
      return;
    const Object* object = editor.active_object();
    // While a new sphere is being made, the old one belongs to the outline as it was.
    if (!object || object->id != view.object->id || !object->visible) return;
    const ToolOverlay& overlay = pane.overlay;
    GaussOverlay(editor, view, pane.projector, overlay.list, overlay.corner, overlay.metrics).draw();
  }
};

}  // namespace

std::unique_ptr<ViewLayer> make_gauss_layer() {
  return std::make_unique<GaussLayer>();
}

}  // namespace hariko
