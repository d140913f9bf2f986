#include "ui/tools/waist_handles.hpp"

#include <algorithm>
#include <map>

#include "ui/tools/nearest_handle.hpp"
#include "ui/tools/overlay_drawing.hpp"

namespace hariko {

namespace {

/// More rings than this would cover the model.
constexpr std::size_t most_handles = 24;
/// Curves that move less, in design pixels for a whole factor, are no handles.
constexpr double least_way = 6;

}  // namespace

void WaistHandles::update(const Editor& editor) {
  handles_.clear();
  const Object* object = editor.has_document ? editor.active_object() : nullptr;
  if (!object || !object->solids() || !object->visible || object->locked || !object->display.polyhedron ||
      editor.view.surfaces_only || editor.mode == ElementMode::object || editor.paper.covers_model())
    return;
  const SurfaceView* view = editor.view_of(object->id);
  if (!view || !view->mesh || view->error) return;
  // Where the handles of curves show, rings would lie on top of them.
  if (editor.view.network_handles && !view->handles.curves.empty()) return;
  const std::set<VertexId>& selected = editor.selection.of(object->id).vertices;
  const Projector projector(editor.camera(), editor.viewport);
  if (!view->handles.bridges.empty()) sight_.look(editor);
  std::map<SolidPair, Handle> best;
  for (const EnvelopeBridge& bridge : view->handles.bridges) {
    const SolidPair& pair = bridge.solids;
    if (!selected.empty() && !selected.contains(VertexId{pair.low}) &&
        !selected.contains(VertexId{pair.high}))
      continue;
    const Vector3 middle = object->transform.apply(bridge.middle);
    const auto at = projector.project(middle);
    const auto to = projector.project(object->transform.apply(Vector3(bridge.middle + bridge.way)));
    if (!at || !to) continue;
    if ((object->transform.rotation * bridge.outward).dot(projector.ray(at->head<2>()).direction) > 0)
      continue;
    const Handle handle{bridge, at->head<2>(), to->head<2>() - at->head<2>()};
    if (handle.way.norm() < least_way * editor.pixel_scale || sight_.hides(middle)) continue;
    const auto [known, fresh] = best.try_emplace(pair, handle);
    if (!fresh && handle.way.norm() > known->second.way.norm()) known->second = handle;
  }
  if (best.size() > most_handles) return;
  for (auto& [pair, handle] : best) handles_.push_back(handle);
}

std::optional<std::size_t> WaistHandles::hit(const Vector2& pixel) const {
  return nearest_handle(handles_, pixel, hit_radius);
}

void WaistHandles::draw(const ToolOverlay& overlay, std::optional<std::size_t> hot) const {
  for (std::size_t i = 0; i < handles_.size(); ++i)
    draw_waist_ring(overlay, handles_[i].at, handles_[i].way, hot == i);
}

void WaistHandles::mark(Marks& marks, const ToolOverlay& overlay) const {
  for (const Handle& handle : handles_) {
    const ImVec2 at = on_screen(overlay, handle.at);
    marks.rect(
        "waist." + std::to_string(handle.bridge.solids.low) + "-" + std::to_string(handle.bridge.solids.high),
        {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2});
  }
}

void draw_waist_ring(const ToolOverlay& overlay, const Vector2& at, const Vector2& way, bool hot) {
  const Metrics& m = overlay.metrics;
  const ImVec2 c = on_screen(overlay, at);
  const ImU32 colour = hot ? palette().hot : palette().secondary;
  const float radius = m.px(hot ? 6.5F : 5.5F);
  overlay.list.AddCircleFilled(c, radius + m.px(1.2F), with_alpha(palette().window, 0.75F));
  overlay.list.AddCircle(c, radius, colour, 0, m.px(2));
  overlay.list.AddCircleFilled(c, m.px(1.8F), colour);
  if (!(way.norm() > 0)) return;
  const Vector2 along = way.normalized(), across(-along.y(), along.x());
  for (const double side : {1.0, -1.0}) {
    const auto place = [&](double out, double beside) {
      const Vector2 shift = side * (out * along + beside * across);
      return ImVec2(c.x + m.px(float(shift.x())), c.y + m.px(float(shift.y())));
    };
    overlay.list.AddTriangleFilled(place(hot ? 16 : 14, 0), place(9, 4), place(9, -4),
                                   with_alpha(palette().window, 0.75F));
    overlay.list.AddTriangleFilled(place(hot ? 15 : 13, 0), place(9.6, 3), place(9.6, -3), colour);
  }
}

}  // namespace hariko
