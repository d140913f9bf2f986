#pragma once

// Invariants of every network at its vertices.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <span>

#include "core/envelope/network/curve_network.hpp"

namespace hariko::test {

/// Tangents at a vertex lie in its plane, and curvature vectors of matched primitive edges agree and point to
/// the solid's centre (in the frame where it has equal sizes). `solids`: relative to the network's origin.
inline void check_vertices(const CurveNetwork& network, std::span<const NetworkSolid> solids) {
  std::vector<std::vector<Vector3>> at(network.cage.vertices.size());
  for (const NetworkCurve& curve : network.curves)
    for (const auto& [v, ribbon] :
         {std::pair{curve.low, curve.ribbon}, std::pair{curve.high, curve.ribbon.reversed()}}) {
      const CageVertex& vertex = network.cage.vertices[v];
      EXPECT_NEAR(ribbon.start_derivative().stableNormalized().dot(vertex.normal), 0, 1e-9);
      EXPECT_LT((ribbon.start() - vertex.position).norm(), 1e-12 * (1 + vertex.position.norm()));
      if (!curve.matched) continue;
      const NetworkSolid& solid = solids[vertex.solid];
      Vector3 p[3];
      for (int i = 0; i < 3; ++i)
        p[i] = solid.to_unit * (cartesian(ribbon.curve[std::size_t(i)]) - solid.centre);
      // Curvature vector of a rational cubic at its start: (2/3) w2 w0 / w1^2 times the height of P2 over
      // |P1-P0|^2.
      const Vector3 t = (p[1] - p[0]).normalized(), across = (p[2] - p[0]) - (p[2] - p[0]).dot(t) * t;
      const double w1 = ribbon.curve[1].w(), w2 = ribbon.curve[2].w();
      at[v].push_back(2.0 / 3 * w2 / (w1 * w1) * across / (p[1] - p[0]).squaredNorm());
    }
  for (std::size_t v = 0; v < at.size(); ++v)
    for (const Vector3& k : at[v]) {
      EXPECT_LT((k - at[v][0]).norm(), 1e-9 * at[v][0].norm());
      EXPECT_LT((k.normalized() + network.cage.vertices[v].unit.normalized()).norm(), 1e-7);
    }
}

}  // namespace hariko::test
