#include "core/approximation/surface_projector.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr int most_steps = 20;
constexpr int finest_density = 128;

Vector2 within(Domain domain, Vector2 p) {
  if (domain == Domain::square) return p.cwiseMax(0.0).cwiseMin(1.0);
  p = p.cwiseMax(0.0);
  if (p.sum() <= 1) return p;
  // The nearest point of the side s + t = 1.
  const double s = std::clamp(0.5 * (1 + p.x() - p.y()), 0.0, 1.0);
  return {s, 1 - s};
}

/// Damped Newton step towards the closest point.
Vector2 step_to(const PatchPoint& at, const Vector3& point, double damping) {
  const Vector3 away = at.position - point;
  Eigen::Matrix2d hessian;
  hessian << at.ds.dot(at.ds) + away.dot(at.dss), at.ds.dot(at.dt) + away.dot(at.dst),
      at.ds.dot(at.dt) + away.dot(at.dst), at.dt.dot(at.dt) + away.dot(at.dtt);
  const Vector2 gradient(away.dot(at.ds), away.dot(at.dt));
  const double trace = at.ds.squaredNorm() + at.dt.squaredNorm();
  // The Gauss-Newton matrix replaces a Hessian that is not positive definite.
  if (!(hessian(0, 0) > 0 && hessian.determinant() > 1e-12 * trace * trace))
    hessian << at.ds.dot(at.ds), at.ds.dot(at.dt), at.ds.dot(at.dt), at.dt.dot(at.dt);
  hessian.diagonal().array() += damping * trace + 1e-300;
  return -hessian.inverse() * gradient;
}

/// Step with the directions removed that leave the domain: along its border.
Vector2 along_border(Domain domain, const Vector2& at, const PatchPoint& here, const Vector3& point,
                     Vector2 step) {
  const Vector3 away = here.position - point;
  const auto slide = [&](const Vector2& along) {
    const Vector3 tangent = here.ds * along.x() + here.dt * along.y();
    const double square = tangent.squaredNorm();
    return square > 0 ? Vector2(-away.dot(tangent) / square * along) : Vector2(Vector2::Zero());
  };
  constexpr double edge = 1e-14;
  if (domain == Domain::triangle && at.sum() >= 1 - edge && step.sum() > 0) step = slide({1, -1});
  for (int axis = 0; axis < 2; ++axis) {
    const bool low = at[axis] <= edge && step[axis] < 0;
    const bool high = domain == Domain::square && at[axis] >= 1 - edge && step[axis] > 0;
    if (low || high) step = slide(axis == 0 ? Vector2(0, 1) : Vector2(1, 0));
  }
  return step;
}

}  // namespace

struct SurfaceProjector::Net {
  std::vector<std::array<int, 3>> pattern;
  std::vector<Vector2> parameters;
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> triangles;

  static Net of(const SurfaceSampler& sampler, std::size_t wanted) {
    const Surface& surface = sampler.surface();
    Net net;
    const double a_patch = double(wanted) / std::max<double>(1, surface.patch_count());
    const double square = surface.domain() == Domain::square ? a_patch / 2 : a_patch;
    const GridPattern grid{surface.domain(), std::clamp(int(std::sqrt(square)), 2, finest_density)};
    net.pattern = grid.triangles();
    net.parameters = grid.parameters();
    const std::size_t count = net.parameters.size();
    net.points.resize(count * surface.patch_count());
    net.triangles.reserve(net.pattern.size() * surface.patch_count());
    for (Index p = 0; p < surface.patch_count(); ++p) {
      sampler.positions(p, net.parameters, {net.points.data() + p * count, count});
      for (const auto& t : net.pattern)
        net.triangles.push_back(
            {Index(p * count) + Index(t[0]), Index(p * count) + Index(t[1]), Index(p * count) + Index(t[2])});
    }
    return net;
  }
};

SurfaceProjector::SurfaceProjector(const SurfaceSampler& sampler, std::size_t triangles)
    : SurfaceProjector(sampler, Net::of(sampler, triangles)) {}

SurfaceProjector::SurfaceProjector(const SurfaceSampler& sampler, const Net& net)
    : sampler_(sampler),
      pattern_(net.pattern),
      parameters_(net.parameters),
      points_(net.points),
      tree_(net.points, net.triangles) {}

SurfaceFoot SurfaceProjector::foot(const Vector3& point) const {
  SurfaceFoot best;
  const Index t = tree_.nearest(point).triangle;
  if (t == no_index) {
    best.distance = std::numeric_limits<double>::infinity();
    return best;
  }
  best.patch = t / Index(pattern_.size());
  // Starts at the nearest corner.
  const auto& corners = pattern_[t % pattern_.size()];
  double nearest = std::numeric_limits<double>::infinity();
  for (const int c : corners) {
    const Vector3& q = points_[best.patch * parameters_.size() + std::size_t(c)];
    if ((q - point).squaredNorm() >= nearest) continue;
    nearest = (q - point).squaredNorm();
    best.parameter = parameters_[std::size_t(c)];
    best.position = q;
  }
  const Domain domain = sampler_.surface().domain();
  PatchPoint here = sampler_.second_order(best.patch, best.parameter);
  double damping = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Vector2 by = along_border(domain, best.parameter, here, point, step_to(here, point, damping));
    const Vector2 next = within(domain, best.parameter + by);
    if ((next - best.parameter).cwiseAbs().maxCoeff() < 1e-14) break;
    const PatchPoint there = sampler_.second_order(best.patch, next);
    const double square = (there.position - point).squaredNorm();
    if (!(square < nearest)) {
      damping = damping == 0 ? 0.01 : 8 * damping;
      if (damping > 1e4) break;
      continue;
    }
    const bool settled = square > nearest * (1 - 1e-14);
    nearest = square;
    best.parameter = next;
    best.position = there.position;
    here = there;
    damping /= 8;
    if (settled) break;
  }
  best.distance = std::sqrt(nearest);
  return best;
}

double farthest_from(const Surface& surface, const Surface& other, const CancelToken& cancel,
                     const Progress& progress) {
  if (surface.patch_count() == 0) return 0;
  const SurfaceSampler sampler(other);
  const SurfaceProjector feet(sampler);
  const Vector3 shift = surface.origin() - other.origin();
  const GridPattern pattern{surface.domain(), 4};
  const auto count = std::size_t(pattern.point_count());
  std::vector<double> each(surface.patch_count(), 0.0);
  parallel_for(each.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3> positions(count), normals(count);
    for (std::size_t p = begin; p < end && !cancel.cancelled(); ++p) {
      const Index patch[] = {Index(p)};
      surface.patches().evaluate_grid(patch, pattern, positions, normals);
      for (const Vector3& at : positions) each[p] = std::max(each[p], feet.foot(at + shift).distance);
    }
  });
  progress.report(1);
  return *std::max_element(each.begin(), each.end());
}

}  // namespace hariko
