#include "core/envelope/valley_push.hpp"

#include <algorithm>

namespace hariko {

namespace {

constexpr double overshoot = 1.3;
constexpr double largest_outside = 0.03, largest_step = 0.03, largest_push = 0.25;  ///< of the diagonal
constexpr double least_slope = 0.35;

class Pushes {
 public:
  Pushes(const CurveNetwork& network, double diagonal) : network_(network), diagonal_(diagonal) {}

  /// False where the face has no vertex in a valley.
  bool add(Index face, const Vector3& point, double depth, const Vector3& direction) {
    double nearest = 1e300;
    for (const Index v : network_.cage.faces[face].loop)
      if (vertex(v).solid == no_index) nearest = std::min(nearest, (vertex(v).position - point).norm());
    if (nearest == 1e300) return false;
    for (const Index v : network_.cage.faces[face].loop) {
      if (vertex(v).solid != no_index) continue;
      const double r = std::max((vertex(v).position - point).norm(), 1e-9 * diagonal_);
      const Vector3& w = vertex(v).outward;
      const double slope = w.dot(direction);
      // Along its own direction a vertex stays in the valley.
      const Vector3 way = slope > least_slope ? Vector3(w / slope) : direction;
      at_[vertex(v).vertex].push_back(overshoot * depth * std::min(1.0, nearest / r) * way);
    }
    return true;
  }

  void apply(std::map<Index, Vector3>& pushes) {
    for (auto& [name, list] : at_) {
      std::stable_sort(list.begin(), list.end(),
                       [](const Vector3& a, const Vector3& b) { return a.norm() > b.norm(); });
      Vector3 sum = Vector3::Zero();
      for (const Vector3& p : list) {
        const Vector3 d = p.stableNormalized();
        if (const double missing = p.norm() - sum.dot(d); missing > 0) sum += missing * d;
      }
      if (const double size = sum.norm(); size > largest_step * diagonal_)
        sum *= largest_step * diagonal_ / size;
      Vector3& total = pushes.try_emplace(name, Vector3::Zero()).first->second;
      total += sum;
      if (const double size = total.norm(); size > largest_push * diagonal_)
        total *= largest_push * diagonal_ / size;
    }
  }

 private:
  const CageVertex& vertex(Index v) const { return network_.cage.vertices[v]; }

  const CurveNetwork& network_;
  double diagonal_;
  std::map<Index, std::vector<Vector3>> at_;
};

}  // namespace

Violations push_valleys(const CurveNetwork& network, const Violations& found, const GrownSolids& grown,
                        std::span<const PlacedSolid> solids, double diagonal,
                        std::map<Index, Vector3>& pushes) {
  Pushes list(network, diagonal);
  Violations rest;
  rest.worst = found.worst;
  for (const Violations::InSolid& v : found.in_solid)
    if (!list.add(v.face, v.point, v.depth, grown.gradient(solids[v.solid].owner, v.point)))
      rest.in_solid.push_back(v);
  for (const Violations::Outside& v : found.outside) {
    const CageFace& face = network.cage.faces[v.face];
    Vector3 mean = Vector3::Zero();
    for (const Index c : face.loop) mean += network.cage.vertices[c].normal / double(face.loop.size());
    const Vector3 g = (newell_normal(face.loop, network.cage.vertices) + mean).stableNormalized();
    if (!list.add(v.face, v.point, std::min(v.height, largest_outside * diagonal), g))
      rest.outside.push_back(v);
  }
  list.apply(pushes);
  return rest;
}

}  // namespace hariko
