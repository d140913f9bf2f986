#include "core/envelope/network/hull_cage.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "core/base/index_list.hpp"
#include "core/base/solvers/small_solver.hpp"
#include "core/geometry/polygon.hpp"
#include "core/geometry/tolerant_hull.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr double duplicate_distance = 1e-6;  ///< relative to the diagonal
constexpr double hull_tolerance = 1e-9;      ///< relative to the diagonal
constexpr double flat_angle = 0.05;          ///< degrees
constexpr double thinning = 0.09;  ///< relative to the size: of corners nearer to each other some are removed
/// Relative to the width: corners on both sides of thin solids stay.
constexpr double thinning_of_width = 0.5;
constexpr double merge_angle = 40;  ///< degrees: largest angle between triangles that are merged to a quad
constexpr double thin_merge_angle = 75;  ///< degrees, if one of the triangles is thin
constexpr int needle_rounds = 12;
constexpr double degree = std::numbers::pi / 180;

struct Candidate {
  Vector3 position;
  Index solid, vertex;
};

/// Turns the vertex normal n towards the mean of the faces' normals until m . n >= limit for the normal m of
/// every face; leaves it where that is impossible.
void guard_frame(CageVertex& vertex, const std::vector<std::pair<Vector3, double>>& faces) {
  const auto fits = [&](const Vector3& n) {
    return std::ranges::all_of(faces, [&](const auto& face) { return face.first.dot(n) >= face.second; });
  };
  if (fits(vertex.normal)) return;
  Vector3 mean = Vector3::Zero();
  for (const auto& face : faces) mean += face.first;
  mean = mean.stableNormalized();
  const auto blend = [&](double x) -> Vector3 {
    return ((1 - x) * vertex.normal + x * mean).stableNormalized();
  };
  double low = 0, high = 1;
  for (int round = 0; round < 20; ++round) {
    const double x = 0.5 * (low + high);
    (fits(blend(x)) ? high : low) = x;
  }
  const Vector3 n = blend(high);
  if (!(n.dot(vertex.radial) > 0.1)) return;
  vertex.normal = n;
  vertex.guarded = true;
}

/// Solid of all corners of a loop; no_index where they belong to several.
Index common_solid(const std::vector<CageVertex>& vertices, const std::vector<Index>& loop) {
  const Index solid = vertices[loop[0]].solid;
  const bool same = std::ranges::all_of(loop, [&](Index v) { return vertices[v].solid == solid; });
  return same ? solid : no_index;
}

class HullCageBuilder {
 public:
  HullCageBuilder(std::span<const NetworkSolid> solids, double size) : solids_(solids), size_(size) {}

  NetworkCage build() {
    collect();
    std::vector<Index> kept = thinned();
    if (!make_faces(kept)) return {};
    for (int round = 0; round < needle_rounds; ++round) {
      const NetworkCage before = cage_;
      if (!remove_needle(kept)) break;
      // Without the needle's corner the others may lie in a plane.
      if (!make_faces(kept)) {
        cage_ = before;
        break;
      }
    }
    return compact();
  }

 private:
  void collect() {
    const double near = duplicate_distance * size_;
    for (Index s = 0; s < solids_.size(); ++s) {
      const NetworkSolid& solid = solids_[s];
      for (Index v = 0; v < solid.unit_vertices.size(); ++v)
        all_.push_back({solid.world(solid.unit_vertices[v]), s, v});
    }
    // Among duplicates the one of the lowest solid stays: compares within cells of a sorted axis.
    const std::vector<Index> order = stable_order(
        all_.size(), [&](Index a, Index b) { return all_[a].position.x() < all_[b].position.x(); });
    std::vector<char> gone(all_.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (all_[order[j]].position.x() - all_[order[i]].position.x() > near) break;
        if ((all_[order[j]].position - all_[order[i]].position).norm() <= near)
          gone[std::max(order[i], order[j])] = 1;
      }
    std::vector<Candidate> left;
    for (Index i = 0; i < all_.size(); ++i)
      if (!gone[i]) left.push_back(all_[i]);
    std::vector<Vector3> positions;
    for (const Candidate& c : left) positions.push_back(c.position);
    all_.clear();
    for (const Index v : tolerant_hull(positions, hull_tolerance * size_).vertices) all_.push_back(left[v]);
  }

  /// Extent of the corners along the axis along which they spread least.
  double width(const Vector3& mean) const {
    Matrix3 spread = Matrix3::Zero();
    for (const Candidate& c : all_) spread += (c.position - mean) * (c.position - mean).transpose();
    const Vector3 axis = symmetric_axes(spread).vectors.col(0);
    double low = 0, high = 0;
    for (const Candidate& c : all_) {
      low = std::min(low, axis.dot(c.position - mean));
      high = std::max(high, axis.dot(c.position - mean));
    }
    return high - low;
  }

  std::vector<Index> thinned() {
    Vector3 mean = Vector3::Zero();
    for (const Candidate& c : all_) mean += c.position / double(all_.size());
    // Distances that differ by rounding count as equal, and the order is then that of the indices, so that a
    // symmetric scene does not depend on the last bit.
    const auto distance = [&](Index i) {
      return std::round((all_[i].position - mean).norm() / (1e-9 * size_));
    };
    const double apart = std::min(thinning * size_, thinning_of_width * width(mean));
    std::vector<Index> kept;
    for (const Index i :
         stable_order(all_.size(), [&](Index a, Index b) { return distance(a) > distance(b); }))
      if (std::ranges::all_of(kept,
                              [&](Index k) { return (all_[k].position - all_[i].position).norm() > apart; }))
        kept.push_back(i);
    std::ranges::sort(kept);
    return kept;
  }

  bool make_faces(const std::vector<Index>& kept) {
    if (!triangulate(kept)) return false;
    set_frames();
    merge_flat();
    merge_pairs();
    return true;
  }

  bool triangulate(const std::vector<Index>& kept) {
    std::vector<Vector3> positions;
    for (const Index k : kept) positions.push_back(all_[k].position);
    const TolerantHull hull = tolerant_hull(positions, hull_tolerance * size_);
    cage_ = {};
    for (const Index k : kept) {
      const NetworkSolid& solid = solids_[all_[k].solid];
      CageVertex vertex;
      vertex.solid = all_[k].solid;
      vertex.position = all_[k].position;
      vertex.unit = solid.unit_vertices[all_[k].vertex];
      vertex.radial = (vertex.position - solid.centre).stableNormalized();
      vertex.normal = (solid.to_unit.transpose() * vertex.unit).stableNormalized();
      cage_.vertices.push_back(vertex);
    }
    for (const auto& t : hull.triangles) cage_.faces.push_back({{t[0], t[1], t[2]}, no_index});
    return !cage_.faces.empty();
  }

  const Vector3& position(Index v) const { return cage_.vertices[v].position; }
  Vector3 normal_of(const std::vector<Index>& loop) const {
    return newell_normal(loop.size(), [&](std::size_t i) { return position(loop[i]); }).stableNormalized();
  }

  void set_frames() {
    std::vector<std::vector<std::pair<Vector3, double>>> faces(cage_.vertices.size());
    for (const CageFace& face : cage_.faces) {
      const Vector3 m = normal_of(face.loop);
      const bool own = common_solid(cage_.vertices, face.loop) != no_index;
      for (const Index v : face.loop) faces[v].emplace_back(m, own ? 0.02 : 0.2);
    }
    for (std::size_t v = 0; v < faces.size(); ++v) guard_frame(cage_.vertices[v], faces[v]);
  }

  void index_edges() {
    at_.clear();
    valence_.assign(cage_.vertices.size(), 0);
    for (Index f = 0; f < cage_.faces.size(); ++f) {
      const auto& loop = cage_.faces[f].loop;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        at_[{loop[i], loop[(i + 1) % loop.size()]}] = f;
        ++valence_[loop[i]];
      }
    }
  }

  /// Loop of two faces without their common edge a-b; empty where the result is not a simple loop.
  std::vector<Index> merged(Index f, Index g, Index a, Index b) const {
    std::vector<Index> out;
    const auto append = [&](const std::vector<Index>& loop, Index from) {
      const auto start = std::size_t(std::find(loop.begin(), loop.end(), from) - loop.begin());
      for (std::size_t k = 0; k + 1 < loop.size(); ++k) out.push_back(loop[(start + k) % loop.size()]);
    };
    append(cage_.faces[f].loop, b);  // b ... before a
    append(cage_.faces[g].loop, a);  // a ... before b
    if (std::set<Index>(out.begin(), out.end()).size() < out.size()) return {};
    return out;
  }

  /// Quality of a loop: the least sine of the turns about its normal, and of the sectors between the
  /// tangents.
  double quality(const std::vector<Index>& loop) const {
    const Vector3 n = normal_of(loop);
    double least = 1;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const CageVertex& v = cage_.vertices[loop[i]];
      const Vector3 next = position(loop[(i + 1) % loop.size()]) - v.position;
      const Vector3 before = position(loop[(i + loop.size() - 1) % loop.size()]) - v.position;
      least = std::min(least, next.stableNormalized().cross(before.stableNormalized()).dot(n));
      least = std::min(least, v.tangent(next).cross(v.tangent(before)).dot(v.normal));
      least = std::min(least, n.dot(v.normal));
    }
    return least;
  }

  double dihedral(Index f, Index g) const {
    const Vector3 m = normal_of(cage_.faces[f].loop), n = normal_of(cage_.faces[g].loop);
    return angle_between(m, n) / degree;
  }

  /// Gives the first of two faces the loop without their common edge a-b, and empties the other one.
  void replace(Index f, Index g, Index a, Index b, std::vector<Index> loop) {
    const Index kept = std::min(f, g);
    at_.erase({a, b});
    at_.erase({b, a});
    --valence_[a];
    --valence_[b];
    for (std::size_t i = 0; i < loop.size(); ++i) at_[{loop[i], loop[(i + 1) % loop.size()]}] = kept;
    cage_.faces[std::max(f, g)].loop.clear();
    cage_.faces[kept].loop = std::move(loop);
  }

  void merge_flat() {
    index_edges();
    bool again = true;
    while (again) {
      again = false;
      for (const auto& [edge, f] : at_) {
        const auto [a, b] = edge;
        if (a > b) continue;
        const Index g = at_.at({b, a});
        if (f == g || !(dihedral(f, g) < flat_angle) || valence_[a] < 4 || valence_[b] < 4) continue;
        std::vector<Index> loop = merged(f, g, a, b);
        if (loop.empty() || !(quality(loop) >= 0.01)) continue;
        replace(f, g, a, b, std::move(loop));
        again = true;
        break;
      }
    }
  }

  /// Square of the length of side i of a triangle.
  double square_side(const std::vector<Index>& t, std::size_t i) const {
    return (position(t[i]) - position(t[(i + 1) % 3])).squaredNorm();
  }
  /// Thinness of a triangle, 2 area / longest^2.
  double thinness(const std::vector<Index>& t) const {
    const double longest = std::max({square_side(t, 0), square_side(t, 1), square_side(t, 2)});
    return area_vector(position(t[0]), position(t[1]), position(t[2])).norm() / longest;
  }

  void merge_triangles(Index a, Index b) {
    const auto at_f = at_.find({a, b}), at_g = at_.find({b, a});
    if (at_f == at_.end() || at_g == at_.end() || valence_[a] < 4 || valence_[b] < 4) return;
    const Index f = at_f->second, g = at_g->second;
    if (cage_.faces[f].loop.size() != 3 || cage_.faces[g].loop.size() != 3) return;
    if (std::vector<Index> loop = merged(f, g, a, b); !loop.empty()) replace(f, g, a, b, std::move(loop));
  }

  void merge_pairs() {
    std::vector<std::tuple<double, Index, Index>> pairs;  // the best score first
    for (const auto& [edge, f] : at_) {
      const auto [a, b] = edge;
      if (a > b) continue;
      const Index g = at_.at({b, a});
      const auto &lf = cage_.faces[f].loop, &lg = cage_.faces[g].loop;
      if (lf.size() != 3 || lg.size() != 3) continue;
      const bool thin = thinness(lf) < 0.25 || thinness(lg) < 0.25;
      const double angle = dihedral(f, g);
      if (!(angle < (thin ? thin_merge_angle : merge_angle))) continue;
      const std::vector<Index> loop = merged(f, g, a, b);
      if (loop.empty()) continue;
      const double q = quality(loop);
      if (!(q >= 0.15)) continue;
      double perimeter = 0;
      for (std::size_t i = 0; i < 4; ++i)
        perimeter += (position(loop[i]) - position(loop[(i + 1) % 4])).norm();
      const double diagonal = (position(a) - position(b)).norm();
      pairs.emplace_back(-std::round((q * (1 - angle / 90) + diagonal / perimeter) * 1e9) / 1e9, a, b);
    }
    std::ranges::sort(pairs);
    for (const auto& [score, a, b] : pairs) merge_triangles(a, b);
    std::erase_if(cage_.faces, [](const CageFace& face) { return face.loop.empty(); });
  }

  /// Removes the apex above the longest side of the thinnest triangle; false if no triangle is thin.
  bool remove_needle(std::vector<Index>& kept) const {
    if (kept.size() < 6) return false;
    double thinnest = 0.13;
    Index drop = no_index;
    for (const CageFace& face : cage_.faces) {
      if (face.loop.size() != 3) continue;
      const double thin = thinness(face.loop);
      if (!(thin < thinnest)) continue;
      std::size_t longest = 0;
      for (const std::size_t i : {1U, 2U})
        if (square_side(face.loop, i) > square_side(face.loop, longest)) longest = i;
      const Vector3& a = position(face.loop[longest]);
      const Vector3 side = position(face.loop[(longest + 1) % 3]) - a;
      const Index tip = face.loop[(longest + 2) % 3];
      const double foot = (position(tip) - a).dot(side) / side.squaredNorm();
      if (foot < 0.08 || foot > 0.92) continue;
      thinnest = thin;
      drop = kept[tip];
    }
    if (drop == no_index) return false;
    std::erase(kept, drop);
    return true;
  }

  NetworkCage compact() {
    std::vector<Index> number(cage_.vertices.size(), no_index);
    NetworkCage out;
    for (const CageFace& face : cage_.faces)
      for (const Index v : face.loop) number[v] = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (number[v] == 0) {
        number[v] = Index(out.vertices.size());
        out.vertices.push_back(cage_.vertices[v]);
      }
    for (CageFace& face : cage_.faces) {
      for (Index& v : face.loop) v = number[v];
      face.solid = common_solid(out.vertices, face.loop);
      out.faces.push_back(std::move(face));
    }
    return out;
  }

  std::span<const NetworkSolid> solids_;
  double size_;
  std::vector<Candidate> all_;
  NetworkCage cage_;
  std::map<std::pair<Index, Index>, Index> at_;
  std::vector<int> valence_;
};

}  // namespace

Vector3 CageVertex::tangent(const Vector3& chord) const {
  const double rounding = 1e-9 * chord.norm();
  const Vector3 along = chord - normal.dot(chord) / normal.dot(radial) * radial;
  if (along.norm() > rounding) return along.stableNormalized();
  const Vector3 flat = chord - normal.dot(chord) * normal;
  return flat.norm() > rounding ? flat.stableNormalized() : Vector3(Vector3::Zero());
}

NetworkCage hull_cage(std::span<const NetworkSolid> solids, double size) {
  return HullCageBuilder(solids, size).build();
}

}  // namespace hariko
