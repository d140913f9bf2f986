#include "core/skinning/sections/section_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hariko {

namespace {

constexpr int densest = 8;  ///< samples per patch side
constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t most_sides = 500;  ///< largest number of sides with so many samples

/// Nearest point of a curve to consecutive points along it: continues from the last result instead of
/// searching the whole curve.
class FootTracker {
 public:
  FootTracker(const SubdivisionCurve& curve, double size) : curve_(curve), size_(size) {}

  double distance(const Vector3& p) {
    if (!started_) return search(p);
    CurveFoot best = descend(p, foot_ + step_, -unbounded, unbounded);
    // At a corner the distance may have a minimum on either side, which Newton steps do not cross.
    const int span = int(std::floor(best.parameter * curve_.spans()));
    for (const int end : {span, span + 1}) {
      const int point = ((end % curve_.size()) + curve_.size()) % curve_.size();
      if (!curve_.is_sharp(point)) continue;
      for (const double side : {-1.0, 1.0}) {
        const double low = (end + std::min(side, 0.0)) / curve_.spans(),
                     high = (end + std::max(side, 0.0)) / curve_.spans();
        if (const CurveFoot other = descend(p, (end + 0.1 * side) / curve_.spans(), low, high);
            other.distance < best.distance)
          best = other;
      }
    }
    // Far away, or at a wrong minimum: searches the whole curve.
    if (!(best.distance < 1e-2 * size_)) return search(p);
    const double step = best.parameter - foot_;
    step_ = std::abs(step) < 1.0 / curve_.spans() ? step : 0;
    foot_ = best.parameter;
    return best.distance;
  }

 private:
  /// Newton steps between two parameters; returns the best place visited.
  CurveFoot descend(const Vector3& p, double u, double low, double high) const {
    if (!curve_.closed) low = std::max(low, 0.0), high = std::min(high, 1.0);
    if (!(low < high)) return {u, unbounded};
    u = std::clamp(u, low, high);
    CurveFoot best{u, unbounded};
    for (int round = 0; round < 8; ++round) {
      const CurvePoint at = evaluate(curve_, u);
      const Vector3 gap = p - at.position;
      if (gap.norm() < best.distance) best = {u, gap.norm()};
      const double flat = at.first.squaredNorm(), slope = flat - gap.dot(at.second);
      const double next =
          std::clamp(u + gap.dot(at.first) / (slope > 0 ? slope : std::max(flat, 1e-300)), low, high);
      if (!std::isfinite(next) || std::abs(next - u) < 1e-13) break;
      u = next;
    }
    return best;
  }

  double search(const Vector3& p) {
    const CurveFoot found = nearest_point(curve_, p);
    started_ = true;
    foot_ = found.parameter;
    step_ = 0;
    return found.distance;
  }

  const SubdivisionCurve& curve_;
  double size_;
  bool started_ = false;
  double foot_ = 0, step_ = 0;
};

/// Largest distance between limits of the row's vertices and those of the section's points.
double miss_of_limits(const SubdivisionCurve& curve, const std::vector<Index>& row,
                      const SubdivisionPatchSet& patches) {
  const std::vector<Vector3> limits = limit_points(curve);
  double out = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
    out = std::max(out, (patches.limit_position(row[i]) - limits[i]).norm());
  return out;
}

SectionMiss sampled(const SubdivisionCurve& curve, const std::vector<Index>& row,
                    const SubdivisionPatchSet& patches, double size, int density) {
  const SubdivisionTopology& topology = patches.topology();
  SectionMiss out;
  FootTracker foot(curve, size);
  double squares = 0, weights = 0;
  const std::size_t edges = row.size() - (curve.closed ? 0 : 1);
  for (std::size_t e = 0; e < edges; ++e) {
    const Index a = row[e], b = row[(e + 1) % row.size()];
    auto sides = topology.edge_sides(a, b);
    const bool backwards = sides.empty();
    if (backwards) sides = topology.edge_sides(b, a);
    if (backwards) std::reverse(sides.begin(), sides.end());
    for (const PatchSide& side : sides)
      for (int i = 0; i <= density; ++i) {
        const double x = double(backwards ? density - i : i) / density;
        const Vector3 p =
            patches.evaluate(side.patch, side_parameter(Domain::square, side.side, x), Order::first).position;
        const double distance = foot.distance(p);
        out.largest = std::max(out.largest, distance);
        const double weight = i == 0 || i == density ? 0.5 : 1;
        squares += weight * distance * distance, weights += weight;
      }
  }
  if (weights > 0) out.root_mean_square = std::sqrt(squares / weights);
  return out;
}

}  // namespace

std::vector<SectionMiss> section_deviations(const SkinResult& result, const SubdivisionPatchSet& patches) {
  const Skin& skin = result.skin;
  const bool pleat = skin.method == SkinMethod::pleat;
  std::vector<char> regular(skin.sections.size(), pleat && skin.pleat.fit != SectionFit::none);
  for (const auto& [k, i] : result.mesh.inexact) regular[std::size_t(k)] = 0;
  if (!skin.path.closed && pleat) regular.front() = regular.back() = 1;
  std::size_t edges = 0;
  for (std::size_t k = 0; k < regular.size(); ++k)
    if (!regular[k]) edges += result.mesh.section_rows[k].size();
  const int density =
      int(std::clamp<std::size_t>(densest * most_sides / std::max<std::size_t>(edges, 1), 1, densest));
  std::vector<SectionMiss> out;
  for (std::size_t k = 0; k < skin.sections.size(); ++k) {
    const SubdivisionCurve curve = skin.sections[k].curve();
    const std::vector<Index>& row = result.mesh.section_rows[k];
    SectionMiss& miss = out.emplace_back();
    if (curve.size() < 2) continue;
    const double size = length(curve);
    if (regular[k]) {
      miss.largest = miss.root_mean_square = miss.same_parameter = miss_of_limits(curve, row, patches);
      if (miss.largest <= 1e-9 * size) continue;
    }
    miss = sampled(curve, row, patches, size, density);
  }
  return out;
}

}  // namespace hariko
