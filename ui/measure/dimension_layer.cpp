#include "ui/measure/dimension_layer.hpp"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "core/document/edits/edit_dimensions.hpp"
#include "ui/base/icons.hpp"
#include "ui/measure/dimension_drawing.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

/// Held from the press on a dimension: chooses it, or moves its label.
class LabelTool final : public Tool {
 public:
  LabelTool(DimensionId id, const DimensionShape& shape)
      : id_(id), natural_(shape.natural), label_(shape.label) {}

  void begin(ToolContext&, const PointerEvent& press) override { press_ = press.pixel; }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    Editor& editor = context.editor;
    if (event.kind == PointerEvent::Kind::release) {
      if (moving_) editor.commit_preview(translatable("Move label"));
      editor.dimensions.choose(editor, id_);
      return ToolState::commit;
    }
    moving_ = moving_ || (event.pixel - press_).norm() > drag_threshold * editor.pixel_scale;
    if (!moving_) return ToolState::stay;
    const Vector3 to = context.projector().on_facing_plane(label_ + event.pixel - press_, natural_);
    editor.preview(move_dimension_label(editor.history.current(), id_, to - natural_));
    return ToolState::stay;
  }

  std::string hint(const Language& tr) const override {
    return tr("Release to choose the dimension, drag to move its label");
  }

 private:
  DimensionId id_;
  Vector3 natural_;  ///< from where the label's place counts
  Vector2 label_, press_ = Vector2::Zero();
  bool moving_ = false;
};

/// A dimension in the active view.
struct DrawnDimension {
  DimensionId id;
  std::string text;
  DimensionShape shape;
  bool label_by_hand = false;                             ///< somebody put the label where it is
  Vector2 low = Vector2::Zero(), high = Vector2::Zero();  ///< box of the label

  void move_label(const Vector2& by) {
    for (auto& line : shape.lines)
      if (line.second == shape.label) line.second += by;  // a radius has a line to the label
    shape.label += by;
    low += by;
    high += by;
  }
  bool label_holds(const Vector2& pixel) const {
    return (pixel.array() >= low.array()).all() && (pixel.array() <= high.array()).all();
  }
};

/// Moves labels that stand where they are by themselves down, off those before them; a thin line leads back.
/// O(labels^3), and O(labels^2) where few of them meet.
void make_way(std::vector<DrawnDimension>& drawn, double gap) {
  std::vector<std::pair<Vector2, Vector2>> taken;
  for (const bool by_hand : {true, false})
    for (DrawnDimension& each : drawn) {
      if (each.label_by_hand != by_hand) continue;
      const auto in_the_way = [&] {
        return std::ranges::find_if(taken, [&](const auto& box) {
          return (each.low.array() < box.second.array()).all() &&
                 (each.high.array() > box.first.array()).all();
        });
      };
      const Vector2 before = each.shape.label;
      // Each move leaves one of them behind for good, as all go the same way.
      for (auto box = in_the_way(); !by_hand && box != taken.end(); box = in_the_way())
        each.move_label({0, box->second.y() + gap - each.low.y()});
      if (each.shape.label != before) each.shape.helpers.emplace_back(before, each.shape.label);
      taken.emplace_back(each.low, each.high);
    }
}

std::vector<DrawnDimension> drawn_dimensions(const Editor& editor, const Projector& projector) {
  std::vector<DrawnDimension> out;
  if (!shows_dimensions(editor)) return out;
  const Unit unit = editor.document().unit;
  for (const ShownDimension& shown : editor.dimensions.all()) {
    if (!shown.measured || !shown.visible) continue;
    const Dimension& dimension = shown.dimension;
    DrawnDimension next{
        dimension.id, dimension_text(dimension.kind, *shown.measured, unit, editor.language),
        shape_of(dimension.kind, *shown.measured, dimension.label, projector, editor.pixel_scale),
        !dimension.label.isZero(0)};
    if (!next.shape.seen) continue;
    std::tie(next.low, next.high) = label_box(next.shape, next.text, editor.pixel_scale);
    out.push_back(std::move(next));
  }
  constexpr double gap = 2;  // design pixels
  make_way(out, gap * editor.pixel_scale);
  return out;
}

class DimensionLayer final : public ViewLayer {
 public:
  void update(const ToolContext& context, bool /*tool_runs*/) override {
    context.editor.dimensions.update(context.editor);
    drawn_ = drawn_dimensions(context.editor, context.projector());
  }

  bool hover(const ToolContext&, const Vector2& pixel) override {
    const DrawnDimension* hit = under(pixel);
    if (hit) hot_ = hit->id;
    return hit != nullptr;
  }
  void leave(const ToolContext&) override { hot_.reset(); }

  std::optional<std::unique_ptr<Tool>> press(const ToolContext& context, const PointerEvent& press) override {
    if (press.button != PointerButton::left || press.alt) return {};
    const DrawnDimension* hit = press.plain_left() ? under(press.pixel) : nullptr;
    if (hit) return std::make_unique<LabelTool>(hit->id, hit->shape);
    context.editor.dimensions.choose_none();
    return {};
  }

  void draw(const ToolContext& context, const LayerPane& pane) override {
    const Editor& editor = context.editor;
    const auto chosen = editor.dimensions.chosen(editor);
    const auto others =
        pane.active ? std::vector<DrawnDimension>() : drawn_dimensions(editor, pane.projector);
    const auto look_of = [&](const DrawnDimension& drawn) {
      if (chosen == drawn.id) return DimensionLook::chosen;
      return hot_ == drawn.id ? DimensionLook::hovered : DimensionLook::plain;
    };
    const auto& shown = pane.active ? drawn_ : others;
    for (const DrawnDimension& drawn : shown) draw_dimension_lines(pane.overlay, drawn.shape, look_of(drawn));
    for (const DrawnDimension& drawn : shown) {
      draw_dimension_label(pane.overlay, drawn.shape, drawn.text, look_of(drawn));
      if (pane.active)
        pane.marks.rect("dimension." + std::to_string(drawn.id.value), on_screen(pane.overlay, drawn.low),
                        on_screen(pane.overlay, drawn.high));
    }
  }

  const char* hint() const override {
    return hot_ ? translatable("Click chooses the dimension, Del then deletes it   drag moves its label")
                : nullptr;
  }

 private:
  /// The dimension whose label is there. Lines are not taken: they lie on the vertices and edges that they
  /// measure.
  const DrawnDimension* under(const Vector2& pixel) const {
    const auto found = std::find_if(drawn_.rbegin(), drawn_.rend(),
                                    [&](const DrawnDimension& drawn) { return drawn.label_holds(pixel); });
    return found == drawn_.rend() ? nullptr : &*found;
  }

  std::vector<DrawnDimension> drawn_;
  std::optional<DimensionId> hot_;
};

}  // namespace

bool shows_dimensions(const Editor& editor) {
  return editor.has_document && editor.view.dimensions && !editor.view.surfaces_only &&
         !editor.paper.covers_model() && !editor.meshing.comparing();
}

std::unique_ptr<ViewLayer> make_dimension_layer() {
  return std::make_unique<DimensionLayer>();
}

namespace {

constexpr std::size_t most_rows_at_once = 10;
constexpr float button_size = 22;  // design pixels

void dimension_row(PanelContext& context, const ShownDimension& shown) {
  Editor& editor = context.editor;
  const Dimension& dimension = shown.dimension;
  const std::string number = std::to_string(dimension.id.value), mark = "dimension_row." + number;
  const bool chosen = editor.dimensions.chosen(editor) == dimension.id;
  ImGui::PushID(static_cast<int>(dimension.id.value));
  row_label(context, dimension_name(dimension.kind), "");
  const float buttons = 2 * context.metrics.px(button_size + 4);
  const std::string text =
      shown.measured ? dimension_text(dimension.kind, *shown.measured, editor.document().unit, context.tr)
                     : std::string(context.tr("no value"));
  const float start = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  const std::string fitting = elided(text, room - buttons - context.metrics.px(4));
  if (selectable_row(context.marks, mark, fitting, chosen, {room - buttons, context.metrics.px(button_size)}))
    editor.dimensions.choose(editor, dimension.id);
  if (!shown.measured && ImGui::IsItemHovered())
    show_tip(context.tr("The surface that it measures is not there, or has no such point any more."));
  else if (fitting != text && ImGui::IsItemHovered())
    show_tip(text);
  ImGui::SameLine(start + room - buttons);
  {
    const Disabled disabled(!shown.measured);
    if (icon_button(context, icon::copy, mark + ".copy", "Copy the value", false, button_size) &&
        shown.measured)
      ImGui::SetClipboardText(
          exact_dimension_text(dimension.kind, *shown.measured, editor.document().unit).c_str());
  }
  ImGui::SameLine(0, context.metrics.px(4));
  if (icon_button(context, icon::trash, mark + ".delete", "Delete the dimension", false, button_size))
    later(context, remove_dimensions(editor.history.current(), std::array{dimension.id}),
          translatable("Delete dimension"));
  ImGui::PopID();
}

}  // namespace

void dimension_section(PanelContext& context) {
  Editor& editor = context.editor;
  const std::vector<ShownDimension>& all = editor.dimensions.all();
  if (all.empty()) return;
  heading(context, "Dimensions");
  const bool many = all.size() > most_rows_at_once;
  if (many)
    ImGui::BeginChild("dimensions",
                      {0, (float(most_rows_at_once) + 0.5F) * ImGui::GetFrameHeightWithSpacing()}, false,
                      ImGuiWindowFlags_NavFlattened);
  for (const ShownDimension& shown : all) dimension_row(context, shown);
  if (many) ImGui::EndChild();
  if (!editor.view.dimensions) hint_text(context, "Hidden in the views: View > Show dimensions.");
}

}  // namespace hariko
