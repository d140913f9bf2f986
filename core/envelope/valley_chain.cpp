#include "core/envelope/valley_chain.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/base/small_solver.hpp"

namespace hariko {

namespace {

constexpr double least_point_sink = 0.02;  ///< of the edge: shallower points of a valley are dropped
constexpr double fillet_share = 0.3;       ///< of the waist, not sunk
constexpr int deepest_split = 2;
constexpr double ray_reach = 2;         ///< edge lengths
constexpr double end_distance = 0.02;   ///< of the edge, between its ends and a third solid's point
constexpr double shallow_third = 0.04;  ///< of the distance of two valleys

/// One valley of a chain, or the point on a third solid between two of them.
struct Step {
  std::optional<ValleyPath> path;
  Vector3 point = Vector3::Zero();
  Index solid_a = no_index, solid_b = no_index;  ///< authored; b none for a point on solid a
  double relative = 0;                           ///< length of the path in edge lengths
  NetworkVertexKey name = {};
};

Index mixed(Index seed, Index value) {
  // FNV-1a on the four bytes.
  for (int k = 0; k < 4; ++k) seed = (seed ^ ((value >> (8 * k)) & 0xffU)) * 16777619U;
  return seed;
}

class Chains {
 public:
  Chains(const NetworkCage& hull, const ValleyCageInput& input) : hull_(hull), input_(input) {
    for (const CageFace& face : hull.faces) {
      const Vector3 normal = newell_normal(face.loop, hull.vertices);
      for (std::size_t i = 0; i < face.loop.size(); ++i)
        normals_[std::minmax(face.loop[i], face.loop[(i + 1) % face.loop.size()])].push_back(normal);
    }
  }

  ValleyChains make() {
    for (const auto& [edge, normals] : normals_) {
      const CageVertex &a = hull_.vertices[edge.first], &b = hull_.vertices[edge.second];
      const Index solid_a = owner(a), solid_b = owner(b);
      if (solid_a == solid_b) continue;
      const NetworkVertexKey from = key_of(SolidVertex{a.solid, a.vertex}, input_.solids),
                             to = key_of(SolidVertex{b.solid, b.vertex}, input_.solids);
      const Index seed =
          mixed(mixed(mixed(mixed(2166136261U, from.solid), from.vertex), to.solid), to.vertex);
      std::vector<Step>& steps = steps_[edge];
      sink(a.position, solid_a, b.position, solid_b, normals, seed, 0, steps);
    }
    select();
    ValleyChains out;
    for (const auto& [edge, steps] : steps_)
      if (std::vector<ChainVertex> chain = placed(steps); !chain.empty()) out.emplace(edge, std::move(chain));
    restore_corners(out);
    return out;
  }

 private:
  Index owner(const CageVertex& v) const { return input_.solids[v.solid].owner; }
  /// Of a point between two authored solids.
  NetworkVertexKey name_of(Index number, Index solid_a, Index solid_b) const {
    const auto id = [&](Index solid) {
      return std::ranges::find(input_.solids, solid, &PlacedSolid::owner)->id;
    };
    const auto [low, high] = std::minmax({id(solid_a), id(solid_b)});
    return {low, number, high};
  }
  const GrownSolids& grown() const { return *input_.grown; }

  /// A third solid that closes the notch from below.
  RayHit third(const ValleyPath& path, Index solid_a, Index solid_b, double edge,
               const std::vector<Vector3>& normals) const {
    const Vector3& end = path.points.back();
    if (path.stop == ValleyPath::Stop::third) return {path.third, end, 0};
    RayHit best;
    if (path.stop != ValleyPath::Stop::open) return best;
    const Vector3 facing =
        (grown().gradient(solid_a, end) - grown().gradient(solid_b, end)).stableNormalized();
    std::vector<Vector3> outward{normals[0] + normals[1], normals[0], normals[1]};
    for (Index c = 0; c < grown().count(); ++c)
      if (c != solid_a && c != solid_b) outward.push_back(grown().gradient(c, end));
    for (const Vector3& o : outward) {
      const Vector3 d = (o.dot(facing) * facing - o).stableNormalized();
      if (d.isZero(0)) continue;
      const RayHit hit =
          hit_third_solid(grown(), solid_a, solid_b, end, d, ray_reach * edge, input_.diagonal);
      if (hit.solid != no_index && (best.solid == no_index || hit.distance < best.distance - 1e-9 * edge))
        best = hit;
    }
    return best;
  }

  void sink(const Vector3& a, Index solid_a, const Vector3& b, Index solid_b,
            const std::vector<Vector3>& normals, Index seed, int depth, std::vector<Step>& out) const {
    const double edge = (b - a).norm();
    if (solid_a == solid_b || !(edge > 0)) return;
    ValleyPath path = valley_path(grown(), solid_a, solid_b, a, b, input_.diagonal);
    if (depth < deepest_split) {
      const RayHit hit = third(path, solid_a, solid_b, edge, normals);
      if (hit.solid != no_index && (hit.point - a).norm() > end_distance * edge &&
          (hit.point - b).norm() > end_distance * edge) {
        sink(a, solid_a, hit.point, hit.solid, normals, mixed(seed, 1), depth + 1, out);
        Step middle;
        middle.point = hit.point;
        middle.solid_a = hit.solid;
        middle.name = name_of(mixed(seed, 4), hit.solid, hit.solid);
        out.push_back(middle);
        sink(hit.point, hit.solid, b, solid_b, normals, mixed(seed, 2), depth + 1, out);
        return;
      }
    }
    const double relative = path.length / edge;
    out.push_back({std::move(path), Vector3::Zero(), std::min(solid_a, solid_b), std::max(solid_a, solid_b),
                   relative, name_of(mixed(seed, 3), solid_a, solid_b)});
  }

  void select() {
    std::map<std::pair<Index, Index>, double> deepest;
    for (const auto& [edge, steps] : steps_)
      for (const Step& step : steps)
        if (step.path) {
          double& most = deepest[{step.solid_a, step.solid_b}];
          most = std::max(most, step.relative);
        }
    const double tightness = input_.settings.tightness;
    for (auto& [edge, steps] : steps_)
      std::erase_if(steps, [&](const Step& step) {
        return step.path && (step.relative * tightness <= least_point_sink ||
                             deepest[{step.solid_a, step.solid_b}] * tightness < input_.settings.least_sink);
      });
  }

  std::vector<ChainVertex> placed(const std::vector<Step>& steps) const {
    const double share = input_.settings.tightness * (1 - fillet_share * input_.settings.waist);
    std::vector<ChainVertex> out;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Step& step = steps[i];
      if (step.path) {
        ChainVertex at;
        std::tie(at.vertex.position, at.vertex.outward) = along(*step.path, share);
        at.vertex.vertex = step.name.vertex;
        at.vertex.name = step.name;
        at.label = {step.solid_a, step.solid_b, false};
        out.push_back(at);
        continue;
      }
      if (i == 0 || i + 1 == steps.size() || !steps[i - 1].path || !steps[i + 1].path) continue;
      const Vector3 before = along(*steps[i - 1].path, share).first,
                    after = along(*steps[i + 1].path, share).first;
      const double inside = -grown().distance(step.solid_a, 0.5 * (before + after));
      if (inside > shallow_third * (after - before).norm()) out.push_back(on_solid(step));
    }
    return out;
  }

  ChainVertex on_solid(const Step& step) const {
    ChainVertex out;
    for (Index s = 0; s < input_.solids.size(); ++s)
      if (input_.solids[s].owner == step.solid_a &&
          (out.vertex.solid == no_index || (input_.solids[s].centre - step.point).norm() <
                                               (input_.solids[out.vertex.solid].centre - step.point).norm()))
        out.vertex.solid = s;
    out.vertex.vertex = no_index;
    out.vertex.name = step.name;
    out.vertex.position = step.point;
    return out;
  }

  /// A corner of a solid that the way to the first valley would cut off.
  struct Corner {
    double height;
    std::pair<Index, Index> edge;
    bool at_high;
    ChainVertex vertex;
  };

  void find_corners(const std::pair<Index, Index>& edge, bool at_high, const std::vector<ChainVertex>& chain,
                    std::vector<Corner>& out) const {
    const CageVertex& a = hull_.vertices[at_high ? edge.second : edge.first];
    const CageVertex& b = hull_.vertices[at_high ? edge.first : edge.second];
    const PlacedSolid& solid = input_.solids[a.solid];
    const ChainVertex& first = at_high ? chain.back() : chain.front();
    if (first.vertex.solid != no_index || solid.is_round()) return;
    const Vector3 q = first.vertex.position - a.position, e = b.position - a.position;
    const double size = q.norm();
    const Vector3 normal = q.cross(e).stableNormalized();
    Eigen::Matrix<double, 3, 2> frame;
    frame << q, e;
    for (Index v = 0; v < solid.unit_vertices.size(); ++v) {
      if (std::any_of(hull_.vertices.begin(), hull_.vertices.end(),
                      [&](const CageVertex& other) { return other.solid == a.solid && other.vertex == v; }))
        continue;
      const Vector3 place = solid.world(solid.unit_vertices[v], input_.growth[a.solid]);
      const Vector3 u = place - a.position;
      const Vector2 affine =
          solve_symmetric(Eigen::Matrix2d(frame.transpose() * frame), Vector2(frame.transpose() * u));
      const double height = (u - u.dot(q) / q.squaredNorm() * q).norm(), along_q = u.dot(q) / size;
      if (height < 0.1 * size || affine.x() < -0.1 || affine.y() <= 0 || affine.sum() >= 1.03 ||
          along_q <= 0.05 * size || std::abs(u.dot(normal)) >= 0.3 * size)
        continue;
      Corner corner{height, edge, at_high, {}};
      corner.vertex.vertex.solid = a.solid;
      corner.vertex.vertex.vertex = v;
      corner.vertex.vertex.position = place;
      corner.vertex.label = {owner(a), owner(b), true};
      out.push_back(corner);
    }
  }

  void restore_corners(ValleyChains& chains) const {
    std::vector<Corner> corners;
    for (const auto& [edge, chain] : chains)
      for (const bool at_high : {false, true}) find_corners(edge, at_high, chain, corners);
    std::stable_sort(corners.begin(), corners.end(), [&](const Corner& x, const Corner& y) {
      return x.height > y.height + 1e-9 * input_.diagonal;
    });
    std::set<SolidVertex> used;
    std::set<std::pair<std::pair<Index, Index>, bool>> served;
    for (const Corner& corner : corners) {
      const CageVertex& v = corner.vertex.vertex;
      if (used.contains({v.solid, v.vertex}) || !served.insert({corner.edge, corner.at_high}).second)
        continue;
      used.emplace(v.solid, v.vertex);
      std::vector<ChainVertex>& chain = chains[corner.edge];
      chain.insert(corner.at_high ? chain.end() : chain.begin(), corner.vertex);
    }
  }

  const NetworkCage& hull_;
  const ValleyCageInput& input_;
  std::map<std::pair<Index, Index>, std::vector<Vector3>> normals_;
  std::map<std::pair<Index, Index>, std::vector<Step>> steps_;
};

}  // namespace

ValleyChains valley_chains(const NetworkCage& hull, const ValleyCageInput& input) {
  return Chains(hull, input).make();
}

}  // namespace hariko
