#include <Eigen/LU>

#include "core/envelope/ball/spline_field.hpp"
#include "core/geometry/mirror_plane.hpp"

namespace hariko {

namespace {

// Lengths in sigma; the field's slope is dimensionless.
constexpr double pinched_below = 0.1;     ///< saddles with smaller absolute values are lowered to minus this
constexpr double value_looked_at = 0.35;  ///< nodes with smaller values
constexpr double slope_looked_at = 0.4;   ///< nodes with smaller slopes
constexpr double no_slope = 1e-3;         ///< slope at which a saddle counts as found
constexpr double farthest_saddle = 2;  ///< largest distance of a saddle from the node where the search begins
constexpr double saddles_apart = 0.5;  ///< nearer saddles count as one
constexpr double lowered_width = 2;    ///< radius of the lowered region
constexpr int most_newton_steps = 12;

/// Saddle or extremum near a point, by Newton's method for a vanishing gradient.
std::optional<Vector3> saddle_near(const SplineField& field, const Vector3& start, double sigma) {
  Vector3 at = start;
  for (int step = 0; step < most_newton_steps; ++step) {
    const BentFieldPoint here = field.bent_at(at);
    const Vector3& slope = here.gradient;
    const Matrix3& bend = here.hessian;
    const double volume = bend.determinant();
    if (slope.norm() < no_slope) {
      // Eigenvalues of one sign mean a maximum or minimum, where nothing opens.
      const double sum = bend.trace();
      const double pairs = 0.5 * (sum * sum - (bend * bend).trace());
      const bool one_sign = pairs > 0 && sum * volume > 0;
      return one_sign ? std::nullopt : std::optional(at);
    }
    if (!(std::abs(volume) * sigma * sigma * sigma > 1e-9)) return {};
    Vector3 way = -bend.inverse() * slope;
    if (const double length = way.norm(); length > 0.5 * sigma) way *= 0.5 * sigma / length;
    at += way;
    if ((at - start).norm() > farthest_saddle * sigma) return {};
  }
  return {};
}

std::vector<Vector3> saddles_of(const SplineField& field, double sigma) {
  std::vector<Vector3> out;
  const auto& size = field.size();
  for (int k = 1; k + 1 < size[2]; ++k)
    for (int j = 1; j + 1 < size[1]; ++j)
      for (int i = 1; i + 1 < size[0]; ++i) {
        if (std::abs(field.weight(i, j, k)) > 2 * value_looked_at * sigma) continue;
        const Vector3 slope(field.weight(i + 1, j, k) - field.weight(i - 1, j, k),
                            field.weight(i, j + 1, k) - field.weight(i, j - 1, k),
                            field.weight(i, j, k + 1) - field.weight(i, j, k - 1));
        if (slope.norm() > 2 * field.spacing() * slope_looked_at) continue;
        const Vector3 node = field.corner() + field.spacing() * Vector3(i, j, k);
        if (std::abs(field.value(node)) > value_looked_at * sigma) continue;
        const auto found = saddle_near(field, node, sigma);
        if (!found || std::abs(field.value(*found)) >= pinched_below * sigma) continue;
        if (std::ranges::none_of(
                out, [&](const Vector3& p) { return (p - *found).norm() < saddles_apart * sigma; }))
          out.push_back(*found);
      }
  return out;
}

}  // namespace

std::size_t close_pinches(SplineField& field, double sigma, std::optional<Eigen::Index> mirror,
                          double plane) {
  std::size_t count = 0;
  for (Vector3 at : saddles_of(field, sigma)) {
    std::optional<Vector3> image;
    if (mirror) {
      double& beside = at[*mirror];
      if (beside < plane - saddles_apart * sigma) continue;  // the image of another one
      if (beside < plane + saddles_apart * sigma)
        beside = plane;
      else
        image = MirrorPlane{int(*mirror), plane}.image(at);
    }
    // Saddles nearby may have lowered this one already.
    const double value = field.value(at);
    if (value <= -pinched_below * sigma) continue;
    // Values are means of coefficients: a trial shows how much one falls.
    field.lower(at, sigma, lowered_width * sigma);
    const double by = (value + pinched_below * sigma) / (value - field.value(at)) * sigma;
    field.lower(at, by - sigma, lowered_width * sigma);
    if (image) field.lower(*image, by, lowered_width * sigma);
    ++count;
  }
  return count;
}

}  // namespace hariko
