#include "core/surface/triangle_net.hpp"

#include <cmath>
#include <memory>
#include <mutex>

#include "core/base/assert.hpp"

namespace hariko {

int polynomial_degree(const PatchSet& patches, Index patch) {
  const ExactForm form = patches.exact_form(patch);
  const auto* bezier = std::get_if<BezierPatch>(&form);
  const bool polynomial = std::holds_alternative<BicubicPatch>(form) || (bezier && !bezier->rational());
  return polynomial ? patches.hull_degree(patch) : 0;
}

TriangleNet::TriangleNet(int degree) : degree_(degree) {
  HARIKO_ASSERT(degree >= 1 && degree <= max_degree, "degree out of range");
  const GridPattern grid{Domain::triangle, degree};
  count_ = std::size_t(grid.point_count());
  for (int side = 0; side < 3; ++side)
    for (int k = 0; k <= degree; ++k)
      for (int i = 0; i + k <= degree; ++i) {
        std::array<int, 3> power{};
        power[std::size_t(side)] = degree - k - i;
        power[std::size_t((side + 1) % 3)] = i;
        power[std::size_t((side + 2) % 3)] = k;
        rows_[std::size_t(side)].push_back(grid.index(power[1], power[2]));
      }
  weights_.resize(count_ * sample_count);
  for (std::size_t s = 0; s < sample_count; ++s) {
    std::array<double, 3> at{};
    const std::size_t side = s / 3;
    if (s < 9) {
      at[(side + 1) % 3] = double(s % 3 + 1) / 4;
      at[side] = 1 - at[(side + 1) % 3];
    } else {
      at = {0.25, 0.25, 0.25};
      at[s - 9] = 0.5;
    }
    for (int l = 0; l <= degree; ++l)
      for (int k = 0; k + l <= degree; ++k) {
        const int m = degree - k - l;
        double weight = std::pow(at[0], m) * std::pow(at[1], k) * std::pow(at[2], l);
        for (int i = 1; i <= degree; ++i) weight *= i;
        for (const int part : {k, l, m})
          for (int i = 1; i <= part; ++i) weight /= i;
        weights_[std::size_t(grid.index(k, l)) * sample_count + s] = weight;
      }
  }
}

namespace {

/// De Casteljau's steps on one row of m + 1 control points. The coordinates of all points are stored
/// consecutively, so that a step is one sum of long vectors; run-time lengths cost nothing there and keep
/// compile time low.
void split_row(int m, const int* at, double t, const Vector3* net, Vector3* first, Vector3* second) {
  std::array<double, 3 * (TriangleNet::max_degree + 1)> row{};
  const auto store = [&](Vector3& to, int i) {
    to = Eigen::Map<const Vector3>(row.data() + std::ptrdiff_t(3) * i);
  };
  for (int i = 0; i <= m; ++i) Eigen::Map<Vector3>(row.data() + std::ptrdiff_t(3) * i) = net[at[i]];
  store(first[at[0]], 0);
  store(second[at[m]], m);
  for (int r = 1; r <= m; ++r) {
    const std::size_t length = 3 * std::size_t(m - r + 1);
    for (std::size_t i = 0; i < length; ++i) row[i] += t * (row[i + 3] - row[i]);
    store(first[at[r]], 0);
    store(second[at[m - r]], m - r);
  }
}

}  // namespace

void TriangleNet::split(int side, double t, const Vector3* net, Vector3* first, Vector3* second) const {
  const int* at = rows_[std::size_t(side)].data();
  for (int m = degree_; m >= 0; at += m + 1, --m) split_row(m, at, t, net, first, second);
}

void TriangleNet::samples(const Vector3* net, std::span<Vector3, sample_count> out) const {
  // One coordinate at a time, so that its sums stay in registers.
  using Sums = Eigen::Array<double, int(sample_count), 1>;
  std::array<Sums, 3> sums;
  for (int axis = 0; axis < 3; ++axis) {
    Sums sum = Sums::Zero();
    for (std::size_t i = 0; i < count_; ++i)
      sum += Eigen::Map<const Sums>(weights_.data() + i * sample_count) * net[i][axis];
    sums[std::size_t(axis)] = sum;
  }
  for (std::size_t s = 0; s < sample_count; ++s)
    out[s] = Vector3(sums[0][Eigen::Index(s)], sums[1][Eigen::Index(s)], sums[2][Eigen::Index(s)]);
}

const TriangleNet& triangle_net(int degree) {
  static std::array<std::once_flag, TriangleNet::max_degree + 1> made;
  static std::array<std::unique_ptr<const TriangleNet>, TriangleNet::max_degree + 1> nets;
  HARIKO_ASSERT(degree >= 1 && degree <= TriangleNet::max_degree, "degree out of range");
  const auto at = std::size_t(degree);
  std::call_once(made[at], [&] { nets[at] = std::make_unique<const TriangleNet>(degree); });
  return *nets[at];
}

}  // namespace hariko
