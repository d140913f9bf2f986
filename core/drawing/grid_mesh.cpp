#include "core/drawing/grid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/drawing/facet_curves.hpp"

namespace hariko {

namespace {

constexpr double same_fraction = 1e-9;  ///< difference of fractions of a side that are one
constexpr double shrunken_side = 1e-9;  ///< size of a side that is a point, relative to the surface

/// Fraction of a side at a parameter on it, the inverse of `side_parameter`.
double fraction_on_side(Domain domain, int side, const Vector2& parameter) {
  if (side == 0) return parameter.x();
  if (side == 1) return parameter.y();
  return domain == Domain::square && side == 2 ? 1 - parameter.x() : 1 - parameter.y();
}

/// Point of a side between points of the grid, which a T-joint adds.
struct AddedPoint {
  int side;
  double fraction;
  int point;
  Index item;
};

/// Points of all patches, numbered patch by patch, and which of them are one sample.
class PatchSamples {
 public:
  PatchSamples(const SurfaceGrid& grid, std::vector<Vector2>& parameters)
      : grid_(grid),
        parameters_(parameters),
        count_(Index(grid.pattern().point_count())),
        sets_(std::size_t(grid.surface().patch_count()) * count_) {
    sides_of_.assign(count_, 0);
    for (int side = 0; side < corner_count(grid.pattern().domain); ++side) {
      sides_.push_back(grid.pattern().side(side));
      for (const int point : sides_.back()) sides_of_[std::size_t(point)] |= bit_of(side);
    }
    for (const Seam& seam : grid.surface().seams()) {
      add_part(seam.first, seam.first_begin, seam.first_end, seam.second, seam.second_begin, seam.second_end);
      add_part(seam.second, seam.second_begin, seam.second_end, seam.first, seam.first_begin, seam.first_end);
    }
    join_shrunken_sides();
  }

  /// Positions of the samples; numbers them.
  std::vector<Vector3> take_samples() {
    std::vector<Vector3> out;
    numbers_.resize(sets_.size());
    for (Index item = 0; item < sets_.size(); ++item) {
      const Index least = sets_.find(item);
      // The least item is a point of the grid: added points are joined with one.
      if (least == item) out.push_back(grid_.position(item / count_, int(item % count_)));
      numbers_[item] = least == item ? Index(out.size() - 1) : numbers_[least];
    }
    return out;
  }

  /// Appends the triangles of a patch over a triangle of points, with the added points on its edges as
  /// corners. Call after `take_samples`.
  void add_triangles(Index patch, const std::array<int, 3>& points,
                     std::vector<GridMesh::Triangle>& out) const {
    const auto found = added_.find(patch);
    if (found != added_.end())
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = points[k], b = points[(k + 1) % 3], c = points[(k + 2) % 3];
        if (const AddedPoint* between = point_between(found->second, a, b)) {
          add_triangles(patch, {a, between->point, c}, out);
          add_triangles(patch, {between->point, b, c}, out);
          return;
        }
      }
    std::array<Index, 3> samples{};
    for (std::size_t k = 0; k < 3; ++k) samples[k] = numbers_[item_of(patch, points[k])];
    if (samples[0] == samples[1] || samples[1] == samples[2] || samples[2] == samples[0]) return;
    std::array<bool, 3> inside{};
    for (std::size_t k = 0; k < 3; ++k) inside[k] = is_inside(patch, points[k], points[(k + 1) % 3]);
    out.push_back({patch, samples, points, inside});
  }

 private:
  static std::uint8_t bit_of(int side) { return std::uint8_t(1U << unsigned(side)); }

  /// Whether an edge is inside its patch. An edge from a side that has shrunk to a point may lie on the next
  /// side.
  bool is_inside(Index patch, int a, int b) const {
    const std::uint8_t at_a = sides_of_[std::size_t(a)], at_b = sides_of_[std::size_t(b)];
    if ((at_a & at_b) != 0) return false;
    const auto found = shrunken_.find(patch);
    return found == shrunken_.end() || ((at_a | at_b) & found->second) == 0;
  }

  Index item_of(Index patch, int point) const {
    if (Index(point) < count_) return patch * count_ + Index(point);
    return added_items_[std::size_t(point) - count_];
  }

  /// Item at a fraction of a side, added where the grid has no point there.
  Index item_at(const PatchSide& side, double fraction) {
    const int density = grid_.pattern().density, k = int(std::lround(fraction * density));
    if (std::abs(grid_fraction(k, density) - fraction) <= same_fraction)
      return item_of(side.patch, sides_[side.side][std::size_t(k)]);
    std::vector<AddedPoint>& own = added_[side.patch];
    for (const AddedPoint& point : own)
      if (point.side == side.side && std::abs(point.fraction - fraction) <= same_fraction) return point.item;
    own.push_back({side.side, fraction, int(parameters_.size()), sets_.add()});
    parameters_.push_back(side_parameter(grid_.pattern().domain, side.side, fraction));
    added_items_.push_back(own.back().item);
    sides_of_.push_back(bit_of(side.side));
    return own.back().item;
  }

  /// Joins the grid points on a part of a side with the points of the other side.
  void add_part(const PatchSide& side, double begin, double end, const PatchSide& other, double other_begin,
                double other_end) {
    const int density = grid_.pattern().density;
    const auto on_other = [&](double fraction) {
      const double share = std::clamp((fraction - begin) / (end - begin), 0.0, 1.0);
      return std::clamp(other_begin + share * (other_end - other_begin), 0.0, 1.0);
    };
    for (int k = 0; k <= density; ++k) {
      const double fraction = grid_fraction(k, density);
      if (fraction < std::min(begin, end) - same_fraction || fraction > std::max(begin, end) + same_fraction)
        continue;
      sets_.join(item_of(side.patch, sides_[side.side][std::size_t(k)]), item_at(other, on_other(fraction)));
    }
  }

  void join_shrunken_sides() {
    Eigen::AlignedBox3d box;
    for (Index patch = 0; patch < grid_.surface().patch_count(); ++patch)
      for (Index point = 0; point < count_; ++point) box.extend(grid_.position(patch, int(point)));
    const double near = shrunken_side * box.diagonal().norm();
    for (Index patch = 0; patch < grid_.surface().patch_count(); ++patch)
      for (int s = 0; s < int(sides_.size()); ++s) {
        const std::vector<int>& side = sides_[std::size_t(s)];
        const Vector3& first = grid_.position(patch, side.front());
        const auto at_first = [&](int point) {
          return (grid_.position(patch, point) - first).norm() <= near;
        };
        if (!std::all_of(side.begin(), side.end(), at_first)) continue;
        for (const int point : side) sets_.join(item_of(patch, side.front()), item_of(patch, point));
        shrunken_[patch] |= bit_of(s);
      }
  }

  const AddedPoint* point_between(const std::vector<AddedPoint>& own, int a, int b) const {
    const Domain domain = grid_.pattern().domain;
    const unsigned common = unsigned(sides_of_[std::size_t(a)]) & sides_of_[std::size_t(b)];
    if (common == 0) return nullptr;
    for (const AddedPoint& point : own) {
      if ((common & bit_of(point.side)) == 0 || point.point == a || point.point == b) continue;
      const double from = fraction_on_side(domain, point.side, parameters_[std::size_t(a)]),
                   to = fraction_on_side(domain, point.side, parameters_[std::size_t(b)]);
      if (point.fraction > std::min(from, to) && point.fraction < std::max(from, to)) return &point;
    }
    return nullptr;
  }

  const SurfaceGrid& grid_;
  std::vector<Vector2>& parameters_;
  Index count_;  ///< points of a patch
  DisjointSets sets_;
  std::vector<std::vector<int>> sides_;             ///< points of each side
  std::vector<std::uint8_t> sides_of_;              ///< sides that each point is on, one bit a side
  std::map<Index, std::uint8_t> shrunken_;          ///< sides of a patch that are points, one bit a side
  std::map<Index, std::vector<AddedPoint>> added_;  ///< points added to each patch that has some
  std::vector<Index> added_items_;
  std::vector<Index> numbers_;
};

}  // namespace

GridMesh::GridMesh(const SurfaceGrid& grid) : parameters_(grid.pattern().parameters()) {
  triangles_.reserve(std::size_t(grid.surface().patch_count()) * grid.triangles().size());
  if (is_facets(grid.surface()))
    share_nodes(grid);
  else
    share_seams(grid);
}

void GridMesh::share_nodes(const SurfaceGrid& grid) {
  const Surface& surface = grid.surface();
  samples_.assign(surface.node_count(), Vector3::Zero());
  std::vector<bool> used(surface.node_count(), false);
  for (Index facet = 0; facet < surface.patch_count(); ++facet)
    for (int k = 0; k < 3; ++k) {
      samples_[surface.node(facet, k)] = grid.position(facet, k);
      used[surface.node(facet, k)] = true;
    }
  std::vector<Index> order, same(samples_.size());
  for (Index node = 0; node < samples_.size(); ++node)
    if (used[node]) order.push_back(node);
  std::stable_sort(order.begin(), order.end(), [this](Index a, Index b) {
    const Vector3 &p = samples_[a], &q = samples_[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    same[order[i]] = i > 0 && samples_[order[i]] == samples_[order[i - 1]] ? same[order[i - 1]] : order[i];
  for (Index facet = 0; facet < surface.patch_count(); ++facet) {
    const std::array<Index, 3> samples{same[surface.node(facet, 0)], same[surface.node(facet, 1)],
                                       same[surface.node(facet, 2)]};
    if (samples[0] != samples[1] && samples[1] != samples[2] && samples[2] != samples[0])
      triangles_.push_back({facet, samples, {0, 1, 2}, {false, false, false}});
  }
}

void GridMesh::share_seams(const SurfaceGrid& grid) {
  PatchSamples shared(grid, parameters_);
  samples_ = shared.take_samples();
  for (Index patch = 0; patch < grid.surface().patch_count(); ++patch)
    for (const std::array<int, 3>& points : grid.triangles()) shared.add_triangles(patch, points, triangles_);
}

}  // namespace hariko
