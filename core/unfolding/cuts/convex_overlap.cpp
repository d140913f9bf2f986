#include "core/unfolding/cuts/convex_overlap.hpp"

#include <cmath>
#include <limits>

#include "core/geometry/expansion.hpp"

namespace hariko {

namespace {

/// Whether q penetrates the line from a to b by at most the tolerance, in exact arithmetic: cross <= 0, or
/// cross^2 <= tolerance^2 |b - a|^2.
bool beyond_exactly(const Vector2& a, const Vector2& b, const Vector2& q, double tolerance) {
  const Expansion ex = Expansion::difference(b.x(), a.x()), ey = Expansion::difference(b.y(), a.y());
  const Expansion cross = ex * Expansion::difference(q.y(), a.y()) - ey * Expansion::difference(q.x(), a.x());
  if (cross.sign() <= 0) return true;
  const Expansion allowed = Expansion::product(tolerance, tolerance) * (ex * ex + ey * ey);
  return (cross * cross - allowed).sign() <= 0;
}

/// Whether the whole polygon lies beyond the line from a to b (on its right), up to the tolerance.
bool separates(const Vector2& a, const Vector2& b, std::span<const Vector2> polygon, double tolerance) {
  // Each of the four differences and the products, their difference and the root have a relative error of
  // half an ulp; 4 ulp of the products bound them all.
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  const double ex = b.x() - a.x(), ey = b.y() - a.y();
  const double allowed = tolerance * std::sqrt(ex * ex + ey * ey), slack = 4 * ulp * allowed;
  for (const Vector2& q : polygon) {
    const double left = ex * (q.y() - a.y()), right = ey * (q.x() - a.x());
    const double cross = left - right, error = 4 * ulp * (std::abs(left) + std::abs(right)) + slack;
    if (cross + error <= allowed) continue;
    if (cross - error > allowed || !beyond_exactly(a, b, q, tolerance)) return false;
  }
  return true;
}

bool some_edge_separates(std::span<const Vector2> first, std::span<const Vector2> second, double tolerance) {
  for (std::size_t k = 0; k < first.size(); ++k)
    if (separates(first[k], first[k + 1 == first.size() ? 0 : k + 1], second, tolerance)) return true;
  return false;
}

}  // namespace

bool overlaps(std::span<const Vector2> first, std::span<const Vector2> second, double tolerance) {
  return !some_edge_separates(first, second, tolerance) && !some_edge_separates(second, first, tolerance);
}

}  // namespace hariko
