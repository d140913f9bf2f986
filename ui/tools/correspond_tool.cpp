#include "ui/tools/correspond_tool.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>

#include "core/document/edit_skin.hpp"
#include "ui/skin_edits.hpp"
#include "ui/tools/overlay_drawing.hpp"

namespace hariko {

namespace {

constexpr double line_reach = 9;  // design pixels within which a line is meant

class CorrespondTool final : public Tool {
 public:
  bool modal() const override { return true; }

  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    look(context);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    if (!shown_skin(context.editor)) return ToolState::commit;
    switch (event.kind) {
      case PointerEvent::Kind::press:
        error_.clear();
        if (!take_diamond(context)) stroke_ = {event.pixel};
        break;
      case PointerEvent::Kind::move:
        if (diamond_)
          drag_diamond(context);
        else if (!stroke_.empty())
          stroke_.push_back(event.pixel);
        break;
      case PointerEvent::Kind::release:
        if (diamond_)
          drop_diamond(context);
        else if (!stroke_.empty())
          finish_stroke(context);
        break;
    }
    look(context);
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    const KeyChord& chord = press.chord;
    Editor& editor = context.editor;
    if (chord.key == GLFW_KEY_ENTER || chord.key == GLFW_KEY_KP_ENTER) return ToolState::commit;
    if (chord.key == GLFW_KEY_Z && chord.control) {
      cancel(context);
      if (chord.shift)
        editor.redo();
      else
        editor.undo();
      look(context);
      return ToolState::stay;
    }
    if (chord.control || chord.alt) return std::nullopt;
    if (chord.key == GLFW_KEY_DELETE || chord.key == GLFW_KEY_BACKSPACE) {
      with_hovered(context, "Delete correspondence", [](const Skin& skin, const SkinView::Line& line) {
        return line.entry ? delete_correspondence(skin, *line.entry) : nothing();
      });
    } else if (chord.key == GLFW_KEY_L) {
      with_hovered(context, "Lock correspondence", [](const Skin& skin, const SkinView::Line& line) {
        return line.entry && line.locked ? set_locked(skin, *line.entry, false)
                                         : lock_line(skin, line.a, line.b);
      });
    } else if (chord.key == GLFW_KEY_R) {
      with_hovered(context, "Reset strip", [](const Skin& skin, const SkinView::Line& line) {
        const auto n = skin.sections.size();
        return Result<CorrespondenceEdit>(reset_strip(skin, skin.sections[std::size_t(line.strip)].id,
                                                      skin.sections[(std::size_t(line.strip) + 1) % n].id));
      });
    } else if (press.text == 0) {
      return std::nullopt;
    }
    // Other letters would run commands in the middle of the tool.
    return ToolState::stay;
  }

  void cancel(ToolContext& context) override {
    stroke_.clear();
    if (diamond_) context.editor.cancel_preview();
    diamond_.reset();
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Object* object = shown_skin(context.editor);
    if (!object) return;
    if (hovered_ && hovered_->line < view_.lines.size() && stroke_.empty() && !diamond_) {
      const Projector projector = context.projector();
      const SkinView::Line& line = view_.lines[hovered_->line];
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const auto a = projector.project(object->transform.apply(line.points[i])),
                   b = projector.project(object->transform.apply(line.points[i + 1]));
        if (a && b)
          overlay.list.AddLine(on_screen(overlay, a->head<2>()), on_screen(overlay, b->head<2>()),
                               palette().secondary, overlay.metrics.px(3));
      }
    }
    for (std::size_t i = 0; i + 1 < stroke_.size(); ++i)
      overlay.list.AddLine(on_screen(overlay, stroke_[i]), on_screen(overlay, stroke_[i + 1]), palette().hot,
                           overlay.metrics.px(2.5F));
    if (diamond_)
      draw_value_label(overlay, pointer_, error_.empty() ? fixed_text(along_, 2) : error_, !error_.empty());
    else
      draw_value_label(overlay, pointer_, error_, true);
  }

  std::string hint(const Language& tr) const override {
    return tr(
        "Line: joins points   closed curve: groups them   wedge: merges them at its tip   Del, L, R: "
        "delete, lock, reset   Esc ends");
  }

 private:
  static Result<CorrespondenceEdit> nothing() {
    return make_error(e_no_correspondence, "There is no such correspondence.", "Select one of the lines.");
  }

  static const Object& skin_object(const ToolContext& context) { return *shown_skin(context.editor); }

  /// The view of the skin as it is now, and the line under the pointer.
  void look(const ToolContext& context) {
    hovered_.reset();
    const Object* object = shown_skin(context.editor);
    if (!object) return;
    if (!diamond_) view_ = cache_.of(object->skin()->skin);
    if (!stroke_.empty() || diamond_) return;
    const auto hit = nearest_line(view_, *object, context.projector(), pointer_);
    if (hit && hit->distance <= line_reach * context.editor.pixel_scale) hovered_ = hit;
  }

  template <class Edit>
  void with_hovered(ToolContext& context, const char* label, const Edit& edit) {
    if (!stroke_.empty() || diamond_ || !shown_skin(context.editor)) return;
    look(context);
    if (!hovered_) return;
    const Object& object = skin_object(context);
    const auto result = edit(*object.skin()->skin, view_.lines[hovered_->line]);
    error_ = result ? std::string() : context.editor.language.text_of(result.error());
    if (result) commit_skin(context.editor, object.id, result, label);
    look(context);
  }

  void finish_stroke(ToolContext& context) {
    Editor& editor = context.editor;
    std::vector<Vector2> pixels = std::move(stroke_);
    stroke_.clear();
    if (pixels.size() < 2) return;
    for (Vector2& p : pixels) p /= editor.pixel_scale;
    Stroke stroke = classify_stroke(pixels);
    for (Vector2& p : stroke.points) p *= editor.pixel_scale;
    const Object& object = skin_object(context);
    const auto edit = gesture_edit(*object.skin()->skin, cache_.of(object.skin()->skin), object,
                                   context.projector(), stroke, editor.pixel_scale);
    if (!edit) {
      error_ = editor.language.text_of(edit.error()) + "  " + editor.language.remedy_of(edit.error());
      return;
    }
    const char* label = stroke.kind == StrokeKind::line    ? "Join points"
                        : stroke.kind == StrokeKind::lasso ? "Group points"
                                                           : "Merge points";
    commit_skin(editor, object.id, edit, label);
  }

  bool take_diamond(const ToolContext& context) {
    const Object& object = skin_object(context);
    const Projector projector = context.projector();
    for (const SkinView::Diamond& diamond : view_.diamonds) {
      const auto at = projector.project(object.transform.apply(diamond.position));
      if (!at || (at->head<2>() - pointer_).norm() > 10 * context.editor.pixel_scale) continue;
      diamond_ = diamond;
      skin_ = *object.skin()->skin;
      object_ = context.editor.history.current().find_shared(object.id);
      return true;
    }
    return false;
  }

  void drag_diamond(ToolContext& context) {
    Editor& editor = context.editor;
    const auto merge = std::find_if(skin_.merges.begin(), skin_.merges.end(),
                                    [&](const SkinMerge& m) { return m.id == diamond_->merge; });
    const auto hit = nearest_line(view_, *object_, context.projector(), pointer_, {diamond_->strip});
    if (merge == skin_.merges.end() || !hit) return;
    const SkinView::Line& line = view_.lines[hit->line];
    along_ = std::clamp(hit->along, 0.02, 0.98);
    const auto edit = move_merge(skin_, merge->id, along_, merge->side == StripSide::a ? line.b : line.a);
    error_ = edit ? std::string() : editor.language.text_of(edit.error());
    if (edit) editor.preview(set_skin(editor.history.current(), object_->id, edit->skin));
  }

  void drop_diamond(ToolContext& context) {
    if (context.editor.history.in_gesture()) context.editor.commit_preview("Move a merge");
    diamond_.reset();
  }

  SkinViewCache cache_;
  SkinView view_;
  Vector2 pointer_ = Vector2::Zero();
  std::vector<Vector2> stroke_;
  std::optional<LineHit> hovered_;
  std::optional<SkinView::Diamond> diamond_;
  Skin skin_;                             ///< when the diamond was taken
  std::shared_ptr<const Object> object_;  ///< likewise
  double along_ = 0;
  std::string error_;
};

}  // namespace

std::unique_ptr<Tool> make_correspond_tool() {
  return std::make_unique<CorrespondTool>();
}

}  // namespace hariko
