#pragma once

// Surfaces that are known exactly, with outlines on them: what control points are compared with.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "core/gaussmap/control_points.hpp"

namespace hariko::test {

inline constexpr double pi = std::numbers::pi;

inline GaussOptions in_mode(GaussMode mode) {
  GaussOptions options;
  options.mode = mode;
  return options;
}

/// An outline of tests/golden/gaussmap.
Outline golden_outline(const std::string& name);

/// A surface near which points are measured. `foot`: a point of the surface and its normal, nearest to a
/// point that is not far off.
struct Truth {
  struct Foot {
    Vector3 point, normal;
  };
  std::function<Foot(const Vector3&)> foot;
  std::function<Vector3(const Vector3&)> point_of_normal;
  std::function<double(const Vector3&)> curvature_of_normal;
};

inline Truth ellipsoid(const Vector3& axes) {
  const Vector3 squares = axes.cwiseAbs2();
  Truth truth;
  truth.foot = [squares](const Vector3& p) {
    // The foot is q = p a^2 / (a^2 + t); t is the root of a function that falls from its pole on.
    double low = -squares.minCoeff(),
           high = squares.maxCoeff() + p.norm() * std::sqrt(squares.maxCoeff()) + 1;
    for (int i = 0; i < 200; ++i) {
      const double t = (low + high) / 2;
      const Vector3 q = p.cwiseProduct(squares).cwiseQuotient((squares.array() + t).matrix());
      (q.cwiseAbs2().cwiseQuotient(squares).sum() > 1 ? low : high) = t;
    }
    const Vector3 q = p.cwiseProduct(squares).cwiseQuotient((squares.array() + low).matrix());
    return Truth::Foot{q, q.cwiseQuotient(squares).normalized()};
  };
  truth.point_of_normal = [squares](const Vector3& n) {
    return Vector3(squares.cwiseProduct(n) / std::sqrt(squares.dot(n.cwiseAbs2())));
  };
  truth.curvature_of_normal = [squares](const Vector3& n) {
    const double square = squares.dot(n.cwiseAbs2());
    return square * square / squares.prod();
  };
  return truth;
}

/// The graph z = f(x, y), by f, its gradient and its second derivatives (xx, xy, yy).
inline Truth graph(const std::function<double(double, double)>& f,
                   const std::function<Vector2(double, double)>& gradient, const Vector3& second) {
  Truth truth;
  const auto normal = [=](double x, double y) {
    const Vector2 g = gradient(x, y);
    return Vector3(Vector3(-g.x(), -g.y(), 1).normalized());
  };
  truth.foot = [=](const Vector3& p) {
    Vector2 at(p.x(), p.y());
    for (int i = 0; i < 50; ++i) {  // Newton's method for half the squared distance
      const Vector2 g = gradient(at.x(), at.y());
      const double lift = f(at.x(), at.y()) - p.z();
      const Vector2 slope = at - Vector2(p.x(), p.y()) + lift * g;
      Eigen::Matrix2d hessian = Eigen::Matrix2d::Identity() + g * g.transpose();
      hessian += lift * (Eigen::Matrix2d() << second.x(), second.y(), second.y(), second.z()).finished();
      at -= hessian.inverse() * slope;
    }
    return Truth::Foot{{at.x(), at.y(), f(at.x(), at.y())}, normal(at.x(), at.y())};
  };
  return truth;
}

/// z = -(x^2 / 2 + y^2 / 1.2)
inline Truth paraboloid() {
  Truth truth = graph([](double x, double y) { return -(x * x / 2 + y * y / 1.2); },
                      [](double x, double y) { return Vector2(-x, -y / 0.6); }, {-1, 0, -1 / 0.6});
  truth.point_of_normal = [](const Vector3& n) {
    const double x = n.x() / n.z(), y = 0.6 * n.y() / n.z();
    return Vector3(x, y, -(x * x / 2 + y * y / 1.2));
  };
  truth.curvature_of_normal = [](const Vector3& n) { return std::pow(n.z(), 4) / 0.6; };
  return truth;
}

/// z = x y
inline Truth saddle_truth() {
  return graph([](double x, double y) { return x * y; }, [](double x, double y) { return Vector2(y, x); },
               {0, 1, 0});
}

/// Radius cosh z round the z axis.
inline Truth catenoid() {
  Truth truth;
  truth.foot = [](const Vector3& p) {
    const double r = std::hypot(p.x(), p.y());
    double v = p.z();
    for (int i = 0; i < 60; ++i) {
      const double slope = (std::cosh(v) - r) * std::sinh(v) + v - p.z();
      const double bend = std::sinh(v) * std::sinh(v) + (std::cosh(v) - r) * std::cosh(v) + 1;
      v -= slope / bend;
    }
    const Vector3 out(p.x() / r, p.y() / r, 0);
    return Truth::Foot{std::cosh(v) * out + v * Vector3::UnitZ(),
                       (out - std::sinh(v) * Vector3::UnitZ()).normalized()};
  };
  return truth;
}

/// An outline along a curve on a surface, uniform in the arc length of its Gauss image. `at(t)`, t in 0 .. 1:
/// point, normal and curvature.
struct OnSurface {
  Vector3 point, normal;
  double curvature;
};
inline OutlineLoop uniform_loop(std::size_t count, const std::function<OnSurface(double)>& at) {
  constexpr int fine = 20000;
  std::vector<double> length{0};
  for (int i = 0; i < fine; ++i)
    length.push_back(length.back() + (at((i + 1.0) / fine).normal - at(double(i) / fine).normal).norm());
  OutlineLoop out;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = length.back() * double(k) / double(count);
    const auto above = std::upper_bound(length.begin(), length.end(), wanted);
    const auto i = std::size_t(above - length.begin()) - 1;
    const OnSurface made = at((double(i) + (wanted - length[i]) / (length[i + 1] - length[i])) / fine);
    out.points.push_back(made.point);
    out.normals.push_back(made.normal);
    out.curvature.push_back(made.curvature);
  }
  return out;
}

/// A loop on a sphere or, by its normals, on an ellipsoid: a circle of normals, the image on its left when
/// `angle` turns counter-clockwise round `axis`.
inline OutlineLoop circle_of_normals(const Truth& truth, const Vector3& axis, double angle, std::size_t count,
                                     bool clockwise) {
  OutlineLoop out;
  const Vector3 a = axis.normalized();
  const Vector3 u =
      (std::abs(a.z()) > 0.9 ? Vector3::UnitY() : Vector3::UnitZ()).cross(a).cross(a).normalized() * -1;
  const Vector3 w = a.cross(u);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = (clockwise ? -2 : 2) * pi * double(k) / double(count);
    const Vector3 n = std::cos(angle) * a + std::sin(angle) * (std::cos(t) * u + std::sin(t) * w);
    out.normals.push_back(n);
    out.points.push_back(truth.point_of_normal(n));
    out.curvature.push_back(truth.curvature_of_normal(n));
  }
  return out;
}

struct GroundTruth {
  std::string name;
  Outline outline;
  Truth truth;
};

inline GroundTruth sphere_cap(std::size_t count) {
  const Truth truth = ellipsoid(Vector3::Constant(2));
  return {"sphere cap", {{circle_of_normals(truth, Vector3::UnitZ(), pi / 3, count, false)}}, truth};
}
inline GroundTruth ellipsoid_cap(std::size_t count) {
  const Truth truth = ellipsoid({2, 1.5, 1});
  const auto at = [truth](double t) {
    const double r = std::sqrt(1 - 0.16);
    const Vector3 p(2 * r * std::cos(2 * pi * t), 1.5 * r * std::sin(2 * pi * t), 0.4);
    const Vector3 n = Vector3(p.x() / 4, p.y() / 2.25, p.z()).normalized();
    return OnSurface{p, n, truth.curvature_of_normal(n)};
  };
  return {"ellipsoid cap", {{uniform_loop(count, at)}}, truth};
}
inline GroundTruth paraboloid_cap(std::size_t count) {
  const Truth truth = paraboloid();
  const auto at = [truth](double t) {
    const double x = std::cos(2 * pi * t), y = 0.8 * std::sin(2 * pi * t);
    const Vector3 n = Vector3(x, y / 0.6, 1).normalized();
    return OnSurface{{x, y, -(x * x / 2 + y * y / 1.2)}, n, truth.curvature_of_normal(n)};
  };
  return {"paraboloid", {{uniform_loop(count, at)}}, truth};
}
/// `count` points on the lower loop, three quarters of it on the upper one.
inline GroundTruth sphere_band(std::size_t count) {
  const Truth truth = ellipsoid(Vector3::Ones());
  return {"sphere band",
          {{circle_of_normals(truth, Vector3::UnitZ(), 2 * pi / 3, count, false),
            circle_of_normals(truth, Vector3::UnitZ(), 2 * pi / 9, count * 3 / 4, true)}},
          truth};
}
inline GroundTruth three_holes(const Vector3& axes, std::size_t count, const std::string& name) {
  const Truth truth = ellipsoid(axes);
  GroundTruth out{name, {}, truth};
  for (const Vector3& axis : {Vector3(1, 0, 0.1), Vector3(-0.5, 0.86, -0.1), Vector3(-0.5, -0.86, 0.25)})
    out.outline.loops.push_back(circle_of_normals(truth, axis, pi / 6, count, true));
  return out;
}
inline GroundTruth saddle_disc(std::size_t count) {
  const auto at = [](double t) {
    const double x = 0.8 * std::cos(2 * pi * t), y = 0.8 * std::sin(2 * pi * t), w = 1 + x * x + y * y;
    return OnSurface{{x, y, x * y}, Vector3(-y, -x, 1).normalized(), -1 / (w * w)};
  };
  return {"saddle", {{uniform_loop(count, at)}}, saddle_truth()};
}

/// `lower` points on the lower loop, whose image is the smaller circle: steps are equal with 31 on the upper
/// loop for 27 on the lower one.
inline GroundTruth catenoid_strip(std::size_t lower, std::size_t upper) {
  const auto ring = [](double v, std::size_t n, bool clockwise) {
    OutlineLoop loop;
    for (std::size_t i = 0; i < n; ++i) {
      const double t = (clockwise ? -2 : 2) * pi * double(i) / double(n), r = std::cosh(v);
      const Vector3 out(std::cos(t), std::sin(t), 0);
      loop.points.push_back(r * out + v * Vector3::UnitZ());
      loop.normals.push_back((out - std::sinh(v) * Vector3::UnitZ()).normalized());
      loop.curvature.push_back(-1 / std::pow(r, 4));
    }
    return loop;
  };
  return {"catenoid", {{ring(-0.9, lower, false), ring(0.7, upper, true)}}, catenoid()};
}
/// As many points as gaussmap.md 4 was measured with.
inline GroundTruth catenoid_strip(std::size_t count) {
  return catenoid_strip(count, count * 7 / 8);
}

/// Errors of the inserted points: largest distance from the true surface, largest angle between given and
/// true normal.
struct PointErrors {
  double distance = 0, degrees = 0, support = 0;
  double curvature = 0;  ///< relative, root of the mean square
};
/// `first`: of so many inserted points only.
inline PointErrors point_errors(const ControlPoints& result, const Truth& truth,
                                std::size_t first = SIZE_MAX) {
  PointErrors out;
  double squares = 0;
  const std::size_t inner = std::min(first, result.points.size() - result.boundary_count);
  for (std::size_t i = result.boundary_count; i < result.boundary_count + inner; ++i) {
    const Truth::Foot foot = truth.foot(result.points[i]);
    out.distance = std::max(out.distance, (result.points[i] - foot.point).norm());
    const double angle =
        std::atan2(foot.normal.cross(result.normals[i]).norm(), foot.normal.dot(result.normals[i]));
    out.degrees = std::max(out.degrees, angle * 180 / pi);
    if (truth.point_of_normal)
      out.support = std::max(
          out.support,
          std::abs(result.support[i] - result.normals[i].dot(truth.point_of_normal(result.normals[i]))));
    if (truth.curvature_of_normal)
      squares += std::pow(result.curvature[i] / truth.curvature_of_normal(result.normals[i]) - 1, 2);
  }
  out.curvature = inner ? std::sqrt(squares / double(inner)) : 0;
  return out;
}

}  // namespace hariko::test
