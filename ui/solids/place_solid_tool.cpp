#include "ui/solids/new_solids.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/modeling/objects/place_solid.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/snapping.hpp"

namespace hariko {

namespace {

constexpr double least_ground_slope = 0.02;  ///< slope of rays against the plane on which the solid stands
constexpr int circle_sides = 48;

/// Stand of a new solid, in the document's space.
struct Stand {
  Vector3 point, up;
};

class PlaceSolidTool final : public ModalTool {
 public:
  explicit PlaceSolidTool(NewSolid shape) : shape_(std::move(shape)) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    usual_radius_ = new_object_radius(context.editor);
    plane_ = context.editor.working_plane;
    look(context, press);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    switch (event.kind) {
      case PointerEvent::Kind::press:
        look(context, event);
        if (stand_) pressed_ = event.pixel;
        return ToolState::stay;
      case PointerEvent::Kind::release:
        return pressed_ ? put(context) : ToolState::stay;
      case PointerEvent::Kind::move:
        if (pressed_)
          drag(context, event);
        else
          look(context, event);
    }
    return ToolState::stay;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Language& tr = context.editor.language;
    if (!stand_) {
      draw_value_label(overlay, pointer_,
                       tr(plane_.is_ground() ? "Click on the ground or on a solid."
                                             : "Click on the working plane or on a solid."),
                       true);
      return;
    }
    draw_circle(context.projector(), overlay);
    if (caught_) draw_snap_target(context, overlay, *caught_);
    draw_value_label(overlay, pointer_, length_text(context.editor, radius()));
  }

  std::string hint(const Language& tr) const override {
    return tr(shape_.label) + (caught_ ? "   " + std::string(tr(snap_name(caught_->kind))) : std::string()) +
           "   |   " + tr("Click places it   drag for its size   Ctrl snaps   Esc cancels");
  }

 private:
  double radius() const { return dragged_ > 0 ? dragged_ : usual_radius_; }

  static std::optional<Stand> on_solid(const ToolContext& context, const Ray& ray) {
    const Object* object = active_solids(context.editor);
    if (!object) return std::nullopt;
    const Similarity inverse = object->transform.inverse();
    const auto hit = hit_solids(object->solids()->input->solids, inverse.apply(ray.origin),
                                (inverse.rotation * ray.direction).normalized());
    if (!hit) return std::nullopt;
    return Stand{object->transform.apply(hit->point),
                 (object->transform.rotation * hit->normal).normalized()};
  }

  std::optional<Stand> on_plane(const ToolContext& context, const Ray& ray, bool snaps) const {
    const auto point = point_on_plane(context, plane_.frame, ray, snaps);
    if (!point) return std::nullopt;
    return Stand{*point, plane_.frame.normal()};
  }

  void look(const ToolContext& context, const PointerEvent& event) {
    pointer_ = event.pixel;
    const Ray ray = context.projector().ray(event.pixel);
    const bool snaps = snaps_now(context.editor, event.control);
    catcher_.update(context);
    caught_ = snaps ? catcher_.find(context, event.pixel, {}, plane_.frame.normal()) : std::nullopt;
    stand_ = on_solid(context, ray);
    // A caught place of a solid that is pointed at keeps that solid's side up.
    if (caught_) stand_ = Stand{caught_->point, stand_ ? stand_->up : plane_.frame.normal()};
    if (!stand_) stand_ = on_plane(context, ray, snaps);
  }

  /// The radius is the way from the press to the pointer, in the plane on which the solid stands.
  void drag(ToolContext& context, const PointerEvent& event) {
    pointer_ = event.pixel;
    if ((event.pixel - *pressed_).norm() < drag_threshold * context.editor.pixel_scale) return;
    const Ray ray = context.projector().ray(event.pixel);
    const bool snaps = snaps_now(context.editor, event.control);
    caught_ = snaps ? catcher_.find(context, event.pixel, stand_->point, stand_->up) : std::nullopt;
    const double slope = ray.direction.dot(stand_->up);
    double way = context.projector().pixel_length_at(stand_->point) * (event.pixel - *pressed_).norm();
    if (const double t = (stand_->point - ray.origin).dot(stand_->up) / slope;
        std::abs(slope) > least_ground_slope && t > 0)
      way = (ray.at(t) - stand_->point).norm();
    if (caught_) {
      const Vector3 there = caught_->point - stand_->point;
      way = (there - there.dot(stand_->up) * stand_->up).norm();
    } else if (snaps && context.editor.settings.snaps.grid) {
      way = grid_step(context, stand_->point).nearest(way);
    }
    if (way > 0) dragged_ = way;
    context.editor.preview(
        with_new_solid(context.editor, standing(context, shape_.of_radius(local(context)))));
  }

  /// The radius in the object's own axes.
  double local(const ToolContext& context) const {
    const Object* object = active_solids(context.editor);
    return radius() / (object ? object->transform.scale : 1);
  }

  Solid standing(const ToolContext& context, const Solid& solid) const {
    Similarity inverse;
    if (const Object* object = active_solids(context.editor)) inverse = object->transform.inverse();
    return standing_on(solid, inverse.apply(stand_->point), (inverse.rotation * stand_->up).normalized());
  }

  ToolState put(ToolContext& context) {
    context.editor.cancel_preview();
    Similarity inverse;
    if (const Object* object = active_solids(context.editor)) inverse = object->transform.inverse();
    const Vector3 point = inverse.apply(stand_->point), up = (inverse.rotation * stand_->up).normalized();
    // Its base stays where it is while its numbers are adjusted.
    const auto on = [point, up](Solid solid) { return standing_on(std::move(solid), point, up); };
    const bool done = add_new_solid(context.editor, shape_, shape_.numbers(local(context)), on, {});
    return done ? ToolState::commit : ToolState::cancel;
  }

  void draw_circle(const Projector& projector, const ToolOverlay& overlay) const {
    const Vector3 side = stand_->up.unitOrthogonal(), across = stand_->up.cross(side);
    std::vector<Vector3> circle;
    for (int k = 0; k <= circle_sides; ++k) {
      const double a = 2 * std::numbers::pi * k / circle_sides;
      circle.push_back(stand_->point + radius() * (std::cos(a) * side + std::sin(a) * across));
    }
    draw_polyline(overlay, projector, circle, palette().hot, 1.5F);
    if (const auto at = projector.project(stand_->point))
      overlay.list.AddCircleFilled(on_screen(overlay, at->head<2>()), overlay.metrics.px(3), palette().hot);
  }

  NewSolid shape_;
  std::optional<Stand> stand_;
  WorkingPlane plane_;  ///< as it was when the tool began
  SnapCatcher catcher_;
  std::optional<SnapTarget> caught_;
  std::optional<Vector2> pressed_;
  double usual_radius_ = 1, dragged_ = 0;
};

}  // namespace

std::unique_ptr<Tool> make_place_solid_tool(NewSolid shape) {
  return std::make_unique<PlaceSolidTool>(std::move(shape));
}

}  // namespace hariko
