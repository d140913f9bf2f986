#pragma once

// Least squares for the inner control points of a tensor spline whose boundary is given. Without ties the
// matrix is the Kronecker product of one small Gram matrix per direction, as functions and weights are
// products. Ties involve only the first rows beside the sides, so the system is solved for those rows, and
// all else follows from products.

#include <Eigen/Cholesky>

#include "core/cad/fit/fit_places.hpp"
#include "core/cad/fit/side_tie.hpp"

namespace hariko {

/// Linear condition on a face's control points, with its wanted value.
struct FaceTie {
  SideTie tie;
  double weight = 0;               ///< weight of the squared residual
  Vector3 rest = Vector3::Zero();  ///< the tie's vector sum without its component along the tie's normal
  double rest_share = 0;           ///< weight of the residual of `rest`, relative to `weight`
  double wanted = 0;
};

/// Solver for the inner control points of one face.
class InnerFit {
 public:
  /// Prepares the matrices. `weight`: factor of the mean squared residual at the places, which must outlive
  /// this. `rows`: rows beside each side that ties involve. O(control points), besides the small matrices of
  /// the rows.
  InnerFit(const FitPlaces& s, const FitPlaces& t, double weight, std::size_t rows);
  InnerFit(const InnerFit&) = delete;
  InnerFit& operator=(const InnerFit&) = delete;

  /// Sets the target values of the inner control points' sum at the places, the gradient of the volume with
  /// respect to that sum, and the wanted volume.
  void aim(std::span<const Vector3> targets, std::span<const Vector3> areas, double volume);
  /// Sets the ties of the next solution. `boundary`: zero inside.
  void tie(std::span<const FaceTie> ties, const SplineSurface& boundary);
  /// Changes the wanted values of the same ties.
  void want(std::span<const double> values);

  /// Sets the control points that ties involve. O(rows^2).
  void solve_rows(SplineSurface& surface) const;
  /// Sets all inner control points.
  void solve(SplineSurface& surface) const;

 private:
  using Field = std::array<Eigen::MatrixXd, 3>;  ///< by axis; (i, j) is control point (i + 1, j + 1)
  struct Tie {
    std::vector<std::pair<Eigen::Index, double>> shares;  ///< factors of the control points in the rows
    Vector3 pull;                                         ///< right-hand side for a wanted value of 1
    double wanted;
  };
  Field gathered(std::span<const Vector3> values) const;
  Field untied(const Field& right) const;
  Eigen::VectorXd rows_of(const Field& field) const;
  Eigen::VectorXd stiff(const Eigen::VectorXd& rows) const;
  Field completed(const Field& untied, const Eigen::VectorXd& rows) const;
  void find_volume_move();
  Eigen::VectorXd tied_rows(double& missing) const;
  bool empty() const { return m_ == 0 || n_ == 0; }

  const FitPlaces &s_places_, &t_places_;
  double weight_;
  Eigen::Index m_, n_;
  Eigen::LLT<Eigen::MatrixXd> s_, t_;  ///< Gram matrices of the functions inside
  std::vector<std::array<Eigen::Index, 2>> rows_;
  /// Index in `rows_` of each inner control point, at i + j m; -1 for others.
  std::vector<Eigen::Index> number_;
  Eigen::MatrixXd stiffness_;  ///< condensed to the rows: all other points follow them

  Field right_, free_;         ///< right-hand side of the distances, and the solution without ties
  Eigen::VectorXd free_pull_;  ///< condensed to the rows
  std::vector<Tie> ties_;
  Eigen::LLT<Eigen::MatrixXd> tied_;
  Eigen::VectorXd tie_pull_;
  Field areas_, volume_move_;  ///< gradient of the volume, and the cheapest move that changes it
  Eigen::VectorXd volume_rows_;
  double volume_ = 0, volume_change_ = 0;
  double volume_untied_ = 0;  ///< volume without the wanted values of ties
};

}  // namespace hariko
