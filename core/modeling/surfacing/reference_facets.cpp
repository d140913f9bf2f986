#include "core/modeling/surfacing/reference_facets.hpp"

#include <algorithm>
#include <utility>

#include "core/base/assert.hpp"
#include "core/base/index_list.hpp"

namespace hariko {

namespace {

/// Cosine between a facet's normal and the way to a point below which the point lies beside the facet, not
/// over it.
constexpr double beside_a_facet = 0.9;
/// Share of the references' size within which a point lies on them.
constexpr double on_the_facets = 1e-13;
/// Share of a side's length within which a foot lies on the side.
constexpr double on_a_side = 1e-9;

/// Side of a triangle, by its ends, the smaller one first.
struct FacetSide {
  std::array<Index, 2> ends;
  Index triangle;
  std::uint8_t number;
};

FacetSide facet_side(const std::array<Index, 3>& corners, Index triangle, std::uint8_t number) {
  const Index a = corners[number], b = corners[(number + 1U) % 3U];
  return {{std::min(a, b), std::max(a, b)}, triangle, number};
}

/// Numbers of the positions, with equal positions of a part under one number, so that facets without corners
/// in common meet where their corners are equal.
std::vector<Index> numbers_of_places(std::span<const Vector3> positions) {
  std::vector<Index> order = ascending_indices(positions.size()), out(positions.size());
  const auto key = [&](Index i) { return std::array{positions[i].x(), positions[i].y(), positions[i].z()}; };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    out[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? out[order[i - 1]] : order[i];
  return out;
}

}  // namespace

struct ReferenceFacets::Gathered {
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::uint8_t> border_sides;
  std::vector<bool> border_points;

  void add(const FacetPart& part, const Vector3& origin, const Similarity& transform);
  void mark_borders(const FacetPart& part, std::size_t first_position, std::size_t first_triangle);
};

void ReferenceFacets::Gathered::add(const FacetPart& part, const Vector3& origin,
                                    const Similarity& transform) {
  const std::size_t first_position = positions.size(), first_triangle = triangles.size();
  const Similarity back = transform.inverse();
  const Matrix3 turn =
      (back.scale * part.transform.scale) * (back.rotation * part.transform.rotation).toRotationMatrix();
  const Vector3 shift = back.apply(part.transform.apply(part.origin)) - origin;
  for (const Vector3& p : part.positions) positions.push_back(turn * p + shift);
  const auto offset = static_cast<Index>(first_position);
  for (const auto& t : part.triangles) triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  border_sides.resize(triangles.size());
  border_points.resize(positions.size());
  mark_borders(part, first_position, first_triangle);
}

/// Sides of one triangle only are the border.
void ReferenceFacets::Gathered::mark_borders(const FacetPart& part, std::size_t first_position,
                                             std::size_t first_triangle) {
  const std::vector<Index> places = numbers_of_places(part.positions);
  std::vector<FacetSide> sides;
  sides.reserve(3 * part.triangles.size());
  for (Index t = 0; t < part.triangles.size(); ++t) {
    const auto& corners = part.triangles[t];
    const std::array<Index, 3> welded{places[corners[0]], places[corners[1]], places[corners[2]]};
    for (std::uint8_t k = 0; k < 3; ++k) sides.push_back(facet_side(welded, t, k));
  }
  std::sort(sides.begin(), sides.end(), [](const FacetSide& a, const FacetSide& b) {
    return std::pair(a.ends, 3 * a.triangle + a.number) < std::pair(b.ends, 3 * b.triangle + b.number);
  });
  std::vector<bool> border(part.positions.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && sides[i - 1].ends == sides[i].ends) continue;
    if (i + 1 < sides.size() && sides[i + 1].ends == sides[i].ends) continue;
    border_sides[first_triangle + sides[i].triangle] |= static_cast<std::uint8_t>(1U << sides[i].number);
    for (const Index end : sides[i].ends) border[end] = true;
  }
  for (std::size_t i = 0; i < places.size(); ++i) border_points[first_position + i] = border[places[i]];
}

ReferenceFacets::ReferenceFacets(std::span<const FacetPart> parts, const Vector3& origin,
                                 const Similarity& transform)
    : ReferenceFacets([&] {
        Gathered gathered;
        for (const FacetPart& part : parts) gathered.add(part, origin, transform);
        return gathered;
      }()) {}

ReferenceFacets::ReferenceFacets(Gathered gathered)
    : positions_(std::move(gathered.positions)),
      triangles_(std::move(gathered.triangles)),
      border_sides_(std::move(gathered.border_sides)),
      border_points_(std::move(gathered.border_points)),
      tree_(positions_, triangles_) {
  HARIKO_ASSERT(!triangles_.empty(), "a reference has triangles");
}

ReferenceFoot ReferenceFacets::foot(const Vector3& point) const {
  const Index nearest = tree_.nearest(point).triangle;
  const ClosedTriangle& triangle = tree_.triangle(nearest);
  ReferenceFoot out;
  out.position = triangle.nearest_point(point);
  const Vector3 way = point - out.position;
  out.distance = way.norm();
  out.direction = triangle.normal();
  if (!(out.distance > on_the_facets * tree_.size())) {
    out.position = point;
    return out;
  }
  out.direction = way / out.distance;
  out.is_beyond =
      std::abs(out.direction.dot(triangle.normal())) < beside_a_facet && is_on_border(nearest, out.position);
  return out;
}

bool ReferenceFacets::is_on_border(Index triangle, const Vector3& foot) const {
  const auto& corners = triangles_[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 &a = positions_[corners[k]], &b = positions_[corners[(k + 1) % 3]];
    const double near = on_a_side * on_a_side * (b - a).squaredNorm();
    if ((border_sides_[triangle] >> k & 1U) && squared_distance_to_segment(foot, a, b) <= near) return true;
    if (border_points_[corners[k]] && (foot - a).squaredNorm() <= near) return true;
  }
  return false;
}

}  // namespace hariko
