#include "core/surface/bicubic_patch.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>

#include "core/base/assert.hpp"
#include "core/surface/tensor_sums.hpp"
#include "core/surface/triangle_collocation.hpp"

namespace hariko {

namespace {

/// Cubic Bernstein polynomials with derivatives. The arithmetic is symmetric under reversal.
struct Bernstein {
  std::array<double, 4> value, first, second;
  Bernstein(double x, double y)  // y = 1 - x
      : value{y * y * y, 3 * ((y * y) * x), 3 * ((x * x) * y), x * x * x},
        first{-3 * (y * y), 3 * (y * y - 2 * (x * y)), 3 * (2 * (x * y) - x * x), 3 * (x * x)},
        second{6 * y, 6 * (x - 2 * y), 6 * (y - 2 * x), 6 * x} {}
};

/// Weighted sum that adds both ends first, then the middle: the same bits from either end.
Vector3 sum(const std::array<double, 4>& weight, const Vector3& a, const Vector3& b, const Vector3& c,
            const Vector3& d) {
  return (weight[0] * a + weight[3] * d) + (weight[1] * b + weight[2] * c);
}

using Controls = std::array<Vector3, 16>;

std::array<Vector3, 4> along_s(const Controls& p, const std::array<double, 4>& weight) {
  std::array<Vector3, 4> out;
  for (std::size_t j = 0; j < 4; ++j)
    out[j] = sum(weight, p[4 * j], p[4 * j + 1], p[4 * j + 2], p[4 * j + 3]);
  return out;
}
Vector3 along_t(const std::array<Vector3, 4>& row, const std::array<double, 4>& weight) {
  return sum(weight, row[0], row[1], row[2], row[3]);
}

/// Recomputes a point on a side from that side's curve alone.
void set_side_position(const Controls& p, double s, double t, PatchPoint& point, const Bernstein& bs,
                       const Bernstein& bt) {
  if (t == 0)
    point.position = sum(bs.value, p[0], p[1], p[2], p[3]);
  else if (t == 1)
    point.position = sum(bs.value, p[12], p[13], p[14], p[15]);
  else if (s == 0)
    point.position = sum(bt.value, p[0], p[4], p[8], p[12]);
  else if (s == 1)
    point.position = sum(bt.value, p[3], p[7], p[11], p[15]);
}

PatchPoint point_of(const Controls& p, double s, double t, Order order) {
  const Bernstein bs(s, 1 - s), bt(t, 1 - t);
  const auto value = along_s(p, bs.value), first = along_s(p, bs.first);
  PatchPoint point;
  point.position = along_t(value, bt.value);
  point.ds = along_t(first, bt.value);
  point.dt = along_t(value, bt.first);
  if (order == Order::second) {
    point.dss = along_t(along_s(p, bs.second), bt.value);
    point.dst = along_t(first, bt.first);
    point.dtt = along_t(value, bt.second);
  }
  set_side_position(p, s, t, point, bs, bt);
  return point;
}

}  // namespace

Index patch_of(const BicubicNet& net, NetSide side) {
  HARIKO_ASSERT(side.side < 4 && side.place < places_of(net, side.side), "no such side");
  switch (side.side) {
    case 0:
      return side.place;
    case 1:
      return side.place * net.columns + net.columns - 1;
    case 2:
      return net.patch_count() - 1 - side.place;
    default:
      return (net.rows - 1 - side.place) * net.columns;
  }
}

SideRows side_rows(const BicubicNet& net, NetSide side) {
  const Index patch = patch_of(net, side);
  SideRows out;
  for (int i = 0; i < 4; ++i) {
    const auto k = std::size_t(i);
    switch (side.side) {
      case 0:
        out.curve[k] = net.index(patch, i, 0);
        out.row[k] = net.index(patch, i, 1);
        break;
      case 1:
        out.curve[k] = net.index(patch, 3, i);
        out.row[k] = net.index(patch, 2, i);
        break;
      case 2:
        out.curve[k] = net.index(patch, 3 - i, 3);
        out.row[k] = net.index(patch, 3 - i, 2);
        break;
      default:
        out.curve[k] = net.index(patch, 0, 3 - i);
        out.row[k] = net.index(patch, 1, 3 - i);
    }
  }
  return out;
}

BicubicPatchSet::BicubicPatchSet(BicubicNet net) : net_(std::move(net)) {
  HARIKO_ASSERT(
      net_.columns > 0 && net_.rows > 0 && net_.points.size() == std::size_t(net_.width()) * net_.height(),
      "a net has the points of its patches");
}

BicubicPatchSet::Controls BicubicPatchSet::controls(Index patch) const {
  Controls out;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) out[std::size_t(4 * j + i)] = net_.points[net_.index(patch, i, j)];
  return out;
}

PatchPoint BicubicPatchSet::evaluate(Index patch, const Vector2& parameter, Order order) const {
  return point_of(controls(patch), parameter.x(), parameter.y(), order);
}

void BicubicPatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                    std::span<Vector3> positions, std::span<Vector3> normals) const {
  const auto count = std::size_t(pattern.point_count());
  std::vector<PatchPoint> points(patches.size() * count);
  evaluate_grid(patches, pattern, points);
  const std::vector<Vector2> parameters = pattern.parameters();
  for (std::size_t k = 0; k < points.size(); ++k) {
    positions[k] = points[k].position;
    normals[k] = normal_at(patches[k / count], parameters[k % count], points[k]);
  }
}

void BicubicPatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                    std::span<PatchPoint> points) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "bicubic patches are squares");
  HARIKO_ASSERT(points.size() >= patches.size() * std::size_t(pattern.point_count()),
                "output array is too small");
  const int n = pattern.density;
  std::vector<Bernstein> basis;
  std::vector<double> fraction;
  for (int i = 0; i <= n; ++i) {
    fraction.push_back(grid_fraction(i, n));
    basis.emplace_back(fraction.back(), 1 - fraction.back());
  }
  std::size_t at = 0;
  for (const Index patch : patches) {
    const Controls p = controls(patch);
    std::vector<std::array<Vector3, 4>> value, first, second;
    for (const Bernstein& b : basis) {
      value.push_back(along_s(p, b.value));
      first.push_back(along_s(p, b.first));
      second.push_back(along_s(p, b.second));
    }
    for (std::size_t j = 0; j < basis.size(); ++j)
      for (std::size_t i = 0; i < basis.size(); ++i) {
        PatchPoint& point = points[at++];
        point.position = along_t(value[i], basis[j].value);
        point.ds = along_t(first[i], basis[j].value);
        point.dt = along_t(value[i], basis[j].first);
        point.dss = along_t(second[i], basis[j].value);
        point.dst = along_t(first[i], basis[j].first);
        point.dtt = along_t(value[i], basis[j].second);
        set_side_position(p, fraction[i], fraction[j], point, basis[i], basis[j]);
      }
  }
}

void BicubicPatchSet::positions(Index patch, std::span<const Vector2> parameters,
                                std::span<Vector3> out) const {
  const Controls p = controls(patch);
  tensor_positions(3, 3, p.data(), parameters, out);
}

void BicubicPatchSet::first_order(Index patch, std::span<const Vector2> parameters,
                                  std::span<PatchPoint> out) const {
  const Controls p = controls(patch);
  for (std::size_t k = 0; k < parameters.size(); ++k)
    out[k] = point_of(p, parameters[k].x(), parameters[k].y(), Order::first);
}

void BicubicPatchSet::hull(Index, const ParameterTriangle&, std::span<const Vector3> samples,
                           std::span<HullBall> out) const {
  triangle_collocation(6).controls(samples, out);
}

namespace {

constexpr double smooth_angle = 1e-6;
constexpr int seam_samples = 16;

bool same_bits(const Vector3& a, const Vector3& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

class GridSurface {
 public:
  GridSurface(const Vector3& origin, BicubicNet net)
      : origin_(origin), patches_(std::make_shared<BicubicPatchSet>(std::move(net))), net_(patches_->net()) {
    closed_s_ = closed_t_ = true;
    for (Index j = 0; j < net_.height(); ++j)
      closed_s_ = closed_s_ && same_bits(net_.at(0, j), net_.at(net_.width() - 1, j));
    for (Index i = 0; i < net_.width(); ++i)
      closed_t_ = closed_t_ && same_bits(net_.at(i, 0), net_.at(i, net_.height() - 1));
  }

  Surface make() {
    number_nodes();
    for (Index l = 0; l < net_.rows; ++l)
      for (Index k = 0; k < net_.columns; ++k) add_patch(k, l);
    Surface::Parts parts;
    parts.origin = origin_;
    parts.patches = patches_;
    parts.node_count = node_count_;
    parts.node_normals = std::make_shared<const std::vector<Vector3>>(node_normals());
    parts.seams = std::make_shared<const std::vector<Seam>>(std::move(seams_));
    parts.provenance = std::make_shared<const std::vector<Provenance>>(std::move(provenance_));
    parts.corner_nodes = std::make_shared<const std::vector<Index>>(std::move(corner_nodes_));
    parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>(std::move(boundary_sides_));
    parts.boundary_sources = std::make_shared<const std::vector<Element>>(std::move(boundary_sources_));
    return Surface(std::move(parts));
  }

 private:
  void number_nodes() {
    nodes_across_ = closed_s_ ? net_.columns : net_.columns + 1;
    node_count_ = nodes_across_ * (closed_t_ ? net_.rows : net_.rows + 1);
  }
  Index node(Index k, Index l) const {
    if (closed_s_) k %= net_.columns;
    if (closed_t_) l %= net_.rows;
    return l * nodes_across_ + k;
  }
  /// Source edge of a side: its middle control edge, by the numbers of its points.
  Element side_source(Index patch, int side) const {
    const auto point = [&](int i, int j) { return VertexId{net_.index(patch, i, j)}; };
    switch (side) {
      case 0:
        return element_of(EdgeId::of(point(1, 0), point(2, 0)));
      case 1:
        return element_of(EdgeId::of(point(3, 1), point(3, 2)));
      case 2:
        return element_of(EdgeId::of(point(1, 3), point(2, 3)));
      default:
        return element_of(EdgeId::of(point(0, 1), point(0, 2)));
    }
  }

  void add_patch(Index k, Index l) {
    const Index patch = l * net_.columns + k;
    for (const Index corner : {node(k, l), node(k + 1, l), node(k + 1, l + 1), node(k, l + 1)})
      corner_nodes_.push_back(corner);
    const Index quad = (3 * l + 1) * (net_.width() - 1) + 3 * k + 1;
    provenance_.push_back({element_of(FaceId{quad}), 0});
    const bool last_column = k + 1 == net_.columns, last_row = l + 1 == net_.rows;
    if (!last_column || closed_s_)
      add_seam({patch, 1}, {last_column ? patch - k : patch + 1, 3});
    else
      add_border({patch, 1});
    if (!last_row || closed_t_)
      add_seam({patch, 2}, {last_row ? k : patch + net_.columns, 0});
    else
      add_border({patch, 2});
    if (k == 0 && !closed_s_) add_border({patch, 3});
    if (l == 0 && !closed_t_) add_border({patch, 0});
  }

  void add_border(PatchSide side) {
    boundary_sides_.push_back(side);
    boundary_sources_.push_back(side_source(side.patch, side.side));
  }
  void add_seam(PatchSide first, PatchSide second) {
    Seam seam;
    seam.first = first;
    seam.second = second;
    seam.source = side_source(first.patch, first.side);
    seam.intended = smooth(first, second) ? Continuity::g1 : Continuity::g0;
    seams_.push_back(seam);
  }
  bool smooth(PatchSide first, PatchSide second) const {
    for (int i = 0; i <= seam_samples; ++i) {
      const double x = grid_fraction(i, seam_samples);
      const auto normal = [&](PatchSide side, double at) {
        return unit_normal(
            patches_->evaluate(side.patch, side_parameter(Domain::square, side.side, at), Order::first));
      };
      const Vector3 a = normal(first, x), b = normal(second, 1 - x);
      // A side that shrinks to a point has no tangent planes to compare.
      if (!a.isZero(0) && !b.isZero(0) && (a - b).norm() > smooth_angle) return false;
    }
    return true;
  }

  /// Common normal of the patches at each node, zero where they have none in common.
  std::vector<Vector3> node_normals() const {
    std::vector<Vector3> normals(node_count_, Vector3::Zero());
    std::vector<bool> seen(node_count_, false);
    for (Index p = 0; p < patches_->patch_count(); ++p)
      for (int c = 0; c < 4; ++c) {
        const Index node = corner_nodes_[4 * p + Index(c)];
        const Vector3 normal =
            unit_normal(patches_->evaluate(p, corner_parameter(Domain::square, c), Order::first));
        if (!seen[node])
          normals[node] = normal;
        else if ((normals[node] - normal).norm() > smooth_angle)
          normals[node].setZero();
        seen[node] = true;
      }
    return normals;
  }

  Vector3 origin_;
  std::shared_ptr<const BicubicPatchSet> patches_;
  const BicubicNet& net_;
  bool closed_s_, closed_t_;
  Index nodes_across_ = 0, node_count_ = 0;
  std::vector<Index> corner_nodes_;
  std::vector<Provenance> provenance_;
  std::vector<Seam> seams_;
  std::vector<PatchSide> boundary_sides_;
  std::vector<Element> boundary_sources_;
};

}  // namespace

Surface bicubic_surface(const Vector3& origin, BicubicNet net) {
  return GridSurface(origin, std::move(net)).make();
}

}  // namespace hariko
