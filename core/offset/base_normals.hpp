#pragma once

// BaseNormals: points and normals of a surface in the form that its offsets need: both sides of a smooth seam
// have the same normal, bit for bit, and every corner knows with which others it shares one.

#include <array>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Point of a surface with its unit normal, and the derivatives of both by the parameters.
struct NormalPoint {
  Vector3 position = Vector3::Zero(), position_s = Vector3::Zero(), position_t = Vector3::Zero();
  Vector3 normal = Vector3::Zero(), normal_s = Vector3::Zero(), normal_t = Vector3::Zero();
};

/// Point of a patch's side with its unit normal, and their derivatives by the fraction of the side.
struct SidePoint {
  Vector3 position = Vector3::Zero(), position_x = Vector3::Zero();
  Vector3 normal = Vector3::Zero(), normal_x = Vector3::Zero();
};

/// Angle between normals, radians, above which a seam that is not meant to be smooth is a sharp edge.
inline constexpr double sharp_seam_angle = 1e-6;

/// Normals of a surface that has patches. Corners that smooth seams join are one group, with one normal.
class BaseNormals {
 public:
  /// Finds the sharp edges and the groups. O(patches + seams).
  explicit BaseNormals(const Surface& base);

  const Surface& base() const { return base_; }
  /// Whether the normals differ across a seam.
  bool sharp(Index seam) const { return sharp_[seam] != 0; }
  /// Whether a side is a point.
  bool shrunk(const PatchSide& side) const { return shrunk_[slot(side.patch, side.side)] != 0; }
  /// Group of a corner, and its normal.
  Index group(Index patch, int corner) const { return groups_[slot(patch, corner)]; }
  const Vector3& group_normal(Index group) const { return group_normals_[group]; }

  /// Unit normal at a point of a patch.
  Vector3 normal(Index patch, const Vector2& parameter, const PatchPoint& point) const;
  /// Point with normal and derivatives. Where second derivatives have no meaning (`second_order_at_corner`),
  /// and where the patch is degenerate, those of the normal are taken 1e-4 further towards its centre.
  NormalPoint at(Index patch, const Vector2& parameter) const;
  /// The same at a fraction of a side, by that fraction.
  SidePoint on_side(const PatchSide& side, double x) const;

 private:
  std::size_t slot(Index patch, int corner) const {
    return std::size_t(patch) * corners_ + std::size_t(corner);
  }
  Vector3 plain_normal(const PatchSide& side, double x) const;
  void find_shrunk();
  void find_sharp();
  void find_groups();
  /// Side and fraction of a parameter on the border of the domain.
  struct Border {
    int side = -1;
    double x = 0;
  };
  Border border_of(const Vector2& parameter) const;

  Surface base_;
  std::size_t corners_;
  std::vector<std::uint8_t> sharp_, shrunk_;
  std::vector<PatchSide> leaders_;  ///< by side: the side across a smooth seam whose normals count here
  std::vector<Index> groups_;
  std::vector<Vector3> group_normals_;
};

}  // namespace hariko
