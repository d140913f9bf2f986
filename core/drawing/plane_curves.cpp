#include "core/drawing/plane_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "core/drawing/facet_curves.hpp"

namespace hariko {

namespace {

/// Part of a curve in one triangle, between the two edges at the corner that is alone on its side of the
/// plane. It has two ends: end 2 k of segment k is where the triangle's border, run through from corner to
/// corner, goes below the plane, end 2 k + 1 where it comes back.
struct PlaneSegment {
  std::size_t triangle;
  std::uint8_t alone;  ///< corner
  bool above;          ///< whether that corner is above
};

/// Crossing of a plane with an edge of the mesh.
struct PlaneCrossing {
  double fraction = 0;  ///< from the edge's sample with the lower number to the other
  Vector3 position = Vector3::Zero();
  std::size_t point = 0;  ///< number of the point; crossings at the same sample have the same one
};

/// Section of a mesh by one plane.
class PlaneSection {
 public:
  PlaneSection(const SurfaceGrid& grid, const GridMesh& mesh, const Eigen::Hyperplane<double, 3>& plane,
               double noise)
      : grid_(grid), mesh_(mesh), plane_(plane), noise_(noise), facets_(is_facets(grid.surface())) {}

  std::vector<PlaceLine> trace(const CancelToken& cancel) {
    measure_values();
    find_segments();
    if (!cancel.cancelled()) join_ends(cancel);
    if (cancel.cancelled()) return {};
    used_.assign(segments_.size(), false);
    // Open curves are traced first, from their ends; the rest is closed.
    for (std::size_t end = 0; end < partner_.size(); ++end)
      if (partner_[end] == no_end && !used_[end / 2]) follow(end);
    for (std::size_t end = 0; end < partner_.size(); end += 2)
      if (!used_[end / 2]) follow(end);
    return std::move(lines_);
  }

 private:
  /// Edge of the end of a segment: corners of its triangle, that of the sample with the lower number first.
  using Corners = std::array<std::size_t, 2>;

  bool above(Index sample) const { return values_[sample] >= -noise_; }
  bool in_plane(Index sample) const { return std::abs(values_[sample]) <= noise_; }

  void measure_values() {
    values_.reserve(mesh_.samples().size());
    for (const Vector3& sample : mesh_.samples()) values_.push_back(plane_.signedDistance(sample));
  }

  void find_segments() {
    for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
      const std::array<Index, 3>& samples = mesh_.triangles()[t].samples;
      const bool up[3] = {above(samples[0]), above(samples[1]), above(samples[2])};
      for (std::uint8_t k = 0; k < 3; ++k)
        if (up[k] != up[(k + 1) % 3] && up[k] != up[(k + 2) % 3]) segments_.push_back({t, k, up[k]});
    }
  }

  const GridMesh::Triangle& triangle_of(std::size_t end) const {
    return mesh_.triangles()[segments_[end / 2].triangle];
  }

  /// Edge of a triangle, 0 .. 2: the border leaves the corner that is alone along one and returns along the
  /// other.
  std::size_t edge_of(std::size_t end) const {
    const PlaneSegment& segment = segments_[end / 2];
    const bool leaves = (end % 2 == 0) == segment.above;
    return leaves ? segment.alone : (segment.alone + 2U) % 3;
  }

  Corners corners_of(std::size_t end) const {
    const std::size_t edge = edge_of(end);
    const Corners out{edge, (edge + 1) % 3};
    const std::array<Index, 3>& samples = triangle_of(end).samples;
    return samples[out[0]] < samples[out[1]] ? out : Corners{out[1], out[0]};
  }

  /// Finds the ends that lie on the same edge: they are one crossing.
  void join_ends(const CancelToken& cancel) {
    struct EdgeEnd {
      std::array<Index, 3> edge;  ///< samples, and the patch if the edge is inside of one
      std::size_t end;
    };
    std::vector<EdgeEnd> ends;
    ends.reserve(2 * segments_.size());
    for (std::size_t end = 0; end < 2 * segments_.size(); ++end) {
      const Corners corners = corners_of(end);
      const GridMesh::Triangle& triangle = triangle_of(end);
      const Index patch = triangle.inside[edge_of(end)] ? triangle.patch : no_index;
      ends.push_back({{triangle.samples[corners[0]], triangle.samples[corners[1]], patch}, end});
    }
    std::sort(ends.begin(), ends.end(), [](const EdgeEnd& a, const EdgeEnd& b) {
      return std::tie(a.edge, a.end) < std::tie(b.edge, b.end);
    });
    partner_.assign(ends.size(), no_end);
    crossing_.resize(ends.size());
    for (std::size_t i = 0, next = 0; i < ends.size() && !cancel.cancelled(); i = next) {
      std::vector<std::size_t> down, up;
      for (; next < ends.size() && ends[next].edge == ends[i].edge; ++next) {
        const std::size_t end = ends[next].end;
        (end % 2 == 0 ? down : up).push_back(end);
        crossing_[end] = crossings_.size();
      }
      crossings_.push_back(cross(ends[i].end));
      pair(down, up);
    }
  }

  /// Joins the ends on one edge in pairs. Triangles with the same orientation run along it in opposite
  /// directions; what remains is of triangles without a common orientation, or, one end, of a border.
  void pair(const std::vector<std::size_t>& down, const std::vector<std::size_t>& up) {
    const auto join = [this](std::size_t a, std::size_t b) { partner_[a] = b, partner_[b] = a; };
    const std::size_t both = std::min(down.size(), up.size());
    for (std::size_t i = 0; i < both; ++i) join(down[i], up[i]);
    const std::vector<std::size_t>& rest = down.size() > both ? down : up;
    for (std::size_t i = both; i + 1 < rest.size(); i += 2) join(rest[i], rest[i + 1]);
  }

  Vector2 parameter_at(std::size_t end, double fraction) const {
    const GridMesh::Triangle& triangle = triangle_of(end);
    const Corners corners = corners_of(end);
    return (1 - fraction) * mesh_.parameter(triangle.points[corners[0]]) +
           fraction * mesh_.parameter(triangle.points[corners[1]]);
  }

  PlaneCrossing cross(std::size_t end) const {
    const GridMesh::Triangle& triangle = triangle_of(end);
    const Corners corners = corners_of(end);
    const Index low = triangle.samples[corners[0]], high = triangle.samples[corners[1]];
    const Vector3 &from = mesh_.samples()[low], &to = mesh_.samples()[high];
    // One end is below the plane by more than the noise, so only the other one can lie in it.
    if (in_plane(low)) return {0, from, low};
    if (in_plane(high)) return {1, to, high};
    PlaneCrossing out;
    out.point = mesh_.samples().size() + crossings_.size();
    if (facets_) {
      out.fraction = values_[low] / (values_[low] - values_[high]);
      out.position = from + out.fraction * (to - from);
      return out;
    }
    const auto position = [&](double fraction) {
      return grid_.evaluate(triangle.patch, parameter_at(end, fraction)).position;
    };
    out.fraction = crossing_fraction([&](double x) { return plane_.signedDistance(position(x)); },
                                     values_[low], values_[high], 0);
    out.position = position(out.fraction);
    return out;
  }

  SurfacePlace place_of(std::size_t end) const {
    const GridMesh::Triangle& triangle = triangle_of(end);
    const Corners corners = corners_of(end);
    const Vector3 &from = mesh_.samples()[triangle.samples[corners[0]]],
                  &to = mesh_.samples()[triangle.samples[corners[1]]];
    const PlaneCrossing& crossing = crossings_[crossing_[end]];
    return {triangle.patch, parameter_at(end, crossing.fraction), crossing.position, (to - from).norm()};
  }

  std::size_t point_of(std::size_t end) const { return crossings_[crossing_[end]].point; }

  /// Follows a curve that begins with the segment of an end, at that end.
  void follow(std::size_t begin) {
    PlaceLine line;
    std::size_t last = no_end;  // number of the last point
    const auto append = [&](std::size_t end) {
      const SurfacePlace place = place_of(end);
      const bool repeats = last == point_of(end) && (facets_ || place.patch == line.back().patch);
      if (!repeats) line.push_back(place);
      last = point_of(end);
    };
    for (std::size_t end = begin;;) {
      used_[end / 2] = true;
      const std::size_t other = end ^ 1U;
      // A segment between two edges that meet in the plane is no more than that point.
      if (point_of(end) != point_of(other)) append(end), append(other);
      end = partner_[other];
      if (end == no_end || used_[end / 2]) break;
    }
    if (line.empty()) return;
    if (partner_[begin] != no_end) close(line);
    lines_.push_back(std::move(line));
  }

  /// Repeats the first place at the end, where the curve has returned to it.
  void close(PlaceLine& line) const {
    if (facets_ || line.back().patch == line.front().patch)
      line.back() = line.front();
    else
      line.push_back(line.front());
  }

  static constexpr std::size_t no_end = std::size_t(-1);
  const SurfaceGrid& grid_;
  const GridMesh& mesh_;
  const Eigen::Hyperplane<double, 3>& plane_;
  double noise_;
  bool facets_;
  std::vector<double> values_;  ///< distances of the samples from the plane
  std::vector<PlaneSegment> segments_;
  std::vector<std::size_t> partner_;      ///< for each end, the one that the curve goes on with
  std::vector<std::size_t> crossing_;     ///< for each end
  std::vector<PlaneCrossing> crossings_;  ///< one for each crossed edge
  std::vector<bool> used_;
  std::vector<PlaceLine> lines_;
};

}  // namespace

std::vector<PlaceLine> plane_places(const SurfaceGrid& grid, const GridMesh& mesh,
                                    const Eigen::Hyperplane<double, 3>& plane, double noise,
                                    const CancelToken& cancel) {
  std::vector<PlaceLine> out = PlaneSection(grid, mesh, plane, noise).trace(cancel);
  // Borders may touch without a seam: faces that were welded with a twist, meshes that come in pieces.
  join_lines(out);
  return out;
}

}  // namespace hariko
