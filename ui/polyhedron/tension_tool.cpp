#include "ui/polyhedron/tension_tool.hpp"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document/edits/edits.hpp"
#include "render/element_colors.hpp"
#include "render/region_picking.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/view/legend.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/transform_target.hpp"

namespace hariko {

namespace {

/// α has no lower bound but 0, from which no factor leads away: it grows as if it had begun with this.
constexpr double alpha_offset = 0.25;

/// Three digits are what a hand can set.
double rounded(double value) {
  if (value == 0) return 0;
  const double scale = std::pow(10.0, 2 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

/// Ids by their new value, so that one edit sets all that share it.
template <class Id, class Value>
std::map<double, std::vector<Id>> by_value(const std::map<Id, double>& before, Value&& value) {
  std::map<double, std::vector<Id>> result;
  for (const auto& [id, old] : before) result[value(old)].push_back(id);
  return result;
}

}  // namespace

void TensionTool::begin(ToolContext& context, const PointerEvent& press) {
  pointer_ = press.pixel;
  const Document& document = context.editor.history.current();
  for (const auto& [id, elements] : context.editor.selection.elements()) {
    const Object* object = document.find(id);
    if (!object || !object->visible || !object->polyhedron()) continue;
    const Shaping& shaping = *object->polyhedron()->shaping;
    for (const VertexId vertex : elements.vertices) alphas_[id][vertex] = shaping.alpha.get_or(vertex, 0);
    for (const EdgeId& edge : elements.edges) betas_[id][edge] = shaping.beta.get_or(edge, 1);
  }
}

double TensionTool::alpha(double before) const {
  if (input_.active()) return input_.value().value_or(before);
  if (way_ == 0) return before;
  const double grown = (before + alpha_offset) * std::exp2(way_ / doubling_pixels) - alpha_offset;
  return rounded(std::clamp(grown, 0.0, max_alpha));
}

double TensionTool::beta(double before) const {
  if (input_.active()) return input_.value().value_or(before);
  if (way_ == 0) return before;
  return rounded(std::clamp(before * std::exp2(way_ / doubling_pixels), min_beta, max_beta));
}

Result<Document> TensionTool::edited(const Document& document) const {
  Result<Document> result = document;
  for (const auto& [object, before] : alphas_)
    for (const auto& [value, ids] : by_value(before, [&](double old) { return alpha(old); }))
      if (result) result = set_alpha(*result, object, ids, value);
  for (const auto& [object, before] : betas_)
    for (const auto& [value, ids] : by_value(before, [&](double old) { return beta(old); }))
      if (result) result = set_beta(*result, object, ids, value);
  return result;
}

ToolState TensionTool::show(ToolContext& context) {
  Editor& editor = context.editor;
  error_.clear();
  if (const auto error = input_.error()) return refuse(context, *error);
  const auto result = edited(editor.history.current());
  if (result) {
    editor.preview(result);
    return ToolState::stay;
  }
  if (input_.active()) {
    error_ = editor.language.text_of(result.error()) + "  " + editor.language.remedy_of(result.error());
    return ToolState::stay;
  }
  editor.notify(result.error());
  editor.cancel_preview();
  return ToolState::cancel;
}

ToolState TensionTool::update(ToolContext& context, const PointerEvent& event) {
  if (alphas_.empty() && betas_.empty()) return ToolState::cancel;
  way_ += (event.shift ? 0.1 : 1.0) * (event.pixel.x() - pointer_.x()) / context.editor.pixel_scale;
  const bool moved = event.pixel != pointer_;
  pointer_ = event.pixel;
  if (moved && !input_.active())
    if (const ToolState state = show(context); state != ToolState::stay) return state;
  return event.kind == PointerEvent::Kind::press ? confirm(context) : ToolState::stay;
}

ToolState TensionTool::confirm(ToolContext& context) {
  if (!error_.empty()) return ToolState::stay;
  const char* label = betas_.empty()    ? "Tension of vertices"
                      : alphas_.empty() ? "Tension of edges"
                                        : "Tension";
  context.editor.commit_preview(label);
  return ToolState::commit;
}

std::optional<ToolState> TensionTool::key(ToolContext& context, const KeyPress& press) {
  if (press.chord.key == Key::enter) return confirm(context);
  if (input_.key(press)) return show(context);
  // Other letters would run commands in the middle of a gesture.
  if (press.text != 0) return ToolState::stay;
  return std::nullopt;
}

void TensionTool::draw(const ToolContext& context, const ToolOverlay& overlay) const {
  const Projector projector = context.projector();
  const Document& document = context.editor.document();
  constexpr std::size_t most = 60;  // more numbers than that hide the model
  std::size_t count = 0;
  const auto number = [&](const ElementRef& ref, double value) {
    if (++count > most) return;
    const auto place = place_of(document, ref);
    const auto at = place ? projector.project(*place) : std::nullopt;
    if (!at) return;
    const std::string text = format_number(value, 3);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str()), c = on_screen(overlay, at->head<2>());
    const Metrics& m = overlay.metrics;
    const ImVec2 low(c.x + m.px(8), c.y - size.y - m.px(4));
    overlay.list.AddRectFilled({low.x - m.px(4), low.y - m.px(1)},
                               {low.x + size.x + m.px(4), low.y + size.y + m.px(1)},
                               with_alpha(palette().popup, 0.85F), m.px(3));
    overlay.list.AddText(low, palette().accent, text.c_str());
  };
  for (const auto& [object, before] : alphas_)
    for (const auto& [id, old] : before) number({object, element_of(id)}, alpha(old));
  for (const auto& [object, before] : betas_)
    for (const auto& [id, old] : before) number({object, element_of(id)}, beta(old));
  if (input_.active())
    draw_value_label(overlay, pointer_, input_.text(0) + "|" + (error_.empty() ? "" : "   " + error_),
                     !error_.empty());
}

std::string TensionTool::hint(const Language& tr) const {
  return tr("Tension: drag to the side   digits type   Shift fine   Enter confirms   Esc cancels");
}

namespace {

/// Rectangles that labels occupy already.
class Room {
 public:
  bool take(const ImVec2& low, const ImVec2& high) {
    for (const auto& [a, b] : taken_)
      if (low.x < b.x && high.x > a.x && low.y < b.y && high.y > a.y) return false;
    taken_.push_back({low, high});
    return true;
  }
  std::size_t size() const { return taken_.size(); }

 private:
  std::vector<std::pair<ImVec2, ImVec2>> taken_;
};

struct NumberLabel {
  Vector3 world;
  double value;
  double place;  ///< place of the tension's colour
  const char* letter;
};

std::vector<NumberLabel> labels_of(const Object& object) {
  const PolyhedronSource& source = *object.polyhedron();
  const Polyhedron& polyhedron = source.polyhedron;
  const Shaping& shaping = *source.shaping;
  constexpr Index few = 40;
  const bool all = polyhedron.vertex_count() + polyhedron.edge_count() <= few;
  const Matrix4 to_world = matrix_of(object.transform);
  const auto world = [&](const Vector3& local) -> Vector3 {
    return to_world.topLeftCorner<3, 3>() * (source.origin + local) + to_world.topRightCorner<3, 1>();
  };
  std::vector<NumberLabel> labels;
  const auto add_vertex = [&](Index v, double alpha) {
    labels.push_back({world(polyhedron.position(v)), alpha, alpha_place(alpha), "\u03b1 "});
  };
  const auto add_edge = [&](Index e, double beta) {
    const Index h = polyhedron.topology().half_edge_of_edge(e);
    labels.push_back({world((polyhedron.position(polyhedron.topology().origin(h)) +
                             polyhedron.position(polyhedron.topology().target(h))) /
                            2),
                      beta, beta_place(beta), "\u03b2 "});
  };
  if (all) {
    for (Index v = 0; v < polyhedron.vertex_count(); ++v)
      add_vertex(v, shaping.alpha.get_or(polyhedron.vertex_id(v), 0));
    for (Index e = 0; e < polyhedron.edge_count(); ++e)
      add_edge(e, shaping.beta.get_or(polyhedron.edge_id(e), 1));
    return labels;
  }
  for (const auto& [id, alpha] : shaping.alpha)
    if (const Index v = polyhedron.find(id); v != no_index && alpha != 0) add_vertex(v, alpha);
  for (const auto& [id, beta] : shaping.beta)
    if (const Index e = polyhedron.find(id); e != no_index && beta != 1) add_edge(e, beta);
  return labels;
}

/// Occlusion by the objects that are drawn solid, coarsely: a number need not vanish to the pixel.
Occlusion hiding_of(const Scene& scene, const Projector& projector) {
  constexpr int coarse = 4;  // pixels a side, of one that is looked at
  Scene solid;
  solid.section = scene.section;
  solid.pixel_scale = scene.pixel_scale;
  for (const SceneObject& object : scene.objects)
    if (object.mesh && object.show_surface) solid.objects.push_back(object);
  const PixelSize size{std::max(1, projector.size().width / coarse),
                       std::max(1, projector.size().height / coarse)};
  return {solid, Projector(projector.camera(), size)};
}

class TensionNumbers final : public ViewLayer {
 public:
  void draw(const ToolContext& context, const LayerPane& pane) override {
    const Editor& editor = context.editor;
    if (editor.view.surfaces_only) return;
    const Scene& scene = context.scene.scene();
    const bool through = editor.view.x_ray || editor.selecting.through;
    std::optional<Occlusion> occlusion;
    Room room;
    for (const auto& object : editor.document().objects) {
      if (!object->visible || !object->polyhedron()) continue;
      if (!object->display.tensions || !object->display.polyhedron) continue;
      if (!occlusion) occlusion = hiding_of(scene, pane.projector);
      std::vector<Seen> seen;
      for (const NumberLabel& label : labels_of(*object)) {
        const auto at = pane.projector.project(label.world);
        if (!at || (scene.section && scene.section->cuts(label.world))) continue;
        const bool hidden = !occlusion->visible(label.world);
        if (!hidden || through) seen.push_back({label, *at, hidden});
      }
      // Visible numbers have room first, of those the nearest; what only shows through is pale.
      std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
        return a.hidden != b.hidden ? b.hidden : a.at.z() < b.at.z();
      });
      for (const Seen& one : seen) {
        if (room.size() >= most) break;
        draw_number(pane, one, room);
      }
    }
  }

 private:
  static constexpr std::size_t most = 400;
  struct Seen {
    NumberLabel label;
    Vector3 at;
    bool hidden;
  };

  static void draw_number(const LayerPane& pane, const Seen& one, Room& room) {
    const Metrics& m = pane.overlay.metrics;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale, begin = pane.overlay.corner;
    const ImVec2 end(begin.x + static_cast<float>(pane.projector.size().width) / scale.x,
                     begin.y + static_cast<float>(pane.projector.size().height) / scale.y);
    const std::string text = one.label.letter + format_number(one.label.value, 3);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at(begin.x + static_cast<float>(one.at.x()) / scale.x + m.px(8),
                    begin.y + static_cast<float>(one.at.y()) / scale.y - size.y - m.px(4));
    const ImVec2 low(at.x - m.px(4), at.y - m.px(1)), high(at.x + size.x + m.px(4), at.y + size.y + m.px(1));
    if (high.x < begin.x || low.x > end.x || high.y < begin.y || low.y > end.y) return;
    if (!room.take(low, high)) return;
    ImDrawList& list = pane.overlay.list;
    const float strength = one.hidden ? 0.45F : 1.0F;
    list.AddRectFilled(low, high, with_alpha(palette().window, 0.78F * strength), m.px(4));
    if (one.label.place != 0)
      list.AddRectFilled(low, {low.x + m.px(3), high.y},
                         with_alpha(to_imgui(tension_color(one.label.place)), strength), m.px(2));
    list.AddText(at, with_alpha(one.label.place != 0 ? palette().text : palette().dim_text, strength),
                 text.c_str());
  }
};

}  // namespace

std::unique_ptr<ViewLayer> make_tension_numbers() {
  return std::make_unique<TensionNumbers>();
}

}  // namespace hariko
