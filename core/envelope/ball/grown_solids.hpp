#pragma once

// Solids grown by individual constants, on which the ball rolls (docs/envelope.md).

#include <optional>
#include <span>
#include <vector>

#include "core/envelope/solid_shape.hpp"

namespace hariko {

/// Growth constant: the largest mean, over a solid, of the distance to the solid `followed` in its place,
/// taken with the kernel of width `sigma` (its standard deviation along each axis). The surface where the
/// mean minus this constant is zero contains the solid. Independent of the solid's placement.
double growth_constant(const SolidShape& solid, const SolidShape& followed, double sigma);

/// Face constant: the least of these means over the centres of the solid's flat faces; growing by it puts the
/// flattest face on the surface, and so all faces wider than the kernel. The growth constant where no face is
/// flat.
double face_constant(const SolidShape& solid, const SolidShape& followed, double sigma);

struct GrownSolid {
  SolidShape shape;
  double growth = 0;  ///< subtracted from the distance
};

/// Constant by which a solid grows; it does not depend on its place. `on_faces`: the face constant, except
/// for solids so thin that the kernel would leave nothing of them.
double constant_of(const Solid& solid, double sigma, bool on_faces);

/// Constants of a scene's solids, kept from call to call: while solids are only moved, none is made anew.
class GrowthConstants {
 public:
  /// Constant of the solid with this number in the scene.
  double of(std::size_t number, const Solid& solid, double sigma, bool on_faces);

 private:
  struct Known {
    Solid solid;  ///< without its place
    double sigma = 0;
    bool on_faces = false;
    double constant = 0;
  };
  std::vector<Known> known_;
};

/// Makes the grown solid relative to `origin`; a solid with a roundness of its own is replaced by its
/// softened one.
GrownSolid grown_solid(const Solid& solid, const Vector3& origin, double growth);

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
  /// Nearest solid of `among`, the first of equal ones.
  NearestSolid nearest(const Vector3& point, std::span<const Index> among) const;
  /// Bounding box of the grown solids' bounding balls.
  const Eigen::AlignedBox3d& box() const { return box_; }
  std::span<const Index> all() const { return all_; }

 private:
  struct Ball {
    Vector3 centre;
    double radius;
  };
  std::vector<GrownSolid> solids_;
  std::vector<Ball> balls_;  ///< bounding balls of the grown solids
  std::vector<Index> all_;
  Eigen::AlignedBox3d box_;
};

}  // namespace hariko
