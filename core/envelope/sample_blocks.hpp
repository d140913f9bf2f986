#pragma once

// Samples of a network's patches in blocks of neighbours, and those in groups, with boxes round both: which
// blocks may hold what is nearest to a point.

#include <array>
#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"
#include "core/envelope/box_distance.hpp"

namespace hariko {

struct Ball {
  Vector3 centre = Vector3::Zero();
  double radius = 0;
};

/// Samples at the nodes of a square grid, patch by patch. Those of a patch are numbered block by block, with
/// `room` numbers each, of which the last ones may be without a sample.
class SampleBlocks {
 public:
  static constexpr int block_side = 5;       ///< samples
  static constexpr std::uint32_t room = 26;  ///< for a block's samples: even, for pairs of doubles
  using Squares = Eigen::Array<double, room, 1>;

  /// `side`: number of nodes along a side. `patches`: how many will be added.
  SampleBlocks(int side, std::size_t patches);
  /// Node i, j of a patch is the one with the number j side + i.
  void add_patch(std::span<const Vector3> nodes);

  int side() const { return side_; }
  std::uint32_t block_count() const { return std::uint32_t(sizes_.size()); }  ///< of a patch
  std::uint32_t block_size(std::uint32_t block) const { return sizes_[block]; }
  std::uint32_t node(std::uint32_t sample) const { return nodes_[sample]; }
  const Ball& ball(Index patch) const { return balls_[patch]; }
  const Ball& ball(Index patch, std::uint32_t block) const {
    return block_balls_[patch * sizes_.size() + block];
  }
  Vector3 position(Index patch, std::uint32_t sample) const {
    return coordinates_[patch * sizes_.size() + sample / room].row(sample % room).transpose();
  }
  Vector3 at_node(Index patch, std::uint32_t node) const { return position(patch, samples_[node]); }

  /// Lower bounds of the distances of all patches' samples from the point.
  void bounds_from(const Vector3& z, Eigen::ArrayXd& out) const;
  /// Squared distances of a block's samples; room that is left has that of the last sample.
  Squares squares_from(Index patch, std::uint32_t block, const Vector3& z) const {
    const Coordinates& at = coordinates_[patch * sizes_.size() + block];
    return (at.col(0) - z.x()).square() + (at.col(1) - z.y()).square() + (at.col(2) - z.z()).square();
  }
  /// Calls use(block) for the blocks of a patch that may hold a sample with a squared distance below `least`,
  /// which `use` may lower.
  template <class Use>
  void visit(Index patch, const Vector3& z, const double& least, const Use& use) const {
    for (std::size_t g = patch * group_count_; g < (patch + 1) * group_count_; ++g) {
      const Group& group = groups_[g];
      if (box_square_distance(z, group.low, group.high) >= least) continue;
      const auto bounds = squares_beyond(group.boxes, z);
      for (std::size_t b = 0; b < group.size; ++b)
        if (bounds[Eigen::Index(b)] < least) use(group.blocks[b]);
    }
  }

 private:
  static constexpr int group_side = 3;  ///< blocks
  static constexpr int group_room = 10;
  using Coordinates = Eigen::Array<double, room, 3>;
  using Boxes = Eigen::Array<double, group_room, 6>;  ///< least x, y, z and largest x, y, z
  struct Group {
    Vector3 low, high;
    std::size_t size = 0;
    std::array<std::uint32_t, group_side * group_side> blocks;
    Boxes boxes;  ///< of the blocks
  };

  void add_block(Group& group, std::uint32_t block, const Vector3& low, const Vector3& high);
  /// Monotonous in each operation, so that rounding makes no bound larger than a point's own square.
  static Eigen::Array<double, group_room, 1> squares_beyond(const Boxes& boxes, const Vector3& z) {
    const auto beyond = [&](int axis) {
      return (boxes.col(axis) - z[axis]).max(z[axis] - boxes.col(3 + axis)).max(0.0).square();
    };
    return beyond(0) + beyond(1) + beyond(2);
  }

  int side_;
  std::vector<std::uint32_t> nodes_;              ///< by numbers of samples
  std::vector<std::uint32_t> samples_;            ///< by numbers of nodes
  std::vector<std::uint32_t> sizes_, groups_of_;  ///< of a patch's blocks
  std::size_t group_count_ = 0;                   ///< of a patch
  std::vector<Coordinates> coordinates_;          ///< of each block
  std::vector<Ball> balls_, block_balls_;
  std::vector<Group> groups_;
  Eigen::ArrayX3d centres_;  ///< of the patches' balls
  Eigen::ArrayXd radii_;
};

}  // namespace hariko
