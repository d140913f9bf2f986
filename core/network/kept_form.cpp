#include "core/network/kept_form.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

std::vector<Matrix3> edge_directions(const Polyhedron& polyhedron, Index v, std::span<const FanEnd> fan) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Vector3& p = polyhedron.position(v);
  Vector3 normal = Vector3::Zero();
  for (const FanEnd& each : fan)
    if (each.end % 2 == 0) {
      const Index before = mesh.origin(mesh.previous(each.end / 2));
      normal += (polyhedron.position(each.other) - p).cross(polyhedron.position(before) - p);
    }
  normal = normal.stableNormalized();
  std::vector<Matrix3> out;
  for (const FanEnd& each : fan) {
    const Vector3 edge = polyhedron.position(each.other) - p;
    const Vector3 along = (edge - normal * normal.dot(edge)).stableNormalized();
    Matrix3 directions = Matrix3::Zero();
    if (!along.isZero(0) && !normal.isZero(0)) {
      directions.col(0) = along;
      directions.col(1) = normal.cross(along);
      directions.col(2) = normal;
    }
    out.push_back(directions);
  }
  return out;
}

Vector3 image_of_unit(const VertexFrames& frames, Index end, std::span<const Vector3> basis) {
  const TangentCoefficients& tangent = frames.ends[end];
  Vector3 out = Vector3::Zero();
  for (std::size_t i = 0; i < 2; ++i)
    if (tangent.basis[i] != no_index) out += tangent.c[i] / frames.length[end] * basis[tangent.basis[i]];
  return out;
}

bool fit_basis(const VertexFrames& frames, Index v, std::span<const Index> ends,
               std::span<const Vector3> images, std::span<Vector3> basis) {
  const Index first = frames.basis_begin[v], count = frames.basis_begin[v + 1] - first;
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(count, count), right = Eigen::MatrixXd::Zero(count, 3);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const TangentCoefficients& tangent = frames.ends[ends[k]];
    for (std::size_t a = 0; a < 2; ++a) {
      if (tangent.basis[a] == no_index) continue;
      const double ca = tangent.c[a] / frames.length[ends[k]];
      right.row(tangent.basis[a] - first) += ca * images[k].transpose();
      for (std::size_t b = 0; b < 2; ++b)
        if (tangent.basis[b] != no_index)
          square(tangent.basis[a] - first, tangent.basis[b] - first) +=
              ca * tangent.c[b] / frames.length[ends[k]];
    }
  }
  const Eigen::VectorXd eigenvalues = symmetric_eigenvalues(square);
  if (count == 0 || !(eigenvalues.minCoeff() > 1e-9 * eigenvalues.maxCoeff())) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd solved = solve_symmetric(square, Eigen::VectorXd(right.col(axis)));
    for (Index b = 0; b < count; ++b) basis[first + b][axis] = solved[b];
  }
  return true;
}

void add_form_offset(const Polyhedron& polyhedron, const VertexFrames& frames, Index v, const KeptForm& form,
                     std::span<Vector3> offset) {
  const std::vector<FanEnd> fan = fan_ends(polyhedron.topology(), v);
  const std::vector<Matrix3> directions = edge_directions(polyhedron, v, fan);
  std::vector<Index> ends;
  std::vector<Vector3> images;
  for (std::size_t k = 0; k < fan.size(); ++k)
    if (const KeptForm::Edge* edge = form.find(polyhedron.vertex_id(fan[k].other))) {
      ends.push_back(fan[k].end);
      images.push_back(directions[k] * edge->offset);
    }
  fit_basis(frames, v, ends, images, offset);
}

KeptForm reflected_form(KeptForm form) {
  for (KeptForm::Edge& edge : form.edges) {
    edge.turn = -edge.turn;
    edge.offset.y() = -edge.offset.y();
    edge.lean = -edge.lean;
  }
  return form;
}

}  // namespace hariko
