#include "core/approximation/refinement/facet_error.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/approximation/net_distance.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {

namespace {

constexpr int spread_density = 2, angle_density = 6, distance_density = 8;
constexpr int refinements = 2;
constexpr int deepest_bound = 3;
constexpr std::size_t max_samples = 91;  ///< size of a grid of TriangleCollocation::max_degree intervals
constexpr int no_side = NetDistance::no_side;
constexpr double sliver_angle = 0.02, watched_tangent = 0.2553419212210362;  ///< tan 0.25
constexpr double fold_over = 2;  ///< relative error of a facet oriented against the surface

using Sides = NetDistance::Sides;

/// Sides of a facet's pieces at which the facet might protrude beyond the surface over it: borders, and all
/// sides of slivers, whose neighbours need not cover the protrusion.
std::array<Sides, 2> watched_sides(const ParameterMesh& mesh, Index facet) {
  const bool sliver =
      !mesh.facets[facet].degenerate() && has_sharp_angle(mesh.corners(facet), watched_tangent);
  const auto watched = [&](int corner) {
    return sliver || mesh.twin[3 * facet + Index(corner)] == no_index ? corner : no_side;
  };
  const int pole = mesh.facets[facet].pole;
  if (pole < 0) return {Sides{watched(0), watched(1), watched(2)}, Sides{no_side, no_side, no_side}};
  return {Sides{watched(pole), watched((pole + 1) % 3), no_side},
          Sides{no_side, no_side, watched((pole + 2) % 3)}};
}

void at_grid(const ParameterTriangle& triangle, const BarycentricGrid& grid, std::span<Vector2> out) {
  const Vector2 b = triangle[1] - triangle[0], c = triangle[2] - triangle[0];
  for (std::size_t k = 0; k < grid.points.size(); ++k)
    out[k] = triangle[0] + grid.points[k].x() * b + grid.points[k].y() * c;
}

}  // namespace

/// Search for the largest distance over one facet.
class DistanceSearch {
 public:
  DistanceSearch(const FacetErrors& errors, const ParameterMesh& mesh, Index facet, double tolerance)
      : errors_(errors),
        patch_(mesh.facets[facet].patch),
        corners_(mesh.corners(facet)),
        closed_(corners_),
        limit_(tolerance * tolerance),
        tolerance_(tolerance),
        degree_(errors.sampler_.patches().hull_degree(patch_)) {}

  /// Bounds the distance as far as needed to decide on the tolerance; stops where it is exceeded.
  DistanceError decide(const ParameterPieces& pieces, const std::array<Sides, 2>& sides) {
    DistanceError out;
    out.certified = degree_ > 0;
    for (int k = 0; k < pieces.count; ++k) {
      const auto& triangle = pieces.triangle[std::size_t(k)];
      const double bound = degree_ > 0 ? certain(triangle, sides[std::size_t(k)], deepest_bound, true)
                                       : estimate(triangle, sides[std::size_t(k)]);
      out.bound = std::max(out.bound, bound);
      if (bound > tolerance_) break;
    }
    out.sampled = std::sqrt(sampled_);
    out.bound = std::max(out.bound, out.sampled);
    return out;
  }

  double sample(const ParameterPieces& pieces, const std::array<Sides, 2>& sides) {
    for (int k = 0; k < pieces.count; ++k) estimate(pieces.triangle[std::size_t(k)], sides[std::size_t(k)]);
    return std::sqrt(sampled_);
  }

  DistanceError measure(const ParameterPieces& pieces, const std::array<Sides, 2>& sides) {
    DistanceError out;
    out.certified = degree_ > 0;
    for (int k = 0; k < pieces.count; ++k) estimate(pieces.triangle[std::size_t(k)], sides[std::size_t(k)]);
    out.sampled = std::sqrt(sampled_);
    out.bound = out.sampled;
    if (degree_ == 0) return out;
    // Subdivides only where the bound is not tight yet.
    tolerance_ = out.sampled * 1.01;
    limit_ = std::numeric_limits<double>::infinity();
    for (int k = 0; k < pieces.count; ++k)
      out.bound = std::max(
          out.bound, certain(pieces.triangle[std::size_t(k)], sides[std::size_t(k)], deepest_bound, false));
    return out;
  }

 private:
  double squared(const Vector3& p) const { return closed_.squared_distance(p); }
  double squared(const Vector3& p, int side) const {
    return squared_distance_to_segment(p, corners_[std::size_t(side)], corners_[std::size_t(side + 1) % 3]);
  }

  /// Certain bound over a triangle of parameters; where it is above the tolerance and `depth` allows, the
  /// bound over its quarters.
  double certain(const ParameterTriangle& triangle, const Sides& sides, int depth, bool stop) {
    const BarycentricGrid& grid = barycentric_grid(degree_);
    const std::size_t count = grid.points.size();
    std::array<Vector2, max_samples> parameters;
    std::array<Vector3, max_samples> samples;
    std::array<HullBall, max_samples> balls;
    at_grid(triangle, grid, {parameters.data(), count});
    errors_.sampler_.positions(patch_, {parameters.data(), count}, {samples.data(), count});
    double worst = 0;
    for (std::size_t k = 0; k < count; ++k) worst = std::max(worst, squared(samples[k]));
    for_sides(grid, sides,
              [&](int side, int k) { worst = std::max(worst, squared(samples[std::size_t(k)], side)); });
    sampled_ = std::max(sampled_, worst);
    if (stop && worst > limit_) return std::sqrt(worst);
    errors_.sampler_.patches().hull(patch_, triangle, {samples.data(), count}, {balls.data(), count});
    double bound = 0;
    for (std::size_t k = 0; k < count; ++k)
      bound = std::max(bound, std::sqrt(squared(balls[k].centre)) + balls[k].radius);
    for_sides(grid, sides, [&](int side, int k) {
      const HullBall& ball = balls[std::size_t(k)];
      bound = std::max(bound, std::sqrt(squared(ball.centre, side)) + ball.radius);
    });
    if (bound <= tolerance_ || depth == 0) return bound;
    return std::min(bound, quarters(triangle, sides, depth - 1, stop));
  }
  double quarters(const ParameterTriangle& t, const Sides& s, int depth, bool stop) {
    const Vector2 a = 0.5 * (t[0] + t[1]), b = 0.5 * (t[1] + t[2]), c = 0.5 * (t[2] + t[0]);
    const std::pair<ParameterTriangle, Sides> parts[4] = {{{t[0], a, c}, {s[0], no_side, s[2]}},
                                                          {{a, t[1], b}, {s[0], s[1], no_side}},
                                                          {{c, b, t[2]}, {no_side, s[1], s[2]}},
                                                          {{b, c, a}, {no_side, no_side, no_side}}};
    double bound = 0;
    for (const auto& [triangle, sides] : parts) {
      bound = std::max(bound, certain(triangle, sides, depth, stop));
      if (stop && bound > tolerance_) break;
    }
    return bound;
  }
  template <class Each>
  static void for_sides(const BarycentricGrid& grid, const Sides& sides, const Each& each) {
    for (std::size_t k = 0; k < 3; ++k)
      if (sides[k] != no_side)
        for (const int i : grid.sides[k]) each(sides[k], i);
  }

  /// Samples at a grid, and then around the worst point.
  double estimate(const ParameterTriangle& triangle, const Sides& sides) {
    const BarycentricGrid& grid = barycentric_grid(distance_density);
    const std::size_t count = grid.points.size();
    std::array<Vector2, max_samples> parameters;
    std::array<Vector3, max_samples> samples;
    at_grid(triangle, grid, {parameters.data(), count});
    errors_.sampler_.positions(patch_, {parameters.data(), count}, {samples.data(), count});
    double worst = 0;
    Vector2 at = grid.points[0];
    for (std::size_t k = 0; k < count; ++k)
      if (const double d = squared(samples[k]); d > worst) worst = d, at = grid.points[k];
    double border = 0;
    for_sides(grid, sides,
              [&](int side, int k) { border = std::max(border, squared(samples[std::size_t(k)], side)); });
    double step = 1.0 / distance_density;
    for (int round = 0; round < refinements; ++round) {
      step /= 2;
      refine(triangle, step, at, worst);
    }
    sampled_ = std::max({sampled_, worst, border});
    return std::sqrt(std::max(worst, border));
  }
  void refine(const ParameterTriangle& triangle, double step, Vector2& at, double& worst) {
    std::array<Vector2, 9> local, parameters;
    std::array<Vector3, 9> samples;
    std::size_t count = 0;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        const Vector2 q = at + step * Vector2(i, j);
        if ((i == 0 && j == 0) || q.x() < 0 || q.y() < 0 || q.x() + q.y() > 1) continue;
        local[count] = q;
        parameters[count++] = at_barycentric(triangle, q.x(), q.y());
      }
    errors_.sampler_.positions(patch_, {parameters.data(), count}, {samples.data(), count});
    for (std::size_t k = 0; k < count; ++k)
      if (const double d = squared(samples[k]); d > worst) worst = d, at = local[k];
  }

  const FacetErrors& errors_;
  Index patch_;
  TriangleCorners corners_;
  ClosedTriangle closed_;
  double limit_, tolerance_;
  int degree_;
  double sampled_ = 0;  ///< squared distance
};

FacetErrors::FacetErrors(const SurfaceSampler& sampler, const MeshCriteria& criteria)
    : sampler_(sampler), criteria_(criteria), brightness_(criteria.luminance_model) {}

DistanceError FacetErrors::distance(const ParameterMesh& mesh, Index facet, double tolerance) const {
  return DistanceSearch(*this, mesh, facet, tolerance)
      .decide(pieces_of(mesh.facets[facet]), watched_sides(mesh, facet));
}

DistanceError FacetErrors::measured_distance(const ParameterMesh& mesh, Index facet) const {
  return DistanceSearch(*this, mesh, facet, 0)
      .measure(pieces_of(mesh.facets[facet]), watched_sides(mesh, facet));
}

namespace {

double largest_angle(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index facet,
                     const BarycentricGrid& grid) {
  const auto corners = mesh.corners(facet);
  const Vector3 normal = facet_normal(corners[0], corners[1], corners[2]);
  if (normal.isZero(0)) return mesh.facets[facet].degenerate() ? 0 : std::numbers::pi;
  std::array<Vector2, max_samples> parameters;
  std::array<Vector3, max_samples> normals;
  const std::size_t count = grid.points.size();
  const ParameterPieces pieces = pieces_of(mesh.facets[facet]);
  double worst = 0;
  for (int piece = 0; piece < pieces.count; ++piece) {
    at_grid(pieces.triangle[std::size_t(piece)], grid, {parameters.data(), count});
    sampler.normals(mesh.facets[facet].patch, {parameters.data(), count}, {normals.data(), count});
    for (std::size_t k = 0; k < count; ++k) {
      // (sine, cosine) grows with the angle: compares tangents of half angles.
      worst = std::max(worst, normals[k].isZero(0) ? 0.0 : angle_between(normals[k], normal));
    }
  }
  return worst;
}

}  // namespace

double FacetErrors::normal_angle(const ParameterMesh& mesh, Index facet) const {
  return largest_angle(sampler_, mesh, facet, barycentric_grid(angle_density));
}

double FacetErrors::normal_spread(const ParameterMesh& mesh, Index facet) const {
  return largest_angle(sampler_, mesh, facet, barycentric_grid(spread_density));
}

double FacetErrors::luminance(const ParameterMesh& mesh, Index facet) const {
  const auto corners = mesh.corners(facet);
  const Vector3 own = facet_normal(corners[0], corners[1], corners[2]);
  if (own.isZero(0)) return 0;
  std::array<Vector2, max_samples> parameters;
  std::array<Vector3, max_samples> normals;
  const BarycentricGrid& grid = barycentric_grid(angle_density);
  const std::size_t count = grid.points.size();
  const ParameterPieces pieces = pieces_of(mesh.facets[facet]);
  const bool flat = criteria_.luminance_model.shading == LuminanceModel::Shading::flat;
  double worst = 0;
  for (int piece = 0; piece < pieces.count; ++piece) {
    at_grid(pieces.triangle[std::size_t(piece)], grid, {parameters.data(), count});
    sampler_.normals(mesh.facets[facet].patch, {parameters.data(), count}, {normals.data(), count});
    for (std::size_t light = 0; light < brightness_.lights(); ++light) {
      const double at[3] = {brightness_.of(normals[std::size_t(grid.sides[0].front())], light),
                            brightness_.of(normals[std::size_t(grid.sides[1].front())], light),
                            brightness_.of(normals[std::size_t(grid.sides[2].front())], light)};
      const double facet_brightness = brightness_.of(own, light);
      for (std::size_t k = 0; k < count; ++k) {
        const double b = grid.points[k].x(), c = grid.points[k].y();
        const double shown = flat ? facet_brightness : (1 - b - c) * at[0] + b * at[1] + c * at[2];
        worst = std::max(worst, std::abs(brightness_.of(normals[k], light) - shown));
      }
    }
  }
  return worst;
}

double FacetErrors::shape_error(const ParameterMesh& mesh, Index facet) const {
  double worst = 0;
  if (!criteria_.max_edge && !criteria_.min_angle) return worst;
  const auto p = mesh.corners(facet);
  std::array<double, 3> length{(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()};
  std::sort(length.begin(), length.end());
  if (criteria_.max_edge) worst = length[2] / *criteria_.max_edge;
  // Halving the longest edge enlarges a needle's angle; the sharp ends of a flat triangle stay.
  if (criteria_.min_angle && !mesh.facets[facet].degenerate() && length[0] < 0.5 * length[1])
    worst = std::max(worst, *criteria_.min_angle / std::max(smallest_angle(p), 1e-9));
  return worst;
}

double FacetErrors::net_bound(const ParameterMesh& mesh, Index facet, const FacetNet& net,
                              double tolerance) const {
  return NetDistance(mesh.corners(facet), net, watched_sides(mesh, facet)[0]).decide(tolerance);
}

double FacetErrors::net_sampled(const ParameterMesh& mesh, Index facet, const FacetNet& net) const {
  return NetDistance(mesh.corners(facet), net, watched_sides(mesh, facet)[0]).sampled();
}

DistanceError FacetErrors::net_measured(const ParameterMesh& mesh, Index facet, const FacetNet& net) const {
  const auto range = NetDistance(mesh.corners(facet), net, watched_sides(mesh, facet)[0]).measure();
  return {range.sampled, range.bound, true};
}

/// Whether the surface is oriented against the facet at one of its corners; false for slivers.
bool FacetErrors::looks_back(const ParameterMesh& mesh, Index facet, const FacetNet& net) const {
  const auto corners = mesh.corners(facet);
  const Vector3 normal = facet_normal(corners[0], corners[1], corners[2]);
  if (normal.isZero(0)) return false;
  bool turned = false, known = net.shape != nullptr;
  for (int k = 0; k < 3 && known; ++k) {
    // The net's legs at a corner span the tangent plane; where they do not, the surface's normals decide.
    const std::span<const int> leaving = net.shape->side(k), arriving = net.shape->side((k + 2) % 3);
    const Vector3& at = net.points[leaving[0]];
    const Vector3 a = net.points[leaving[1]] - at, b = net.points[arriving[arriving.size() - 2]] - at;
    const Vector3 cross = a.cross(b);
    const double height = cross.dot(normal);
    known = std::abs(height) > 1e-6 * a.norm() * b.norm();
    turned = turned || height < 0;
  }
  if (!known) {
    std::array<Vector3, 3> normals;
    sampler_.normals(mesh.facets[facet].patch, mesh.facets[facet].parameter, normals);
    turned = std::any_of(normals.begin(), normals.end(), [&](const Vector3& n) { return n.dot(normal) < 0; });
  }
  // The orientation of a sliver is meaningless, and cutting it makes more slivers.
  return turned && smallest_angle(corners) > sliver_angle;
}

double FacetErrors::relative_error(const ParameterMesh& mesh, Index facet, const FacetNet& net,
                                   double* distance_bound) const {
  double worst = shape_error(mesh, facet);
  if (criteria_.distance) {
    const double tolerance = *criteria_.distance;
    const double bound =
        net.shape ? net_bound(mesh, facet, net, tolerance) : distance(mesh, facet, tolerance).bound;
    worst = std::max(worst, bound / tolerance);
    if (distance_bound) *distance_bound = bound;
  }
  if (mesh.facets[facet].degenerate()) return worst;
  if (criteria_.normal_angle && worst <= 1)
    worst = std::max(worst, normal_angle(mesh, facet) / *criteria_.normal_angle);
  if (criteria_.luminance && worst <= 1)
    worst = std::max(worst, luminance(mesh, facet) / *criteria_.luminance);
  if (worst > 1) return worst;
  return looks_back(mesh, facet, net) ? fold_over : worst;
}

double FacetErrors::sampled_error(const ParameterMesh& mesh, Index facet) const {
  double worst = 0;
  if (criteria_.distance)
    worst = DistanceSearch(*this, mesh, facet, 0)
                .sample(pieces_of(mesh.facets[facet]), watched_sides(mesh, facet)) /
            *criteria_.distance;
  if (criteria_.max_edge) {
    const auto p = mesh.corners(facet);
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, (p[(c + 1) % 3] - p[c]).norm() / *criteria_.max_edge);
  }
  if (criteria_.normal_angle) worst = std::max(worst, normal_angle(mesh, facet) / *criteria_.normal_angle);
  if (criteria_.luminance) worst = std::max(worst, luminance(mesh, facet) / *criteria_.luminance);
  return worst;
}

}  // namespace hariko
