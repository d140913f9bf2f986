#include "ui/tools/draw_skin_tool.hpp"

#include <GLFW/glfw3.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/document/edits.hpp"
#include "core/skinning/add_section.hpp"
#include "core/skinning/edit_section.hpp"
#include "core/skinning/simple_skin.hpp"
#include "ui/commands/new_object.hpp"
#include "ui/skin_edits.hpp"
#include "ui/skin_view.hpp"
#include "ui/tools/curve_sketch.hpp"
#include "ui/tools/overlay_drawing.hpp"

namespace hariko {

namespace {

/// The view along the normal of a plane, upright, that shows `extent` round its point.
Camera facing(Camera camera, const CurveSketch::Plane& plane, double extent) {
  const Vector3 back = -plane.normal;
  Vector3 up = Vector3::UnitZ() - Vector3::UnitZ().dot(back) * back;
  // Looked at from above, north is up.
  if (up.norm() < 0.1) up = Vector3::UnitY() - Vector3::UnitY().dot(back) * back;
  up.normalize();
  Matrix3 axes;
  axes << up.cross(back), up, back;
  camera.orientation = Eigen::Quaterniond(axes).normalized();
  camera.target = plane.point;
  if (extent > 0) camera.distance *= extent / camera.view_height();
  return camera;
}

/// A section is about as large as the path is long, and seldom larger than twice that.
constexpr double view_of_path = 1.25;

CurveSketch::Plane plane_across(const SubdivisionCurve& path, double v) {
  const CurvePoint at = evaluate(path, v);
  const Vector3 normal = at.first.norm() > 0 ? Vector3(at.first.normalized()) : Vector3(Vector3::UnitX());
  return {at.position, normal};
}

/// Enter, keys of the curve, and what is shown of both.
class DrawingTool : public Tool {
 public:
  bool modal() const override { return true; }
  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    before_ = context.editor.camera();
  }
  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    error_.clear();
    if (press.chord.key == GLFW_KEY_ENTER || press.chord.key == GLFW_KEY_KP_ENTER) return go_on(context);
    if (press.chord.key == GLFW_KEY_BACKSPACE && sketch_.size() == 0 && !sketch_.busy()) {
      go_back(context);
      return ToolState::stay;
    }
    if (sketch_.key(press)) return ToolState::stay;
    if (press.chord.control || press.chord.alt || press.text == 0) return std::nullopt;
    return ToolState::stay;
  }
  void cancel(ToolContext& context) override {
    if (turned_) context.editor.fly_to(before_);
  }
  std::string hint(const Language& tr) const override {
    return value_text(tr) + "   |   " +
           tr("Click points or draw a stroke   C closes   P points of the polygon   Backspace: last point   "
              "Enter goes on   Esc cancels");
  }

 protected:
  virtual ToolState go_on(ToolContext& context) = 0;
  virtual void go_back(ToolContext& context) = 0;
  virtual std::string value_text(const Language& tr) const = 0;

  void feed(const ToolContext& context, const PointerEvent& event) {
    pointer_ = event.pixel;
    if (event.kind != PointerEvent::Kind::move) error_.clear();
    if (const auto error = sketch_.feed(context, event)) error_ = context.editor.language.text_of(*error);
  }
  void draw_label(const ToolContext& context, const ToolOverlay& overlay) const {
    draw_value_label(overlay, pointer_, error_.empty() ? value_text(context.editor.language) : error_,
                     !error_.empty());
  }
  void face(ToolContext& context, const SubdivisionCurve& path) {
    context.editor.fly_to(facing(context.editor.camera(), sketch_.plane(), view_of_path * length(path)));
    turned_ = true;
  }
  std::string points_text(const Language& tr) const {
    std::string text = fill(tr("points: {0}"), {std::to_string(sketch_.size())});
    if (sketch_.closed()) text += "  " + std::string(tr("closed"));
    if (!sketch_.through_points()) text += "  " + std::string(tr("control polygon"));
    return text;
  }

  CurveSketch sketch_;
  Vector2 pointer_ = Vector2::Zero();
  Camera before_;
  bool turned_ = false;  ///< the view
  std::string error_;
};

class DrawSkinTool final : public DrawingTool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    DrawingTool::begin(context, press);
    // A view along the ground draws in the plane that faces it.
    constexpr double least_slope = 0.1;
    if (std::abs(before_.forward().z()) < least_slope)
      sketch_ = CurveSketch({before_.target, before_.forward()});
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    feed(context, event);
    return ToolState::stay;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Projector projector = context.projector();
    for (const CurveSketch& sketch : done_)
      draw_curve(projector, overlay, sketch.curve(), palette().secondary, 2);
    sketch_.draw(context, overlay);
    draw_label(context, overlay);
  }

 private:
  ToolState go_on(ToolContext& context) override {
    const Language& tr = context.editor.language;
    if (!sketch_.complete()) {
      error_ = tr(sketch_.closed() ? "A closed curve needs three points." : "A curve needs two points.");
      return ToolState::stay;
    }
    if (done_.size() == 2 && done_[1].closed() != sketch_.closed()) {
      error_ = tr("Both sections are closed, or none.");
      return ToolState::stay;
    }
    if (done_.size() == 2) return finish(context);
    done_.push_back(sketch_);
    begin_section(context);
    return ToolState::stay;
  }

  void begin_section(ToolContext& context) {
    const SubdivisionCurve path = done_[0].curve();
    const double end = path.closed ? 0.5 : 1;
    sketch_ = CurveSketch(plane_across(path, done_.size() == 1 ? 0 : end));
    face(context, path);
  }

  void go_back(ToolContext& context) override {
    if (done_.empty()) return;
    const CurveSketch last = done_.back();
    done_.pop_back();
    if (done_.empty())
      context.editor.fly_to(before_);
    else
      begin_section(context);
    sketch_ = last;
  }

  ToolState finish(ToolContext& context) {
    Editor& editor = context.editor;
    const auto skin = skin_between(done_[0].curve(), done_[1].curve(), sketch_.curve());
    if (!skin) {
      error_ = editor.language.text_of(skin.error());
      return ToolState::stay;
    }
    const Document& document = editor.history.current();
    const auto added =
        add_object(document, free_name(document, editor.language("Skin")), Source(SkinSource{*skin, {}}));
    if (!added) {
      error_ = editor.language.text_of(added.error());
      return ToolState::stay;
    }
    editor.fly_to(before_);
    if (!editor.commit(added->document, translatable("Draw skin"))) return ToolState::cancel;
    editor.selection.clear_elements();
    editor.selection.active = added->id;
    editor.mode = ElementMode::vertex;
    return ToolState::commit;
  }

  std::string value_text(const Language& tr) const override {
    constexpr std::array names{translatable("Path"), translatable("First section"),
                               translatable("Last section")};
    return std::string(tr(names[done_.size()])) + "  " + points_text(tr);
  }

  std::vector<CurveSketch> done_;  ///< the path, then the first section
};

class DrawSectionTool final : public DrawingTool {
 public:
  ToolState update(ToolContext& context, const PointerEvent& event) override {
    const Object* object = shown_skin(context.editor);
    if (!object) return ToolState::commit;
    if (fixed_) {
      feed(context, event);
      return ToolState::stay;
    }
    pointer_ = event.pixel;
    view_ = view_of(*object->skin()->skin, nullptr);
    place_ = path_place(view_, *object, context.projector(), pointer_);
    if (event.kind == PointerEvent::Kind::press) choose(context, *object);
    return ToolState::stay;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Object* object = shown_skin(context.editor);
    if (!object) return;
    if (fixed_) {
      sketch_.draw(context, overlay);
    } else if (place_) {
      const Vector3 at = evaluate(object->skin()->skin->path, *place_).position;
      if (const auto pixel = pixel_of(*object, context.projector(), at)) {
        overlay.list.AddCircleFilled(on_screen(overlay, *pixel), overlay.metrics.px(7), palette().window);
        overlay.list.AddCircleFilled(on_screen(overlay, *pixel), overlay.metrics.px(5), palette().hot);
      }
    }
    draw_label(context, overlay);
  }

  std::string hint(const Language& tr) const override {
    if (!fixed_) return value_text(tr) + "   |   " + tr("Click the path where the section is wanted");
    return DrawingTool::hint(tr);
  }

 private:
  void choose(ToolContext& context, const Object& object) {
    if (!place_) return;
    fixed_ = place_;
    SubdivisionCurve path = object.skin()->skin->path;
    for (Vector3& p : path.points) p = object.transform.apply(p);
    sketch_ = CurveSketch(plane_across(path, *fixed_));
    face(context, path);
  }

  void go_back(ToolContext& context) override {
    if (!fixed_) return;
    fixed_.reset();
    context.editor.fly_to(before_);
  }

  ToolState go_on(ToolContext& context) override {
    Editor& editor = context.editor;
    const Object* object = shown_skin(editor);
    if (!object || !fixed_) return ToolState::stay;
    if (!sketch_.complete()) {
      error_ = editor.language(sketch_.closed() ? "A closed curve needs three points."
                                                : "A curve needs two points.");
      return ToolState::stay;
    }
    const SubdivisionCurve curve = sketch_.curve();
    const Similarity inverse = object->transform.inverse();
    std::vector<Vector3> points;
    for (const Vector3& p : curve.points) points.push_back(inverse.apply(p));
    auto edit = draw_section(*object->skin()->skin, *fixed_, points, curve.closed);
    if (edit) {
      std::vector<std::uint32_t> corners;
      for (int i = 0; i < curve.size(); ++i)
        if (curve.is_sharp(i)) corners.push_back(edit->points[std::size_t(i)]);
      if (!corners.empty()) edit.value().skin = set_sharp(edit->skin, corners, true).value().skin;
    }
    if (!edit) {
      error_ = editor.language.text_of(edit.error());
      return ToolState::stay;
    }
    editor.fly_to(before_);
    if (commit_skin(editor, object->id, edit, translatable("Draw section"))) select_new_points(editor, *edit);
    return ToolState::commit;
  }

  std::string value_text(const Language& tr) const override {
    std::string text = tr("Section");
    const auto place = fixed_ ? fixed_ : place_;
    if (place) text += "  " + fixed_text(100 * *place, 1) + " %";
    return fixed_ ? text + "  " + points_text(tr) : text;
  }

  SkinView view_;
  std::optional<double> place_, fixed_;  ///< on the path: under the pointer, and chosen
};

}  // namespace

std::unique_ptr<Tool> make_draw_skin_tool() {
  return std::make_unique<DrawSkinTool>();
}

std::unique_ptr<Tool> make_draw_section_tool() {
  return std::make_unique<DrawSectionTool>();
}

}  // namespace hariko
