#include "ui/pictures/picture_rows.hpp"

#include "core/document/edits/edit_pictures.hpp"
#include "core/document/length_units.hpp"
#include "ui/editor/numeric_input.hpp"
#include "ui/editor/reference_pictures.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

class PictureScaleTool final : public ModalTool {
 public:
  explicit PictureScaleTool(ObjectId picture) : picture_(picture) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    const auto lengths = length_units(context.editor.document().unit);
    input_ = NumericInput(1, {lengths.begin(), lengths.end()});
    pointer_ = press.pixel;
    under_ = point_at(context, pointer_);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    if (!context.editor.history.current().find(picture_)) return ToolState::commit;
    pointer_ = event.pixel;
    if (second_) return ToolState::stay;
    under_ = point_at(context, pointer_);
    if (event.kind != PointerEvent::Kind::press) return ToolState::stay;
    error_.clear();
    if (!under_) return refuse(context, "Click a point of the picture.");
    if (!first_)
      first_ = under_;
    else if (*under_ != *first_)
      second_ = under_;
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    const bool enter = press.chord.key == Key::enter;
    if (!second_) {
      if (enter) return ToolState::stay;
      return unused_key(press);
    }
    if (enter) return confirm(context);
    if (input_.key(press)) {
      show(context, false);
      return ToolState::stay;
    }
    if (press.chord.key == Key::backspace) second_.reset();
    if (press.chord.control || press.chord.alt || (press.text == 0 && second_)) return std::nullopt;
    return ToolState::stay;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Projector projector = context.projector();
    const auto pixel_of = [&](const Vector3& point) -> std::optional<Vector2> {
      const auto at = projector.project(point);
      return at ? std::optional<Vector2>(at->head<2>()) : std::nullopt;
    };
    // A typed length moves the second point away from the first: the line follows.
    const auto [from, to] = ends();
    const auto a = from ? pixel_of(*from) : std::nullopt, b = to ? pixel_of(*to) : std::nullopt;
    const float radius = overlay.metrics.px(4);
    if (a && b)
      overlay.list.AddLine(on_screen(overlay, *a), on_screen(overlay, *b), palette().hot,
                           overlay.metrics.px(2));
    for (const auto& end : {a, b})
      if (end) overlay.list.AddCircleFilled(on_screen(overlay, *end), radius, palette().hot);
    draw_value_label(overlay, second_ && b ? *b : pointer_,
                     error_.empty() ? value_text(context.editor) : error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    if (!first_) return tr("Click the first of two points whose distance is known   Esc cancels");
    if (!second_) return tr("Click the second point   Esc cancels");
    return tr("Type the distance   Enter confirms   Backspace goes back   Esc cancels");
  }

 private:
  std::optional<Vector3> point_at(const ToolContext& context, const Vector2& pixel) const {
    const Object* object = context.editor.history.current().find(picture_);
    const Projector projector = context.projector();
    if (!object || !object->picture()) return std::nullopt;
    ScenePicture picture;
    picture.transform = matrix_of(object->transform);
    picture.half = {object->picture()->width / 2, object->picture()->height() / 2};
    const Ray ray = projector.ray(pixel);
    const auto t = picture.hit(ray);
    return t ? std::optional<Vector3>(ray.at(*t)) : std::nullopt;
  }

  std::pair<std::optional<Vector3>, std::optional<Vector3>> ends() const {
    if (!first_ || !second_) return {first_ ? first_ : under_, first_ ? under_ : std::nullopt};
    if (!shown_length_) return {first_, second_};
    return {first_, Vector3(*first_ + *shown_length_ * (*second_ - *first_).normalized())};
  }

  void show(ToolContext& context, bool confirmed) {
    Editor& editor = context.editor;
    error_.clear();
    // The last number stays in view until the unit is whole.
    if (input_.unfinished() && !confirmed) return;
    shown_length_.reset();
    if (const auto wrong = input_.error()) error_ = editor.language.text_of(*wrong);
    const auto length = input_.value();
    if (!length || !error_.empty()) return editor.cancel_preview();
    const auto scaled = scale_picture(editor.history.current(), picture_, *first_, *second_, *length);
    if (!scaled) {
      error_ = editor.language.text_of(scaled.error());
      return editor.cancel_preview();
    }
    editor.preview(scaled);
    shown_length_ = length;
  }

  ToolState confirm(ToolContext& context) {
    if (!input_.active()) return refuse(context, "Type the distance of the two points.");
    show(context, true);
    if (!error_.empty()) return ToolState::stay;
    if (!context.editor.commit_preview(translatable("Scale picture"))) {
      context.editor.cancel_preview();
      return ToolState::cancel;
    }
    return ToolState::commit;
  }

  std::string value_text(const Editor& editor) const {
    const Language& tr = editor.language;
    if (!first_) return tr("First point");
    if (!second_)
      return under_ ? tr("Second point") + std::string("  ") + length_text(editor, (*under_ - *first_).norm())
                    : std::string(tr("Second point"));
    return std::string(tr("Distance")) + "  " +
           (input_.active() ? input_.text(0) : length_text(editor, (*second_ - *first_).norm()));
  }

  ObjectId picture_;
  NumericInput input_;
  std::optional<Vector3> under_, first_, second_;  ///< in the document's space, before scaling
  std::optional<double> shown_length_;             ///< length that the preview has
};

}  // namespace

std::unique_ptr<Tool> make_picture_scale_tool(ObjectId picture) {
  return std::make_unique<PictureScaleTool>(picture);
}

}  // namespace hariko
