// Networks by hand: a vertex follows the pointer, a curve's tangents grow with it.

#include <algorithm>
#include <cmath>

#include "core/document/edit_solids.hpp"
#include "ui/tools/network_handles.hpp"
#include "ui/tools/overlay_drawing.hpp"

namespace hariko {

namespace {

constexpr double finely = 0.2;                             ///< with Shift
constexpr double least_fullness = 0.1, most_fullness = 3;  ///< as `check_envelope` holds
constexpr double fullness_step = 0.05;                     ///< with Ctrl

/// What both have in common: a drag that previews, a double click that puts back.
class NetworkTool : public Tool {
 public:
  explicit NetworkTool(ObjectId object) : object_(object) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    press_ = press;
    pointer_ = press.pixel;
    if (const Object* object = context.editor.document().find(object_); object && object->solids())
      take(*object, context.projector());
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    Editor& editor = context.editor;
    if (event.kind == PointerEvent::Kind::release) {
      if (moved_) {
        editor.commit_preview(step());
        return ToolState::commit;
      }
      if (press_.clicks < 2) return ToolState::cancel;
      editor.commit(put_back(editor.history.current()), translatable("Reset curves of solids"));
      return ToolState::commit;
    }
    if (!moved_ && (event.pixel - press_.pixel).norm() <= drag_threshold * editor.pixel_scale)
      return ToolState::stay;
    moved_ = true;
    follow(context, event);
    editor.preview(changed(editor.history.current()));
    return ToolState::stay;
  }

  void cancel(ToolContext& context) override { context.editor.cancel_preview(); }

 protected:
  virtual void take(const Object& object, const Projector& projector) = 0;
  virtual void follow(const ToolContext& context, const PointerEvent& event) = 0;
  virtual Result<Document> changed(const Document& document) const = 0;
  virtual Result<Document> put_back(const Document& document) const = 0;
  virtual const char* step() const = 0;

  ObjectId object_;
  PointerEvent press_;
  Vector2 pointer_ = Vector2::Zero();
  bool moved_ = false;
};

/// In the plane of the screen, or along the surface's normal.
class NetworkVertexTool final : public NetworkTool {
 public:
  NetworkVertexTool(ObjectId object, const EnvelopeVertex& vertex) : NetworkTool(object), vertex_(vertex) {}

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!moved_) return;
    const Object* object = context.editor.document().find(object_);
    if (!object) return;
    const Vector3 now = object->transform.apply(Vector3(vertex_.position + shift_));
    if (along_normal_)
      draw_axis_line(overlay, context.projector(), now, object->transform.rotation * vertex_.outward,
                     palette().secondary);
    if (const auto at = context.projector().project(now))
      draw_network_handle(overlay, at->head<2>(), true, true, true);
    draw_value_label(overlay, pointer_,
                     length_text(context.editor, offset_.norm() * object->transform.scale));
  }

  std::string hint(const Language& tr) const override {
    return std::string(tr("Drag moves the vertex   Ctrl along the normal   Shift fine   Esc cancels"));
  }

 protected:
  void take(const Object& object, const Projector&) override {
    start_ = object.solids()->input->settings.offsets.get_or(vertex_.vertex, Vector3(Vector3::Zero()));
    offset_ = start_;
  }

  void follow(const ToolContext& context, const PointerEvent& event) override {
    const Object* object = context.editor.document().find(object_);
    if (!object) return;
    const Projector projector = context.projector();
    const Vector3 at = object->transform.apply(vertex_.position);
    const Vector3 normal = object->transform.rotation * vertex_.outward;
    const auto from = projector.project(at);
    if (!from) return;
    const double length = projector.pixel_length_at(at);
    along_normal_ = event.control;
    Vector3 moved = Vector3::Zero();
    if (along_normal_) {
      const auto to = projector.project(Vector3(at + length * normal));
      const Vector2 way = to ? Vector2(to->head<2>() - from->head<2>()) : Vector2(Vector2::Zero());
      // A normal that looks at the eye takes the way up on the screen.
      const Vector2 along = way.norm() > 0.1 ? Vector2(way / way.squaredNorm()) : Vector2(0, -1);
      moved = (event.pixel - press_.pixel).dot(along) * length * normal;
    } else {
      const Vector3 eye = projector.ray(from->head<2>()).direction;
      const auto onto_plane = [&](const Vector2& pixel) -> Vector3 {
        const Ray ray = projector.ray(pixel);
        return ray.origin + (at - ray.origin).dot(eye) / ray.direction.dot(eye) * ray.direction;
      };
      moved = onto_plane(from->head<2>() + event.pixel - press_.pixel) - at;
    }
    if (event.shift) moved *= finely;
    shift_ = object->transform.rotation.conjugate() * moved / object->transform.scale;
    offset_ = start_ + vertex_.axes.transpose() * shift_;
  }

  Result<Document> changed(const Document& document) const override {
    return change_network_vertex(document, object_, vertex_.vertex, offset_);
  }
  Result<Document> put_back(const Document& document) const override {
    return change_network_vertex(document, object_, vertex_.vertex, Vector3::Zero());
  }
  const char* step() const override { return translatable("Move vertex of solids"); }

 private:
  EnvelopeVertex vertex_;                                       ///< when the drag began
  Vector3 start_ = Vector3::Zero(), offset_ = Vector3::Zero();  ///< in the solid's axes
  Vector3 shift_ = Vector3::Zero();                             ///< in the object's
  bool along_normal_ = false;
};

/// The middle of the curve follows the pointer along its way.
class NetworkCurveTool final : public NetworkTool {
 public:
  NetworkCurveTool(ObjectId object, const EnvelopeCurve& curve) : NetworkTool(object), curve_(curve) {}

  void draw(const ToolContext&, const ToolOverlay& overlay) const override {
    if (!moved_) return;
    draw_network_handle(overlay, at_ + (factor_ - start_) * way_, false, true, true);
    draw_value_label(overlay, pointer_, fixed_text(factor_, 2));
  }

  std::string hint(const Language& tr) const override {
    return std::string(tr("Fullness")) + "  " + fixed_text(factor_, 2) + "   |   " +
           tr("Drag makes the curve fuller or tauter   Shift fine   Ctrl steps   Esc cancels");
  }

 protected:
  void take(const Object& object, const Projector& projector) override {
    start_ = factor_ = object.solids()->input->settings.fullness.get_or(curve_.curve, 1.0);
    const auto from = projector.project(object.transform.apply(curve_.middle));
    const auto to = projector.project(object.transform.apply(Vector3(curve_.middle + curve_.way)));
    if (!from || !to) return;
    at_ = from->head<2>();
    way_ = to->head<2>() - from->head<2>();
  }

  void follow(const ToolContext&, const PointerEvent& event) override {
    if (!(way_.squaredNorm() > 0)) return;
    const double share = (event.pixel - press_.pixel).dot(way_) / way_.squaredNorm();
    factor_ = start_ + (event.shift ? finely : 1) * share;
    if (event.control) factor_ = fullness_step * std::round(factor_ / fullness_step);
    factor_ = std::clamp(factor_, least_fullness, most_fullness);
  }

  Result<Document> changed(const Document& document) const override {
    return change_network_curve(document, object_, curve_.curve, factor_);
  }
  Result<Document> put_back(const Document& document) const override {
    return change_network_curve(document, object_, curve_.curve, 1);
  }
  const char* step() const override { return translatable("Fullness of curve"); }

 private:
  EnvelopeCurve curve_;                                   ///< when the drag began
  Vector2 at_ = Vector2::Zero(), way_ = Vector2::Zero();  ///< pixels; the way for a factor that grows by one
  double start_ = 1, factor_ = 1;
};

}  // namespace

std::unique_ptr<Tool> make_network_tool(ObjectId object, const NetworkHandle& handle) {
  if (const auto* vertex = std::get_if<EnvelopeVertex>(&handle))
    return std::make_unique<NetworkVertexTool>(object, *vertex);
  return std::make_unique<NetworkCurveTool>(object, std::get<EnvelopeCurve>(handle));
}

}  // namespace hariko
