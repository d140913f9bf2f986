#include "core/unfolding/face_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.hpp"

namespace hariko {

namespace {

/// Ear clipping of a polygon in its mean plane.
class EarCutter {
 public:
  explicit EarCutter(std::span<const Vector3> corners) {
    const Vector3 normal = newell_normal(corners).normalized();
    points_ = flattened(corners, corners[0], normal);
    for (Index k = 0; k < corners.size(); ++k) {
      ring_.push_back(k);
      largest_ = std::max(largest_, (corners[k] - corners[0]).squaredNorm());
    }
    for (std::size_t i = 0; i < ring_.size(); ++i) score_.push_back(score(i));
  }

  std::vector<std::array<Index, 3>> cut() {
    std::vector<std::array<Index, 3>> out;
    while (ring_.size() >= 3) {
      const auto best = std::max_element(score_.begin(), score_.end());
      if (!(*best > 0)) return {};
      const auto i = static_cast<std::size_t>(best - score_.begin());
      out.push_back({before(i), ring_[i], after(i)});
      if (ring_.size() == 3) break;
      ring_.erase(ring_.begin() + std::ptrdiff_t(i));
      score_.erase(best);
      const std::size_t n = ring_.size();
      score_[(i + n - 1) % n] = score((i + n - 1) % n);
      score_[i % n] = score(i % n);
      // Recomputes ears that contained a corner: they may be free now.
      for (std::size_t k = 0; k < n; ++k)
        if (score_[k] < 0) score_[k] = score(k);
    }
    return out;
  }

 private:
  Index before(std::size_t i) const { return ring_[(i + ring_.size() - 1) % ring_.size()]; }
  Index after(std::size_t i) const { return ring_[(i + 1) % ring_.size()]; }

  /// Roundness of the ear; 0 where the corner is not convex, below 0 where the ear contains another corner.
  double score(std::size_t i) const {
    const Vector2 &a = points_[before(i)], &b = points_[ring_[i]], &c = points_[after(i)];
    const double twice = twice_area(a, b, c);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if (!(twice > 1e-12 * longest)) return 0;
    const double touching = 1e-12 * largest_;
    for (std::size_t k = 2; k + 1 < ring_.size(); ++k) {
      const Vector2& p = points_[ring_[(i + k) % ring_.size()]];
      if (twice_area(a, b, p) > -touching && twice_area(b, c, p) > -touching &&
          twice_area(c, a, p) > -touching)
        return -1;
    }
    return twice / longest;
  }

  std::vector<Vector2> points_;
  std::vector<Index> ring_;
  std::vector<double> score_;  ///< score of the ear at each corner of the ring
  double largest_ = 0;
};

}  // namespace

double flatness(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

std::vector<std::array<Index, 3>> face_triangles(std::span<const Vector3> corners) {
  if (corners.size() < 3) return {};
  std::vector<std::array<Index, 3>> out;
  if (corners.size() == 3)
    out = {{0, 1, 2}};
  else if (newell_normal(corners).norm() > 0)
    out = EarCutter(corners).cut();
  for (const auto& [i, j, k] : out)
    if (!(flatness(corners[i], corners[j], corners[k]) > 1e-12)) return {};
  return out;
}

}  // namespace hariko
