#include "core/gaussmap/contact_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/index_list.hpp"
#include "core/base/solvers/least_squares.hpp"

namespace hariko {
namespace {

/// Neighbours of the site and their neighbours.
std::vector<Index> two_rings(const SphereMesh& mesh, Index site) {
  std::vector<Index> out = mesh.ring(site).neighbours;
  for (const Index k : mesh.ring(site).neighbours)
    out.insert(out.end(), mesh.ring(k).neighbours.begin(), mesh.ring(k).neighbours.end());
  sort_unique(out);
  std::erase(out, site);
  return out;
}

struct Fit {
  Vector2 gradient;
  double determinant;  ///< determinant of the second derivatives
};

/// Fit of H(t) - H(0) in gnomonic coordinates t at the site: gradient, second derivatives, four cubic terms.
class SupportFit {
 public:
  SupportFit(const SphereMesh& mesh, const BoundaryData& boundary, std::span<const double> support,
             Index site)
      : mesh_(mesh),
        boundary_(boundary),
        support_(support),
        site_(site),
        u_(mesh.site(site).unitOrthogonal()) {
    w_ = mesh.site(site).cross(u_);
    for (const Index k : two_rings(mesh, site)) {
      const double cosine = mesh.site(k).dot(mesh.site(site));
      if (cosine >= 0.3) samples_.push_back({k, in_plane(mesh.site(k)) / cosine, support[k] / cosine});
    }
  }
  Vector3 lift(const Vector2& in) const { return in.x() * u_ + in.y() * w_; }

  Fit solve() const {
    // With few sites on a large part of the sphere none is near; assumes a sphere about the origin.
    if (samples_.empty()) return {Vector2::Zero(), support_[site_] * support_[site_]};
    std::vector<double> squares;
    for (const Sample& sample : samples_) squares.push_back(sample.t.squaredNorm());
    const auto middle = squares.begin() + std::ptrdiff_t(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    const double scale = std::sqrt(*middle);
    const int terms = samples_.size() >= 12 ? 9 : 5;
    Eigen::MatrixXd rows(3 * samples_.size(), terms);
    Eigen::VectorXd right(3 * samples_.size());
    Eigen::Index used = 0;
    const auto add = [&](const Eigen::Matrix<double, 9, 1>& row, double value, double weight) {
      rows.row(used) = weight * row.head(terms).transpose();
      right[used++] = weight * value;
    };
    for (const Sample& sample : samples_) {
      const double x = sample.t.x() / scale, y = sample.t.y() / scale, weight = 1 / (x * x + y * y + 0.1);
      Eigen::Matrix<double, 9, 1> value, dx, dy;
      value << x, y, x * x / 2, x * y, y * y / 2, x * x * x, x * x * y, x * y * y, y * y * y;
      add(value, sample.value - support_[site_], weight);
      if (!mesh_.is_boundary(sample.site)) continue;
      // If the point is known, the gradient of H is known too.
      dx << 1, 0, x, y, 0, 3 * x * x, 2 * x * y, y * y, 0;
      dy << 0, 1, 0, x, y, 0, x * x, 2 * x * y, 3 * y * y;
      const Vector2 gradient = scale * in_plane(boundary_.points[sample.site]);
      add(dx, gradient.x(), weight);
      add(dy, gradient.y(), weight);
    }
    const Eigen::VectorXd found = solve_overdetermined(rows.topRows(used), right.head(used));
    const double square = scale * scale;
    return {Vector2(found.head<2>() / scale),
            (found[2] * found[4] - found[3] * found[3]) / (square * square)};
  }

 private:
  struct Sample {
    Index site;
    Vector2 t;
    double value;
  };
  Vector2 in_plane(const Vector3& v) const { return {v.dot(u_), v.dot(w_)}; }

  const SphereMesh& mesh_;
  const BoundaryData& boundary_;
  std::span<const double> support_;
  Index site_;
  Vector3 u_, w_;
  std::vector<Sample> samples_;
};

}  // namespace

std::vector<Contact> contact_points(const SphereMesh& mesh, const BoundaryData& boundary,
                                    std::span<const double> support) {
  std::vector<Contact> out(mesh.site_count());
  for (Index i = 0; i < mesh.site_count(); ++i) {
    const bool given = mesh.is_boundary(i);
    if (given) out[i].point = boundary.points[i];
    if (given && !boundary.curvature.empty()) {
      out[i].curvature = boundary.curvature[i];
      continue;
    }
    const SupportFit fit(mesh, boundary, support, i);
    const Fit solved = fit.solve();
    out[i].curvature = 1 / solved.determinant;
    if (!given) out[i].point = support[i] * mesh.site(i) + fit.lift(solved.gradient);
  }
  return out;
}

}  // namespace hariko
