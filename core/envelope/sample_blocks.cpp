#include "core/envelope/sample_blocks.hpp"

#include <algorithm>

namespace hariko {

namespace {

Ball ball_round(const Vector3& low, const Vector3& high) {
  return {0.5 * (low + high), 0.5 * (high - low).norm()};
}

}  // namespace

SampleBlocks::SampleBlocks(int side, std::size_t patches) : side_(side), samples_(std::size_t(side * side)) {
  const int blocks = (side + block_side - 1) / block_side, groups = (blocks + group_side - 1) / group_side;
  group_count_ = std::size_t(groups * groups);
  for (int row = 0; row < blocks; ++row)
    for (int column = 0; column < blocks; ++column) {
      const int i0 = column * block_side, i1 = std::min(side, i0 + block_side);
      const int j0 = row * block_side, j1 = std::min(side, j0 + block_side);
      for (int j = j0; j < j1; ++j)
        for (int i = i0; i < i1; ++i) {
          samples_[std::size_t(j * side + i)] = std::uint32_t(nodes_.size());
          nodes_.push_back(std::uint32_t(j * side + i));
        }
      sizes_.push_back(std::uint32_t((j1 - j0) * (i1 - i0)));
      groups_of_.push_back(std::uint32_t(row / group_side * groups + column / group_side));
      nodes_.resize(sizes_.size() * room, nodes_.back());
    }
  coordinates_.reserve(patches * sizes_.size());
  block_balls_.reserve(patches * sizes_.size());
  groups_.reserve(patches * group_count_);
  balls_.reserve(patches);
  centres_.resize(Eigen::Index(patches), 3);
  radii_.resize(Eigen::Index(patches));
}

void SampleBlocks::add_patch(std::span<const Vector3> nodes) {
  const std::size_t first_group = groups_.size();
  groups_.resize(first_group + group_count_);
  Vector3 patch_low = nodes[0], patch_high = nodes[0];
  for (std::uint32_t b = 0; b < sizes_.size(); ++b) {
    Coordinates& coordinates = coordinates_.emplace_back();
    Vector3 low = nodes[nodes_[b * room]], high = low;
    for (std::uint32_t k = 0; k < room; ++k) {
      const Vector3& at = nodes[nodes_[b * room + k]];
      coordinates.row(k) = at.transpose();
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    block_balls_.push_back(ball_round(low, high));
    add_block(groups_[first_group + groups_of_[b]], b, low, high);
    patch_low = patch_low.cwiseMin(low);
    patch_high = patch_high.cwiseMax(high);
  }
  const Ball ball = ball_round(patch_low, patch_high);
  centres_.row(Eigen::Index(balls_.size())) = ball.centre.transpose();
  radii_[Eigen::Index(balls_.size())] = ball.radius;
  balls_.push_back(ball);
}

void SampleBlocks::add_block(Group& group, std::uint32_t block, const Vector3& low, const Vector3& high) {
  if (group.size == 0) {
    group.low = low;
    group.high = high;
    group.boxes.setZero();
  }
  group.low = group.low.cwiseMin(low);
  group.high = group.high.cwiseMax(high);
  group.boxes.row(Eigen::Index(group.size)) << low.transpose(), high.transpose();
  group.blocks[group.size++] = block;
}

void SampleBlocks::bounds_from(const Vector3& z, Eigen::ArrayXd& out) const {
  out = ((centres_.col(0) - z.x()).square() + (centres_.col(1) - z.y()).square() +
         (centres_.col(2) - z.z()).square())
            .sqrt() -
        radii_;
  out = out.max(0.0);
}

}  // namespace hariko
