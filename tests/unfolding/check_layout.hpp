#pragma once

// An independent check of an unfolding: lengths, folds, trees, and overlaps in exact arithmetic. It uses
// nothing of core/unfolding but the names of facets and edges.

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <set>
#include <vector>

#include "core/polyhedron/polygon_mesh.hpp"
#include "tests/unfolding/dyadic.hpp"

namespace hariko::test {

using Corners = std::array<Vector2, 3>;

/// Layout to be checked: facets in the order of the mesh.
struct CheckedLayout {
  double scale = 1;
  std::vector<Corners> corners;
  std::vector<Index> piece, sheet;  ///< a sheet is what must be free of overlaps
  std::vector<std::pair<Index, Index>> folds;
};

inline Dyadic exact_cross(const Vector2& a, const Vector2& b, const Vector2& q) {
  const Dyadic ex = Dyadic(b.x()) - Dyadic(a.x()), ey = Dyadic(b.y()) - Dyadic(a.y());
  return ex * (Dyadic(q.y()) - Dyadic(a.y())) - ey * (Dyadic(q.x()) - Dyadic(a.x()));
}

/// No edge line of the counter-clockwise polygons separates them up to `tolerance`.
template <class P, class Q>
bool exactly_overlap(const P& p, const Q& q, double tolerance) {
  const auto separated = [&](const auto& own, const auto& other) {
    const std::size_t n = std::size(own);
    for (std::size_t k = 0; k < n; ++k) {
      const Vector2 &a = own[k], &b = own[(k + 1) % n];
      const Dyadic ex = Dyadic(b.x()) - Dyadic(a.x()), ey = Dyadic(b.y()) - Dyadic(a.y());
      const Dyadic allowed = Dyadic(tolerance) * Dyadic(tolerance) * (ex * ex + ey * ey);
      bool beyond = true;
      for (const Vector2& corner : other) {
        const Dyadic cross = exact_cross(a, b, corner);
        beyond = beyond && (cross.sign() <= 0 || (cross * cross - allowed).sign() <= 0);
      }
      if (beyond) return true;
    }
    return false;
  };
  return !separated(p, q) && !separated(q, p);
}

template <class P, class Q>
bool boxes_touch(const P& p, const Q& q) {
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    double low_p = p[0][axis], high_p = low_p, low_q = q[0][axis], high_q = low_q;
    for (const Vector2& v : p) low_p = std::min(low_p, v[axis]), high_p = std::max(high_p, v[axis]);
    for (const Vector2& v : q) low_q = std::min(low_q, v[axis]), high_q = std::max(high_q, v[axis]);
    if (high_p < low_q || high_q < low_p) return false;
  }
  return true;
}

inline double longest_edge_of(const PolygonMesh& mesh) {
  double longest = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(
          longest, (mesh.positions[mesh.face(f)[(k + 1) % 3]] - mesh.positions[mesh.face(f)[k]]).norm());
  return longest;
}

/// Overlapping pairs of facets on the same sheet, exactly.
inline std::size_t count_overlaps(const CheckedLayout& layout, double tolerance) {
  std::vector<Index> order(layout.corners.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto low = [&](Index f) {
    const Corners& c = layout.corners[f];
    return std::min({c[0].x(), c[1].x(), c[2].x()});
  };
  const auto high = [&](Index f) {
    const Corners& c = layout.corners[f];
    return std::max({c[0].x(), c[1].x(), c[2].x()});
  };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return low(a) < low(b); });
  std::size_t count = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size() && low(order[k]) <= high(order[i]); ++k) {
      const Index a = order[i], b = order[k];
      if (layout.sheet[a] == layout.sheet[b] && boxes_touch(layout.corners[a], layout.corners[b]) &&
          exactly_overlap(layout.corners[a], layout.corners[b], tolerance))
        ++count;
    }
  return count;
}

/// Lengths to 1e-12 of the longest edge, orientation, folds whose sides coincide bit for bit, one tree of
/// folds a piece.
inline void check_shape(const PolygonMesh& mesh, const CheckedLayout& layout) {
  const double size = layout.scale * longest_edge_of(mesh);
  ASSERT_EQ(layout.corners.size(), mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Corners& c = layout.corners[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const double length =
          layout.scale * (mesh.positions[mesh.face(f)[(k + 1) % 3]] - mesh.positions[mesh.face(f)[k]]).norm();
      ASSERT_NEAR((c[(k + 1) % 3] - c[k]).norm(), length, 1e-12 * size) << "facet " << f;
    }
    ASSERT_GT(exact_cross(c[0], c[1], c[2]).sign(), 0) << "facet " << f << " is a mirror image";
  }
  std::vector<Index> parent(mesh.face_count());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for (const auto& [f, g] : layout.folds) {
    std::size_t shared = 0;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        if (mesh.face(f)[k] == mesh.face(g)[j]) {
          ++shared;
          ASSERT_EQ(layout.corners[f][k], layout.corners[g][j]) << "fold " << f << "-" << g << " gapes";
        }
    ASSERT_GE(shared, 2U) << "fold " << f << "-" << g;
    ASSERT_NE(root(f), root(g)) << "fold " << f << "-" << g << " closes a cycle";
    parent[root(f)] = root(g);
  }
  std::set<Index> pieces(layout.piece.begin(), layout.piece.end());
  EXPECT_EQ(pieces.size(), mesh.face_count() - layout.folds.size());
  for (Index f = 0; f < mesh.face_count(); ++f)
    ASSERT_EQ(layout.piece[f], layout.piece[root(f)])
        << "facet " << f << " is in another piece than its tree";
}

/// All of it.
inline void check_layout(const PolygonMesh& mesh, const CheckedLayout& layout) {
  check_shape(mesh, layout);
  EXPECT_EQ(count_overlaps(layout, 1e-9 * layout.scale * longest_edge_of(mesh)), 0U);
}

}  // namespace hariko::test
