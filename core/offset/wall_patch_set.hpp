#pragma once

// WallPatchSet: the patches of offset surfaces and shells. All of them are p + d n, a point of the base plus
// a distance times a unit normal; they differ in what runs along s and t.

#include <array>
#include <memory>
#include <vector>

#include "core/offset/base_normals.hpp"

namespace hariko {

/// Part of a side of the base, in any direction.
struct BaseSide {
  PatchSide side;
  double begin = 0, end = 1;
};

/// Patch of an offset surface or a shell.
struct WallPatch {
  enum class Kind : std::uint8_t {
    face,  ///< patch `base` at the distance `from`
    /// Part of a tube round a sharp edge at the distance `from`: s runs against `first`, t turns the normal
    /// from that of `first` to that of `second`, on the shortest way.
    join,
    rim,  ///< between two distances: s runs against `first`, t from `from` to `to`
    end,  ///< sector at `position`: s turns the normal from normals[0] to normals[1], t runs as in a rim
    fan,  ///< part of a sphere round `position`, between three normals; in squares t = 1 is the third
  };
  Kind kind = Kind::face;
  bool flipped = false;      ///< s and t are exchanged, so that the outside is on the other side
  bool second_half = false;  ///< in triangles: the half of the square at (1, 1), turned by half a turn
  Index base = no_index;
  double from = 0, to = 0;
  BaseSide first, second;
  std::array<Vector3, 3> normals{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  Vector3 position = Vector3::Zero();

  /// Whether every point has the same distance, so that the normal of the base is normal to the patch.
  bool parallel() const { return kind != Kind::rim && kind != Kind::end; }
};

/// Patches of offsets and shells over the normals of a base. First derivatives are exact. So are the normal
/// components of second derivatives, and with them all curvatures; their tangential components, which would
/// need third derivatives of the base, are differences of first derivatives, to about 1e-5.
class WallPatchSet final : public PatchSet {
 public:
  WallPatchSet(std::shared_ptr<const BaseNormals> normals, std::vector<WallPatch> patches);

  const std::vector<WallPatch>& patches() const { return patches_; }
  /// Normal at a corner by construction; zero where the patch is not parallel to the base.
  Vector3 corner_normal(Index patch, int corner) const;

  Domain domain() const override { return normals_->base().domain(); }
  Index patch_count() const override { return Index(patches_.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;
  void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const override;
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override;

 private:
  NormalPoint shape(const WallPatch& patch, const Vector2& at) const;
  NormalPoint face(const WallPatch& patch, const Vector2& at) const;
  NormalPoint join(const WallPatch& patch, const Vector2& at) const;
  NormalPoint rim(const WallPatch& patch, const Vector2& at) const;
  NormalPoint end(const WallPatch& patch, const Vector2& at) const;
  NormalPoint fan(const WallPatch& patch, const Vector2& at) const;
  void add_second_order(const WallPatch& patch, const Vector2& at, const NormalPoint& here,
                        PatchPoint& out) const;

  std::shared_ptr<const BaseNormals> normals_;
  std::vector<WallPatch> patches_;
};

}  // namespace hariko
