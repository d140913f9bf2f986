#pragma once

// AxisLock: along what a transformation moves, and how the pointer moves along it.

#include "render/camera.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {

struct AxisLock {
  enum class Kind { free, axis, plane };
  Kind kind = Kind::free;
  int axis = 0;        ///< the axis, or the plane's normal: 0 x, 1 y, 2 z
  bool local = false;  ///< axes of the object, not of the document

  /// X, Y and Z lock to the axis, with Shift to the plane across it; again: to the object's own; again: free.
  /// False for other keys.
  bool key(const KeyPress& press);
  /// The numbers that a translation has: 3, 1 or 2.
  std::size_t components() const { return kind == Kind::axis ? 1 : kind == Kind::plane ? 2 : 3; }
  /// Axis that the i-th of these is along.
  int component_axis(std::size_t i) const;
  friend bool operator==(const AxisLock&, const AxisLock&) = default;
};

/// Way of a point that begins at `anchor`, in the document's space, when it is dragged from one pixel to
/// another; `frame`'s columns are the axes. Unlocked it moves in the plane that faces the viewer. Where an
/// axis points at the viewer or a plane is seen from its edge, the pointer's way on the screen counts. Never
/// further than 10,000 viewing distances.
Vector3 drag_vector(const Projector& projector, const AxisLock& lock, const Matrix3& frame,
                    const Vector3& anchor, const Vector2& from, const Vector2& to);

}  // namespace hariko
