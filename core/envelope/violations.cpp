#include "core/envelope/violations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/envelope/grid_summit.hpp"

namespace hariko {

namespace {

constexpr int block_side = 5;  ///< samples
/// By how much `PlacedSolid::inside` changes at most over a length of 1 of the unit frame: that of a cone.
constexpr double steepest_inside = 1.1181;

/// How long ago neighbours of a test point were tested: on edges the last one, on spirals with the golden
/// angle Fibonacci numbers. What is nearest to them is near to the point.
constexpr std::size_t neighbours[] = {1, 13, 21};

struct Ball {
  Vector3 centre = Vector3::Zero();
  double radius = 0;
};

Ball ball_round(const Vector3& low, const Vector3& high) {
  return {0.5 * (low + high), 0.5 * (high - low).norm()};
}

/// Samples of one build in blocks of neighbours, patch by patch.
class Samples {
 public:
  struct Block {
    Ball ball;
    std::uint32_t begin = 0, end = 0;  ///< into `nodes` and, from the patch's first sample on, `positions`
  };

  Samples(const CurveNetwork& network, const EnvelopeGrid& grid) : network_(network), grid_(grid) {
    const int n = grid.intervals() + 1;
    for (int j = 0; j < n; j += block_side)
      for (int i = 0; i < n; i += block_side) {
        Block block;
        block.begin = std::uint32_t(nodes_.size());
        for (int b = j; b < std::min(n, j + block_side); ++b)
          for (int a = i; a < std::min(n, i + block_side); ++a) nodes_.push_back(std::uint32_t(b * n + a));
        block.end = std::uint32_t(nodes_.size());
        pattern_.push_back(block);
      }
    places_.resize(nodes_.size());
    for (std::uint32_t k = 0; k < nodes_.size(); ++k) places_[nodes_[k]] = k;
    positions_.resize(nodes_.size() * network.patches.size());
    std::vector<Vector3> rows(nodes_.size());
    for (std::size_t p = 0; p < network.patches.size(); ++p) {
      grid.evaluate(network.patches[p], rows);
      Vector3 patch_low = rows[0], patch_high = rows[0];
      for (Block block : pattern_) {
        Vector3 low = rows[nodes_[block.begin]], high = low;
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
          const Vector3& at = rows[nodes_[k]];
          positions_[p * nodes_.size() + k] = at;
          low = low.cwiseMin(at);
          high = high.cwiseMax(at);
        }
        block.ball = ball_round(low, high);
        blocks_.push_back(block);
        patch_low = patch_low.cwiseMin(low);
        patch_high = patch_high.cwiseMax(high);
      }
      balls_.push_back(ball_round(patch_low, patch_high));
    }
    centres_.resize(Eigen::Index(balls_.size()), 3);
    radii_.resize(Eigen::Index(balls_.size()));
    for (std::size_t p = 0; p < balls_.size(); ++p) {
      centres_.row(Eigen::Index(p)) = balls_[p].centre.transpose();
      radii_[Eigen::Index(p)] = balls_[p].radius;
    }
  }

  Index patch_count() const { return Index(balls_.size()); }
  const Ball& ball(Index patch) const { return balls_[patch]; }
  /// No sample of a patch is nearer to the point.
  void bounds_from(const Vector3& z, Eigen::ArrayXd& out) const {
    out = ((centres_.col(0) - z.x()).square() + (centres_.col(1) - z.y()).square() +
           (centres_.col(2) - z.z()).square())
              .sqrt() -
          radii_;
    out = out.max(0.0);
  }
  std::span<const Block> blocks(Index patch) const {
    return std::span(blocks_).subspan(patch * pattern_.size(), pattern_.size());
  }
  const Vector3& position(Index patch, std::uint32_t k) const {
    return positions_[patch * nodes_.size() + k];
  }
  std::uint32_t side() const { return std::uint32_t(grid_.intervals()) + 1; }
  std::uint32_t node(std::uint32_t k) const { return nodes_[k]; }
  const Vector3& at_node(Index patch, std::uint32_t node) const { return position(patch, places_[node]); }
  /// Unit, computed when asked for; zero where there is none.
  Vector3 normal(Index patch, std::uint32_t k) const {
    return grid_.normal(network_.patches[patch], nodes_[k] % side(), nodes_[k] / side());
  }

 private:
  const CurveNetwork& network_;
  const EnvelopeGrid& grid_;
  std::vector<std::uint32_t> nodes_;   ///< numbers of the grid's nodes, block by block
  std::vector<std::uint32_t> places_;  ///< the other way round
  std::vector<Block> pattern_;         ///< without balls
  std::vector<Vector3> positions_;
  std::vector<Block> blocks_;
  std::vector<Ball> balls_;
  Eigen::ArrayX3d centres_;  ///< of the balls
  Eigen::ArrayXd radii_;
};

class ViolationFinder {
 public:
  ViolationFinder(const CurveNetwork& network, std::span<const PlacedSolid> solids, double tolerance,
                  const EnvelopeGrid& grid, ListedViolations which)
      : network_(network), solids_(solids), tolerance_(tolerance), which_(which), samples_(network, grid) {}

  Violations find() {
    for (Index p = 0; p < samples_.patch_count(); ++p)
      for (Index s = 0; s < solids_.size(); ++s) test_patch(p, s);
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
    std::uint32_t sample = 0;
  };
  Deepest deepest_of(Index patch, const PlacedSolid& solid, const Samples::Block& block) const {
    Deepest out;
    // Thin round solids reach through large patches between the samples.
    const bool is_round = solid.is_round();
    for (std::uint32_t k = block.begin; k < block.end; ++k) {
      const Vector3& at = samples_.position(patch, k);
      if (const double depth = is_round ? solid.level(at) : solid.depth(at); depth > out.depth)
        out = {depth, k};
    }
    if (is_round) out.depth += rise_beside(patch, solid, out);
    return out;
  }

  /// How much deeper the solid is between a sample and its neighbours than at the sample.
  double rise_beside(Index patch, const PlacedSolid& solid, const Deepest& sample) const {
    const int n = int(samples_.side()), node = int(samples_.node(sample.sample));
    const int column = node % n, row = node / n;
    NeighbourValues values;
    for (int k = 0; k < 9; ++k) {
      const int right = column + k % 3 - 1, up = row + k / 3 - 1;
      const bool there = right >= 0 && right < n && up >= 0 && up < n;
      values[std::size_t(k)] = !there   ? std::numeric_limits<double>::quiet_NaN()
                               : k == 4 ? sample.depth
                                        : solid.level(samples_.at_node(patch, std::uint32_t(up * n + right)));
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
    for (const Samples::Block& block : samples_.blocks(patch)) {
      if (deepest_in(solid, block.ball) <= deepest) continue;
      const Deepest found = deepest_of(patch, solid, block);
      if (found.depth > deepest) deepest = found.depth, place = samples_.position(patch, found.sample);
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
    for (const Samples::Block& block : samples_.blocks(patch)) {
      if (deepest_in(solid, block.ball) <= 0) continue;
      const Deepest found = deepest_of(patch, solid, block);
      out_.worst = std::max(out_.worst, found.depth);
      if (found.depth > tolerance_)
        out_.in_solid.push_back({face, s, found.depth, samples_.position(patch, found.sample)});
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

  template <std::size_t N>
  void scan(Index patch, const Samples::Block& block, const Vector3& z, Nearest<N>& near) const {
    for (std::uint32_t k = block.begin; k < block.end; ++k) {
      const double square = (samples_.position(patch, k) - z).squaredNorm();
      if (square >= near[N - 1].square) continue;
      std::size_t at = N - 1;
      while (at > 0 && near[at - 1].square > square) near[at] = near[at - 1], --at;
      near[at] = {square, patch, k};
    }
  }

  template <std::size_t N>
  void take_near(Index patch, const Vector3& z, Nearest<N>& near) const {
    double reach = std::sqrt(near[N - 1].square);
    for (const Samples::Block& block : samples_.blocks(patch)) {
      const double far = block.ball.radius + reach;
      if ((z - block.ball.centre).squaredNorm() >= far * far) continue;
      scan(patch, block, z, near);
      reach = std::sqrt(near[N - 1].square);
    }
  }

  /// Surely below the tangent plane at a sample, by the plane through its neighbours: within 60 degrees of
  /// straight below it. That is cheaper than the patch's normal.
  bool is_well_below(const Near& near, const Vector3& z) const {
    const int n = int(samples_.side()), node = int(samples_.node(near.sample));
    const int column = std::clamp(node % n, 1, n - 2), row = std::clamp(node / n, 1, n - 2);
    const auto at = [&](int i, int j) -> const Vector3& {
      return samples_.at_node(near.patch, std::uint32_t(j * n + i));
    };
    const Vector3 normal =
        (at(column + 1, row) - at(column - 1, row)).cross(at(column, row + 1) - at(column, row - 1));
    const Vector3 offset = z - samples_.position(near.patch, near.sample);
    const double height = offset.dot(normal);
    return height < 0 && height * height > 0.25 * offset.squaredNorm() * normal.squaredNorm();
  }

  double height(const Near& near, const Vector3& z) const {
    return (z - samples_.position(near.patch, near.sample)).dot(samples_.normal(near.patch, near.sample));
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
  Samples samples_;
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
