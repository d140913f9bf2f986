#include "core/envelope/violations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/envelope/grid_summit.hpp"
#include "core/envelope/sample_blocks.hpp"

namespace hariko {

namespace {

/// By how much `PlacedSolid::inside` changes at most over a length of 1 of the unit frame: that of a cone.
constexpr double steepest_inside = 1.1181;

/// How long ago neighbours of a test point were tested: on edges the last one, on spirals with the golden
/// angle Fibonacci numbers. What is nearest to them is near to the point.
constexpr std::size_t neighbours[] = {1, 13, 21};

class ViolationFinder {
 public:
  ViolationFinder(const CurveNetwork& network, std::span<const PlacedSolid> solids, double tolerance,
                  const EnvelopeGrid& grid, ListedViolations which)
      : network_(network),
        solids_(solids),
        tolerance_(tolerance),
        which_(which),
        grid_(grid),
        nodes_(grid.point_count()),
        samples_(grid.intervals() + 1, network.patches.size()) {}

  Violations find() {
    for (Index p = 0; p < network_.patches.size(); ++p) {
      grid_.evaluate(network_.patches[p], nodes_);
      samples_.add_patch(nodes_);
      for (Index s = 0; s < solids_.size(); ++s) test_patch(p, s);
    }
    for (Index s = 0; s < solids_.size(); ++s)
      for (const Vector3& z : solids_[s].test_points) test_point(s, z);
    return std::move(out_);
  }

 private:
  /// No point of the ball is deeper in the solid.
  static double deepest_in(const PlacedSolid& solid, const Ball& ball) {
    const Vector3 unit = solid.to_unit * (ball.centre - solid.centre);
    return solid.inside(unit) * solid.least_stretch + steepest_inside * ball.radius;
  }

  struct Deepest {
    double depth = -1e300;
    std::uint32_t node = 0;
  };
  /// Of the patch that is tested.
  Deepest deepest_of(const PlacedSolid& solid, std::uint32_t block) const {
    Deepest out;
    // Thin round solids reach through large patches between the samples.
    const bool is_round = solid.is_round();
    for (std::uint32_t k = 0; k < samples_.block_size(block); ++k) {
      const std::uint32_t node = samples_.node(block * SampleBlocks::room + k);
      const Vector3& at = nodes_[node];
      if (const double depth = is_round ? solid.level(at) : solid.depth(at); depth > out.depth)
        out = {depth, node};
    }
    if (is_round) out.depth += rise_beside(solid, out);
    return out;
  }

  /// How much deeper the solid is between a sample and its neighbours than at the sample.
  double rise_beside(const PlacedSolid& solid, const Deepest& sample) const {
    const int n = samples_.side(), column = int(sample.node) % n, row = int(sample.node) / n;
    NeighbourValues values;
    for (int k = 0; k < 9; ++k) {
      const int right = column + k % 3 - 1, up = row + k / 3 - 1;
      const bool there = right >= 0 && right < n && up >= 0 && up < n;
      values[std::size_t(k)] = !there   ? std::numeric_limits<double>::quiet_NaN()
                               : k == 4 ? sample.depth
                                        : solid.level(nodes_[std::size_t(up * n + right)]);
    }
    return summit_beside(values).rise;
  }

  void test_patch(Index patch, Index s) {
    const PlacedSolid& solid = solids_[s];
    const Ball& ball = samples_.ball(patch);
    const double far = solid.reach + ball.radius;
    if ((ball.centre - solid.centre).squaredNorm() > far * far || deepest_in(solid, ball) <= 0) return;
    if (which_ == ListedViolations::all) return test_blocks(patch, s);
    double deepest = 0;
    Vector3 place = Vector3::Zero();
    for (std::uint32_t block = 0; block < samples_.block_count(); ++block) {
      if (deepest_in(solid, samples_.ball(patch, block)) <= deepest) continue;
      const Deepest found = deepest_of(solid, block);
      if (found.depth > deepest) deepest = found.depth, place = nodes_[found.node];
    }
    out_.worst = std::max(out_.worst, deepest);
    if (!(deepest > tolerance_)) return;
    const Index face = network_.patch_places[patch].face;
    const auto known = std::find_if(out_.in_solid.begin(), out_.in_solid.end(),
                                    [&](const auto& v) { return v.face == face && v.solid == s; });
    if (known == out_.in_solid.end())
      out_.in_solid.push_back({face, s, deepest, place});
    else if (deepest > known->depth)
      known->depth = deepest, known->point = place;
  }

  void test_blocks(Index patch, Index s) {
    const PlacedSolid& solid = solids_[s];
    const Index face = network_.patch_places[patch].face;
    for (std::uint32_t block = 0; block < samples_.block_count(); ++block) {
      if (deepest_in(solid, samples_.ball(patch, block)) <= 0) continue;
      const Deepest found = deepest_of(solid, block);
      out_.worst = std::max(out_.worst, found.depth);
      if (found.depth > tolerance_) out_.in_solid.push_back({face, s, found.depth, nodes_[found.node]});
    }
  }

  struct Near {
    double square = 1e300;
    Index patch = 0;
    std::uint32_t sample = 0;
  };
  /// Ascending by distance.
  template <std::size_t N>
  using Nearest = std::array<Near, N>;

  void scan(Index patch, std::uint32_t block, const Vector3& z, Nearest<1>& near) const {
    const SampleBlocks::Squares squares = samples_.squares_from(patch, block, z);
    const double least = squares.minCoeff();
    if (!(least < near[0].square)) return;
    const auto first = std::uint32_t(std::find(squares.begin(), squares.end(), least) - squares.begin());
    near[0] = {least, patch, block * SampleBlocks::room + first};
  }
  template <std::size_t N>
  void scan(Index patch, std::uint32_t block, const Vector3& z, Nearest<N>& near) const {
    const SampleBlocks::Squares squares = samples_.squares_from(patch, block, z);
    for (std::uint32_t k = 0; k < samples_.block_size(block); ++k) {
      const double square = squares[k];
      if (square >= near[N - 1].square) continue;
      std::size_t at = N - 1;
      while (at > 0 && near[at - 1].square > square) near[at] = near[at - 1], --at;
      near[at] = {square, patch, block * SampleBlocks::room + k};
    }
  }

  template <std::size_t N>
  void take_near(Index patch, const Vector3& z, Nearest<N>& near) const {
    samples_.visit(patch, z, near[N - 1].square, [&](std::uint32_t block) { scan(patch, block, z, near); });
  }

  /// Surely below the tangent plane at a sample, by the plane through its neighbours: within 60 degrees of
  /// straight below it. That is cheaper than the patch's normal.
  bool is_well_below(const Near& near, const Vector3& z) const {
    const int n = samples_.side(), node = int(samples_.node(near.sample));
    const int column = std::clamp(node % n, 1, n - 2), row = std::clamp(node / n, 1, n - 2);
    const auto at = [&](int i, int j) { return samples_.at_node(near.patch, std::uint32_t(j * n + i)); };
    const Vector3 normal =
        (at(column + 1, row) - at(column - 1, row)).cross(at(column, row + 1) - at(column, row - 1));
    const Vector3 offset = z - samples_.position(near.patch, near.sample);
    const double height = offset.dot(normal);
    return height < 0 && height * height > 0.25 * offset.squaredNorm() * normal.squaredNorm();
  }

  double height(const Near& near, const Vector3& z) const {
    const std::uint32_t node = samples_.node(near.sample), n = std::uint32_t(samples_.side());
    return (z - samples_.position(near.patch, near.sample))
        .dot(grid_.normal(network_.patches[near.patch], node % n, node / n));
  }

  /// Takes what is nearer to the point than what is known; `bounds_` are of all patches. The nearest patch
  /// first: it rules out nearly all others.
  template <std::size_t N>
  void take_nearest(const Vector3& z, Nearest<N>& near) const {
    Eigen::Index first = 0;
    bounds_.minCoeff(&first);
    take_near(Index(first), z, near);
    for (Eigen::Index p = 0; p < bounds_.size(); ++p)
      if (p != first && bounds_[p] * bounds_[p] < near[N - 1].square) take_near(Index(p), z, near);
  }

  void test_point(Index solid, const Vector3& z) {
    samples_.bounds_from(z, bounds_);
    Nearest<1> nearest;
    for (const std::size_t back : neighbours) {
      if (back > found_.size()) break;
      const Near& known = found_[found_.size() - back];
      const double square = (samples_.position(known.patch, known.sample) - z).squaredNorm();
      if (square < nearest[0].square) nearest[0] = {square, known.patch, known.sample};
    }
    take_nearest(z, nearest);
    found_.push_back(nearest[0]);
    // Most points lie below the tangent plane of the nearest sample, which is enough.
    if (is_well_below(nearest[0], z) || height(nearest[0], z) <= 0) return;
    Nearest<4> near;
    take_nearest(z, near);
    double least = 1e300;
    for (const Near& n : near) {
      least = std::min(least, height(n, z));
      if (least <= 0) return;  // inside
    }
    out_.worst = std::max(out_.worst, least);
    if (!(least > tolerance_)) return;
    const Index face = network_.patch_places[near[0].patch].face;
    const auto known = which_ == ListedViolations::all
                           ? out_.outside.end()
                           : std::find_if(out_.outside.begin(), out_.outside.end(),
                                          [&](const auto& v) { return v.face == face && v.solid == solid; });
    if (known == out_.outside.end())
      out_.outside.push_back({face, solid, z, least});
    else if (least > known->height)
      known->height = least, known->point = z;
  }

  const CurveNetwork& network_;
  std::span<const PlacedSolid> solids_;
  double tolerance_;
  ListedViolations which_;
  const EnvelopeGrid& grid_;
  std::vector<Vector3> nodes_;  ///< of the patch that is tested
  SampleBlocks samples_;        ///< of all patches up to that one
  Violations out_;
  Eigen::ArrayXd bounds_;
  std::vector<Near> found_;  ///< nearest to the points so far
};

}  // namespace

Violations find_violations(const CurveNetwork& network, std::span<const PlacedSolid> solids, double tolerance,
                           const EnvelopeGrid& grid, ListedViolations which) {
  return ViolationFinder(network, solids, tolerance, grid, which).find();
}

}  // namespace hariko
