#include "render/surface_lines.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

using Point = std::array<float, 3>;

Vector3 wide(const Point& p) {
  return {double(p[0]), double(p[1]), double(p[2])};
}

/// Intersection of the plane with an edge. Its ends are ordered, so that both triangles of the edge get the
/// same bits.
Point cut(const Point& a, double da, const Point& b, double db) {
  if (std::pair(a, da) > std::pair(b, db)) return cut(b, db, a, da);
  const double x = da / (da - db);
  Point out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = static_cast<float>(double(a[i]) + x * (double(b[i]) - double(a[i])));
  return out;
}

}  // namespace

std::shared_ptr<const EdgeMarks> edge_marks(const DisplayMesh& mesh, std::span<const Continuity> classes) {
  auto marks = std::make_shared<EdgeMarks>();
  for (const DisplayCurve& curve : mesh.curves()->curves) {
    if (curve.seam == no_index || curve.source.kind != Element::Kind::edge) continue;
    HARIKO_ASSERT(curve.seam < classes.size(), "one class a seam");
    EdgeMarks::Class& to = marks->classes[std::size_t(classes[curve.seam])];
    const auto& segments = mesh.curves()->segments[std::size_t(curve.kind)];
    ++to.curves;
    double length = 0;
    for (std::size_t i = 0; i < curve.segment_count; ++i) {
      const CurveSegment& segment = segments[curve.first_segment + i];
      const double begin = length;
      length +=
          (wide(mesh.vertex(segment.vertices[2]).position) - wide(mesh.vertex(segment.vertices[1]).position))
              .norm();
      to.segments.push_back(segment);
      to.lengths.push_back({static_cast<float>(begin), static_cast<float>(length)});
    }
  }
  return marks;
}

std::shared_ptr<const FacetLines> facet_lines(const Vector3& origin, std::span<const Vector3> positions,
                                              std::span<const std::array<Index, 3>> triangles, double depth) {
  auto lines = std::make_shared<FacetLines>();
  lines->origin = origin;
  lines->depth = depth;
  lines->points.reserve(positions.size());
  for (const Vector3& p : positions)
    lines->points.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  lines->edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      lines->edges.push_back({std::min(from, to), std::max(from, to)});
  std::sort(lines->edges.begin(), lines->edges.end());
  lines->edges.erase(std::unique(lines->edges.begin(), lines->edges.end()), lines->edges.end());
  return lines;
}

std::shared_ptr<const CombLines> comb_lines(const CurvatureCombs& combs, const Vector3& origin) {
  auto lines = std::make_shared<CombLines>();
  lines->origin = origin;
  lines->density = combs.density;
  lines->typical = typical_curvature(combs);
  for (const Vector3& tooth : combs.teeth) lines->greatest = std::max(lines->greatest, tooth.norm());
  lines->teeth.resize(combs.teeth.size());
  for (std::size_t i = 0; i < combs.teeth.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      lines->teeth[i][std::size_t(k)] = static_cast<float>(combs.points[i][k]);
      lines->teeth[i][std::size_t(k) + 3] = static_cast<float>(combs.teeth[i][k]);
    }
  return lines;
}

std::vector<std::array<Point, 2>> section_curve(const DisplayMesh& mesh, const LocalPlane& plane) {
  std::vector<std::array<Point, 2>> pieces;
  if (mesh.patch_count() == 0) return pieces;
  const auto triangles = mesh.pattern().triangles();
  const std::size_t n = mesh.vertices_per_patch();
  std::vector<double> distances(n);
  for (const auto& chunk : mesh.chunks()) {
    const Vector3 half = chunk->box.sizes() / 2;
    const double reach = plane.normal.cwiseAbs().dot(half);
    if (std::abs(plane.normal.dot(chunk->box.center()) - plane.offset) > reach * (1 + 1e-9)) continue;
    for (std::size_t base = 0; base < chunk->vertices.size(); base += n) {
      bool above = false, below = false;
      for (std::size_t i = 0; i < n; ++i) {
        distances[i] = plane.normal.dot(wide(chunk->vertices[base + i].position)) - plane.offset;
        (distances[i] >= 0 ? above : below) = true;
      }
      if (!above || !below) continue;
      for (const auto& triangle : triangles) {
        std::array<Point, 2> piece{};
        std::size_t found = 0;
        for (std::size_t k = 0; k < 3 && found < 2; ++k) {
          const auto a = static_cast<std::size_t>(triangle[k]),
                     b = static_cast<std::size_t>(triangle[(k + 1) % 3]);
          if ((distances[a] >= 0) == (distances[b] >= 0)) continue;
          piece[found++] = cut(chunk->vertices[base + a].position, distances[a],
                               chunk->vertices[base + b].position, distances[b]);
        }
        if (found == 2 && piece[0] != piece[1]) pieces.push_back(piece);
      }
    }
  }
  return pieces;
}

}  // namespace hariko
