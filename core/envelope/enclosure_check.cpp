#include "core/envelope/enclosure_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/geometry/winding_tree.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

namespace {

/// Depth within which points count as on both surfaces, relative to a solid's reach.
constexpr double coincident = 1e-9;
constexpr int arcs = 8;  ///< parts of an ellipse before these are halved
/// Step and first index of a patch's tested triangles.
constexpr std::size_t covered_stride = 37, covered_first = 18;
constexpr std::size_t covered_samples = 7;
/// Height at which winding numbers are evaluated, relative to a triangle's size.
constexpr double lift = 0.01;

struct TestedPoint {
  Vector3 point;
  Index solid;
};

/// The surface's triangles and the solids.
class Scene {
 public:
  Scene(const Surface& surface, std::span<const SolidShape> solids, const EnclosureEffort& effort,
        double slack, const CancelToken& cancel)
      : surface_(surface),
        solids_(solids),
        effort_(effort),
        slack_(slack),
        cancel_(cancel),
        mesh_(tessellate(surface, effort.density, cancel)),
        tree_(mesh_.positions, mesh_.triangles),
        per_patch_(mesh_.triangles.size() / std::max<std::size_t>(1, surface.patch_count())) {}

  std::vector<TestedPoint> spread_points() const {
    std::vector<TestedPoint> out;
    for (Index s = 0; s < solids_.size(); ++s)
      for (const Vector3& p : solids_[s].surface_points(effort_.points))
        if (!hidden(p, s, 0)) out.push_back({p, s});
    return out;
  }

  std::vector<TestedPoint> curve_points() const {
    struct Piece {
      SharpCurve curve;
      Index solid;
      double begin, end;
    };
    std::vector<Piece> pieces;
    for (Index s = 0; s < solids_.size(); ++s)
      for (const SharpCurve& curve : solids_[s].sharp_curves()) {
        const int count = curve.across ? arcs : 1;
        for (int k = 0; k < count; ++k)
          pieces.push_back({curve, s, double(k) / count, double(k + 1) / count});
      }
    std::vector<std::vector<TestedPoint>> found(pieces.size());
    parallel_for(pieces.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !cancel_.cancelled(); ++i)
        add_piece(pieces[i].curve, pieces[i].solid, pieces[i].begin, pieces[i].end, found[i]);
    });
    std::vector<TestedPoint> out;
    for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
    return out;
  }

  EnclosureReport report(std::span<const TestedPoint> tested) const {
    std::vector<WindingTree::Nearest> miss(tested.size(), {0, no_index});
    parallel_for(tested.size(), 256, [&](std::size_t begin, std::size_t end) {
      if (cancel_.cancelled()) return;
      for (std::size_t i = begin; i < end; ++i)
        if (tree_.winding(tested[i].point) < 0.5) miss[i] = tree_.nearest(tested[i].point);
    });
    EnclosureReport out;
    out.tested = tested.size();
    for (std::size_t i = 0; i < tested.size(); ++i)
      if (miss[i].distance > slack_)
        add({tested[i].point, tested[i].solid, Index(miss[i].triangle / per_patch_), miss[i].distance}, out);
    return out;
  }

  /// Adds vertices of the surface that lie inside a solid, which reaches out there by the depth of the
  /// vertex.
  void add_dips(EnclosureReport& report) const {
    std::vector<TestedPoint> deepest(mesh_.positions.size());
    std::vector<double> depth(mesh_.positions.size(), 0);
    parallel_for(depth.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !cancel_.cancelled(); ++i)
        for (Index s = 0; s < solids_.size(); ++s)
          if (const double d = -solids_[s].distance(mesh_.positions[i]); d > depth[i])
            depth[i] = d, deepest[i] = {mesh_.positions[i], s};
    });
    report.tested += depth.size();
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const Index i : mesh_.triangles[t])
        if (double& d = depth[i]; d > slack_) {
          add({deepest[i].point, deepest[i].solid, Index(t / per_patch_), d}, report);
          d = 0;
        }
  }

  std::size_t covered_patches() const {
    std::vector<std::uint8_t> covered(surface_.patch_count(), 0);
    parallel_for(covered.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end && !cancel_.cancelled(); ++p) covered[p] = is_covered(p);
    });
    return std::size_t(std::ranges::count(covered, 1));
  }

 private:
  static void add(const OutsidePoint& point, EnclosureReport& report) {
    ++report.outside;
    report.worst = std::max(report.worst, point.distance);
    report.points.push_back(point);
  }

  /// Whether the ball of `radius` about the point lies inside another solid.
  bool hidden(const Vector3& point, Index solid, double radius) const {
    for (Index s = 0; s < solids_.size(); ++s)
      if (s != solid && solids_[s].distance(point) < -radius - coincident * solids_[s].reach()) return true;
    return false;
  }

  /// Tests the midpoint of a piece where the piece is short, inside another solid as a whole, or farther from
  /// the surface than its ends are from its midpoint. Halves other pieces.
  void add_piece(const SharpCurve& curve, Index solid, double begin, double end,
                 std::vector<TestedPoint>& out) const {
    const double length = (end - begin) * curve.length(), middle = 0.5 * (begin + end);
    const Vector3 point = curve.at(middle);
    if (hidden(point, solid, 0.5 * length)) return;
    if (length > effort_.spacing && !tree_.is_clear(point, 0.5 * length)) {
      add_piece(curve, solid, begin, middle, out);
      add_piece(curve, solid, middle, end, out);
    } else if (!hidden(point, solid, 0)) {
      out.push_back({point, solid});
      // A piece farther from the surface than it is long reaches out most at an end.
      if (length > effort_.spacing)
        for (const double end_of_piece : {begin, end})
          if (const Vector3 at = curve.at(end_of_piece); !hidden(at, solid, 0)) out.push_back({at, solid});
    }
  }

  bool is_covered(std::size_t patch) const {
    for (std::size_t k = 0; k < covered_samples; ++k) {
      const std::size_t at = covered_first + k * covered_stride;
      if (at >= per_patch_) break;
      const auto& t = mesh_.triangles[patch * per_patch_ + at];
      const Vector3 &a = mesh_.positions[t[0]], &b = mesh_.positions[t[1]], &c = mesh_.positions[t[2]];
      const Vector3 normal = (b - a).cross(c - a);
      const double size = std::sqrt(normal.norm());
      if (!(size > 0)) continue;
      if (tree_.winding((a + b + c) / 3 + lift / size * normal) > 0.5) return true;
    }
    return false;
  }

  const Surface& surface_;
  std::span<const SolidShape> solids_;
  const EnclosureEffort& effort_;
  double slack_;
  const CancelToken& cancel_;
  TriangleMesh mesh_;
  WindingTree tree_;
  std::size_t per_patch_;
};

}  // namespace

EnclosureReport check_enclosure(const Surface& surface, std::span<const SolidShape> solids,
                                const EnclosureEffort& effort, double slack, const CancelToken& cancel) {
  HARIKO_ASSERT(effort.spacing > 0, "points of sharp curves need a distance from each other");
  const Scene scene(surface, solids, effort, slack, cancel);
  std::vector<TestedPoint> tested = scene.spread_points();
  const std::vector<TestedPoint> of_curves = scene.curve_points();
  tested.insert(tested.end(), of_curves.begin(), of_curves.end());
  EnclosureReport out = scene.report(tested);
  scene.add_dips(out);
  if (effort.covered) out.covered = scene.covered_patches();
  return out;
}

}  // namespace hariko
