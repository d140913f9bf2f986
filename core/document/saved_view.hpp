#pragma once

// SavedView: a look at the model that the designer keeps under a name.

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

inline constexpr Code e_view_invalid{"E_VIEW_INVALID"};

enum class Projection : std::uint8_t {
  perspective,
  parallel,
  two_point  ///< perspective in which verticals of the world stay parallel
};

/// Invariants (checked by the edits and the file reader): the name is one that objects may have, numbers are
/// finite, the orientation is a unit quaternion to 1e-9, the distance is in (0, max_distance], the focal
/// length in its range.
struct SavedView {
  std::string name;
  Vector3 target = Vector3::Zero();  ///< centre of rotation, in the document's unit
  /// From the axes of the camera (x right, y up, z towards the viewer) to those of the document.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  /// From the eye to the target, in the document's unit. Parallel views show the target's plane as large as
  /// perspective does.
  double distance = 1;
  Projection projection = Projection::perspective;
  double focal_length = 50;  ///< millimetres, for a picture as high as film of 36 x 24 mm

  static constexpr double max_distance = 1e15;
  /// Focal lengths that can be asked for, in millimetres.
  static constexpr double least_focal_length = 15, greatest_focal_length = 300;

  friend bool operator==(const SavedView& a, const SavedView& b) {
    return a.name == b.name && a.target == b.target && a.orientation.coeffs() == b.orientation.coeffs() &&
           a.distance == b.distance && a.projection == b.projection && a.focal_length == b.focal_length;
  }
};

/// In the order in which they were saved; names are unique.
using SavedViews = std::vector<SavedView>;

/// Checks the invariants of a view. Errors: E_NAME_EMPTY, E_NAME_INVALID, E_VIEW_INVALID.
Result<Done> check_view(const SavedView& view);

}  // namespace hariko
