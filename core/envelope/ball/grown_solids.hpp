#pragma once

// Solids grown by constants of their own: what the ball rolls on (docs/envelope.md).

#include <optional>
#include <span>
#include <vector>

#include "core/envelope/solid_shape.hpp"

namespace hariko {

/// Largest mean, over a solid, of the distance to the one that is `followed` instead of it, taken with the
/// kernel of width `sigma` (its standard deviation along each axis). A surface where the mean is zero once
/// this is subtracted contains the solid. The same wherever the solid stands.
double growth_constant(const SolidShape& solid, const SolidShape& followed, double sigma);

/// Least of these means over the middles of the solid's flat faces: with it, the flattest face lies on the
/// surface, as all do that are wider than the kernel. The growth constant where no face is flat.
double face_constant(const SolidShape& solid, const SolidShape& followed, double sigma);

struct GrownSolid {
  SolidShape shape;
  double growth = 0;  ///< subtracted from the distance
};

/// The solid, or what is followed instead of one with a roundness of its own, relative to `origin`. `room`: a
/// length that it is grown by beyond its constant. `on_faces`: that is the face constant, but for solids so
/// thin that the kernel would leave nothing of them.
GrownSolid grown_solid(const Solid& solid, const Vector3& origin, double sigma, double room,
                       bool on_faces = false);

struct NearestSolid {
  Index solid = no_index;
  double distance = 1e300;  ///< to the grown solid
};

class GrownUnion {
 public:
  explicit GrownUnion(std::vector<GrownSolid> solids);

  std::size_t size() const { return solids_.size(); }
  const GrownSolid& operator[](std::size_t i) const { return solids_[i]; }
  /// Distance from grown solid i; at least `bound` from it where that is far enough.
  double distance(Index i, const Vector3& point) const {
    return solids_[i].shape.distance(point) - solids_[i].growth;
  }
  double bound(Index i, const Vector3& point) const {
    return (point - solids_[i].shape.centre()).norm() - solids_[i].shape.reach() - solids_[i].growth;
  }
  /// The nearest of `among`, the first of equal ones.
  NearestSolid nearest(const Vector3& point, std::span<const Index> among) const;
  const Eigen::AlignedBox3d& box() const { return box_; }  ///< of the grown solids' bounding balls
  std::span<const Index> all() const { return all_; }

 private:
  std::vector<GrownSolid> solids_;
  std::vector<Index> all_;
  Eigen::AlignedBox3d box_;
};

}  // namespace hariko
