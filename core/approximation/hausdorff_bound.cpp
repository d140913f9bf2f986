#include "core/approximation/hausdorff_bound.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr std::size_t triangles_per_task = 64;
constexpr int deepest = 40;
constexpr int most_pieces = 100'000;  ///< per triangle

class PieceBound {
 public:
  PieceBound(const TriangleTree& tree, std::span<const Vector3> positions,
             std::span<const std::array<Index, 3>> triangles, double tolerance)
      : tree_(tree), positions_(positions), triangles_(triangles), tolerance_(tolerance) {}

  /// Bound of one triangle's distance; negative where it is not within the tolerance, or where that cannot be
  /// decided.
  double of(const TriangleCorners& corners) {
    pieces_ = 0;
    std::array<Corner, 3> piece;
    for (std::size_t c = 0; c < 3; ++c) piece[c] = corner(corners[c]);
    return of(piece, deepest);
  }

 private:
  struct Corner {
    Vector3 at = Vector3::Zero();
    TriangleTree::Nearest nearest;
  };
  using Piece = std::array<Corner, 3>;

  Corner corner(const Vector3& at) const { return {at, tree_.nearest(at, tolerance_)}; }

  double of(const Piece& piece, int depth) {
    if (++pieces_ > most_pieces) return -1;
    for (const Corner& c : piece)
      if (c.nearest.triangle == no_index) return -1;
    double best = std::numeric_limits<double>::infinity();
    for (const Corner& candidate : piece) {
      const ClosedTriangle& triangle = tree_.triangle(candidate.nearest.triangle);
      double worst = 0;
      for (const Corner& c : piece) worst = std::max(worst, triangle.distance(c.at));
      best = std::min(best, worst);
    }
    if (best <= tolerance_) return best;
    if (depth == 0) return -1;
    return cut(piece, depth - 1);
  }

  /// Bisecting plane between two triangles with a common edge, as a point and a normal.
  std::optional<std::pair<Vector3, Vector3>> between(Index a, Index b) const {
    Index common[2] = {no_index, no_index}, opposite[2] = {no_index, no_index};
    int count = 0;
    for (const Index v : triangles_[a]) {
      const bool shared = std::find(triangles_[b].begin(), triangles_[b].end(), v) != triangles_[b].end();
      if (!shared) opposite[0] = v;
      if (shared && count < 2) common[count++] = v;
    }
    for (const Index v : triangles_[b])
      if (v != common[0] && v != common[1]) opposite[1] = v;
    if (count != 2 || opposite[0] == no_index || opposite[1] == no_index) return std::nullopt;
    const Vector3& from = positions_[common[0]];
    const Vector3 edge = (positions_[common[1]] - from).normalized();
    const auto inward = [&](Index v) {
      const Vector3 way = positions_[v] - from;
      return Vector3((way - way.dot(edge) * edge).normalized());
    };
    const Vector3 normal = inward(opposite[0]) - inward(opposite[1]);
    if (!(normal.norm() > 1e-6)) return std::nullopt;
    return std::pair{from, normal};
  }

  double cut(const Piece& piece, int depth) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &a = piece[i], &b = piece[(i + 1) % 3];
      if (a.nearest.triangle == b.nearest.triangle) continue;
      const auto plane = between(a.nearest.triangle, b.nearest.triangle);
      if (!plane) continue;
      std::array<double, 3> side;
      double size = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        side[c] = (piece[c].at - plane->first).dot(plane->second);
        size = std::max(size, std::abs(side[c]));
      }
      // A corner on the plane belongs to both sides.
      for (double& s : side)
        if (std::abs(s) < 1e-3 * size) s = 0;
      const auto [low, high] = std::minmax_element(side.begin(), side.end());
      if (*low < 0 && *high > 0) return halves(piece, side, depth);
    }
    return middle(piece, depth);
  }
  double halves(const Piece& p, const std::array<double, 3>& side, int depth) {
    const auto crossing = [&](std::size_t i, std::size_t j) {
      const double t = side[i] / (side[i] - side[j]);
      return corner(p[i].at + t * (p[j].at - p[i].at));
    };
    // Rotated so that corner k is alone on its side, or on the plane with the others on opposite sides.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      if (side[k] == 0 && side[a] * side[b] < 0) {
        const Corner m = crossing(a, b);
        return both({p[k], p[a], m}, {p[k], m, p[b]}, depth);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      if (!(side[k] * side[a] < 0 && side[k] * side[b] < 0)) continue;
      const Corner m = crossing(k, a), n = crossing(k, b);
      const double tip = of({p[k], m, n}, depth);
      if (tip < 0) return tip;
      const double rest = both({m, p[a], p[b]}, {m, p[b], n}, depth);
      return rest < 0 ? rest : std::max(tip, rest);
    }
    return middle(p, depth);
  }
  double both(const Piece& a, const Piece& b, int depth) {
    const double first = of(a, depth);
    if (first < 0) return first;
    const double second = of(b, depth);
    return second < 0 ? second : std::max(first, second);
  }
  double middle(const Piece& p, int depth) {
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t c = 0; c < 3; ++c) {
      const double l = (p[(c + 1) % 3].at - p[c].at).squaredNorm();
      if (l > length) length = l, longest = c;
    }
    const Corner &a = p[longest], &b = p[(longest + 1) % 3], &o = p[(longest + 2) % 3];
    const Corner m = corner(0.5 * (a.at + b.at));
    return both({a, m, o}, {m, b, o}, depth);
  }

  const TriangleTree& tree_;
  std::span<const Vector3> positions_;
  std::span<const std::array<Index, 3>> triangles_;
  double tolerance_;
  int pieces_ = 0;
};

}  // namespace

MeshBound bounded_distance(std::span<const Vector3> positions,
                           std::span<const std::array<Index, 3>> triangles, const TriangleTree& tree,
                           std::span<const Vector3> other_positions,
                           std::span<const std::array<Index, 3>> others, double tolerance,
                           const CancelToken& cancel) {
  std::vector<double> bound(triangles.size(), -1.0);
  parallel_for(triangles.size(), triangles_per_task, [&](std::size_t begin, std::size_t end) {
    PieceBound pieces(tree, other_positions, others, tolerance);
    for (std::size_t t = begin; t < end && !cancel.cancelled(); ++t) {
      const auto& [a, b, c] = triangles[t];
      bound[t] = pieces.of({positions[a], positions[b], positions[c]});
    }
  });
  MeshBound out;
  double worst = 0;
  for (Index t = 0; t < bound.size(); ++t) {
    if (bound[t] < 0) {
      out.triangle = t;
      return out;
    }
    worst = std::max(worst, bound[t]);
  }
  out.bound = worst;
  return out;
}

}  // namespace hariko
