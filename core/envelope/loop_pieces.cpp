#include "core/envelope/loop_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

namespace hariko {

namespace {

constexpr std::size_t largest_exact = 10;
constexpr double degrees = 180 / std::numbers::pi;

Vector3 newell(std::span<const Vector3> loop) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += (loop[i] - loop[0]).cross(loop[i + 1] - loop[0]);
  return sum.stableNormalized();
}

double perimeter_of(std::span<const Vector3> loop) {
  double out = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) out += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return out;
}

class Partition {
 public:
  Partition(std::span<const Vector3> loop, const Vector3& outside,
            const std::function<bool(Index, Index)>& allowed)
      : loop_(loop), outside_(outside), allowed_(allowed), perimeter_(perimeter_of(loop)) {}

  std::vector<std::vector<Index>> run() {
    std::vector<Index> all(loop_.size());
    for (Index i = 0; i < all.size(); ++i) all[i] = i;
    cut(all);
    return std::move(out_);
  }

 private:
  struct Best {
    double cost;
    Index i = 0, j = 0;  ///< the diagonal to cut along; equal where the piece stays whole
  };

  std::vector<Vector3> places(const std::vector<Index>& piece) const {
    std::vector<Vector3> out;
    for (const Index i : piece) out.push_back(loop_[i]);
    return out;
  }
  double whole(const std::vector<Index>& piece) const {
    return std::round(piece_cost(places(piece), outside_) * 1e6) / 1e6;
  }
  double diagonal(Index i, Index j) const {
    return std::round((0.15 + 0.3 * (loop_[i] - loop_[j]).norm() / perimeter_) * 1e6) / 1e6;
  }
  static std::vector<Index> between(const std::vector<Index>& piece, std::size_t i, std::size_t j) {
    std::vector<Index> out(piece.begin() + std::ptrdiff_t(i), piece.begin() + std::ptrdiff_t(j) + 1);
    return out;
  }
  static std::vector<Index> around(const std::vector<Index>& piece, std::size_t i, std::size_t j) {
    std::vector<Index> out(piece.begin(), piece.begin() + std::ptrdiff_t(i) + 1);
    out.insert(out.end(), piece.begin() + std::ptrdiff_t(j), piece.end());
    return out;
  }

  template <class Each>
  void for_diagonals(const std::vector<Index>& piece, const Each& each) const {
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (std::size_t j = i + 2; j < piece.size(); ++j)
        if (!(i == 0 && j + 1 == piece.size()) && allowed_(piece[i], piece[j])) each(i, j);
  }

  const Best& best(const std::vector<Index>& piece) {
    std::uint32_t mask = 0;
    for (const Index i : piece) mask |= 1U << i;
    if (const auto known = known_.find(mask); known != known_.end()) return known->second;
    Best out{whole(piece)};
    for_diagonals(piece, [&](std::size_t i, std::size_t j) {
      const double cut = diagonal(piece[i], piece[j]);
      if (cut >= out.cost) return;
      const double cost = cut + best(between(piece, i, j)).cost + best(around(piece, i, j)).cost;
      if (cost < out.cost - 1e-9) out = {cost, Index(i), Index(j)};
    });
    return known_.emplace(mask, out).first->second;
  }

  void cut(const std::vector<Index>& piece) {
    Best found{whole(piece)};
    if (loop_.size() <= largest_exact) {
      found = best(piece);
    } else {
      for_diagonals(piece, [&](std::size_t i, std::size_t j) {
        const double cost =
            diagonal(piece[i], piece[j]) + whole(between(piece, i, j)) + whole(around(piece, i, j));
        if (cost < found.cost - 1e-9) found = {cost, Index(i), Index(j)};
      });
    }
    if (found.i == found.j) {
      out_.push_back(piece);
      return;
    }
    cut(between(piece, found.i, found.j));
    cut(around(piece, found.i, found.j));
  }

  std::span<const Vector3> loop_;
  Vector3 outside_;
  const std::function<bool(Index, Index)>& allowed_;
  double perimeter_;
  std::unordered_map<std::uint32_t, Best> known_;
  std::vector<std::vector<Index>> out_;
};

}  // namespace

double piece_cost(std::span<const Vector3> loop, const Vector3& outside) {
  const std::size_t n = loop.size();
  Vector3 normal = newell(loop);
  if (normal.dot(outside) < -0.3)
    normal = outside;
  else if (normal.dot(outside) < 0.3)
    normal = (normal + outside).stableNormalized();
  double cost = n == 3 ? 0.7 : n == 4 ? 0 : n == 5 ? 0.6 : 0.9 + 0.1 * (double(n) - 6);
  double least = 360, most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto flat = [&](const Vector3& v) -> Vector3 { return v - v.dot(normal) * normal; };
    const Vector3 next = flat(loop[(i + 1) % n] - loop[i]), before = flat(loop[(i + n - 1) % n] - loop[i]);
    double angle = std::atan2(next.cross(before).dot(normal), next.dot(before)) * degrees;
    if (angle < 0) angle += 360;
    least = std::min(least, angle);
    most = std::max(most, angle);
    if (angle > 162) cost += 6 + (angle - 162) / 30;
    if (angle > 340 || angle < 6) cost += 20;
  }
  return cost + std::max(0.0, 1 - least / 50) + std::max(0.0, (std::min(most, 162.0) - 125) / 60);
}

std::vector<std::vector<Index>> cheapest_pieces(std::span<const Vector3> loop, const Vector3& outside,
                                                const std::function<bool(Index, Index)>& allowed) {
  return Partition(loop, outside, allowed).run();
}

}  // namespace hariko
