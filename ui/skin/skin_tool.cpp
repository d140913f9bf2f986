#include "ui/skin/skin_tools.hpp"

#include <Eigen/Geometry>

#include "core/document/edits/edit_skin.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "core/skinning/edit/symmetric_edit.hpp"
#include "core/skinning/sections/section_frame.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/skin/correspondence_drag.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/skin_sight.hpp"

namespace hariko {

namespace {

using How = Selection::How;

class SkinTool final : public SpeakingTool {
 public:
  SkinTool(ObjectId object, SkinView view, SkinHit hit)
      : object_(object), view_(std::move(view)), hit_(hit) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    press_ = press;
    pointer_ = press.pixel;
    before_ = context.editor.selection;
    const Object* object = context.editor.history.current().find(object_);
    if (object && object->skin()) skin_ = *object->skin()->skin;
    if (hit_.kind == SkinHit::Kind::diamond) merge_.emplace(skin_, view_, hit_.index);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    Editor& editor = context.editor;
    pointer_ = event.pixel;
    if (event.kind == PointerEvent::Kind::release) {
      if (!dragging_) {
        select(editor);
        return ToolState::commit;
      }
      const bool changed = editor.history.in_gesture();
      editor.commit_preview(label());
      return changed ? ToolState::commit : ToolState::cancel;
    }
    if (!dragging_) {
      if ((event.pixel - press_.pixel).norm() <= drag_threshold * editor.pixel_scale) return ToolState::stay;
      dragging_ = true;
      // The panel then shows what is dragged.
      const VertexId id{handle() ? handle()->id : 0};
      if (handle() && !editor.selection.of(object_).vertices.contains(id)) select(editor);
    }
    show(context, event);
    return ToolState::stay;
  }

  void cancel(ToolContext& context) override {
    context.editor.cancel_preview();
    context.editor.selection = before_;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!dragging_) return;
    draw_value_label(overlay, pointer_, error_.empty() ? value(context) : error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    if (hit_.kind == SkinHit::Kind::diamond)
      return tr("Drag along the lines to merge earlier or later   sideways: to another line");
    if (handle()->kind == SkinView::Handle::Kind::path) return tr("Release to select, drag to move");
    return skin_.mirror
               ? tr("Release to select, drag to move   Ctrl: this half only   Alt: parallel to the screen")
               : tr("Release to select, drag to move   Ctrl: both halves   Alt: parallel to the screen");
  }

 private:
  const SkinView::Handle* handle() const {
    return hit_.kind == SkinHit::Kind::handle ? &view_.handles[hit_.index] : nullptr;
  }

  std::string label() const {
    if (hit_.kind == SkinHit::Kind::diamond) return "Move a merge";
    return handle()->kind == SkinView::Handle::Kind::path ? "Move path" : "Move section points";
  }

  void select(Editor& editor) const {
    if (!handle()) return;
    editor.mode = ElementMode::vertex;
    editor.selection.select({object_, element_of(VertexId{handle()->id})},
                            press_.shift ? How::add : How::replace);
    editor.selection.active = object_;
  }

  /// The way of the pointer in the object's space, in the plane of the section or parallel to the screen.
  Vector3 way(const ToolContext& context, const Object& object, bool facing) const {
    const Projector projector = context.projector();
    const Similarity& place = object.transform;
    const Vector3 anchor = place.apply(handle()->position);
    const auto in_object = [&](const Vector3& offset) {
      return Vector3(place.rotation.conjugate() * offset / place.scale);
    };
    const Vector3 normal = handle()->section >= 0 && !facing
                               ? section_normal(skin_.sections[std::size_t(handle()->section)])
                               : Vector3(Vector3::Zero());
    const Vector3 n = place.rotation * normal;
    const Ray from = projector.ray(press_.pixel), to = projector.ray(pointer_);
    // Seen from the edge a plane would throw points far away.
    constexpr double least_slope = 0.17;
    const double slope_from = n.dot(from.direction.normalized()), slope_to = n.dot(to.direction.normalized());
    if (std::abs(slope_from) > least_slope && std::abs(slope_to) > least_slope && slope_from * slope_to > 0) {
      const auto meet = [&](const Ray& ray) {
        return Vector3(ray.origin + ray.direction * (n.dot(anchor - ray.origin) / n.dot(ray.direction)));
      };
      return in_object(meet(to) - meet(from));
    }
    return in_object(projector.on_facing_plane(pointer_, anchor) -
                     projector.on_facing_plane(press_.pixel, anchor));
  }

  /// `both`: the images of points in a mirror follow them.
  Result<SkinEdit> moved(const ToolContext& context, const Object& object, bool facing, bool both) {
    const Vector3 by = way(context, object, facing);
    const SkinView::Handle& held = *handle();
    const MirrorPlane plane = mirror_plane(skin_);
    if (held.kind == SkinView::Handle::Kind::limit && selected_count(context.editor) < 2)
      return both ? move_limit_point(skin_, held.id, held.position + by, plane)
                  : move_limit_point(skin_, held.id, held.position + by);
    std::vector<MovedPathPoint> path;
    std::vector<MovedPoint> points;
    for (const VertexId id : context.editor.selection.of(object_).vertices) {
      if (is_path_point(id.value)) {
        const bool rail = id.value >= rail_point_ids;
        const int index = int(id.value - (rail ? rail_point_ids : path_point_ids));
        if (rail && !skin_.second_rail) continue;
        const SubdivisionCurve& curve = rail ? *skin_.second_rail : skin_.path;
        if (index < curve.size())
          path.push_back({rail ? PathCurve::second_rail : PathCurve::path, index,
                          curve.points[std::size_t(index)] + by});
        continue;
      }
      for (const SkinSection& section : skin_.sections)
        if (const int i = find_point(section, id.value); i >= 0)
          points.push_back({id.value, section.points[std::size_t(i)].position + by});
    }
    if (points.empty()) return move_path_points(skin_, path);
    if (path.empty())
      return both ? move_section_points(skin_, points, plane) : move_section_points(skin_, points);
    // The path carries the sections; chosen points then go where they are drawn.
    const auto carried = move_path_points(skin_, path);
    if (!carried) return carried;
    return both ? move_section_points(carried->skin, points, plane)
                : move_section_points(carried->skin, points);
  }

  std::size_t selected_count(const Editor& editor) const {
    return editor.selection.of(object_).vertices.size();
  }

  void show(ToolContext& context, const PointerEvent& event) {
    Editor& editor = context.editor;
    const Object* object = editor.history.current().find(object_);
    if (!object || !object->skin()) return;
    Result<Document> next = editor.history.current();
    if (merge_) {
      const auto slid = merge_->to({*object, context.projector(), pointer_, editor.pixel_scale, event.alt});
      next = slid ? set_skin(editor.history.current(), object_, slid->skin) : slid.error();
    } else {
      next = with_skin(editor.history.current(), object_,
                       moved(context, *object, event.alt, event.control != skin_.mirror.has_value()));
    }
    error_ = next ? std::string() : editor.language.text_of(next.error());
    if (next) editor.preview(next);
  }

  std::string value(const ToolContext& context) const {
    if (merge_) return fixed_text(merge_->along(), 2);
    const Object* object = context.editor.document().find(object_);
    const double length = object ? way(context, *object, false).norm() * object->transform.scale : 0;
    return length_text(context.editor, length);
  }

  ObjectId object_;
  SkinView view_;  ///< as it was at the press
  SkinHit hit_;
  Skin skin_;
  PointerEvent press_;
  Selection before_;
  std::optional<MergeDrag> merge_;
  bool dragging_ = false;
};

}  // namespace

std::unique_ptr<Tool> skin_tool_at(const ToolContext& context, const PointerEvent& press) {
  const Object* object = shown_skin(context.editor);
  if (!object || press.button != PointerButton::left || press.control || press.alt) return nullptr;
  if (context.editor.mode == ElementMode::object) return nullptr;
  SkinView view = view_of(*object->skin()->skin, shown_surface(context.editor, *object));
  const Projector projector = context.projector();
  const SkinHit hit = SkinSight(context.editor, projector, view, *object)
                          .hit(projector, press.pixel, context.editor.pixel_scale);
  if (hit.kind == SkinHit::Kind::none) return nullptr;
  if (hit.kind == SkinHit::Kind::handle && view.handles[hit.index].kind == SkinView::Handle::Kind::place)
    return make_slide_section_tool(view.handles[hit.index].id, false);
  return std::make_unique<SkinTool>(object->id, std::move(view), hit);
}

}  // namespace hariko
