#include "ui/polyhedron/tension_tool.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "core/document/edits/edits.hpp"
#include "ui/editor/object_kind.hpp"
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
  if (const auto error = input_.error()) {
    error_ = editor.language.text_of(*error);
    return ToolState::stay;
  }
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
  if (press.chord.key == GLFW_KEY_ENTER || press.chord.key == GLFW_KEY_KP_ENTER) return confirm(context);
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

}  // namespace hariko
