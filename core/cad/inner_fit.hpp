#pragma once

// Least squares of the control points inside of a tensor spline whose boundary is given. Without ties along
// the sides the matrix is the product of one small Gram matrix a direction (the functions are products, and
// so are the weights of the places); ties see only the first rows beside the sides. So the system is solved
// for those rows, and all else follows from products.

#include <Eigen/Cholesky>

#include "core/cad/fit_places.hpp"
#include "core/cad/side_tie.hpp"

namespace hariko {

/// A number of a face that is to have a wanted value.
struct FaceTie {
  SideTie tie;
  double weight = 0;               ///< of the square of what it misses
  Vector3 rest = Vector3::Zero();  ///< the sum whose component the tie is, without that
  double rest_share = 0;           ///< weight of what that misses, in parts of `weight`
  double wanted = 0;
};

class InnerFit {
 public:
  /// `weight`: of the mean square of what is missed at the places, which must outlive this. `rows`: those
  /// beside each side that ties see. O(control points) but for the small matrices of the rows.
  InnerFit(const FitPlaces& s, const FitPlaces& t, double weight, std::size_t rows);
  InnerFit(const InnerFit&) = delete;
  InnerFit& operator=(const InnerFit&) = delete;

  /// Sets the values that control points inside are to add up to at the places, and the derivatives of a
  /// volume by those sums, with the volume.
  void aim(std::span<const Vector3> targets, std::span<const Vector3> areas, double volume);
  /// For the next solution. `boundary`: zero inside.
  void tie(std::span<const FaceTie> ties, const SplineSurface& boundary);
  /// Other wanted values of the same ties.
  void want(std::span<const double> values);

  /// Sets the control points that ties see. O(rows^2).
  void solve_rows(SplineSurface& surface) const;
  void solve(SplineSurface& surface) const;

 private:
  using Field = std::array<Eigen::MatrixXd, 3>;  ///< by axis; (i, j) is control point (i + 1, j + 1)
  struct Tie {
    std::vector<std::pair<Eigen::Index, double>> shares;  ///< of the rows
    Vector3 pull;                                         ///< of a wanted value of 1
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
  std::vector<Eigen::Index> number_;  ///< of each control point inside in `rows_`, i + j m; -1 for others
  Eigen::MatrixXd stiffness_;         ///< of the rows, all other points following them

  Field right_, free_;         ///< of the distances, and the solution without ties
  Eigen::VectorXd free_pull_;  ///< by the rows
  std::vector<Tie> ties_;
  Eigen::LLT<Eigen::MatrixXd> tied_;
  Eigen::VectorXd tie_pull_;
  Field areas_, volume_move_;  ///< derivative of the volume, and what changes it at least cost
  Eigen::VectorXd volume_rows_;
  double volume_ = 0, volume_change_ = 0;
  double volume_untied_ = 0;  ///< without what ties pull
};

}  // namespace hariko
