#include "ui/skin/skin_tools.hpp"

#include <algorithm>

#include "core/document/edits/edit_skin.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/skin/correspondence_drag.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/skin_sight.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

namespace {

constexpr double line_reach = 9;  // design pixels within which a line is meant

class CorrespondTool final : public PointingTool {
 public:
  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    if (!shown_skin(context.editor)) return ToolState::commit;
    switch (event.kind) {
      case PointerEvent::Kind::press:
        error_.clear();
        if (!take_hold(context)) stroke_ = {event.pixel};
        break;
      case PointerEvent::Kind::move:
        if (dragging())
          drag(context, event.alt);
        else if (!stroke_.empty())
          stroke_.push_back(event.pixel);
        break;
      case PointerEvent::Kind::release:
        if (dragging())
          drop(context);
        else if (!stroke_.empty())
          finish_stroke(context);
        break;
    }
    look(context);
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    const KeyChord& chord = press.chord;
    if (chord.key == Key::enter) return ToolState::commit;
    if (chord.control && (chord.key == Key::z || chord.key == Key::y)) {
      cancel(context);
      error_.clear();
      if (chord.shift || chord.key == Key::y)
        context.editor.redo();
      else
        context.editor.undo();
      look(context);
      return ToolState::stay;
    }
    if (chord.control || chord.alt) return std::nullopt;
    if (chord.key == Key::delete_forward || chord.key == Key::backspace) {
      with_hovered(context, "Delete correspondence", [](const Skin& skin, const SkinView::Line& line) {
        return line.entry ? delete_correspondence(skin, *line.entry) : nothing();
      });
    } else if (chord.key == Key::l) {
      with_hovered(context, "Lock correspondence", [](const Skin& skin, const SkinView::Line& line) {
        return line.entry && line.locked ? set_locked(skin, *line.entry, false)
                                         : lock_line(skin, line.a, line.b);
      });
    } else if (chord.key == Key::r) {
      with_hovered(context, "Reset strip", [](const Skin& skin, const SkinView::Line& line) {
        return Result<CorrespondenceEdit>(reset_strip(skin, line.first, line.second));
      });
    } else if (press.text == 0) {
      return std::nullopt;
    }
    // Other letters would run commands in the middle of the tool.
    return ToolState::stay;
  }

  void cancel(ToolContext& context) override {
    stroke_.clear();
    if (dragging()) context.editor.cancel_preview();
    merge_.reset();
    end_.reset();
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Object* object = shown_skin(context.editor);
    if (!object) return;
    const Projector projector = context.projector();
    if (context.editor.now < flash_until_)
      for (const auto& line : flashed_) draw_polyline(*object, projector, overlay, line, palette().error, 3);
    if (hovered_ && hovered_->line < view_.lines.size() && stroke_.empty() && !dragging())
      draw_hovered(context, *object, overlay);
    for (std::size_t i = 0; i + 1 < stroke_.size(); ++i)
      overlay.list.AddLine(on_screen(overlay, stroke_[i]), on_screen(overlay, stroke_[i + 1]), palette().hot,
                           overlay.metrics.px(2.5F));
    if (end_)
      if (const auto anchor = pixel_of(*object, projector, end_->anchor()))
        draw_dashed_line(overlay, *anchor, pointer_, palette().hot);
    if (merge_ && error_.empty())
      draw_value_label(overlay, pointer_, fixed_text(merge_->along(), 2));
    else
      draw_value_label(overlay, pointer_, error_, true);
  }

  std::string hint(const Language& tr) const override {
    if (merge_) return tr("Drag along the lines to merge earlier or later   sideways: to another line");
    if (end_) return tr("Drag the end of the line to another point of its section");
    return tr(
        "Line: joins points   closed curve: groups them   wedge: merges them at its tip   drag ends and "
        "diamonds   Del, L, R: delete, lock, reset   Esc ends");
  }

 private:
  static constexpr double flash_seconds = 1.5;

  static Result<CorrespondenceEdit> nothing() {
    return make_error(e_no_correspondence, "There is no such correspondence.", "Select one of the lines.");
  }

  static const Object& skin_object(const ToolContext& context) { return *shown_skin(context.editor); }

  bool dragging() const { return merge_ || end_; }

  /// The view of the skin as it is now, and the line under the pointer.
  void look(const ToolContext& context) override {
    hovered_.reset();
    const Object* object = shown_skin(context.editor);
    if (!object) return;
    if (!dragging()) view_ = cache_.of(context.editor, *object);
    if (!stroke_.empty() || dragging()) return;
    const auto hit = nearest_line(view_, *object, context.projector(), pointer_);
    if (hit && hit->distance <= line_reach * context.editor.pixel_scale) hovered_ = hit;
  }

  static void draw_polyline(const Object& object, const Projector& projector, const ToolOverlay& overlay,
                            const std::vector<Vector3>& points, ImU32 colour, float width) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const auto a = pixel_of(object, projector, points[i]), b = pixel_of(object, projector, points[i + 1]);
      if (a && b)
        overlay.list.AddLine(on_screen(overlay, *a), on_screen(overlay, *b), colour,
                             overlay.metrics.px(width));
    }
  }

  /// The line across all sections, and the ends that can be dragged.
  void draw_hovered(const ToolContext& context, const Object& object, const ToolOverlay& overlay) const {
    const Projector projector = context.projector();
    for (const std::size_t l : connected_lines(view_, hovered_->line))
      draw_polyline(object, projector, overlay, view_.lines[l].points,
                    with_alpha(palette().secondary, l == hovered_->line ? 1.0F : 0.55F), 3);
    const double scale = context.editor.pixel_scale;
    const auto hot = line_end_at(view_, object, projector, hovered_->line, pointer_, scale);
    for (const LineEnd& end : line_ends(view_, object, projector, hovered_->line, pointer_, scale)) {
      const bool under = hot && hot->at_b == end.at_b;
      const ImVec2 at = on_screen(overlay, end.pixel);
      overlay.list.AddCircleFilled(at, overlay.metrics.px(under ? 6.5F : 5), palette().window);
      overlay.list.AddCircle(at, overlay.metrics.px(under ? 6.5F : 5), palette().secondary, 0,
                             overlay.metrics.px(2));
    }
  }

  template <class Edit>
  void with_hovered(ToolContext& context, const char* label, const Edit& edit) {
    if (!stroke_.empty() || dragging() || !shown_skin(context.editor)) return;
    look(context);
    if (!hovered_) return;
    const Object& object = skin_object(context);
    const auto result = edit(*object.skin()->skin, view_.lines[hovered_->line]);
    error_ = result ? std::string() : context.editor.language.text_of(result.error());
    if (result) commit_skin(context.editor, object.id, result, label);
    look(context);
  }

  /// Shows for a moment in red what gave way.
  void flash(const Editor& editor, const CorrespondenceEdit& edit) {
    flashed_.clear();
    for (const SkinView::Line& line : view_.lines)
      if (line.entry &&
          std::find(edit.removed.begin(), edit.removed.end(), *line.entry) != edit.removed.end())
        flashed_.push_back(line.points);
    if (!flashed_.empty()) flash_until_ = editor.now + flash_seconds;
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
    const SkinView& view = cache_.of(editor, object);
    const Projector projector = context.projector();
    const auto edit = gesture_edit(*object.skin()->skin, view, object, projector, stroke, editor.pixel_scale,
                                   SkinSight(editor, projector, view, object).hidden_points());
    if (!edit) {
      error_ = editor.language.text_of(edit.error()) + "  " + editor.language.remedy_of(edit.error());
      return;
    }
    const char* label = stroke.kind == StrokeKind::line    ? "Join points"
                        : stroke.kind == StrokeKind::lasso ? "Group points"
                                                           : "Merge points";
    flash(editor, *edit);
    commit_skin(editor, object.id, edit, label);
  }

  /// Takes hold of the diamond under the pointer, or of the end of the line under it.
  bool take_hold(const ToolContext& context) {
    const Object& object = skin_object(context);
    look(context);
    const Projector projector = context.projector();
    const double scale = context.editor.pixel_scale;
    const Skin& skin = *object.skin()->skin;
    const SkinHit hit = SkinSight(context.editor, projector, view_, object).hit(projector, pointer_, scale);
    if (hit.kind == SkinHit::Kind::diamond) {
      merge_.emplace(skin, view_, hit.index);
    } else if (hovered_) {
      const auto end = line_end_at(view_, object, projector, hovered_->line, pointer_, scale);
      if (end) end_.emplace(skin, view_, *end);
    }
    if (dragging()) object_ = context.editor.history.current().find_shared(object.id);
    return dragging();
  }

  void drag(ToolContext& context, bool free) {
    Editor& editor = context.editor;
    const DragPlace place{*object_, context.projector(), pointer_, editor.pixel_scale, free};
    const auto edit = merge_ ? merge_->to(place) : end_->to(place);
    error_ = edit ? std::string() : editor.language.text_of(edit.error());
    if (edit) editor.preview(set_skin(editor.history.current(), object_->id, edit->skin));
  }

  void drop(ToolContext& context) {
    if (context.editor.history.in_gesture())
      context.editor.commit_preview(merge_ ? "Move a merge" : "Move a correspondence");
    merge_.reset();
    end_.reset();
  }

  SkinViewCache cache_;
  SkinView view_;
  std::vector<Vector2> stroke_;
  std::optional<LineHit> hovered_;
  std::optional<MergeDrag> merge_;
  std::optional<LineEndDrag> end_;
  std::shared_ptr<const Object> object_;  ///< object when what is dragged was taken
  std::vector<std::vector<Vector3>> flashed_;
  double flash_until_ = 0;
};

}  // namespace

std::unique_ptr<Tool> make_correspond_tool() {
  return std::make_unique<CorrespondTool>();
}

}  // namespace hariko
