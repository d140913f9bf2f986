#pragma once

// SkinFrames: the path of a skin with a frame at every parameter, along which sections are moved.

#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Immutable. Only relative frames matter: F(v) F(w)^-1 maps offsets at w to offsets at v.
class SkinFrames {
 public:
  /// Makes the frames of a path that passes the checks of a skin. Errors: E_PATH_CUSP where the path's
  /// derivative vanishes, or where the rails meet; E_RAIL where two_rail lacks a second rail that is open or
  /// closed like the path. O(64 per span).
  static Result<SkinFrames> make(const Skin& skin);

  /// Mode with `automatic` resolved: two_rail with a second rail, else rotation_minimising where the tangent
  /// turns by more than 15 degrees in total, else translate.
  FrameMode mode() const { return mode_; }
  Vector3 position(double v) const { return evaluate(path_, v).position; }
  Vector3 tangent(double v) const { return evaluate(path_, v).first; }
  /// Point of the second rail (two_rail only).
  Vector3 rail(double v) const { return evaluate(*rail_, v).position; }
  /// Frame at v; its columns are the axes of the offsets' coordinates.
  Matrix3 frame(double v) const;
  /// Frame between two rails at these two points.
  static Matrix3 rail_frame(const Vector3& first, const Vector3& second);

 private:
  SkinFrames() = default;
  FrameMode mode_ = FrameMode::translate;
  SubdivisionCurve path_;
  std::optional<SubdivisionCurve> rail_;
  std::vector<Vector3> reference_;  ///< at 64 samples per span
};

/// Sum of the angles between tangents at 64 samples per span, radians.
double total_turning(const SubdivisionCurve& curve);

}  // namespace hariko
