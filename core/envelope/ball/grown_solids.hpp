#pragma once

// Solids grown by individual constants, on which the ball rolls (docs/envelope.md).

#include <optional>
#include <vector>

#include "core/envelope/solid_shape.hpp"

namespace hariko {

/// Returns the solid with all faces moved inwards by its own roundness times 0.95 of the radius of an
/// inscribed ball: a surface that follows it at a larger distance has rounder edges. Solids without edges,
/// and those without a roundness of their own, are returned unchanged.
Solid softened(const Solid& solid);

/// Face constant: the least mean, over the centres of the solid's flat faces, of the distance to the solid
/// `followed` in its place, taken with the kernel of width `sigma` (its standard deviation along each axis).
/// Growing by it puts the flattest face on the surface, and so all faces wider than the kernel. Where no face
/// is flat: the growth constant, the largest mean over the solid; the surface where the mean minus that is
/// zero contains the solid. Independent of the solid's placement.
double face_constant(const SolidShape& solid, const SolidShape& followed, double sigma);

struct GrownSolid {
  SolidShape shape;
  double growth = 0;  ///< subtracted from the distance
};

/// Constant by which a solid grows; it does not depend on its place. `on_faces`: the face constant, except
/// for solids so thin that the kernel would leave nothing of them; else the growth constant.
double constant_of(const Solid& solid, double sigma, bool on_faces);

/// Grown solids of a scene, kept from call to call: a constant is found anew only where the solid itself
/// changes, a shape also where its place does.
class KnownSolids {
 public:
  /// Solid with this number in the scene, grown by its constant and `room`, relative to `origin`.
  GrownSolid grown(std::size_t number, const Solid& solid, const Vector3& origin, double sigma, bool on_faces,
                   double room);

 private:
  struct Known {
    Solid solid;  ///< without its place
    double sigma = 0;
    bool on_faces = false;
    double constant = 0;
    std::optional<GrownSolid> grown = {};  ///< with the place and relative to the origin below
    Vector3 position = Vector3::Zero(), rotation = Vector3::Zero(), origin = Vector3::Zero();
  };
  std::vector<Known> known_;
};

struct NearestSolid {
  Index solid = no_index;
  double distance = 1e300;  ///< to the grown solid
};

class GrownUnion {
 public:
  explicit GrownUnion(std::vector<GrownSolid> solids);

  std::size_t size() const { return solids_.size(); }
  const GrownSolid& operator[](std::size_t i) const { return solids_[i]; }
  /// Distance from grown solid i; `bound`: a lower bound of it from the bounding ball.
  double distance(Index i, const Vector3& point) const {
    return solids_[i].shape.distance(point) - solids_[i].growth;
  }
  double bound(Index i, const Vector3& point) const {
    return (point - balls_[i].centre).norm() - balls_[i].radius;
  }
  /// Whether this bound is at least `distance`; takes no root.
  bool is_farther(Index i, const Vector3& point, double distance) const {
    const double least = distance + balls_[i].radius;
    return least <= 0 || (point - balls_[i].centre).squaredNorm() >= least * least;
  }
  /// Whether grown solid i is at least `distance` from a point, by distances that change by no more than the
  /// way: then it is at least `distance` less the way from any other point, too.
  bool is_beyond(Index i, const Vector3& point, double distance) const {
    return is_farther(i, point, distance) ||
           (solids_[i].shape.is_exact() && this->distance(i, point) >= distance);
  }
  /// Nearest solid, the first of equal ones.
  NearestSolid nearest(const Vector3& point) const;
  /// Bounding box of the grown solids.
  const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  struct Ball {
    Vector3 centre;
    double radius;
  };
  std::vector<GrownSolid> solids_;
  std::vector<Ball> balls_;  ///< bounding balls of the grown solids
  Eigen::AlignedBox3d box_;
};

}  // namespace hariko
