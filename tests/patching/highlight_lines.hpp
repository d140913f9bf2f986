#pragma once

// Counts what a designer sees as beads: extrema of mean curvature along lines over the faces.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/analysis/curvature.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"
#include "core/surface/surface.hpp"

namespace hariko::test {

/// Means a line.
struct Beads {
  double extrema = 0;  ///< inner ones with both flanks higher than a twentieth of the unit
  double excess = 0;   ///< half of (variation - difference of the ends), in units
};

/// Turns from rising to falling or back, where the values before and after differ by more than `least`.
inline int extrema_of(const std::vector<double>& values, double least) {
  int found = 0, direction = 0;
  double low = values.front(), high = values.front(), last = values.front();
  for (const double value : values) {
    if (direction == 0) {
      low = std::min(low, value);
      high = std::max(high, value);
      if (value < high - least || value > low + least) {
        direction = value < high - least ? -1 : 1;
        const double turned = direction < 0 ? high - values.front() : values.front() - low;
        if (turned > least) ++found;
        last = value;
      }
    } else if ((value - last) * direction > 0) {
      last = value;
    } else if ((last - value) * direction > least) {
      ++found;
      direction = -direction;
      last = value;
    }
  }
  return found;
}

/// Lines of a face in its regular polygon: parameter lines of quads; of others those from the middle to
/// corners and sides, and three rings.
inline std::vector<std::vector<Vector2>> highlight_lines(int sides) {
  const double radius = 1 / (2 * std::sin(std::numbers::pi / sides));
  std::vector<Vector2> corner;
  for (int j = 0; j < sides; ++j) {
    const double angle = 2 * std::numbers::pi * j / sides;
    corner.push_back(radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  std::vector<std::vector<Vector2>> out;
  const auto add = [&](const Vector2& from, const Vector2& to) {
    out.emplace_back();
    for (int i = 0; i < 33; ++i) out.back().push_back(from + (0.02 + 0.96 * i / 32) * (to - from));
  };
  if (sides == 4) {
    const auto between = [&](int a, int b, double x) -> Vector2 {
      return corner[std::size_t(a)] + x * (corner[std::size_t(b)] - corner[std::size_t(a)]);
    };
    for (const double x : {0.08, 0.25, 0.5, 0.75, 0.92}) {
      add(between(0, 1, x), between(3, 2, x));
      add(between(0, 3, x), between(1, 2, x));
    }
    return out;
  }
  for (int j = 0; j < sides; ++j) {
    const Vector2 &a = corner[std::size_t(j)], &b = corner[std::size_t((j + 1) % sides)];
    add({0, 0}, a);
    add({0, 0}, (a + b) / 2);
  }
  for (const double ring : {0.5, 0.75, 0.95}) {
    out.emplace_back();
    const int steps = std::max(4, 32 / sides);
    for (int j = 0; j < sides; ++j)
      for (int i = 0; i < steps; ++i) {
        const Vector2 &a = corner[std::size_t(j)], &b = corner[std::size_t((j + 1) % sides)];
        out.back().push_back(ring * (a + (double(i) / steps) * (b - a)));
      }
  }
  return out;
}

/// Mean curvature at a point of a face's regular polygon; patch h is the triangle (middle, origin, target).
inline double mean_curvature_at(const Surface& surface, const HalfEdgeMesh& mesh, Index face,
                                const Vector2& point) {
  const auto n = static_cast<int>(mesh.side_count(face));
  const double step = 2 * std::numbers::pi / n, radius = 1 / (2 * std::sin(std::numbers::pi / n));
  const double turn = std::atan2(point.y(), point.x());
  const int side =
      std::clamp(int(std::floor((turn < 0 ? turn + 2 * std::numbers::pi : turn) / step)), 0, n - 1);
  const Vector2 a = radius * Vector2(std::cos(step * side), std::sin(step * side));
  const Vector2 b = radius * Vector2(std::cos(step * (side + 1)), std::sin(step * (side + 1)));
  const double determinant = a.x() * b.y() - a.y() * b.x();
  const Vector2 parameter((point.x() * b.y() - point.y() * b.x()) / determinant,
                          (a.x() * point.y() - a.y() * point.x()) / determinant);
  const auto at = curvature(
      surface.patches().evaluate(mesh.face_begin(face) + Index(side), parameter.cwiseMax(0), Order::second));
  return at ? at->mean : 0;
}

/// `unit`: the curvature that counts as one.
inline Beads beads_of(const Surface& surface, const HalfEdgeMesh& mesh, double unit) {
  Beads out;
  double lines = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (const auto& line : highlight_lines(int(mesh.side_count(f)))) {
      std::vector<double> values;
      for (const Vector2& point : line) values.push_back(mean_curvature_at(surface, mesh, f, point));
      double variation = 0;
      for (std::size_t i = 1; i < values.size(); ++i) variation += std::abs(values[i] - values[i - 1]);
      out.excess += (variation - std::abs(values.back() - values.front())) / 2 / unit;
      out.extrema += extrema_of(values, 0.05 * unit);
      lines += 1;
    }
  out.extrema /= lines;
  out.excess /= lines;
  return out;
}

}  // namespace hariko::test
