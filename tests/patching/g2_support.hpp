#pragma once

// Measures of the tests of mode G2: jumps over edges at many points, and how curvature varies round vertices.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/analysis/curvature.hpp"
#include "core/g2/g2_patch_set.hpp"
#include "core/network/vertex_frames.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko::test {

inline const G2PatchSet& g2_set(const PolyhedronSurface& surface) {
  return dynamic_cast<const G2PatchSet&>(surface.surface.patches());
}

/// Error bounds for rounding of a point's derivatives, which are sums of terms as large as the largest
/// derivatives along its seam; these cancel where the point's own are small. They matter where the surface
/// all but folds.
struct Rounding {
  double normal = 0, curvature = 0;  ///< radians; 1 / length

  static double terms(const PatchPoint& point) {
    return point.ds.norm() + point.dt.norm() + point.dss.norm() + point.dst.norm() + point.dtt.norm();
  }
  Rounding(const PatchPoint& point, double largest_terms) {
    const double first = std::max(point.ds.norm(), point.dt.norm()),
                 width = point.ds.cross(point.dt).norm() / first;
    normal = 256 * std::numeric_limits<double>::epsilon() * largest_terms / width;
    curvature = normal * largest_terms / (width * width);
  }
};

/// Over all smooth seams.
struct Jumps {
  double gap = 0, normal = 0, curvature = 0;  ///< the largest ones
  double rms = 0;                             ///< root mean square of the curvature over all samples
  struct Sample {
    double normal = 0, curvature = 0;
    double normal_rounding = 0, curvature_rounding = 0;  ///< bounds of rounding on both sides
  };
  std::vector<Sample> samples;
  double relative() const { return rms > 0 ? curvature / rms : 0; }
};

/// 33 points a seam, ends included, where both sides have a curvature.
inline Jumps jumps_of(const Surface& surface) {
  Jumps out;
  double square = 0;
  for (const Seam& seam : surface.seams()) {
    constexpr int steps = 32;
    const auto at = [&](const PatchSide& side, double fraction) {
      return surface.patches().evaluate(side.patch, side_parameter(Domain::triangle, side.side, fraction),
                                        Order::second);
    };
    double terms = 0;
    for (int k = 0; k <= steps; ++k)
      terms = std::max({terms, Rounding::terms(at(seam.first, k / double(steps))),
                        Rounding::terms(at(seam.second, k / double(steps)))});
    for (int k = 0; k <= steps; ++k) {
      const double x = k / double(steps);
      const PatchPoint a = at(seam.first, x), b = at(seam.second, 1 - x);
      out.gap = std::max(out.gap, (a.position - b.position).norm());
      if (seam.intended == Continuity::g0) continue;
      const auto p = curvature(a), q = curvature(b);
      if (!p || !q) continue;
      const double sine = p->normal.cross(q->normal).norm(), cosine = p->normal.dot(q->normal);
      // Normals are opposite where the surface folds along the edge, and the planes are compared.
      const double sign = cosine < 0 ? -1 : 1;
      const Rounding ra(a, terms), rb(b, terms);
      const Jumps::Sample sample{std::atan2(sine, std::abs(cosine)), (p->tensor - sign * q->tensor).norm(),
                                 ra.normal + rb.normal, ra.curvature + rb.curvature};
      out.normal = std::max(out.normal, sample.normal);
      out.curvature = std::max(out.curvature, sample.curvature);
      out.samples.push_back(sample);
      square += p->tensor.squaredNorm() + q->tensor.squaredNorm();
    }
  }
  if (!out.samples.empty()) out.rms = std::sqrt(square / (2 * double(out.samples.size())));
  return out;
}

/// Largest minus smallest mean and Gaussian curvature on circles round vertices of one sector, in the
/// vertex's own chart: 9 directions a corner, radius in mean edges of the vertex. Relative to rms curvature:
/// (rms, rms^2). Worst vertex.
struct Spread {
  double mean = 0, gauss = 0;
};
inline Spread spread_round(const HalfEdgeMesh& mesh, const VertexFrames& frames, const G2PatchSet& set,
                           double radius, double rms, bool straight_too = false) {
  Spread out;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.outgoing(v) == no_index) continue;
    const bool plain =
        frames.kind[v] == FrameKind::smooth || (straight_too && frames.kind[v] == FrameKind::straight);
    if (!plain) continue;
    double low = std::numeric_limits<double>::infinity(), high = -low, gauss_low = low, gauss_high = -low;
    // Corners of nearly a half turn open by their sine only, and what is near is so much nearer there.
    double opening = 1;
    for (Index k = mesh.outgoing(v), first = k;;) {
      const FaceChart& chart = *set.atlas()->chart[mesh.face(k)];
      if (!chart.straight(set.atlas()->side[k]))
        opening = std::min(opening, 2 * std::sin(chart.corner(set.atlas()->side[k]).angle));
      k = mesh.rotate(k);
      if (k == no_index || k == first) break;
    }
    Index h = mesh.outgoing(v);
    do {
      const Index f = mesh.face(h);
      const FaceChart& chart = *set.atlas()->chart[f];
      const int corner = set.atlas()->side[h], n = chart.sides();
      const Vector2 &at = chart.vertex(corner), forward = chart.vertex((corner + 1) % n) - at,
                    back = chart.vertex((corner + n - 1) % n) - at;
      for (int i = 0; i < 9; ++i) {
        // y = (out alpha + in beta cos d, in beta sin d) at this angle and radius; at straight corners
        // out (alpha - beta, q).
        const CornerShape& shape = chart.corner(corner);
        const double d = shape.angle, angle = d * (i + 0.5) / 9;
        double alpha = 0, beta = 0;
        if (chart.straight(corner)) {
          const double s = std::sin(angle) / shape.out,
                       c = std::cos(angle) / shape.out;  // alpha - beta = c, 2 alpha beta = s (alpha + beta)
          const double sum = s + std::sqrt(s * s + c * c);
          alpha = (sum + c) / 2;
          beta = (sum - c) / 2;
        } else {
          beta = std::sin(angle) / (shape.in * std::sin(d));
          alpha = (std::cos(angle) - shape.in * beta * std::cos(d)) / shape.out;
        }
        const auto k = curvature(
            set.evaluate_chart(f, at + opening * radius * (alpha * forward + beta * back), Order::second));
        if (!k) continue;
        low = std::min(low, k->mean);
        high = std::max(high, k->mean);
        gauss_low = std::min(gauss_low, k->gauss);
        gauss_high = std::max(gauss_high, k->gauss);
      }
      h = mesh.rotate(h);
    } while (h != no_index && h != mesh.outgoing(v));
    if (high < low) continue;
    out.mean = std::max(out.mean, (high - low) / rms);
    out.gauss = std::max(out.gauss, (gauss_high - gauss_low) / (rms * rms));
  }
  return out;
}

}  // namespace hariko::test
