#include "ui/skin/skin_tools.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/document/edits/edits.hpp"
#include "core/skinning/columns/simple_skin.hpp"
#include "core/skinning/edit/add_section.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/skin/curve_sketch.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

/// The view along the normal of a plane, upright, that shows `extent` round its point.
Camera facing(Camera camera, const CurveSketch& sketch, double extent) {
  camera.orientation = Eigen::Quaterniond(sketch.axes()).normalized();
  camera.target = sketch.plane().point;
  if (extent > 0) camera.distance *= extent / camera.view_height();
  return camera;
}

/// A section that is there already, for another plane.
struct DrawnSection {
  CurveSketch::Plane plane;
  SubdivisionCurve curve;
};

/// The control points of a section as they lie in another plane.
std::vector<Vector3> carried(const DrawnSection& section, const CurveSketch::Plane& plane) {
  const Matrix3 from = upright_axes(section.plane.normal), to = carried_axes(from, plane.normal);
  std::vector<Vector3> out;
  for (const Vector3& p : section.curve.points)
    out.push_back(plane.point + to * (from.transpose() * (p - section.plane.point)));
  return out;
}

/// A section is about as large as the path is long, and seldom larger than twice that.
constexpr double view_of_path = 1.25;

CurveSketch::Plane plane_across(const SubdivisionCurve& path, double v) {
  const CurvePoint at = evaluate(path, v);
  const Vector3 normal = at.first.norm() > 0 ? Vector3(at.first.normalized()) : Vector3(Vector3::UnitX());
  return {at.position, normal};
}

/// Enter, keys of the curve, and what is shown of both.
class DrawingTool : public ModalTool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    before_ = context.editor.camera();
  }
  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    error_.clear();
    const Unit unit = context.editor.document().unit;
    if (press.chord.key == Key::enter) {
      if (!shape_.active()) return go_on(context);
      set_shape();
      return ToolState::stay;
    }
    if (draws_section() && (shape_.active() || !sketch_.busy()) && shape_.key(press, unit))
      return ToolState::stay;
    if (draws_section() && press.chord.key == Key::n && !press.chord.control && !press.chord.alt) {
      take_nearest(context);
      return ToolState::stay;
    }
    if (press.chord.key == Key::backspace && sketch_.size() == 0 && !sketch_.busy()) {
      go_back(context);
      return ToolState::stay;
    }
    if (sketch_.key(press)) return ToolState::stay;
    return unused_key(press);
  }
  void cancel(ToolContext& context) override {
    if (turned_) context.editor.fly_to(before_);
  }
  std::string hint(const Language& tr) const override {
    if (shape_.active())
      return value_text(tr) + "   |   " +
             tr("Click or type the size   Tab: height   Ctrl snaps   Enter takes it   Backspace: no shape");
    const std::string shapes =
        draws_section()
            ? std::string(tr("O circle   E ellipse   R rectangle   N like the nearest section")) + "   "
            : std::string();
    return value_text(tr) + "   |   " + shapes +
           tr("Click points or draw a stroke   C closes   P points of the polygon   Backspace: last point   "
              "Enter goes on   Esc cancels");
  }

 protected:
  virtual ToolState go_on(ToolContext& context) = 0;
  virtual void go_back(ToolContext& context) = 0;
  /// Whether a section is drawn now, and not a path.
  virtual bool draws_section() const = 0;
  /// The section to begin with on request; nothing where there is none.
  virtual std::optional<DrawnSection> nearest(const ToolContext& context) const = 0;
  virtual std::string value_text(const Language& tr) const = 0;

  void feed(const ToolContext& context, const PointerEvent& event) {
    pointer_ = event.pixel;
    if (event.kind != PointerEvent::Kind::move) error_.clear();
    const bool snaps = snaps_now(context.editor, event.control);
    sketch_.look_for_places(context);
    caught_ = snaps && !sketch_.closed() ? sketch_.caught(context, event.pixel) : std::nullopt;
    if (shape_.active()) {
      shape_.follow(context, sketch_, event.pixel, snaps);
      if (event.kind == PointerEvent::Kind::press) set_shape();
      return;
    }
    if (const auto error = sketch_.feed(context, event)) error_ = context.editor.language.text_of(*error);
  }
  /// The plane, what was drawn in it, and numbers at the pointer.
  void draw_sketch(const ToolContext& context, const ToolOverlay& overlay) const {
    if (turned_) draw_plane_grid(context, overlay, sketch_.plane().point, sketch_.axes());
    shape_.active() ? shape_.draw(context, overlay, sketch_) : sketch_.draw(context, overlay);
    if (caught_ && !sketch_.busy()) draw_snap_target(context, overlay, *caught_);
  }
  void draw_label(const ToolContext& context, const ToolOverlay& overlay) const {
    const std::string text = value_text(context.editor.language) + numbers(context);
    draw_value_label(overlay, pointer_, error_.empty() ? text : error_, !error_.empty());
  }
  /// The size of a shape, or where the pointer is in the plane, from its middle.
  std::string numbers(const ToolContext& context) const {
    if (shape_.active()) return "   " + shape_.text(context.editor);
    const auto at = turned_ ? sketch_.place(context, pointer_, false) : std::nullopt;
    if (!at) return {};
    const Vector3 local = sketch_.axes().transpose() * (*at - sketch_.plane().point);
    return "   x " + length_text(context.editor, local.x()) + "   y " +
           length_text(context.editor, local.y());
  }
  const char* lacks_points() const {
    return sketch_.closed() ? "A closed curve needs three points." : "A curve needs two points.";
  }
  void set_shape() {
    if (shape_.fill(sketch_)) shape_.end();
  }
  void take_nearest(const ToolContext& context) {
    const auto section = nearest(context);
    if (!section) return void(refuse(context, "There is no other section yet."));
    sketch_.fill(carried(*section, sketch_.plane()), section->curve.sharp, section->curve.closed, false);
    shape_.end();
  }
  void face(ToolContext& context, const SubdivisionCurve& path) {
    context.editor.fly_to(facing(context.editor.camera(), sketch_, view_of_path * length(path)));
    turned_ = true;
  }
  std::string points_text(const Language& tr) const {
    std::string text = fill(tr("points: {0}"), {std::to_string(sketch_.size())});
    if (caught_) text += "  " + std::string(tr(snap_name(caught_->kind)));
    if (sketch_.closed()) text += "  " + std::string(tr("closed"));
    if (!sketch_.through_points()) text += "  " + std::string(tr("control polygon"));
    return text;
  }

  CurveSketch sketch_;
  ShapeSketch shape_;
  Camera before_;
  bool turned_ = false;  ///< the view
  std::optional<SnapTarget> caught_;
};

class DrawSkinTool final : public DrawingTool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    DrawingTool::begin(context, press);
    const WorkingPlane& plane = context.editor.working_plane;
    const Vector3 normal = plane.frame.normal();
    // A view along the plane draws in the plane that faces it.
    constexpr double least_slope = 0.1;
    if (std::abs(before_.forward().dot(normal)) < least_slope)
      sketch_ = CurveSketch({before_.target, before_.forward()});
    else if (!plane.is_ground())
      sketch_ = CurveSketch({plane.frame.point, normal, plane.frame.axes});
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    feed(context, event);
    return ToolState::stay;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Projector projector = context.projector();
    // Seen along itself the path would be a bar across the section.
    for (std::size_t i = 0; i < done_.size(); ++i)
      draw_curve(projector, overlay, done_[i].curve(),
                 i == 0 ? with_alpha(palette().secondary, 0.3F) : palette().secondary, i == 0 ? 1.2F : 2);
    draw_sketch(context, overlay);
    draw_label(context, overlay);
  }

 private:
  bool draws_section() const override { return !done_.empty(); }
  std::optional<DrawnSection> nearest(const ToolContext&) const override {
    if (done_.size() < 2) return {};
    return DrawnSection{done_[1].plane(), done_[1].curve()};
  }

  ToolState go_on(ToolContext& context) override {
    if (!sketch_.complete()) return refuse(context, lacks_points());
    if (done_.size() == 2 && done_[1].closed() != sketch_.closed())
      return refuse(context, "Both sections are closed, or none.");
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
    if (!skin) return refuse(context, skin.error());
    const Document& document = editor.history.current();
    const auto added =
        add_object(document, free_name(document, editor.language("Skin")), Source(SkinSource{*skin, {}}));
    if (!added) return refuse(context, added.error());
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
      draw_sketch(context, overlay);
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

  bool draws_section() const override { return fixed_.has_value(); }
  std::optional<DrawnSection> nearest(const ToolContext& context) const override {
    const Object* object = shown_skin(context.editor);
    if (!object || !fixed_) return {};
    const Skin& skin = *object->skin()->skin;
    const SkinSection* best = nullptr;
    for (const SkinSection& section : skin.sections)
      if (section.size() > 1 && (!best || std::abs(section.v - *fixed_) < std::abs(best->v - *fixed_)))
        best = &section;
    if (!best) return {};
    SubdivisionCurve path = skin.path, curve = best->curve();
    for (Vector3& p : path.points) p = object->transform.apply(p);
    for (Vector3& p : curve.points) p = object->transform.apply(p);
    return DrawnSection{plane_across(path, best->v), curve};
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
    if (!sketch_.complete()) return refuse(context, lacks_points());
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
    if (!edit) return refuse(context, edit.error());
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
