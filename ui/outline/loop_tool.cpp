#include "ui/outline/outline_handles.hpp"

#include "core/document/edits/edits.hpp"
#include "core/gaussmap/outlines/drawn_loop.hpp"
#include "core/gaussmap/outlines/interpolate_normals.hpp"
#include "core/gaussmap/outlines/loop_curve.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/editor/probe.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/snapping.hpp"

namespace hariko {

namespace {

constexpr double close_radius = 12;  ///< design pixels round the first corner that close the loop
constexpr std::size_t loop_points = 32;
constexpr double dome_tilt = 0.7853981633974483, hole_tilt = 0.35;  ///< radians

class LoopTool final : public ModalTool {
 public:
  explicit LoopTool(std::optional<ObjectId> outline) : outline_(outline) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    plane_ = context.editor.working_plane;
    look(context, press);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    if (event.kind == PointerEvent::Kind::release) return ToolState::stay;
    look(context, event);
    if (event.kind != PointerEvent::Kind::press) return ToolState::stay;
    if (closes_) return confirm(context);
    if (!place_)
      return refuse(context, on_surface_ && !corners_.empty() ? "Click on the surface."
                             : plane_.is_ground()             ? "Click on the ground or on a surface."
                                                  : "Click on the working plane or on a surface.");
    if (corners_.empty()) on_surface_ = place_->normal.has_value();
    corners_.push_back(*place_);
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    const KeyChord& chord = press.chord;
    if (chord.key == Key::enter) return confirm(context);
    if (chord.key == Key::backspace) {
      if (!corners_.empty()) corners_.pop_back();
      error_.clear();
      return ToolState::stay;
    }
    return unused_key(press);
  }

  void cancel(ToolContext&) override {}

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Projector projector = context.projector();
    std::vector<Vector3> ahead = places();
    // Right after a click the pointer is still on the corner.
    const bool onward = place_ && !closes_ && (ahead.empty() || place_->point != ahead.back());
    if (onward) ahead.push_back(place_->point);
    draw_curve(projector, overlay, ahead);
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (const auto at = projector.project(corners_[i].point)) {
        const ImVec2 p = on_screen(overlay, at->head<2>());
        const bool first = i == 0 && closes_;
        overlay.list.AddCircleFilled(p, overlay.metrics.px(first ? 7 : 5), palette().window);
        overlay.list.AddCircleFilled(p, overlay.metrics.px(first ? 5.5F : 3.5F), palette().hot);
      }
    if (place_ && !closes_)
      if (const auto at = projector.project(place_->point))
        overlay.list.AddCircle(on_screen(overlay, at->head<2>()), overlay.metrics.px(5), palette().text, 0,
                               overlay.metrics.px(1.5F));
    if (caught_ && !closes_) draw_snap_target(context, overlay, *caught_, !error_.empty());
    const Language& tr = context.editor.language;
    draw_value_label(overlay, pointer_, error_.empty() ? value_text(tr) : error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    return value_text(tr) + "   |   " +
           tr("Click corners   Ctrl snaps   Backspace: last corner   Enter closes the loop   Esc cancels");
  }

 private:
  struct Corner {
    Vector3 point;                  ///< in the document's space
    std::optional<Vector3> normal;  ///< normal of the surface that it lies on
    double gauss = 0;               ///< its Gaussian curvature, 0 where it has none
  };

  std::vector<Vector3> places() const {
    std::vector<Vector3> out;
    for (const Corner& corner : corners_) out.push_back(corner.point);
    return out;
  }

  static std::optional<Corner> on_surface(const ToolContext& context, const Ray& ray) {
    const auto at = surface_point(context.scene, ray);
    const auto reading = at ? read_probe(context.editor, *at) : std::nullopt;
    if (!reading || !(reading->normal.norm() > 0.5)) return std::nullopt;
    return Corner{reading->position, reading->normal, reading->curvature ? reading->curvature->gauss : 0};
  }

  /// The foot of what was caught, else the point of the plane under the pointer.
  std::optional<Corner> on_plane(const ToolContext& context, const Ray& ray, bool snaps) const {
    const auto point = caught_ ? std::optional(plane_.frame.foot(caught_->point))
                               : point_on_plane(context, plane_.frame, ray, snaps);
    if (!point) return std::nullopt;
    return Corner{*point, {}, 0};
  }

  /// Whether what was caught lies on the surface that the eye sees there.
  bool caught_on(const ToolContext& context, const Corner& seen) const {
    constexpr double most_pixels = 4;
    const double pixel = context.editor.pixel_scale * context.projector().pixel_length_at(seen.point);
    return (caught_->point - seen.point).norm() < most_pixels * pixel;
  }

  void look(const ToolContext& context, const PointerEvent& event) {
    pointer_ = event.pixel;
    error_.clear();
    const Projector projector = context.projector();
    const bool snaps = snaps_now(context.editor, event.control);
    catcher_.update(context);
    const auto last = corners_.empty() ? std::nullopt : std::optional(corners_.back().point);
    caught_ = snaps ? catcher_.find(context, event.pixel, last, plane_.frame.normal()) : std::nullopt;
    const auto pixel = caught_ ? projector.project(caught_->point) : std::nullopt;
    const Ray ray = projector.ray(pixel ? Vector2(pixel->head<2>()) : event.pixel);
    place_.reset();
    if (corners_.empty() || on_surface_) place_ = on_surface(context, ray);
    if (place_ && caught_ && corners_.empty() && !caught_on(context, *place_)) place_.reset();
    if (!place_ && (corners_.empty() || !on_surface_)) place_ = on_plane(context, ray, snaps);
    closes_ = false;
    if (corners_.size() < 3) return;
    const auto first = projector.project(corners_.front().point);
    closes_ = first && (first->head<2>() - event.pixel).norm() < close_radius * context.editor.pixel_scale;
  }

  void draw_curve(const Projector& projector, const ToolOverlay& overlay,
                  const std::vector<Vector3>& through) const {
    std::vector<Vector3> line = through;
    constexpr int pieces = 16;
    if (through.size() >= 3 && apart(through)) {
      const LoopCurve curve(corner_loop(through));
      line.clear();
      for (std::size_t i = 0; i < curve.piece_count(); ++i)
        for (int k = 0; k < pieces; ++k) line.push_back(curve.at(i, double(k) / pieces).point);
    }
    if (through.size() >= 3) line.push_back(line.front());
    draw_polyline(overlay, projector, line, palette().hot, 2);
  }

  static bool apart(const std::vector<Vector3>& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!((points[i] - points[(i + 1) % points.size()]).norm() > 0)) return false;
    return true;
  }
  /// A loop through the corners for the curve alone.
  OutlineLoop corner_loop(const std::vector<Vector3>& points) const {
    OutlineLoop loop;
    loop.points = points;
    for (std::size_t i = 0; i < points.size(); ++i)
      loop.normals.push_back(on_surface_ && i < corners_.size() ? *corners_[i].normal
                                                                : plane_.frame.normal());
    if (on_surface_ && place_ && points.size() > corners_.size() && place_->normal)
      loop.normals.back() = *place_->normal;
    return loop;
  }

  /// The loop in the document's space.
  Result<OutlineLoop> make(const ToolContext& context) const {
    if (!on_surface_) {
      DrawnLoop settings;
      settings.axis = plane_.frame.normal();
      settings.hole = outline_.has_value();
      settings.tilt = settings.hole ? hole_tilt : dome_tilt;
      settings.count = loop_points;
      return drawn_loop(places(), settings);
    }
    if (corners_.size() < 3)
      return make_error(e_outline_too_few, "A loop needs at least three corners.", "Click more corners.");
    if (!apart(places()))
      return make_error(e_same_point, "Two corners of the loop lie in one place.", "Leave one of them out.");
    return laid_on_surface(context);
  }

  /// The smooth curve through the corners, put on the surfaces as it is seen.
  Result<OutlineLoop> laid_on_surface(const ToolContext& context) const {
    const LoopCurve curve(corner_loop(places()));
    const Projector projector = context.projector();
    constexpr int pieces = 12;
    OutlineLoop fine;
    for (std::size_t i = 0; i < curve.piece_count(); ++i)
      for (int k = 0; k < pieces; ++k) {
        const auto pixel = projector.project(curve.at(i, double(k) / pieces).point);
        const auto corner = pixel ? on_surface(context, projector.ray(pixel->head<2>())) : std::nullopt;
        if (!corner)
          return make_error(e_outline_too_few, "The loop leaves the surface between two corners.",
                            "Add a corner there, or turn the view so that all of it can be seen.");
        fine.points.push_back(corner->point);
        fine.normals.push_back(*corner->normal);
      }
    Vector3 mean = Vector3::Zero();
    for (const Vector3& normal : fine.normals) mean += normal;
    if ((vector_area(fine.points).dot(mean) < 0) != outline_.has_value()) fine = reversed(fine);
    auto even = resample_loop(fine, loop_points, LoopMeasure::gauss_arc);
    return even ? even : resample_loop(fine, loop_points, LoopMeasure::arc);
  }

  ToolState confirm(ToolContext& context) {
    auto loop = make(context);
    if (!loop) return refuse(context, loop.error());
    return outline_ ? add_to_outline(context.editor, *std::move(loop))
                    : add_outline(context.editor, *std::move(loop));
  }

  ToolState add_outline(Editor& editor, OutlineLoop loop) const {
    const Document& document = editor.history.current();
    OutlineSource source;
    source.outline = Outline{{std::move(loop)}};
    source.settings = new_outline_settings();
    double sum = 0;
    for (const Corner& corner : corners_) sum += corner.gauss;
    if (sum < 0) source.settings.sign = CurvatureSign::negative;
    const auto added =
        add_object(document, free_name(document, editor.language("Outline")), std::move(source));
    if (!added) {
      editor.notify(added.error());
      return ToolState::cancel;
    }
    const bool first = document.objects.empty();
    if (!editor.commit(added->document, translatable("Add outline"))) return ToolState::cancel;
    editor.selection.clear_elements();
    editor.selection.active = added->id;
    editor.mode = ElementMode::vertex;
    if (first) editor.wants_framing = true;
    return ToolState::commit;
  }

  ToolState add_to_outline(Editor& editor, OutlineLoop loop) const {
    const Document& document = editor.history.current();
    const Object* object = document.find(*outline_);
    if (!object || !object->outline()) return ToolState::cancel;
    const Similarity inverse = object->transform.inverse();
    for (Vector3& point : loop.points) point = inverse.apply(point);
    for (Vector3& normal : loop.normals) normal = inverse.rotation * normal;
    const OutlineSource& source = *object->outline();
    OutlineSettings settings = source.settings;
    // A drawn loop has no curvature, and without it no mode that needs it can go on.
    settings.sign = curvature_sign(*source.outline, settings.sign);
    if (settings.mode != GaussMode::position) settings.mode = GaussMode::umbilic;
    auto changed = edit_outline(document, *outline_, [&](const Outline& outline) -> Result<Outline> {
      return with_loop(outline, loop);
    });
    if (changed) changed = set_outline_settings(*changed, *outline_, settings);
    if (!editor.commit(changed, translatable("Add loop"))) return ToolState::cancel;
    std::set<VertexId> added;
    const Index first = Index(source.outline->point_count());
    for (Index i = 0; i < loop.points.size(); ++i) added.insert(VertexId{first + i});
    ElementSelection chosen;
    chosen.vertices = std::move(added);
    editor.selection.select(*outline_, chosen, Selection::How::replace);
    editor.selection.active = *outline_;
    editor.mode = ElementMode::vertex;
    return ToolState::commit;
  }

  std::string value_text(const Language& tr) const {
    std::string text = tr(outline_ ? "Loop" : "Outline");
    if (!corners_.empty()) text += "  " + tr.counted(corners_.size(), "{0} corner", "{0} corners");
    if (closes_) text += "   " + std::string(tr("Closes the loop"));
    if (caught_ && !closes_) text += "   " + std::string(tr(snap_name(caught_->kind)));
    return text;
  }

  std::optional<ObjectId> outline_;  ///< outline that gets the loop; none: a new one
  std::vector<Corner> corners_;
  bool on_surface_ = false;  ///< the first corner lies on one
  std::optional<Corner> place_;
  bool closes_ = false;  ///< a click would
  WorkingPlane plane_;   ///< as it was when the tool began
  SnapCatcher catcher_;
  std::optional<SnapTarget> caught_;
};

}  // namespace

std::unique_ptr<Tool> make_loop_tool(std::optional<ObjectId> outline) {
  return std::make_unique<LoopTool>(outline);
}

}  // namespace hariko
