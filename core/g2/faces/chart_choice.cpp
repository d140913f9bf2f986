#include "core/g2/faces/chart_choice.hpp"

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/g2/faces/chart_polygon.hpp"

namespace hariko {

namespace {

/// Corners, coordinates of the polygon, joined sides.
using ChartKey = std::tuple<std::vector<CornerShape>, std::vector<double>, std::vector<int>>;
using CornerKey = std::tuple<CornerShape, std::array<double, 3>, bool>;

/// Canonical order of a face's corners: the rotation that is least in lexicographic order.
class SmallestOrder {
 public:
  SmallestOrder(const HalfEdgeMesh& mesh, const std::vector<CornerShape>& corners,
                const TensionWeights& weights, const std::vector<PrescribedRibbon>& ribbons)
      : mesh_(mesh), corners_(corners), weights_(weights), ribbons_(ribbons) {}

  /// Corner that the face begins with in canonical order.
  Index find(Index face) {
    const Index n = mesh_.side_count(face), first = mesh_.face_begin(face);
    Index shift = 0;
    for (Index s = 0; s < n; ++s) {
      turned_.clear();
      for (Index j = 0; j < n; ++j) turned_.push_back(key(first + (j + s) % n));
      if (s > 0 && !(turned_ < best_)) continue;
      best_ = turned_;
      shift = s;
    }
    return shift;
  }
  /// Corners in the order found last.
  const std::vector<CornerKey>& corners() const { return best_; }

 private:
  CornerKey key(Index h) const {
    const bool joined = !ribbons_.empty() && ribbons_[h] != PrescribedRibbon::none;
    return {
        corners_[h],
        std::array{weights_.curve[h], weights_.tangent[2 * h], weights_.tangent[2 * mesh_.previous(h) + 1]},
        joined};
  }

  const HalfEdgeMesh& mesh_;
  const std::vector<CornerShape>& corners_;
  const TensionWeights& weights_;
  const std::vector<PrescribedRibbon>& ribbons_;
  std::vector<CornerKey> turned_, best_;
};

std::vector<double> coordinates(const std::vector<Vector2>& polygon) {
  std::vector<double> out;
  for (const Vector2& p : polygon) out.insert(out.end(), {p.x(), p.y()});
  return out;
}

/// Rounds away what differs among equal faces by rounding alone, so that they share a chart.
std::vector<Vector2> rounded(std::vector<Vector2> polygon) {
  constexpr double unit = 0x1p-44;
  for (Vector2& p : polygon)
    for (double* c : {&p.x(), &p.y()}) *c = unit * std::round(*c / unit);
  return polygon;
}

}  // namespace

ChartChoice choose_charts(const HalfEdgeMesh& mesh, const FaceCharts& charts,
                          const std::vector<CornerShape>& corners, const TensionWeights& weights,
                          const std::vector<PrescribedRibbon>& ribbons) {
  ChartChoice out;
  out.half_edge.resize(mesh.half_edge_count());
  out.side.resize(mesh.half_edge_count());
  SmallestOrder order(mesh, corners, weights, ribbons);
  std::map<ChartKey, std::shared_ptr<const PlacedChart>> known;
  std::vector<CornerShape> shapes;
  std::vector<int> joined;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index n = mesh.side_count(f), first = mesh.face_begin(f), shift = order.find(f);
    for (Index j = 0; j < n; ++j) {
      out.half_edge[first + j] = first + (j + shift) % n;
      out.side[first + (j + shift) % n] = static_cast<int>(j);
    }
    shapes.clear();
    joined.clear();
    for (const auto& [shape, weight, is_given] : order.corners()) {
      if (is_given) joined.push_back(static_cast<int>(shapes.size()));
      shapes.push_back(shape);
    }
    std::vector<Vector2> polygon = regular_chart_polygon(int(n));
    if (charts.frames == Frames::metric) {
      for (Index j = 0; j < n; ++j) polygon[j] = charts.corner[first + (j + shift) % n];
      polygon = rounded(chart_polygon(polygon, shapes));
    }
    auto& slot = known[{shapes, coordinates(polygon), joined}];
    if (!slot) slot = std::make_shared<const PlacedChart>(shapes, polygon, joined);
    out.placed.push_back(slot);
  }
  return out;
}

}  // namespace hariko
