#include "core/surface/weld_patches.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"

namespace hariko {

namespace {

/// Welding tolerance, relative to the size of the whole. IGES files have nine digits per number, so that both
/// sides are off by up to 5e-9 in each direction.
constexpr double weld_tolerance = 2e-8;
constexpr double smooth_seam_angle = 1e-6;
/// Rounding error of a number in a file, relative to its distance from zero.
constexpr double number_rounding = 64 * std::numeric_limits<double>::epsilon();
constexpr int samples = 16;  ///< intervals by which sides are compared
/// Snapping distance of parameters to multiples of 1 / `halvings`, as sides are mostly halved.
constexpr double same_parameter = 1e-5;
constexpr double halvings = 4096;
/// Share of a side that must be free for it to be boundary: the rounding of files leaves smaller gaps between
/// parts.
constexpr double least_gap = 1e-6;

struct SideCurve {
  std::array<Vector3, samples + 1> point;
  Eigen::AlignedBox3d box;   ///< box of the sampled points
  Eigen::AlignedBox3d hull;  ///< box of the whole curve, which extends beyond the samples
  bool collapsed = false;
};

/// Two sides that meet; begins and ends as in Seam, but before patches are flipped.
struct Meeting {
  Index first, second;  ///< slots: 4 patch + side
  double first_begin, first_end, second_begin, second_end;
  /// Whether both sides run the same way, so that one of the two patches must be flipped.
  bool parallel() const { return (first_end > first_begin) == (second_end > second_begin); }
};

class Welder {
 public:
  Welder(const Vector3& origin, std::vector<BezierPatch> patches)
      : origin_(origin), loose_(std::move(patches)) {}

  Surface weld() {
    sample_sides();
    match_whole_sides();
    match_parts();
    orient();
    std::vector<BezierPatch> turned;
    for (std::size_t k = 0; k < count_; ++k)
      turned.push_back(flip_[k] ? flipped(loose_.patch(Index(k))) : loose_.patch(Index(k)));
    patches_ = std::make_shared<const BezierPatchSet>(std::move(turned));
    return assemble();
  }

 private:
  Vector3 on_side(Index slot, double x) const {
    return loose_.evaluate(slot / 4, side_parameter(Domain::square, int(slot % 4), x), Order::first).position;
  }

  /// Bounding box of the control points of a side.
  Eigen::AlignedBox3d hull_of(Index slot) const {
    const BezierPatch& patch = loose_.patch(slot / 4);
    const int side = int(slot % 4), m = patch.degree_s, n = patch.degree_t;
    Eigen::AlignedBox3d out;
    for (int i = 0; i <= (side % 2 == 0 ? m : n); ++i) {
      const std::size_t at = side == 0   ? patch.index(i, 0)
                             : side == 1 ? patch.index(m, i)
                             : side == 2 ? patch.index(i, n)
                                         : patch.index(0, i);
      out.extend(patch.points[at]);
    }
    return out;
  }

  void sample_sides() {
    count_ = loose_.patch_count();
    curves_.resize(4 * count_);
    Eigen::AlignedBox3d all;
    for (Index slot = 0; slot < curves_.size(); ++slot) {
      SideCurve& curve = curves_[slot];
      for (int i = 0; i <= samples; ++i) {
        curve.point[std::size_t(i)] = on_side(slot, grid_fraction(i, samples));
        curve.box.extend(curve.point[std::size_t(i)]);
      }
      curve.hull = hull_of(slot);
      all.extend(curve.box);
    }
    const double farthest = origin_.norm() + std::max(all.min().norm(), all.max().norm());
    tolerance_ = std::max(weld_tolerance * all.diagonal().norm(), number_rounding * farthest);
    for (SideCurve& curve : curves_) curve.collapsed = curve.box.diagonal().norm() <= tolerance_;
    matched_.assign(curves_.size(), 0);
  }

  bool same(const SideCurve& a, const SideCurve& b, bool reversed) const {
    for (int i = 0; i <= samples; ++i)
      if ((a.point[std::size_t(i)] - b.point[std::size_t(reversed ? samples - i : i)]).norm() > tolerance_)
        return false;
    return true;
  }

  /// Finds sides that are the same curve by a sweep over their sorted midpoints; of several, as where bodies
  /// touch, one that runs the other way, so that no patch is flipped. The sweep direction is one
  /// that control nets rarely have, since across an aligned direction all midpoints of a net would be
  /// candidates.
  void match_whole_sides() {
    const Vector3 direction = Vector3(0.4871, 0.6257, 0.6092).normalized();
    std::vector<Index> order;
    for (Index slot = 0; slot < curves_.size(); ++slot)
      if (!curves_[slot].collapsed) order.push_back(slot);
    const auto place = [&](Index slot) { return curves_[slot].point[samples / 2].dot(direction); };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return place(a) < place(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (matched_[order[i]]) continue;
      Index other = no_index;
      bool reversed = false;
      for (std::size_t j = i + 1; j < order.size() && !reversed; ++j) {
        if (place(order[j]) - place(order[i]) > tolerance_) break;
        if (matched_[order[j]]) continue;
        reversed = same(curves_[order[i]], curves_[order[j]], true);
        if (reversed || (other == no_index && same(curves_[order[i]], curves_[order[j]], false)))
          other = order[j];
      }
      if (other == no_index) continue;
      const auto [a, b] = std::minmax({order[i], other});
      meetings_.push_back({a, b, 0, 1, reversed ? 1.0 : 0.0, reversed ? 0.0 : 1.0});
      matched_[a] = matched_[b] = 1;
    }
    std::sort(meetings_.begin(), meetings_.end(),
              [](const Meeting& a, const Meeting& b) { return a.first < b.first; });
  }

  /// Parameter of the point on a side nearest to p; negative when it is farther than the tolerance.
  double parameter_on(Index slot, const Vector3& p) const {
    const SideCurve& curve = curves_[slot];
    if (curve.hull.exteriorDistance(p) > tolerance_) return -1;
    // Ends first: where a curve begins slowly, a range of parameters lies within the tolerance.
    if ((curve.point[0] - p).norm() <= tolerance_) return 0;
    if ((curve.point[samples] - p).norm() <= tolerance_) return 1;
    int nearest = 0;
    for (int i = 1; i <= samples; ++i)
      if ((curve.point[std::size_t(i)] - p).squaredNorm() <
          (curve.point[std::size_t(nearest)] - p).squaredNorm())
        nearest = i;
    double low = double(std::max(nearest - 1, 0)) / samples;
    double high = double(std::min(nearest + 1, samples)) / samples;
    constexpr double golden = 0.6180339887498949;
    for (int round = 0; round < 60; ++round) {
      const double a = high - golden * (high - low), b = low + golden * (high - low);
      if ((on_side(slot, a) - p).squaredNorm() < (on_side(slot, b) - p).squaredNorm())
        high = b;
      else
        low = a;
    }
    // Golden section search stops at the square root of rounding; Gauss-Newton refines it.
    double x = 0.5 * (low + high);
    for (int round = 0; round < 4; ++round) {
      const double h = 1e-6;
      const double left = std::max(0.0, x - h), right = std::min(1.0, x + h);
      const Vector3 tangent = (on_side(slot, right) - on_side(slot, left)) / (right - left);
      if (tangent.squaredNorm() == 0) break;
      x = std::clamp(x + (p - on_side(slot, x)).dot(tangent) / tangent.squaredNorm(), 0.0, 1.0);
    }
    const double halved = std::round(x * halvings) / halvings;
    if (std::abs(x - halved) < same_parameter && (on_side(slot, halved) - p).norm() <= tolerance_) x = halved;
    return (on_side(slot, x) - p).norm() <= tolerance_ ? x : -1;
  }

  void match_parts() {
    std::vector<Index> open;
    for (Index slot = 0; slot < curves_.size(); ++slot)
      if (!matched_[slot] && !curves_[slot].collapsed) open.push_back(slot);
    for (const auto& [small, large] : points_in_hulls(open)) {
      if (matched_[small]) continue;
      const double begin = parameter_on(large, curves_[small].point[0]);
      if (begin < 0) continue;
      const double end = parameter_on(large, curves_[small].point[samples]);
      if (end < 0 || std::abs(end - begin) < 1e-6 || !is_part(small, large, begin, end)) continue;
      meetings_.push_back({large, small, begin, end, 0, 1});
      matched_[small] = 1;
    }
  }
  /// Pairs of sides where the points of the first lie in the box of the second, in order of the first: a
  /// sweep over the beginnings of boxes, along the axis of greatest extent.
  std::vector<std::pair<Index, Index>> points_in_hulls(const std::vector<Index>& open) const {
    Eigen::AlignedBox3d all;
    for (const Index slot : open) all.extend(curves_[slot].hull);
    std::vector<std::pair<Index, Index>> out;
    if (open.empty()) return out;
    Eigen::Index axis = 0;
    all.sizes().maxCoeff(&axis);
    std::vector<Index> order = open, running;
    const auto low = [&](Index slot) { return curves_[slot].hull.min()[axis]; };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return low(a) < low(b); });
    const auto holds = [&](Index large, Index small) {
      Eigen::AlignedBox3d box = curves_[large].hull;
      box.min().array() -= tolerance_;
      box.max().array() += tolerance_;
      return box.contains(curves_[small].box);
    };
    for (const Index slot : order) {
      std::erase_if(running,
                    [&](Index other) { return curves_[other].hull.max()[axis] < low(slot) - tolerance_; });
      for (const Index other : running) {
        if (holds(other, slot)) out.emplace_back(slot, other);
        if (holds(slot, other)) out.emplace_back(other, slot);
      }
      running.push_back(slot);
    }
    std::sort(out.begin(), out.end());
    return out;
  }
  bool is_part(Index small, Index large, double begin, double end) const {
    for (int i = 1; i < samples; ++i) {
      const double x = double(i) / samples;
      if ((on_side(large, begin + x * (end - begin)) - curves_[small].point[std::size_t(i)]).norm() >
          4 * tolerance_)
        return false;
    }
    return true;
  }

  /// Chooses the patches to flip, so that sides that meet run in opposite directions.
  void orient() {
    std::vector<std::vector<Index>> at(count_);
    for (Index m = 0; m < meetings_.size(); ++m) {
      at[meetings_[m].first / 4].push_back(m);
      at[meetings_[m].second / 4].push_back(m);
    }
    flip_.assign(count_, 0);
    std::vector<char> seen(count_, 0);
    std::vector<Index> stack;
    for (Index start = 0; start < count_; ++start) {
      if (seen[start]) continue;
      seen[start] = 1;
      stack.push_back(start);
      while (!stack.empty()) {
        const Index patch = stack.back();
        stack.pop_back();
        for (const Index m : at[patch]) {
          const Index a = meetings_[m].first / 4, b = meetings_[m].second / 4;
          const Index other = a == patch ? b : a;
          if (seen[other]) continue;
          seen[other] = 1;
          flip_[other] = flip_[patch] != char(meetings_[m].parallel());
          stack.push_back(other);
        }
      }
    }
    std::erase_if(meetings_, [&](const Meeting& m) {
      return (flip_[m.first / 4] != flip_[m.second / 4]) != m.parallel();
    });
  }

  /// Side of a patch that may have been flipped, and a parameter along it.
  PatchSide turned_side(Index slot) const {
    const Index patch = slot / 4, side = slot % 4;
    return {patch, static_cast<std::uint8_t>(flip_[patch] ? 3 - side : side)};
  }
  double turned(Index slot, double x) const { return flip_[slot / 4] ? 1 - x : x; }

  Surface assemble() {
    std::vector<Seam> seams;
    std::vector<double> covered(4 * count_, 0.0);
    DisjointSets corners(4 * count_);
    const auto corner = [](PatchSide side, double x) {
      return 4 * side.patch + (x == 0 ? side.side : (side.side + 1U) % 4U);
    };
    for (const Meeting& m : meetings_) {
      Seam seam;
      seam.first = turned_side(m.first);
      seam.second = turned_side(m.second);
      seam.first_begin = turned(m.first, m.first_begin);
      seam.first_end = turned(m.first, m.first_end);
      seam.second_begin = turned(m.second, m.second_begin);
      seam.second_end = turned(m.second, m.second_end);
      if (seam.first_begin > seam.first_end) {
        std::swap(seam.first_begin, seam.first_end);
        std::swap(seam.second_begin, seam.second_end);
      }
      seam.intended = smooth(seam) ? Continuity::g1 : Continuity::g0;
      covered[4 * seam.first.patch + seam.first.side] += std::abs(seam.first_end - seam.first_begin);
      covered[4 * seam.second.patch + seam.second.side] += std::abs(seam.second_end - seam.second_begin);
      const auto is_end = [](double x) { return x == 0 || x == 1; };
      if (is_end(seam.first_begin) && is_end(seam.second_begin))
        corners.join(corner(seam.first, seam.first_begin), corner(seam.second, seam.second_begin));
      if (is_end(seam.first_end) && is_end(seam.second_end))
        corners.join(corner(seam.first, seam.first_end), corner(seam.second, seam.second_end));
      seams.push_back(seam);
    }
    std::vector<Index> nodes(4 * count_);
    Index node_count = 0;
    for (Index k = 0; k < nodes.size(); ++k)
      nodes[k] = corners.find(k) == k ? node_count++ : nodes[corners.find(k)];

    Surface::Parts parts;
    parts.origin = origin_;
    parts.patches = patches_;
    parts.node_count = node_count;
    parts.node_normals = std::make_shared<const std::vector<Vector3>>(node_normals(nodes, node_count));
    parts.corner_nodes = std::make_shared<const std::vector<Index>>(std::move(nodes));
    parts.seams = std::make_shared<const std::vector<Seam>>(std::move(seams));
    std::vector<Provenance> provenance;
    for (Index k = 0; k < count_; ++k) provenance.push_back({element_of(FaceId{k}), 0});
    parts.provenance = std::make_shared<const std::vector<Provenance>>(std::move(provenance));
    std::vector<PatchSide> boundary;
    for (Index slot = 0; slot < covered.size(); ++slot)
      if (covered[slot] < 1 - least_gap) boundary.push_back({slot / 4, static_cast<std::uint8_t>(slot % 4)});
    parts.boundary_sources = std::make_shared<const std::vector<Element>>(boundary.size());
    parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>(std::move(boundary));
    return Surface(std::move(parts));
  }

  Vector3 side_normal(PatchSide side, double x) const {
    return unit_normal(
        patches_->evaluate(side.patch, side_parameter(Domain::square, side.side, x), Order::first));
  }
  bool smooth(const Seam& seam) const {
    for (int i = 0; i <= samples; ++i) {
      const double x = double(i) / samples;
      const Vector3 a = side_normal(seam.first, seam.first_begin + x * (seam.first_end - seam.first_begin));
      const Vector3 b =
          side_normal(seam.second, seam.second_begin + x * (seam.second_end - seam.second_begin));
      // A side that shrinks to a point has no tangent planes to compare.
      if (!a.isZero(0) && !b.isZero(0) && (a - b).norm() > smooth_seam_angle) return false;
    }
    return true;
  }
  /// Common normal of the patches at each node, zero where they have none in common.
  std::vector<Vector3> node_normals(const std::vector<Index>& nodes, Index node_count) const {
    std::vector<Vector3> normals(node_count, Vector3::Zero());
    std::vector<char> seen(node_count, 0);
    for (Index p = 0; p < count_; ++p)
      for (int c = 0; c < 4; ++c) {
        const Index node = nodes[4 * p + Index(c)];
        const Vector3 normal =
            unit_normal(patches_->evaluate(p, corner_parameter(Domain::square, c), Order::first));
        if (!seen[node])
          normals[node] = normal;
        else if ((normals[node] - normal).norm() > smooth_seam_angle)
          normals[node].setZero();
        seen[node] = 1;
      }
    return normals;
  }

  Vector3 origin_;
  BezierPatchSet loose_;
  std::shared_ptr<const BezierPatchSet> patches_;
  Index count_ = 0;
  double tolerance_ = 0;
  std::vector<SideCurve> curves_;
  std::vector<char> matched_, flip_;
  std::vector<Meeting> meetings_;
};

}  // namespace

Result<Surface> weld_patches(const Vector3& origin, std::vector<BezierPatch> patches) {
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (auto error = check_patch(patches[k], k)) return *error;
  return Welder(origin, std::move(patches)).weld();
}

}  // namespace hariko
