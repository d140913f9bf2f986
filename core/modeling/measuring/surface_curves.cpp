#include "core/modeling/measuring/surface_curves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/analysis/quadrature.hpp"

namespace hariko {

namespace {

/// Nodes and weights of the Gauss rule of five points on 0 .. 1.
constexpr std::array<std::pair<double, double>, 5> gauss_on_unit{{{0.0469100770306680, 0.1184634425280945},
                                                                  {0.2307653449471585, 0.2393143352496833},
                                                                  {0.5, 0.2844444444444444},
                                                                  {0.7692346550528415, 0.2393143352496833},
                                                                  {0.9530899229693320, 0.1184634425280945}}};
constexpr int curve_pieces = 4;
constexpr int area_points = 8;

/// Calls visit(source, curve) for the curve of each seam and of each boundary side.
template <class Visit>
void visit_curves(const Surface& surface, Visit&& visit) {
  for (const Seam& seam : surface.seams())
    visit(seam.source, SideCurve{seam.first, seam.first_begin, seam.first_end});
  const auto& sides = surface.boundary_sides();
  for (std::size_t i = 0; i < sides.size(); ++i)
    visit(surface.boundary_sources()[i], SideCurve{sides[i], 0, 1});
}

template <class Value>
std::vector<Value> with_key(const std::vector<std::pair<std::uint64_t, Value>>& sorted, std::uint64_t key) {
  auto at = std::lower_bound(sorted.begin(), sorted.end(), key,
                             [](const auto& entry, std::uint64_t k) { return entry.first < k; });
  std::vector<Value> out;
  for (; at != sorted.end() && at->first == key; ++at) out.push_back(at->second);
  return out;
}

}  // namespace

Vector2 curve_parameter(const Surface& surface, const SideCurve& curve, double x) {
  return side_parameter(surface.domain(), curve.side.side, curve.begin + x * (curve.end - curve.begin));
}

Vector3 curve_point(const Surface& surface, const SideCurve& curve, double x) {
  return surface.patches()
      .evaluate(curve.side.patch, curve_parameter(surface, curve, x), Order::first)
      .position;
}

double curve_length(const Surface& surface, const SideCurve& curve) {
  const Vector2 along = curve_parameter(surface, curve, 1) - curve_parameter(surface, curve, 0);
  double length = 0;
  for (int piece = 0; piece < curve_pieces; ++piece)
    for (const auto& [node, weight] : gauss_on_unit) {
      const double x = (piece + node) / curve_pieces;
      const PatchPoint at =
          surface.patches().evaluate(curve.side.patch, curve_parameter(surface, curve, x), Order::first);
      length += weight / curve_pieces * (at.ds * along.x() + at.dt * along.y()).norm();
    }
  return length;
}

double patch_area(const Surface& surface, std::span<const Index> patches) {
  if (patches.empty()) return 0;
  const DomainRule rule = gauss_rule(surface.domain(), area_points);
  std::vector<PatchPoint> points(patches.size() * rule.points.size());
  surface.patches().batch(rule.points)->evaluate(patches, Order::first, points);
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    area += rule.weights[i % rule.weights.size()] * points[i].ds.cross(points[i].dt).norm();
  return area;
}

SurfaceElements::SurfaceElements(const Surface& surface) {
  visit_curves(surface, [&](const Element& source, const SideCurve& curve) {
    if (source.kind == Element::Kind::edge) curves_.emplace_back(source.id, curve);
  });
  for (Index p = 0; p < surface.patch_count(); ++p) {
    const Element& source = surface.provenance()[p].element;
    if (source.kind == Element::Kind::face) patches_.emplace_back(source.id, p);
  }
  const auto by_key = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::stable_sort(curves_.begin(), curves_.end(), by_key);
  std::stable_sort(patches_.begin(), patches_.end(), by_key);
}

std::vector<SideCurve> SurfaceElements::curves_over(EdgeId edge) const {
  return with_key(curves_, edge.packed());
}

std::vector<Index> SurfaceElements::patches_of(FaceId face) const {
  return with_key(patches_, face.value);
}

std::vector<SideCurve> curves_over(const Surface& surface, EdgeId edge) {
  std::vector<SideCurve> out;
  const Element wanted = element_of(edge);
  visit_curves(surface, [&](const Element& source, const SideCurve& curve) {
    if (source == wanted) out.push_back(curve);
  });
  return out;
}

}  // namespace hariko
