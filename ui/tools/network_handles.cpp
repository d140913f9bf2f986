#include "ui/tools/network_handles.hpp"

#include <algorithm>

#include "ui/tools/nearest_handle.hpp"
#include "ui/tools/overlay_drawing.hpp"

namespace hariko {

namespace {

/// Curves that move less, in design pixels for a whole factor, are no handles.
constexpr double least_movement = 6;

bool belongs_to(const std::set<VertexId>& solids, const NetworkVertexKey& vertex) {
  return std::ranges::any_of(solids, [&](VertexId id) { return vertex.is_of(id.value); });
}
bool belongs_to(const std::set<VertexId>& solids, const EnvelopeVertex& vertex) {
  return belongs_to(solids, vertex.vertex);
}
bool belongs_to(const std::set<VertexId>& solids, const EnvelopeCurve& curve) {
  return belongs_to(solids, curve.curve.low) || belongs_to(solids, curve.curve.high);
}

std::string text_of(const NetworkVertexKey& key) {
  return std::to_string(key.solid) + (key.in_valley() ? "+" + std::to_string(key.other) : "") + "-" +
         std::to_string(key.vertex);
}

}  // namespace

void NetworkHandles::update(const Editor& editor) {
  handles_.clear();
  const Object* object = editor.has_document ? editor.active_object() : nullptr;
  if (!editor.view.network_handles || editor.view.surfaces_only || !object || !object->solids() ||
      !object->visible || object->locked || editor.mode == ElementMode::object || editor.paper.covers_model())
    return;
  const SurfaceView* view = editor.view_of(object->id);
  if (!view || !view->mesh || view->error) return;
  const EnvelopeSettings& settings = object->solids()->input->settings;
  const std::set<VertexId>& selected = editor.selection.of(object->id).vertices;
  const Projector projector(editor.camera(), editor.viewport);
  sight_.look(editor);
  const auto shows = [&](const Vector2& pixel) {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= editor.viewport.width &&
           pixel.y() <= editor.viewport.height;
  };
  const auto place = [&](const Vector3& point, const Vector3& outward) -> std::optional<Vector2> {
    const Vector3 world = object->transform.apply(point);
    const auto at = projector.project(world);
    if (!at || (object->transform.rotation * outward).dot(projector.ray(at->head<2>()).direction) > 0 ||
        sight_.hides(world) || !shows(at->head<2>()))
      return {};
    return at->head<2>();
  };
  for (const EnvelopeCurve& curve : view->handles.curves) {
    if (!selected.empty() && !belongs_to(selected, curve)) continue;
    const auto at = place(curve.middle, curve.outward);
    const auto to = projector.project(object->transform.apply(Vector3(curve.middle + curve.way)));
    if (!at || !to || (to->head<2>() - *at).norm() < least_movement * editor.pixel_scale) continue;
    handles_.push_back({curve, *at, settings.fullness.find(curve.curve) != nullptr});
  }
  for (const EnvelopeVertex& vertex : view->handles.vertices) {
    if (!selected.empty() && !belongs_to(selected, vertex)) continue;
    if (const auto at = place(vertex.position, vertex.outward))
      handles_.push_back({vertex, *at, settings.offsets.find(vertex.vertex) != nullptr});
  }
  if (handles_.size() > most_handles) handles_.clear();
}

std::optional<std::size_t> NetworkHandles::hit(const Vector2& pixel) const {
  return nearest_handle(handles_, pixel, hit_radius);
}

void NetworkHandles::draw(const ToolOverlay& overlay, std::optional<std::size_t> hot) const {
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    const bool vertex = std::holds_alternative<EnvelopeVertex>(handles_[i].handle);
    draw_network_handle(overlay, handles_[i].at, vertex, handles_[i].changed, hot == i);
  }
}

void NetworkHandles::mark(Marks& marks, const ToolOverlay& overlay) const {
  for (const Shown& shown : handles_) {
    const ImVec2 at = on_screen(overlay, shown.at);
    const auto* vertex = std::get_if<EnvelopeVertex>(&shown.handle);
    const auto* curve = std::get_if<EnvelopeCurve>(&shown.handle);
    const std::string name =
        vertex ? "network.vertex." + text_of(vertex->vertex)
               : "network.curve." + text_of(curve->curve.low) + "." + text_of(curve->curve.high);
    marks.rect(name, {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2});
  }
}

void draw_network_handle(const ToolOverlay& overlay, const Vector2& at, bool vertex, bool changed, bool hot) {
  const Metrics& m = overlay.metrics;
  const ImVec2 c = on_screen(overlay, at);
  const ImU32 colour = hot ? palette().hot : palette().secondary;
  const ImU32 inside = changed ? colour : with_alpha(palette().window, 0.85F);
  const float r = m.px(hot ? 5.5F : 4.5F), halo = m.px(1.4F);
  if (vertex) {
    overlay.list.AddRectFilled({c.x - r - halo, c.y - r - halo}, {c.x + r + halo, c.y + r + halo},
                               with_alpha(palette().window, 0.6F));
    overlay.list.AddRectFilled({c.x - r, c.y - r}, {c.x + r, c.y + r}, inside);
    overlay.list.AddRect({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, 0, 0, m.px(1.6F));
    return;
  }
  const auto diamond = [&](float size) {
    return std::array{ImVec2(c.x, c.y - size), ImVec2(c.x + size, c.y), ImVec2(c.x, c.y + size),
                      ImVec2(c.x - size, c.y)};
  };
  const auto outer = diamond(r + halo), inner = diamond(r);
  overlay.list.AddConvexPolyFilled(outer.data(), 4, with_alpha(palette().window, 0.6F));
  overlay.list.AddConvexPolyFilled(inner.data(), 4, inside);
  overlay.list.AddPolyline(inner.data(), 4, colour, ImDrawFlags_Closed, m.px(1.6F));
}

}  // namespace hariko
