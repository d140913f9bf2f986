#include "core/drawing/section_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/drawing/facet_curves.hpp"
#include "core/drawing/plane_curves.hpp"
#include "core/geometry/curve_places.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

namespace {

constexpr double page_units = 1200;  ///< size of the surfaces on the page that sets the density of grids
constexpr std::size_t most_grid_triangles = 2'000'000;
constexpr double facet_noise = 1e-12, patch_noise = 1e-9;  ///< relative to the size
constexpr double coordinate_noise = 4e-15;                 ///< relative to the farthest coordinate
constexpr double same_place = 1e-7;   ///< distance of points that are one, relative to a grid edge
constexpr double same_tooth = 1e-5;   ///< difference of teeth that are one, relative to their length
constexpr double least_slope = 1e-6;  ///< sine of the angle between plane and surface where they touch
/// Share of the way to the middle of a patch, whose corners may be singular.
constexpr double corner_inset = 1e-7;
constexpr double circle_steps = 8;  ///< distance of points on a circle through three, mean segments
constexpr double typical_tooth = 0.06, longest_tooth = 0.15, tooth_step = 1.0 / 150;  ///< shares of the size

Eigen::AlignedBox3d box_of_surfaces(std::span<const DrawnSurface> surfaces) {
  Eigen::AlignedBox3d box;
  for (const DrawnSurface& drawn : surfaces) {
    const GridPattern pattern{drawn.surface.domain(), is_facets(drawn.surface) ? 1 : 2};
    std::vector<Vector3> positions(std::size_t(pattern.point_count())), normals(positions.size());
    for (Index patch = 0; patch < drawn.surface.patch_count(); ++patch) {
      drawn.surface.patches().evaluate_grid(std::span(&patch, 1), pattern, positions, normals);
      for (const Vector3& p : positions) box.extend(drawn.transform * (drawn.surface.origin() + p));
    }
  }
  return box;
}

/// Parallel view across the planes, for which the density of a grid is chosen.
DrawingView view_across(const Matrix3& axes, const Eigen::AlignedBox3d& box, double size) {
  DrawingView view;
  view.right = axes.col(0);
  view.up = axes.col(1);
  view.forward = -axes.col(2);
  view.eye = box.center() + size * axes.col(2);
  view.orthographic = true;
  view.focal = page_units / size;
  view.width = view.height = page_units;
  return view;
}

/// Tooth of a plane's curve at a place of a smooth surface.
Vector3 tooth_on_patch(const SurfaceGrid& grid, const SurfacePlace& place, const Vector3& across) {
  const Vector2 middle =
      grid.surface().domain() == Domain::square ? Vector2(0.5, 0.5) : Vector2(1.0 / 3, 1.0 / 3);
  const Vector2 parameter = place.parameter + corner_inset * (middle - place.parameter);
  const Vector3 normal = grid.evaluate(place.patch, parameter).normal;
  const Vector3 along = normal.cross(across), inward = normal - normal.dot(across) * across;
  const double sine = along.norm();
  if (!(sine > least_slope)) return Vector3::Zero();
  const double bend = grid.bending(place.patch, parameter, along / sine);
  const Vector3 tooth = -bend / (sine * sine) * inward;
  return tooth.allFinite() ? tooth : Vector3(Vector3::Zero());
}

/// Appends a point unless it repeats the last one, with the same tooth.
void append_point(SectionCurve& curve, const Vector3& point, const Vector3& tooth, double edge) {
  if (!curve.points.empty() && (curve.points.back() - point).norm() <= same_place * edge) {
    const double larger = std::max(curve.teeth.back().norm(), tooth.norm());
    if ((curve.teeth.back() - tooth).norm() <= same_tooth * larger) return;
  }
  curve.points.push_back(point);
  curve.teeth.push_back(tooth);
}

/// Point at a length along a polyline.
Vector3 point_at_length(const std::vector<Vector3>& points, const std::vector<double>& lengths, double at) {
  const auto after = std::upper_bound(lengths.begin(), lengths.end(), at);
  if (after == lengths.begin()) return points.front();
  if (after == lengths.end()) return points.back();
  const auto i = std::size_t(after - lengths.begin());
  const double share = (at - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
  return points[i - 1] + share * (points[i] - points[i - 1]);
}

/// Curvature vector, reversed, of the circle through three points; zero where they lie in a line.
Vector3 tooth_of_circle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u = a - b, w = c - b, normal = u.cross(w);
  const double square = normal.squaredNorm();
  if (!(square > 0)) return Vector3::Zero();
  // Centre of the circle relative to b.
  const Vector3 centre =
      (u.squaredNorm() * w.cross(normal) - w.squaredNorm() * u.cross(normal)) / (2 * square);
  const Vector3 tooth = -centre / centre.squaredNorm();
  return tooth.allFinite() ? tooth : Vector3(Vector3::Zero());
}

/// Teeth of a polyline on facets. The ends of an open one take the circle nearest to them.
void measure_polyline(SectionCurve& curve) {
  const std::vector<double> lengths = lengths_along(curve.points);
  const double whole = lengths.back(), step = circle_steps * whole / double(curve.points.size() - 1);
  curve.teeth.assign(curve.points.size(), Vector3::Zero());
  if (!(step > 0) || 2 * step >= whole) return;
  const auto at = [&](double length) {
    if (curve.closed) length -= whole * std::floor(length / whole);
    return point_at_length(curve.points, lengths, length);
  };
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double middle = curve.closed ? lengths[i] : std::clamp(lengths[i], step, whole - step);
    curve.teeth[i] = tooth_of_circle(at(middle - step), at(middle), at(middle + step));
  }
}

/// Rounding of a surface's positions across planes: how near to a plane they lie in it. Facets are as they
/// were given; patches were computed.
double position_noise(const Surface& surface, const Eigen::AlignedBox3d& box) {
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::max((is_facets(surface) ? facet_noise : patch_noise) * box.diagonal().norm(),
                  coordinate_noise * farthest);
}

std::vector<SectionCurve> curves_in_plane(const SurfaceGrid& grid, const GridMesh& mesh,
                                          const SectionPlanes& planes, int number, double noise,
                                          const CancelToken& cancel) {
  const Eigen::Hyperplane<double, 3> plane(planes.direction, -planes.offset(number));
  const bool facets = is_facets(grid.surface());
  std::vector<SectionCurve> out;
  for (const PlaceLine& line : plane_places(grid, mesh, plane, noise, cancel)) {
    SectionCurve curve;
    curve.plane = number;
    double edge = 0;
    for (const SurfacePlace& place : line) {
      edge = std::max(edge, place.edge);
      append_point(curve, place.position,
                   facets ? Vector3(Vector3::Zero()) : tooth_on_patch(grid, place, planes.direction), edge);
    }
    if (curve.points.size() < 2) continue;
    curve.closed = is_closed(line);
    if (curve.closed) curve.points.back() = curve.points.front();
    if (facets) measure_polyline(curve);
    out.push_back(std::move(curve));
  }
  return out;
}

/// Fills in the typical and the greatest curvature.
void measure_teeth(SectionSet& set) {
  std::vector<std::pair<double, double>> weighted;  // curvature and length
  double whole = 0;
  for (const SectionCurve& curve : set.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      double length = 0;
      if (i > 0) length += 0.5 * (curve.points[i] - curve.points[i - 1]).norm();
      if (i + 1 < curve.points.size()) length += 0.5 * (curve.points[i + 1] - curve.points[i]).norm();
      weighted.emplace_back(curve.teeth[i].norm(), length);
      whole += length;
      set.greatest = std::max(set.greatest, weighted.back().first);
    }
  std::sort(weighted.begin(), weighted.end());
  double passed = 0;
  for (const auto& [curvature, length] : weighted) {
    set.typical = curvature;
    if ((passed += length) >= 0.95 * whole) break;
  }
}

Result<Done> check_planes(const SectionPlanes& planes) {
  const bool fine = planes.direction.allFinite() && std::abs(planes.direction.norm() - 1) < 1e-9 &&
                    std::isfinite(planes.first) && planes.count >= 1 && planes.count <= SectionPlanes::most &&
                    (planes.count == 1 || (std::isfinite(planes.spacing) && planes.spacing > 0));
  if (fine) return Done{};
  return make_error(e_sections_planes, "These section planes cannot be made.",
                    "Choose 1 to 200 planes, a spacing above zero and a direction that is not zero.");
}

}  // namespace

SectionPlanes spread_planes(const Vector3& direction, int count, const Eigen::AlignedBox3d& box) {
  HARIKO_ASSERT(!box.isEmpty() && count >= 1, "planes are spread over a box");
  SectionPlanes out;
  out.direction = direction.stableNormalized();
  out.count = count;
  const double half = 0.5 * out.direction.cwiseAbs().dot(box.sizes()),
               middle = out.direction.dot(box.center());
  out.spacing = half > 0 ? 2 * half / count : 1;
  out.first = middle - 0.5 * out.spacing * (count - 1);
  return out;
}

Matrix3 section_axes(const Vector3& direction) {
  constexpr double level = 1 - 1e-9;
  const bool flat = std::abs(direction.z()) > level;
  const Vector3 up = flat ? Vector3::UnitY() : Vector3::UnitZ();
  Matrix3 out;
  out.col(2) = direction;
  out.col(0) = up.cross(direction).normalized();
  out.col(1) = direction.cross(out.col(0));
  return out;
}

Result<SectionSet> section_set(std::span<const DrawnSurface> surfaces, const SectionPlanes& planes,
                               const CancelToken& cancel, const Progress& progress) {
  if (const auto fine = check_planes(planes); !fine.ok()) return fine.error();
  progress.report(0);
  SectionSet out;
  out.planes = planes;
  const Eigen::AlignedBox3d box = box_of_surfaces(surfaces);
  if (!box.isEmpty()) out.size = box.diagonal().norm();
  const DrawingView view = view_across(section_axes(planes.direction), box, out.size);
  for (std::size_t s = 0; s < surfaces.size() && out.size > 0; ++s) {
    if (surfaces[s].surface.patch_count() == 0) continue;
    if (cancel.cancelled()) break;
    const SurfaceGrid grid(surfaces[s], view, most_grid_triangles / surfaces.size());
    const GridMesh mesh(grid);
    const double noise = position_noise(surfaces[s].surface, box);
    std::vector<std::vector<SectionCurve>> found(std::size_t(planes.count));
    parallel_for(found.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end && !cancel.cancelled(); ++k)
        found[k] = curves_in_plane(grid, mesh, planes, int(k), noise, cancel);
    });
    for (std::vector<SectionCurve>& own : found)
      for (SectionCurve& curve : own) {
        curve.surface = s;
        out.curves.push_back(std::move(curve));
      }
    progress.report(double(s + 1) / double(surfaces.size()));
  }
  if (cancel.cancelled()) return make_error(e_cancelled, "The sections were cancelled.");
  if (out.curves.empty())
    return make_error(e_sections_empty, "None of the section planes meets a visible surface.",
                      "Move the planes, or spread them over the model.");
  measure_teeth(out);
  return out;
}

double tooth_length(const SectionSet& set, double scale) {
  if (!(set.typical > 0)) return set.greatest > 0 ? scale * longest_tooth * set.size / set.greatest : 0;
  return scale * set.size * std::min(typical_tooth / set.typical, longest_tooth / set.greatest);
}

CombShape comb_shape(const SectionCurve& curve, double size, double length) {
  CombShape out;
  const std::vector<double> lengths = lengths_along(curve.points);
  const double whole = lengths.back();
  const int steps = std::max(1, int(std::lround(whole / (tooth_step * size))));
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    out.tips.push_back(curve.points[i] + length * curve.teeth[i]);
    if (i == 0) continue;
    // Teeth whose lengths along the curve lie behind the last point, up to this one.
    const double before = lengths[i - 1], after = lengths[i];
    if (!(after > before)) continue;
    for (int k = int(std::ceil(before / whole * steps)); k <= steps; ++k) {
      const double at = whole * k / steps;
      if (at < before || (at >= after && i + 1 < curve.points.size()) || at > after * (1 + 1e-12)) break;
      const double share = std::clamp((at - before) / (after - before), 0.0, 1.0);
      const Vector3 foot = curve.points[i - 1] + share * (curve.points[i] - curve.points[i - 1]);
      const Vector3 tooth = curve.teeth[i - 1] + share * (curve.teeth[i] - curve.teeth[i - 1]);
      out.teeth.push_back({foot, Vector3(foot + length * tooth)});
    }
  }
  return out;
}

}  // namespace hariko
