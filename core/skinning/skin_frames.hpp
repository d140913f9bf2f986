#pragma once

// The path of a skin with a frame at every place: how a section is carried along it.

#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Immutable. Frames matter only relative to each other: F(v) F(w)^-1 carries offsets from w to v.
class SkinFrames {
 public:
  /// Needs a path that passes the checks of a skin. Errors: E_PATH_CUSP where the path stands still, or where
  /// the rails meet. O(64 a span).
  static Result<SkinFrames> make(const Skin& skin);

  /// What `automatic` became: rotation_minimising where the tangent turns by more than 15 degrees in all.
  FrameMode mode() const { return mode_; }
  Vector3 position(double v) const { return evaluate(path_, v).position; }
  Vector3 tangent(double v) const { return evaluate(path_, v).first; }
  /// A point of the second rail (two_rail only).
  Vector3 rail(double v) const { return evaluate(*rail_, v).position; }
  /// Columns are the axes that offsets are coordinates of.
  Matrix3 frame(double v) const;
  /// Of rails at these two points.
  static Matrix3 rail_frame(const Vector3& first, const Vector3& second);

 private:
  SkinFrames() = default;
  FrameMode mode_ = FrameMode::translate;
  SubdivisionCurve path_;
  std::optional<SubdivisionCurve> rail_;
  std::vector<Vector3> reference_;  ///< at 64 samples a span
};

/// Sum of the angles between tangents at 64 samples a span, radians.
double total_turning(const SubdivisionCurve& curve);

}  // namespace hariko
