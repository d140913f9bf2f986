#include "core/unfolding/folding.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

using Eigen::Quaterniond;

/// Orthonormal axes of a triangle: along its first side, across it in the plane, normal.
Matrix3 axes_of(const SpaceCorners& c) {
  Matrix3 out;
  out.col(0) = (c[1] - c[0]).normalized();
  out.col(2) = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
  out.col(1) = out.col(2).cross(out.col(0));
  return out;
}

/// Neighbour of a facet in space, rotated about the common side by `angle` from the facet's plane, away from
/// its normal.
SpaceCorners turned_neighbour(const SpaceCorners& facet, Index side, const FacetCorners& shape, Index mate,
                              double angle) {
  const Vector3 &a = facet[side], &b = facet[(side + 1) % 3];
  const Vector3 along = (b - a).normalized();
  const Vector3 normal = (facet[1] - facet[0]).cross(facet[2] - facet[0]).normalized();
  const Vector3 outward = along.cross(normal);
  // In the neighbour the side runs from b to a.
  const Vector2 u = (shape[(mate + 1) % 3] - shape[mate]).normalized(), up(-u.y(), u.x());
  const Vector2 tip = shape[(mate + 2) % 3] - shape[mate];
  SpaceCorners out;
  out[mate] = b;
  out[(mate + 1) % 3] = a;
  out[(mate + 2) % 3] =
      b - tip.dot(u) * along + tip.dot(up) * (std::cos(angle) * outward - std::sin(angle) * normal);
  return out;
}

/// Final position of mesh points on the pages.
class Standing {
 public:
  Standing(const Unfolding& unfolding, double page_distance) : scale_(unfolding.settings.scale) {
    Vector3 low = Vector3::Constant(1e300), high = -low;
    for (Index f = 0; f < unfolding.graph->facet_count(); ++f)
      for (const Index v : unfolding.graph->triangle(f)) {
        low = low.cwiseMin(unfolding.graph->positions()[v]);
        high = high.cwiseMax(unfolding.graph->positions()[v]);
      }
    foot_ = {0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), low.z()};
    const double pages = std::max<double>(1, unfolding.page_count) - 1;
    place_ = {0.5 * (pages * page_distance + unfolding.settings.page.width),
              0.5 * unfolding.settings.page.height, 0};
  }
  Vector3 apply(const Vector3& p) const { return place_ + scale_ * (p - foot_); }

 private:
  double scale_;
  Vector3 foot_, place_;
};

}  // namespace

std::vector<SpaceCorners> folded_positions(const Unfolding& unfolding, double t, double page_distance) {
  t = std::clamp(t, 0.0, 1.0);
  const FacetGraph& graph = *unfolding.graph;
  const std::vector<FacetCorners> shapes = facet_shapes(graph, unfolding.settings.scale);
  const Standing standing(unfolding, page_distance);
  std::vector<SpaceCorners> out(graph.facet_count());
  std::vector<char> done(graph.facet_count(), 0);
  for (const PaperPiece& piece : unfolding.pieces) {
    const Index root = piece.facets.front();
    SpaceCorners flat, solid;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2& p = unfolding.corners[root][k];
      flat[k] = {p.x() + piece.placement.page * page_distance, p.y(), 0};
      solid[k] = standing.apply(graph.positions()[graph.triangle(root)[k]]);
    }
    const Matrix3 from = axes_of(flat), to = axes_of(solid);
    const Matrix3 axes = Quaterniond(from).slerp(t, Quaterniond(to)).toRotationMatrix();
    const Vector3 corner = (1 - t) * flat[0] + t * solid[0];
    for (std::size_t k = 0; k < 3; ++k)
      out[root][k] = corner + axes.col(0) * shapes[root][k].x() + axes.col(1) * shapes[root][k].y();
    done[root] = 1;
    for (const Index facet : piece.facets)  // parents come before their children
      for (Index side = 0; side < 3; ++side) {
        const Index e = graph.edge_at(facet, side), next = graph.neighbour(facet, side);
        if (!unfolding.folds[e] || done[next]) continue;
        done[next] = 1;
        out[next] = turned_neighbour(out[facet], side, shapes[next], graph.mate_side(facet, side),
                                     t * graph.edge(e).fold_angle);
      }
  }
  return out;
}

}  // namespace hariko
