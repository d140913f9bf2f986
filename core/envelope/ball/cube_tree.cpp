#include "core/envelope/ball/cube_tree.hpp"

namespace hariko {

namespace {

constexpr int deepest_level = 3;  ///< cubes of 2 sigma or 4 sigma end at 1/4 or 1/2 of sigma
/// Least cosine of the angle between normals in a cube: 0 occurs at edges and corners of boxes, -1 at plates
/// and needles.
constexpr double widest_spread = -0.85;
constexpr double near_share = 0.45;  ///< largest distance of tested points from the surface, in cube edges

/// Halves cubes in which the surface's normals spread too widely for one vertex.
class CubeSplitter {
 public:
  CubeSplitter(const SplineField& field, CubeTree& cubes) : field_(field), cubes_(cubes) {}

  /// Looks at all cubes of the first level. `ahead`: see `surface_cubes`.
  void look_at_all(bool ahead) {
    const std::array<int, 3>& size = cubes_.size();
    for (int k = 0; k < size[2]; ++k) {
      take_layer(k);
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i) look_at({0, {i, j, k}}, ahead);
    }
  }

 private:
  /// Place with the field there, found when it is asked for: before, the value is not a number and the normal
  /// is zero.
  struct Sample {
    Vector3 point;
    double& value;
    Vector3& normal;
  };

  void look_at(const Cube& cube, bool ahead) {
    if (cube.level >= cubes_.depth()) return;
    const double edge = cubes_.edge(cube.level);
    const Vector3 corner = cubes_.point(cubes_.low_node(cube));
    const bool here = cube.level == 0 ? spreads_in_layer(cube, edge) : spreads(corner, edge);
    if (!here && !(ahead && part_spreads(corner, 0.5 * edge))) return;
    cubes_.split(cube);
    for (int c = 0; c < 8; ++c) look_at(cube.part(c), false);
  }

  /// Prepares the normals of the cubes of one layer, which shares those between with the layer before.
  void take_layer(int k) {
    const std::size_t count = std::size_t(2 * cubes_.size()[0] + 1) * std::size_t(2 * cubes_.size()[1] + 1);
    std::swap(layer_[0], layer_[2]);
    for (std::size_t plane = k == 0 ? 0 : 1; plane < 3; ++plane) layer_[plane].assign(count, Vector3::Zero());
  }

  bool spreads_in_layer(const Cube& cube, double edge) {
    const int half = cubes_.steps(0) / 2;
    return spread(edge, [&](int c) -> Sample {
      const std::array<int, 3> n{2 * cube.at[0] + c % 3, 2 * cube.at[1] + c / 3 % 3, 2 * cube.at[2] + c / 9};
      const std::size_t at = std::size_t(n[1]) * std::size_t(2 * cubes_.size()[0] + 1) + std::size_t(n[0]);
      return {cubes_.point({half * n[0], half * n[1], half * n[2]}), cubes_.kept_value(n),
              layer_[std::size_t(c / 9)][at]};
    });
  }

  /// Whether normals spread in one of the halves of a cube.
  bool part_spreads(const Vector3& corner, double half) {
    for (int c = 0; c < 8; ++c)
      if (spreads(corner + half * Vector3(c & 1, c >> 1 & 1, c >> 2), half)) return true;
    return false;
  }

  bool spreads(const Vector3& corner, double edge) {
    std::array<double, 27> values;
    std::array<Vector3, 27> normals;
    values.fill(std::numeric_limits<double>::quiet_NaN());
    normals.fill(Vector3::Zero());
    return spread(edge, [&](int c) -> Sample {
      const auto at = std::size_t(c);
      return {corner + 0.5 * edge * Vector3(c % 3, c / 3 % 3, c / 9), values[at], normals[at]};
    });
  }

  /// Whether normals spread among 27 points of a cube, whose samples place(c) gives.
  template <class Place>
  bool spread(double edge, const Place& place) {
    constexpr int middle = 13;
    if (std::abs(value_at(place(middle))) > std::sqrt(3.0) * 0.5 * edge) return false;
    normals_.clear();
    for (int c = 0; c < 27; ++c) {
      const Sample at = place(c);
      if (std::abs(value_at(at)) > near_share * edge) continue;
      const Vector3& normal = normal_at(at);
      for (const Vector3& other : normals_)
        if (normal.dot(other) < widest_spread) return true;
      normals_.push_back(normal);
    }
    return false;
  }

  double value_at(const Sample& at) const {
    if (std::isnan(at.value)) at.value = field_.value(at.point);
    return at.value;
  }
  const Vector3& normal_at(const Sample& at) const {
    if (at.normal.isZero(0)) at.normal = field_.at(at.point).gradient.stableNormalized();
    return at.normal;
  }

  const SplineField& field_;
  CubeTree& cubes_;
  std::vector<Vector3> normals_;
  /// Normals at half edges in a layer of cubes of the first level: below, amid, above.
  std::array<std::vector<Vector3>, 3> layer_;
};

}  // namespace

void CubeTree::split(const Cube& cube) {
  if (cube.level >= depth_ || !holds(cube) || is_split(cube)) return;
  if (cube.level > 0) {
    // Its neighbours of the level above have to be split, as its parent is; the parent is one of them.
    for (int c = 0; c < 27; ++c) {
      Cube beside = cube;
      const std::array<int, 3> by{c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1};
      for (std::size_t a = 0; a < 3; ++a) beside.at[a] += by[a];
      if (!holds(beside)) continue;
      split({cube.level - 1, {beside.at[0] >> 1, beside.at[1] >> 1, beside.at[2] >> 1}});
    }
  }
  split_.insert(packed_key(cube.level, cube.at));
}

Cube CubeTree::leaf(const std::array<int, 3>& steps) const {
  Cube out;
  for (;; ++out.level) {
    const int shift = depth_ - out.level;
    out.at = {steps[0] >> shift, steps[1] >> shift, steps[2] >> shift};
    if (!is_split(out)) return out;
  }
}

Cube CubeTree::leaf_at(const Vector3& point) const {
  std::array<int, 3> steps;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = Eigen::Index(a);
    const double at = std::floor((point[axis] - low_[axis]) / edge(depth_));
    steps[a] = int(std::clamp(at, 0.0, double((size_[a] << depth_) - 1)));
  }
  return leaf(steps);
}

CubeTree surface_cubes(const SplineField& field, const Vector3& origin, double edge, bool ahead) {
  Vector3 low;
  std::array<int, 3> size{};
  for (Eigen::Index a = 0; a < 3; ++a) {
    const double begin = field.corner()[a] + origin[a],
                 end = begin + (field.size()[std::size_t(a)] - 1) * field.spacing();
    low[a] = std::floor(begin / edge) * edge - origin[a];
    size[std::size_t(a)] = int(std::ceil(end / edge) - std::floor(begin / edge));
  }
  CubeTree out(low, size, edge, deepest_level);
  out.keep_values();
  CubeSplitter(field, out).look_at_all(ahead);
  return out;
}

}  // namespace hariko
