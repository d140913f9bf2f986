#include "ui/view/transform_tool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/document/length_units.hpp"
#include "ui/editor/operations.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

constexpr double fine_share = 0.1;
constexpr double degrees_per_radian = 180 / std::numbers::pi;
constexpr DecimalStep rotation_steps[] = {{15, 0}, {5, 0}};  ///< coarse, and with Shift
constexpr DecimalStep scale_steps[] = {{1, -1}, {1, -2}};
constexpr double radius_factor = 1.1;  ///< a step of the wheel

std::vector<UnitFactor> units_for(TransformKind kind, Unit unit) {
  if (kind == TransformKind::move) {
    const auto lengths = length_units(unit);
    return {lengths.begin(), lengths.end()};
  }
  if (kind == TransformKind::rotate) return {std::begin(angle_units), std::end(angle_units)};
  return {};
}

const char* verb(TransformKind kind) {
  return kind == TransformKind::move ? "Move" : kind == TransformKind::rotate ? "Rotate" : "Scale";
}

}  // namespace

void TransformTool::begin(ToolContext& context, const PointerEvent& press) {
  Editor& editor = context.editor;
  if (made_) editor.preview(made_->document);
  target_ = made_ ? TransformTarget::of_objects(editor, made_->document, made_->objects)
                  : TransformTarget::of(editor);
  from_ = at_ = pointer_ = press.pixel;
  camera_ = editor.camera();
  const double view = camera_.view_height();
  decimals_ = std::clamp(3 - static_cast<int>(std::floor(std::log10(view))), 0, 9);
  length_unit_ = to_string(editor.document().unit);
  input_ = NumericInput(fields(), units_for(kind_, editor.document().unit));
  if (target_.empty()) return say_locked(editor);
  if (target_.in_planes() && by_ == DrivenBy::command) {
    lock_ = section_plane_lock;
    input_.resize(fields());
  }
  if (!places_ && by_ != DrivenBy::typing) places_.emplace(context, editor.settings.snaps);
  anchor_ = target_.pivot();
  // The grabbed point stays under the pointer.
  if (by_ == DrivenBy::element)
    if (const auto hit = pick_element(context, press.pixel)) anchor_ = hit->point;
  const Projector projector = context.projector();
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3& point : target_.selected_points()) {
    const auto at = projector.project(point);
    const double distance = at ? (at->head<2>() - press.pixel).norm() : std::numeric_limits<double>::max();
    if (distance >= nearest) continue;
    nearest = distance;
    source_ = point;
  }
  SoftSelection& soft = editor.transform.soft;
  if (soft.on && soft.radius == 0) {
    Box3 box;
    for (const auto& object : editor.document().objects)
      if (!editor.selection.of(object->id).empty()) box.extend(world_box(*object));
    soft.radius = box.isEmpty() ? view / 4 : box.diagonal().norm() / 4;
  }
  apply_falloff(context);
}

/// The first press means the own axes of sections, the second those of the document.
bool TransformTool::lock_key(const KeyPress& press) {
  if (!target_.in_planes()) return lock_.key(press);
  AxisLock next = lock_ == section_plane_lock ? AxisLock{} : AxisLock{lock_.kind, lock_.axis, !lock_.local};
  if (!next.key(press)) return false;
  lock_ =
      next.kind == AxisLock::Kind::free ? section_plane_lock : AxisLock{next.kind, next.axis, !next.local};
  return true;
}

void TransformTool::restart(ToolContext& context, TransformKind kind) {
  PointerEvent at;
  at.pixel = pointer_;
  auto next = std::make_unique<TransformTool>(kind, by_ == DrivenBy::typing ? by_ : DrivenBy::command);
  next->places_ = std::move(places_);  // the scene shows the preview now
  next->made_ = made_;
  context.editor.cancel_preview();
  successor_ = std::move(next);
}

ToolState TransformTool::update(ToolContext& context, const PointerEvent& event) {
  if (target_.empty()) return ToolState::cancel;
  if (by_ != DrivenBy::typing) {
    follow_pointer(context, event);
    if (moved_ || event.kind == PointerEvent::Kind::move)
      if (const ToolState state = show(context); state != ToolState::stay) return state;
  }
  if (modal()) return event.kind == PointerEvent::Kind::press ? confirm(context) : ToolState::stay;
  if (event.kind != PointerEvent::Kind::release) return ToolState::stay;
  // A click on a handle asks for the number.
  if (by_ == DrivenBy::handle && !moved_) {
    context.editor.cancel_preview();
    successor_ = std::make_unique<TransformTool>(kind_, DrivenBy::typing, lock_);
    return ToolState::commit;
  }
  return confirm(context);
}

void TransformTool::follow_pointer(const ToolContext& context, const PointerEvent& event) {
  fine_ = event.shift;
  snapping_ = snaps_now(context.editor, event.control);
  keep_through_view_change(context, event.pixel);
  const Vector2 by = event.pixel - pointer_;
  // With Ctrl, Shift makes the steps finer and not the hand.
  const double share = fine_ && !snapping_ ? fine_share : 1;
  if (kind_ == TransformKind::rotate) {
    if (const auto pivot = context.projector().project(target_.pivot())) {
      const Vector2 a = pointer_ - pivot->head<2>(), b = event.pixel - pivot->head<2>();
      if (a.norm() > 2 && b.norm() > 2)
        screen_degrees_ -= share * std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * degrees_per_radian;
    }
  }
  at_ += share * by;
  pointer_ = event.pixel;
  const double threshold = by_ == DrivenBy::handle ? drag_threshold * context.editor.pixel_scale : 0;
  if ((at_ - from_).norm() > threshold) moved_ = true;
}

/// After the view has turned, what was reached counts as done, and the pointer begins anew where it is.
void TransformTool::keep_through_view_change(const ToolContext& context, const Vector2& pixel) {
  const Camera now = context.editor.camera();
  const bool same = now.target == camera_.target && now.distance == camera_.distance &&
                    now.orientation.coeffs() == camera_.orientation.coeffs() &&
                    now.orthographic == camera_.orthographic;
  if (same) return;
  const ToolContext& before = context;
  const Projector old(camera_, before.editor.viewport);
  base_move_ += drag_vector(old, lock_, frame(), anchor_ + base_move_, from_, at_);
  if (const auto pivot = old.project(target_.pivot())) {
    const Vector2 a = from_ - pivot->head<2>(), b = at_ - pivot->head<2>();
    if (a.norm() > 2) base_ratio_ *= b.norm() / a.norm();
  }
  camera_ = now;
  from_ = at_ = pointer_ = pixel;
}

Vector3 TransformTool::dragged(const ToolContext& context) const {
  Vector3 translation =
      base_move_ + drag_vector(context.projector(), lock_, frame(), anchor_ + base_move_, from_, at_);
  // Ways made before under another lock count as far as this one allows.
  if (lock_.kind == AxisLock::Kind::free) return translation;
  Vector3 local = frame().transpose() * translation;
  for (int i = 0; i < 3; ++i)
    if ((i == lock_.axis) != (lock_.kind == AxisLock::Kind::axis)) local[i] = 0;
  return frame() * local;
}

double TransformTool::drag_ratio(const ToolContext& context) const {
  const auto pivot = context.projector().project(target_.pivot());
  if (!pivot) return base_ratio_;
  const Vector2 a = from_ - pivot->head<2>(), b = at_ - pivot->head<2>();
  const double near_pixels = 12 * context.editor.pixel_scale;
  // Begun on the pivot there is no distance to compare with: to the right is larger.
  if (a.norm() < near_pixels)
    return base_ratio_ * (1 + (at_ - from_).x() / (100 * context.editor.pixel_scale));
  return base_ratio_ * (a.dot(b) < 0 ? -1 : 1) * b.norm() / a.norm();
}

Transformation TransformTool::transformation(const ToolContext& context) {
  snap_.reset();
  switch (kind_) {
    case TransformKind::move:
      return move(context);
    case TransformKind::rotate:
      return rotation(context);
    default:
      return scaling(context);
  }
}

Transformation TransformTool::move(const ToolContext& context) {
  Transformation result;
  if (input_.active()) {
    Vector3 local = Vector3::Zero();
    for (std::size_t i = 0; i < input_.size(); ++i)
      local[lock_.component_axis(i)] = input_.value(i).value_or(0);
    result.translation = lock_.local ? Vector3(frame() * local) : local;
  } else if (by_ != DrivenBy::typing) {
    result.translation = dragged(context);
    if (snapping_) result.translation = snapped(context, result.translation);
  }
  return result;
}

/// The translation that puts the source on the place under the pointer, or on the grid: that of the working
/// plane, where the axes are not local ones.
Vector3 TransformTool::snapped(const ToolContext& context, const Vector3& translation) {
  const Matrix3 axes = frame();
  const auto allowed = [&](const Vector3& wanted) -> Vector3 {
    if (lock_.kind == AxisLock::Kind::free) return wanted;
    Vector3 local = axes.transpose() * wanted;
    for (int i = 0; i < 3; ++i)
      if ((i == lock_.axis) != (lock_.kind == AxisLock::Kind::axis)) local[i] = 0;
    return axes * local;
  };
  const SnapSettings& kinds = context.editor.settings.snaps;
  const PlaneFrame& plane = context.editor.working_plane.frame;
  const SnapGesture gesture{kinds, source_, plane.normal(), &target_};
  snap_ = places_ ? places_->nearest(context, gesture, pointer_) : std::nullopt;
  if (snap_) return allowed(snap_->point - source_);
  if (!kinds.grid) return translation;
  DecimalStep step = grid_step(context, source_);
  if (fine_) step = step.tenth();
  // Local axes have no grid of their own: steps along them count from where the drag began.
  Vector3 result;
  if (lock_.local) {
    Vector3 local = axes.transpose() * translation;
    for (double& x : local) x = step.nearest(x);
    result = allowed(axes * local);
  } else {
    // Locks are along the axes of the document, so they count in its own grid.
    const PlaneFrame grid = lock_.kind == AxisLock::Kind::free ? plane : PlaneFrame{};
    Vector3 place = grid.local(source_ + translation);
    for (double& x : place) x = step.nearest(x);
    result = allowed(grid.at(place) - source_);
  }
  snap_ = SnapTarget{SnapTarget::Kind::grid, source_ + result};
  return result;
}

Transformation TransformTool::rotation(const ToolContext& context) {
  Transformation result;
  const Vector3 towards_viewer = -context.editor.camera().forward();
  const bool free = lock_.kind == AxisLock::Kind::free;
  result.axis = free ? towards_viewer : Vector3(frame().col(lock_.axis));
  if (input_.active()) {
    result.degrees = input_.value().value_or(0);
  } else if (by_ != DrivenBy::typing) {
    result.degrees = result.axis.dot(towards_viewer) < 0 ? -screen_degrees_ : screen_degrees_;
    if (snapping_) result.degrees = rotation_steps[fine_ ? 1 : 0].nearest(result.degrees);
  }
  return result;
}

Transformation TransformTool::scaling(const ToolContext& context) {
  Transformation result;
  result.frame = frame();
  double factor = 1;
  if (input_.active()) {
    factor = input_.value().value_or(1);
  } else if (by_ != DrivenBy::typing) {
    factor = drag_ratio(context);
    if (snapping_) factor = scale_steps[fine_ ? 1 : 0].nearest(factor);
  }
  if (lock_.kind == AxisLock::Kind::free) {
    result.factors = Vector3::Constant(factor);
    // With Tab each axis gets its own.
    const bool several = input_.value(1) || input_.value(2);
    if (several)
      for (int i = 0; i < 3; ++i) result.factors[i] = input_.value(static_cast<std::size_t>(i)).value_or(1);
  } else {
    for (int i = 0; i < 3; ++i)
      if ((i == lock_.axis) == (lock_.kind == AxisLock::Kind::axis)) result.factors[i] = factor;
    // With Tab both axes of a plane have their own, too.
    if (lock_.kind == AxisLock::Kind::plane && input_.value(1))
      for (std::size_t i = 0; i < 2; ++i)
        result.factors[lock_.component_axis(i)] = input_.value(i).value_or(1);
  }
  return result;
}

ToolState TransformTool::show(ToolContext& context, bool confirmed) {
  Editor& editor = context.editor;
  // Until the unit is whole the last number stays in view.
  if (input_.unfinished() && !confirmed) {
    error_.clear();
    return ToolState::stay;
  }
  done_ = transformation(context);
  error_.clear();
  if (const auto error = input_.error()) return refuse(context, *error);
  const auto result = target_.apply(made_ ? made_->document : editor.history.current(), done_, lock_.local);
  if (result) {
    editor.preview(result);
    shown_ = true;
    return ToolState::stay;
  }
  // Nothing can be done about a lock here; a number that leads too far can be corrected.
  if (shown_ || input_.active()) return refuse(context, result.error());
  editor.notify(result.error());
  editor.cancel_preview();
  return ToolState::cancel;
}

ToolState TransformTool::confirm(ToolContext& context) {
  if (input_.unfinished())
    if (const ToolState state = show(context, true); state != ToolState::stay) return state;
  if (!error_.empty()) return ToolState::stay;
  Editor& editor = context.editor;
  const Document before = editor.history.current();
  const std::string step = made_ ? made_->step : std::string(verb(kind_)) + " " + target_.describe();
  if (!editor.commit_preview(step)) return ToolState::commit;
  if (made_)
    made_->moved(editor, before, target_, done_);
  else
    remember_transform(editor, {verb(kind_), target_.local_frame(), done_, lock_.local});
  return ToolState::commit;
}

std::optional<ToolState> TransformTool::key(ToolContext& context, const KeyPress& press) {
  if (target_.empty()) return std::nullopt;
  const Key key = press.chord.key;
  if (key == Key::enter) return confirm(context);
  if (input_.key(press)) return show(context);
  if (lock_key(press)) {
    input_.resize(fields());
    return show(context);
  }
  if (press.chord.control || press.chord.alt) return std::nullopt;
  if (modal()) {
    const auto other = key == Key::g   ? std::optional(TransformKind::move)
                       : key == Key::r ? std::optional(TransformKind::rotate)
                       : key == Key::s ? std::optional(TransformKind::scale)
                                       : std::nullopt;
    if (other && *other != kind_) {
      restart(context, *other);
      return ToolState::commit;
    }
    if (other) return ToolState::stay;
  }
  if (key == Key::o && target_.of_elements()) {
    SoftSelection& soft = context.editor.transform.soft;
    soft.on = !soft.on;
    if (soft.radius == 0) soft.radius = camera_.view_height() / 8;
    apply_falloff(context);
    return show(context);
  }
  if (key == Key::left_bracket || key == Key::right_bracket) {
    change_radius(context, key == Key::right_bracket ? 1 : -1);
    return show(context);
  }
  // Other letters would run commands in the middle of a gesture.
  if (press.text != 0) return ToolState::stay;
  return std::nullopt;
}

bool TransformTool::wheel(ToolContext& context, double steps, const PointerEvent& event) {
  if (!context.editor.transform.soft.on || !target_.of_elements() || event.control) return false;
  change_radius(context, steps);
  show(context);
  return true;
}

void TransformTool::change_radius(ToolContext& context, double steps) {
  SoftSelection& soft = context.editor.transform.soft;
  if (!soft.on) return;
  const double view = context.editor.camera().view_height();
  soft.radius = std::clamp(soft.radius * std::pow(radius_factor, steps), 1e-4 * view, 1e4 * view);
  apply_falloff(context);
}

void TransformTool::apply_falloff(const ToolContext& context) {
  const SoftSelection& soft = context.editor.transform.soft;
  target_.follow(soft.on ? soft.radius : 0, soft.falloff);
}

std::string TransformTool::value_text(const Language& tr) const {
  static constexpr const char* axis_names[] = {"X", "Y", "Z"};
  const Matrix3 back = frame().transpose();
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "   ") + part; };
  const auto typed = [&](std::size_t i) {
    const std::string cursor = i == input_.current() ? "|" : "";
    return input_.text(i) + cursor;
  };
  const auto field = [&](std::size_t i, const std::string& name, const std::string& value) {
    const bool here = input_.active() || by_ == DrivenBy::typing;
    const bool open = here && (!input_.text(i).empty() || i == input_.current());
    const bool waits = open && i == input_.current() && input_.unfinished();
    add(waits ? name + " " + typed(i) : open ? name + " " + typed(i) + "  = " + value : name + " " + value);
  };
  switch (kind_) {
    case TransformKind::move: {
      const Vector3 local = back * done_.translation;
      for (std::size_t i = 0; i < lock_.components(); ++i) {
        const int axis = lock_.component_axis(i);
        field(i, axis_names[axis], fixed_text(local[axis], decimals_) + " " + length_unit_);
      }
      break;
    }
    case TransformKind::rotate:
      field(0, lock_.kind == AxisLock::Kind::free ? std::string(tr("Rotate")) : axis_names[lock_.axis],
            fixed_text(done_.degrees, 1) + "\u00b0");
      break;
    case TransformKind::scale: {
      const bool one = lock_.kind != AxisLock::Kind::free || (!input_.value(1) && !input_.value(2));
      const int axis = lock_.kind == AxisLock::Kind::plane  ? (lock_.axis + 1) % 3
                       : lock_.kind == AxisLock::Kind::axis ? lock_.axis
                                                            : 0;
      if (lock_.kind == AxisLock::Kind::plane && (input_.current() == 1 || input_.value(1)))
        for (std::size_t i = 0; i < 2; ++i) {
          const int along = lock_.component_axis(i);
          field(i, axis_names[along], fixed_text(done_.factors[along], 4));
        }
      else if (one && input_.current() == 0)
        field(0, lock_.kind == AxisLock::Kind::axis ? axis_names[lock_.axis] : std::string(tr("Scale")),
              fixed_text(done_.factors[axis], 4));
      else
        for (int i = 0; i < 3; ++i)
          field(static_cast<std::size_t>(i), axis_names[i], fixed_text(done_.factors[i], 4));
      break;
    }
  }
  if (target_.in_planes() && lock_.local)
    add(tr("in the plane of the section"));
  else if (lock_.local)
    add(tr("local axes"));
  return text;
}

std::string TransformTool::hint(const Language& tr) const {
  if (target_.empty()) return {};
  std::string text = std::string(tr(verb(kind_))) + "  " + value_text(tr) + "   |   ";
  if (snap_) text += std::string(tr(snap_name(snap_->kind))) + "   |   ";
  text +=
      tr("X Y Z axis   Shift+X plane   digits type   Shift fine   Ctrl snaps   Enter confirms   Esc cancels");
  return text;
}

std::unique_ptr<Tool> make_transform_tool(TransformKind kind, DrivenBy by, AxisLock lock) {
  return std::make_unique<TransformTool>(kind, by, lock);
}

std::unique_ptr<Tool> make_transform_tool(NewObjects made) {
  return std::make_unique<TransformTool>(TransformKind::move, std::move(made));
}

}  // namespace hariko
