#include "core/modeling/objects/transform_solid.hpp"

#include <Eigen/Geometry>

#include "core/base/solvers/small_solver.hpp"
#include "core/document/angles.hpp"

namespace hariko {

Solid transformed(Solid solid, const Transformation& transformation, const Vector3& pivot) {
  solid.position = transformation.apply(solid.position, pivot);
  if (transformation.only_translates()) return solid;
  const Matrix3 axes = transformation.linear() * solid_rotation(solid.rotation);
  const Vector3 stretch = axes.colwise().norm();
  solid.scale = solid.scale.cwiseProduct(stretch);
  if (!(stretch.minCoeff() > 0)) return solid;  // flat: the check of the solid reports it
  const Matrix3 directions = axes * stretch.cwiseInverse().asDiagonal();
  const SingularAxes axes_of = singular_axes(directions);
  Matrix3 rotation = axes_of.u * axes_of.v.transpose();
  // Solids are symmetric along their own x axis, so a reflection can be dropped.
  if (rotation.determinant() < 0) rotation.col(0) *= -1;
  solid.rotation = angles_of(Eigen::Quaterniond(rotation));
  return solid;
}

}  // namespace hariko
