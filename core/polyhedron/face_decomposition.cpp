#include "core/polyhedron/face_decomposition.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/base/index_list.hpp"
#include "core/geometry/polygon.hpp"

namespace hariko {
namespace {

/// Projection of the corners along the mean normal, scaled to an extent of about 1; where there is no mean
/// normal, along the axis of least extent.
std::vector<Vector2> in_mean_plane(std::span<const Vector3> corners) {
  Vector3 low = Vector3::Zero(), high = Vector3::Zero();
  for (const Vector3& p : corners) {
    low = low.cwiseMin(p - corners[0]);
    high = high.cwiseMax(p - corners[0]);
  }
  const double extent = (high - low).maxCoeff();
  const double scale = extent > 0 && std::isfinite(extent) ? 1 / extent : 1;
  std::vector<Vector3> scaled;
  for (const Vector3& p : corners) scaled.push_back(scale * (p - corners[0]));
  Vector3 normal = newell_normal(scaled);
  if (!(normal.norm() > 1e-12)) {
    int thin = 0;
    (high - low).minCoeff(&thin);
    normal = Vector3::Unit(thin);
  }
  normal.normalize();
  return flattened(scaled, Vector3::Zero(), normal);
}

class EarClipper {
 public:
  EarClipper(std::span<const Vector3> corners, const MayJoin& may_join)
      : points_(in_mean_plane(corners)), may_join_(may_join), ring_(ascending_indices(corners.size())) {
    ears_.resize(ring_.size());
    for (std::size_t i = 0; i < ring_.size(); ++i) judge(i);
  }

  std::optional<std::vector<std::array<Index, 3>>> clip() {
    std::vector<std::array<Index, 3>> out;
    while (ring_.size() > 3) {
      const auto best = std::max_element(ears_.begin(), ears_.end());
      if (!best->allowed) return std::nullopt;
      const auto i = static_cast<std::size_t>(best - ears_.begin());
      out.push_back({ring_[before(i)], ring_[i], ring_[after(i)]});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
      ears_.erase(best);
      judge(i % ring_.size());
      judge((i + ring_.size() - 1) % ring_.size());
      if (ring_.size() == 4)  // this cut also decides the last triangle
        for (std::size_t k = 0; k < 4; ++k) judge(k);
    }
    out.push_back({ring_[0], ring_[1], ring_[2]});
    return out;
  }

 private:
  /// Quality of an ear, in order of importance: the cut is allowed, no other corner lies inside, the shape is
  /// good.
  struct Ear {
    bool allowed = false, clear = false;
    double quality = 0;
    friend auto operator<=>(const Ear&, const Ear&) = default;
  };

  std::size_t after(std::size_t i) const { return i + 1 == ring_.size() ? 0 : i + 1; }
  std::size_t before(std::size_t i) const { return i == 0 ? ring_.size() - 1 : i - 1; }

  double quality(Index a, Index b, Index c) const {
    const Vector2 &p = points_[a], &q = points_[b], &r = points_[c];
    const double longest = std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
    return longest > 0 ? cross(q - p, r - q) / longest : 0;
  }

  /// Whether no other corner lies in the closed triangle, except at the position of one of its corners.
  bool is_clear(std::size_t i) const {
    const Vector2 &a = points_[ring_[before(i)]], &b = points_[ring_[i]], &c = points_[ring_[after(i)]];
    const double slack = -1e-14;
    for (const Index k : ring_) {
      const Vector2& p = points_[k];
      if (p == a || p == b || p == c) continue;
      if (cross(b - a, p - a) >= slack && cross(c - b, p - b) >= slack && cross(a - c, p - c) >= slack)
        return false;
    }
    return true;
  }

  void judge(std::size_t i) {
    const Index a = ring_[before(i)], b = ring_[i], c = ring_[after(i)];
    Ear& ear = ears_[i];
    ear.allowed = ring_.size() == 3 || may_join_(a, c);
    ear.quality = quality(a, b, c);
    if (ring_.size() == 4) ear.quality = std::min(ear.quality, quality(c, ring_[after(after(i))], a));
    ear.clear = ear.allowed && ear.quality > 0 && is_clear(i);
  }

  std::vector<Vector2> points_;
  const MayJoin& may_join_;
  std::vector<Index> ring_;
  std::vector<Ear> ears_;
};

/// Union of two pieces that share a side, which they run through in opposite directions.
std::vector<Index> joined(const std::vector<Index>& p, const std::vector<Index>& q, Index a, Index b) {
  // p holds a -> b, q holds b -> a: p from b round to a, then q from after a round to before b.
  std::vector<Index> out;
  const auto at = [](const std::vector<Index>& piece, Index corner) {
    return static_cast<std::size_t>(std::find(piece.begin(), piece.end(), corner) - piece.begin());
  };
  const std::size_t start_p = at(p, b), start_q = at(q, a);
  for (std::size_t i = 0; i < p.size(); ++i) out.push_back(p[(start_p + i) % p.size()]);
  for (std::size_t i = 1; i + 1 < q.size(); ++i) out.push_back(q[(start_q + i) % q.size()]);
  // Starts at the lowest corner.
  std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
  return out;
}

bool is_convex(std::span<const Vector3> corners, const std::vector<Index>& piece) {
  std::vector<Vector3> own;
  for (const Index i : piece) own.push_back(corners[i]);
  return classify_face(own) == FaceShape::convex;
}

}  // namespace

std::optional<std::vector<std::array<Index, 3>>> triangles_of(std::span<const Vector3> corners,
                                                              const MayJoin& may_join) {
  HARIKO_ASSERT(corners.size() >= 3, "a polygon has at least three corners");
  if (corners.size() > largest_cut_polygon) return std::nullopt;
  return EarClipper(corners, may_join).clip();
}

std::vector<std::vector<Index>> joined_to_convex(std::span<const Vector3> corners,
                                                 std::span<const std::array<Index, 3>> triangles) {
  std::vector<std::vector<Index>> pieces;
  struct Diagonal {
    Index a, b;
    double length;
  };
  std::vector<Diagonal> diagonals;
  const auto count = static_cast<Index>(corners.size());
  for (const auto& triangle : triangles) {
    std::vector<Index> piece(triangle.begin(), triangle.end());
    std::rotate(piece.begin(), std::min_element(piece.begin(), piece.end()), piece.end());
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = piece[i], b = piece[(i + 1) % 3];
      if (a < b && b - a != 1 && b - a != count - 1)
        diagonals.push_back({a, b, (corners[b] - corners[a]).norm()});
    }
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(diagonals.begin(), diagonals.end(),
                   [](const Diagonal& x, const Diagonal& y) { return x.length > y.length; });
  const auto holder = [&](Index a, Index b) {  // the piece with the side a -> b
    return std::find_if(pieces.begin(), pieces.end(), [&](const std::vector<Index>& piece) {
      for (std::size_t i = 0; i < piece.size(); ++i)
        if (piece[i] == a && piece[(i + 1) % piece.size()] == b) return true;
      return false;
    });
  };
  for (const Diagonal& diagonal : diagonals) {
    const auto p = holder(diagonal.a, diagonal.b), q = holder(diagonal.b, diagonal.a);
    std::vector<Index> whole = joined(*p, *q, diagonal.a, diagonal.b);
    if (!is_convex(corners, whole)) continue;
    *p = std::move(whole);
    pieces.erase(q);
  }
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

std::optional<std::vector<std::vector<Index>>> convex_pieces(std::span<const Vector3> corners,
                                                             const MayJoin& may_join) {
  const FaceShape shape = classify_face(corners);
  if (shape == FaceShape::self_crossing) return std::nullopt;
  if (shape == FaceShape::convex) return std::vector<std::vector<Index>>{ascending_indices(corners.size())};
  const auto triangles = triangles_of(corners, may_join);
  if (!triangles) return std::nullopt;
  return joined_to_convex(corners, *triangles);
}

}  // namespace hariko
