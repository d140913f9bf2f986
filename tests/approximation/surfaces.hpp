#pragma once

// The surfaces of tests/golden/approximation, and made ones.

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/surface/weld_patches.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

inline std::vector<BezierPatch> golden_patches(const std::string& name) {
  std::ifstream file(test::source_folder() + "/tests/golden/approximation/surfaces.json");
  const auto json = nlohmann::json::parse(file);
  std::vector<BezierPatch> out;
  for (const auto& patch : json.at(name)) {
    const auto& rows = patch.at("ctrl");
    BezierPatch made;
    made.degree_s = int(rows.size()) - 1;
    made.degree_t = int(rows[0].size()) - 1;
    for (std::size_t j = 0; j < rows[0].size(); ++j)
      for (std::size_t i = 0; i < rows.size(); ++i)
        made.points.emplace_back(rows[i][j][0], rows[i][j][1], rows[i][j][2]);
    out.push_back(std::move(made));
  }
  return out;
}

inline Surface golden_surface(const std::string& name) {
  return weld_patches(Vector3::Zero(), golden_patches(name)).value();
}

inline BezierPatch scaled(BezierPatch patch, double factor) {
  for (Vector3& p : patch.points) p *= factor;
  return patch;
}

/// s runs the other way.
inline BezierPatch reversed(const BezierPatch& patch) {
  BezierPatch out = patch;
  for (int j = 0; j <= patch.degree_t; ++j)
    for (int i = 0; i <= patch.degree_s; ++i) {
      out.points[out.index(i, j)] = patch.points[patch.index(patch.degree_s - i, j)];
      if (patch.rational()) out.weights[out.index(i, j)] = patch.weights[patch.index(patch.degree_s - i, j)];
    }
  return out;
}

/// A quarter circle from angle k pi / 2 on, as a rational quadratic: x, y, weight.
inline std::array<Vector3, 3> quarter_circle(int k) {
  const double c[4] = {1, 0, -1, 0}, s[4] = {0, 1, 0, -1};
  const int a = k % 4, b = (k + 1) % 4;
  return {Vector3(c[a], s[a], 1), Vector3(c[a] + c[b], s[a] + s[b], std::sqrt(0.5)), Vector3(c[b], s[b], 1)};
}

/// The whole sphere as eight rational biquadratic octants, each shrunk to a point at a pole.
inline std::vector<BezierPatch> rational_sphere(double radius) {
  std::vector<BezierPatch> out;
  for (int half = 0; half < 2; ++half)
    for (int k = 0; k < 4; ++k) {
      const auto round = quarter_circle(k), up = quarter_circle(half == 0 ? 3 : 0);
      BezierPatch patch;
      patch.degree_s = patch.degree_t = 2;
      for (const Vector3& q : up)
        for (const Vector3& p : round) {
          patch.points.push_back(radius * Vector3(q.x() * p.x(), q.x() * p.y(), q.y()));
          patch.weights.push_back(p.z() * q.z());
        }
      out.push_back(std::move(patch));
    }
  return out;
}

/// A body of revolution with bicubic quarters like a teapot's lid and pot: the profile is a chain of cubic
/// pieces that starts and ends on the axis.
inline std::vector<BezierPatch> teapot_like() {
  const std::vector<Vector2> profile = {
      {0, 3.15},  {0.8, 3.15}, {0, 2.7},  {0.2, 2.55},  {0.4, 2.4},  {1.3, 2.4}, {1.3, 2.25}, {1.5, 2.25},
      {1.9, 1.2}, {2, 0.9},    {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}, {1.5, 0},   {1.2, -0.1}, {0, -0.1}};
  constexpr double k = 0.5522847498;
  std::vector<BezierPatch> out;
  for (std::size_t piece = 0; piece + 3 < profile.size(); piece += 3)
    for (int quarter = 0; quarter < 4; ++quarter) {
      BezierPatch patch;
      const auto corner = quarter_circle(quarter);
      const Vector2 a(corner[0].x(), corner[0].y()), b(corner[2].x(), corner[2].y());
      const Vector2 ring[4] = {a, a + k * b, b + k * a, b};
      for (std::size_t j = 0; j < 4; ++j)
        for (const Vector2& r : ring) {
          const Vector2& p = profile[piece + j];
          patch.points.emplace_back(p.x() * r.x(), p.x() * r.y(), p.y());
        }
      out.push_back(flipped(patch));
    }
  return out;
}

}  // namespace hariko::test
