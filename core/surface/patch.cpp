#include "core/surface/patch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

Vector2 corner_parameter(Domain domain, int corner) {
  HARIKO_ASSERT(corner >= 0 && corner < corner_count(domain), "no such corner");
  if (domain == Domain::triangle) return {corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0};
  return {corner == 1 || corner == 2 ? 1.0 : 0.0, corner >= 2 ? 1.0 : 0.0};
}

Vector2 centre_parameter(Domain domain) {
  return Vector2::Constant(domain == Domain::triangle ? 1.0 / 3 : 0.5);
}

Vector2 side_parameter(Domain domain, int side, double x) {
  HARIKO_ASSERT(side >= 0 && side < corner_count(domain), "no such side");
  if (side == 0) return {x, 0.0};
  if (domain == Domain::triangle) return side == 1 ? Vector2(1.0 - x, x) : Vector2(0.0, 1.0 - x);
  if (side == 1) return {1.0, x};
  return side == 2 ? Vector2(1.0 - x, 1.0) : Vector2(0.0, 1.0 - x);
}

double grid_fraction(int i, int density) {
  HARIKO_ASSERT(density >= 1 && i >= 0 && i <= density, "grid index out of range");
  // The upper half is a multiple of 2^-53, so its distance from 1 is exact: the lower half is that distance.
  const int far = std::max(i, density - i);
  const double upper = 1.0 - double(density - far) / density;
  return i == far ? upper : 1.0 - upper;
}

std::vector<Vector2> GridPattern::parameters() const {
  std::vector<Vector2> out;
  out.reserve(static_cast<std::size_t>(point_count()));
  std::vector<double> fractions(static_cast<std::size_t>(density) + 1);
  for (int i = 0; i <= density; ++i) fractions[static_cast<std::size_t>(i)] = grid_fraction(i, density);
  for (int j = 0; j <= density; ++j) {
    const int end = domain == Domain::triangle ? density - j : density;
    for (int i = 0; i <= end; ++i)
      out.emplace_back(fractions[static_cast<std::size_t>(i)], fractions[static_cast<std::size_t>(j)]);
  }
  return out;
}

std::vector<std::array<int, 3>> GridPattern::triangles() const {
  std::vector<std::array<int, 3>> out;
  out.reserve(static_cast<std::size_t>(density * density * (domain == Domain::triangle ? 1 : 2)));
  for (int j = 0; j < density; ++j) {
    const int end = domain == Domain::triangle ? density - j : density;
    for (int i = 0; i < end; ++i) {
      out.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
      if (domain == Domain::square || i + 1 < end)
        out.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return out;
}

std::vector<int> GridPattern::side(int side) const {
  HARIKO_ASSERT(side >= 0 && side < corner_count(domain), "no such side");
  std::vector<int> out(static_cast<std::size_t>(density) + 1);
  for (int k = 0; k <= density; ++k) {
    const int back = density - k;
    int point = 0;
    if (side == 0) {
      point = index(k, 0);
    } else if (domain == Domain::triangle) {
      point = side == 1 ? index(back, k) : index(0, back);
    } else {
      point = side == 1 ? index(density, k) : side == 2 ? index(back, density) : index(0, back);
    }
    out[static_cast<std::size_t>(k)] = point;
  }
  return out;
}

namespace {

/// Default batch: evaluates one point after the other.
class SinglePoints final : public BatchEvaluation {
 public:
  SinglePoints(const PatchSet& patches, std::vector<Vector2> parameters)
      : patches_(patches), parameters_(std::move(parameters)) {}

  void evaluate(std::span<const Index> patches, Order order, std::span<PatchPoint> points) const override {
    HARIKO_ASSERT(points.size() >= patches.size() * parameters_.size(), "output array is too small");
    std::size_t at = 0;
    for (const Index patch : patches)
      for (const Vector2& parameter : parameters_) points[at++] = patches_.evaluate(patch, parameter, order);
  }

 private:
  const PatchSet& patches_;
  std::vector<Vector2> parameters_;
};

}  // namespace

std::unique_ptr<const BatchEvaluation> PatchSet::batch(std::vector<Vector2> parameters) const {
  return std::make_unique<SinglePoints>(*this, std::move(parameters));
}

void PatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                             std::span<Vector3> positions, std::span<Vector3> normals) const {
  HARIKO_ASSERT(pattern.domain == domain(), "a grid of another domain");
  const std::vector<Vector2> parameters = pattern.parameters();
  const std::size_t count = patches.size() * parameters.size();
  HARIKO_ASSERT(positions.size() >= count && normals.size() >= count, "output arrays are too small");
  std::size_t at = 0;
  for (const Index patch : patches)
    for (const Vector2& parameter : parameters) {
      const PatchPoint point = evaluate(patch, parameter, Order::first);
      positions[at] = point.position;
      normals[at++] = normal_at(patch, parameter, point);
    }
}

void PatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                             std::span<PatchPoint> points) const {
  HARIKO_ASSERT(pattern.domain == domain(), "a grid of another domain");
  SinglePoints(*this, pattern.parameters()).evaluate(patches, Order::second, points);
}

CornerSecondOrder PatchSet::second_order_at_corner(Index patch, int corner) const {
  const PatchPoint point = evaluate(patch, corner_parameter(domain(), corner), Order::first);
  return unit_normal(point).isZero(0) ? CornerSecondOrder::undefined : CornerSecondOrder::exact;
}

Vector3 PatchSet::normal_at(Index patch, const Vector2& parameter, const PatchPoint& point) const {
  const Vector3 normal = unit_normal(point);
  return normal.isZero(0) ? inner_normal(patch, parameter) : normal;
}

Vector3 PatchSet::inner_normal(Index patch, const Vector2& parameter) const {
  const Vector2 inside = parameter + 1e-4 * (centre_parameter(domain()) - parameter);
  return unit_normal(evaluate(patch, inside, Order::first));
}

void PatchSet::positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const {
  for (std::size_t k = 0; k < parameters.size(); ++k)
    out[k] = evaluate(patch, parameters[k], Order::first).position;
}

void PatchSet::first_order(Index patch, std::span<const Vector2> parameters,
                           std::span<PatchPoint> out) const {
  for (std::size_t k = 0; k < parameters.size(); ++k) out[k] = evaluate(patch, parameters[k], Order::first);
}

void PatchSet::hull(Index, const ParameterTriangle&, std::span<const Vector3>, std::span<HullBall>) const {
  HARIKO_ASSERT(false, "this patch has no bound");
}

Vector3 unit_normal(const PatchPoint& point) {
  // Scaled first, since derivatives may be as small or large as doubles allow.
  const double s = point.ds.stableNorm(), t = point.dt.stableNorm();
  if (!(s > 0) || !(t > 0)) return Vector3::Zero();
  const Vector3 cross = (point.ds / s).cross(point.dt / t);
  const double length = cross.norm();
  if (!(length > 1e-12)) return Vector3::Zero();
  return cross / length;
}

}  // namespace hariko
