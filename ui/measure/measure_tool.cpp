#include <vector>

#include "core/document/edits/edit_dimensions.hpp"
#include "ui/base/quantity.hpp"
#include "ui/editor/dimension_view.hpp"
#include "ui/measure/dimension_drawing.hpp"
#include "ui/measure/measure_snap.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

const char* step_of(DimensionKind kind) {
  return name_among(kind, {"Measure distance", "Measure angle", "Measure radius"});
}

/// "x 10   y 0   z -2.5", of a distance.
std::string steps_text(const Vector3& way, Unit unit) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    Quantity number = measured_length(unit, way[axis]);
    number.unit.clear();
    text += (axis == 0 ? "" : "   ") + std::string(1, "xyz"[axis]) + " " + format_quantity(number, way[axis]);
  }
  return text;
}

class MeasureTool final : public ModalTool {
 public:
  explicit MeasureTool(DimensionKind kind) : kind_(kind) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    look(context, press.control);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    if (event.kind == PointerEvent::Kind::release) return ToolState::stay;
    look(context, event.control);
    if (event.kind == PointerEvent::Kind::press) put(context, event.control);
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    const KeyChord& chord = press.chord;
    if (chord.key == Key::enter || chord.key == Key::space) return ToolState::commit;
    if (chord.key == Key::backspace) {
      if (!anchors_.empty()) anchors_.pop_back();
      look(context, false);
      return ToolState::stay;
    }
    return unused_key(press);
  }

  void cancel(ToolContext&) override {}

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Projector projector = context.projector();
    if (const auto value = present(context)) {
      const DimensionShape shape =
          shape_of(kind_, *value, Vector3::Zero(), projector, context.editor.pixel_scale);
      draw_dimension_lines(overlay, shape, DimensionLook::hovered);
    } else {
      draw_begun(context, overlay);
    }
    if (place_) draw_place(context, overlay);
    draw_value_label(overlay, pointer_, error_.empty() ? value_ : error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    const std::string keys =
        kind_ == DimensionKind::radius
            ? tr("Click a point of a surface   Enter or Esc ends")
            : std::string(tr(asked())) + "   " +
                  tr("Ctrl: middles of edges   Backspace: last point   Enter or Esc ends");
    const auto target = place_ ? target_of(*place_) : std::nullopt;
    const std::string caught = target ? std::string(tr(snap_name(target->kind))) + "   |   " : std::string();
    return (error_.empty() ? value_ : error_) + "   |   " + (steps_.empty() ? "" : steps_ + "   |   ") +
           caught + keys;
  }

 private:
  const char* asked() const {
    if (anchors_.empty()) return translatable("Click the first point");
    if (kind_ == DimensionKind::angle && anchors_.size() == 1)
      return translatable("Click the corner of the angle");
    return kind_ == DimensionKind::angle ? translatable("Click a point on the other arm")
                                         : translatable("Click the second point");
  }

  std::optional<Vector3> last_point(const ToolContext& context) const {
    if (anchors_.empty()) return std::nullopt;
    return anchor_place(context.editor.document(), anchors_.back(), ready_surfaces(context.editor));
  }

  /// The dimension that a click would make.
  Dimension in_hand() const {
    Dimension dimension{{}, kind_, anchors_, Vector3::Zero()};
    if (place_) dimension.anchors.push_back(place_->anchor);
    return dimension;
  }

  /// Its value; nothing while points are missing.
  std::optional<MeasuredDimension> present(const ToolContext& context) const {
    const Dimension dimension = in_hand();
    if (dimension.anchors.size() != anchor_count(kind_)) return std::nullopt;
    return measured(context.editor.document(), dimension, ready_surfaces(context.editor));
  }

  /// Finds what is under the pointer, and the value that it gives.
  void look(const ToolContext& context, bool middles) {
    const Language& tr = context.editor.language;
    const Unit unit = context.editor.document().unit;
    error_.clear();
    steps_.clear();
    if (kind_ == DimensionKind::radius) {
      place_ = surface_to_measure(context, pointer_);
    } else {
      MeasureAim aim{pointer_, middles, last_point(context)};
      catcher_.update(context);
      if (snaps_now(context.editor, middles)) aim.snaps = catcher_.places();
      place_ = place_to_measure(context, aim);
    }
    value_ = tr(dimension_name(kind_));
    const auto value = present(context);
    if (!value) return;
    value_ += "  " + dimension_text(kind_, *value, unit, tr);
    if (kind_ == DimensionKind::distance) steps_ = steps_text(value->points[1] - value->points[0], unit);
  }

  void put(ToolContext& context, bool middles) {
    if (!place_) return void(refuse(context, "Click a point of a surface."));
    if (const auto last = last_point(context); last && *last == place_->point)
      return void(refuse(context, "This is the last point. Click another one."));
    if (anchors_.size() + 1 == anchor_count(kind_)) return keep(context, middles);
    anchors_.push_back(place_->anchor);
    look(context, middles);
  }

  /// Makes the dimension that is complete, and begins the next one.
  void keep(ToolContext& context, bool middles) {
    Editor& editor = context.editor;
    if (!present(context)) return void(refuse(context, "The surface has no curvature here."));
    auto added = add_dimension(editor.history.current(), kind_, in_hand().anchors);
    if (!added) return void(refuse(context, added.error()));
    editor.commit(Result<Document>(std::move(added).value().document), step_of(kind_));
    anchors_.clear();
    look(context, middles);
  }

  /// Points and lines of what is not complete yet.
  void draw_begun(const ToolContext& context, const ToolOverlay& overlay) const {
    const Projector projector = context.projector();
    std::vector<Vector2> pixels;
    for (const Anchor& anchor : in_hand().anchors) {
      const auto place = anchor_place(context.editor.document(), anchor, ready_surfaces(context.editor));
      const auto at = place ? projector.project(*place) : std::nullopt;
      if (at) pixels.emplace_back(at->head<2>());
    }
    for (std::size_t i = 0; i + 1 < pixels.size(); ++i)
      overlay.list.AddLine(on_screen(overlay, pixels[i]), on_screen(overlay, pixels[i + 1]), palette().hot,
                           overlay.metrics.px(1.4F));
    for (const Vector2& pixel : pixels)
      overlay.list.AddCircleFilled(on_screen(overlay, pixel), overlay.metrics.px(2.5F), palette().hot);
  }

  /// Draws what holds the point, with its name; a small circle at a point of space.
  void draw_place(const ToolContext& context, const ToolOverlay& overlay) const {
    if (const auto target = target_of(*place_))
      return draw_snap_target(context, overlay, *target, !error_.empty());
    const auto at = context.projector().project(place_->point);
    if (!at) return;
    overlay.list.AddCircle(on_screen(overlay, at->head<2>()), overlay.metrics.px(4.2F),
                           error_.empty() ? palette().text : palette().warning, 0, overlay.metrics.px(1.8F));
  }

  DimensionKind kind_;
  std::vector<Anchor> anchors_;  ///< anchors of the points that were clicked
  std::optional<MeasurePlace> place_;
  SnapCatcher catcher_;
  std::string value_, steps_;
};

}  // namespace

std::unique_ptr<Tool> make_measure_tool(DimensionKind kind) {
  return std::make_unique<MeasureTool>(kind);
}

}  // namespace hariko
