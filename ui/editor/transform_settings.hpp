#pragma once

// TransformSettings: how the transform tools work. Kept for the session, not part of the document.

#include "core/modeling/selection/soft_selection.hpp"

namespace hariko {

enum class PivotMode { median, box_centre, individual, active };

struct SoftSelection {
  bool on = false;
  double radius = 0;  ///< document's unit; 0 until the first use chooses one for the model
  Falloff falloff = Falloff::smooth;
};

struct TransformSettings {
  PivotMode pivot = PivotMode::median;
  bool local_axes = false;  ///< the gizmo follows the object's axes instead of the document's
  bool gizmo = true;
  /// Vertices are edited with the tangents round them fixed; turning and scaling change their tangent plane.
  bool local_edit = false;
  SoftSelection soft;
  bool proportional_size = false;  ///< a typed size scales the object along all axes
};

}  // namespace hariko
