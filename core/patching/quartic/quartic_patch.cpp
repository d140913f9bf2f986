#include "core/patching/quartic/quartic_patch.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/patching/quartic/quartic_kernel.hpp"

namespace hariko {

namespace {

constexpr std::array<std::array<std::size_t, 5>, 3> side_controls{{
    {quartic::d400, quartic::d310, quartic::d220, quartic::d130, quartic::d040},
    {quartic::d040, quartic::d031, quartic::d022, quartic::d013, quartic::d004},
    {quartic::d004, quartic::d103, quartic::d202, quartic::d301, quartic::d400},
}};

/// Side of the triangle that a parameter lies on, with the fraction along it and its complement; side -1 for
/// inner parameters.
struct OnSide {
  int side = -1;
  double x = 0, one_minus_x = 0;
};
OnSide side_of(double u, double v, double w) {
  if (w == 0) return {0, v, u};
  if (u == 0) return {1, w, v};
  if (v == 0) return {2, u, w};
  return {};
}

}  // namespace

QuarticGridTable quartic_point_table(std::span<const Vector2> parameters) {
  QuarticGridTable table;
  const std::size_t points = parameters.size();
  constexpr std::size_t width = QuarticGridTable::width;
  table.blocks = (points + width - 1) / width;
  table.first.assign(table.blocks * quartic_control_count * 3 * width, 0.0);
  table.second = table.first;
  for (std::size_t i = 0; i < table.blocks * width; ++i) {
    const Vector2& p = parameters[std::min(i, points - 1)];  // the last block repeats the last point
    const QuarticBasis basis = quartic_basis(1 - p.x() - p.y(), p.x(), p.y());
    for (std::size_t k = 0; k < quartic_control_count; ++k) {
      const auto gradient = basis.gradient.row(Eigen::Index(k));
      const Eigen::Matrix3d& h = basis.hessian[k];
      const double du_v = gradient(1) - gradient(0), du_w = gradient(2) - gradient(0);
      const double vv = h(1, 1) - 2 * h(0, 1) + h(0, 0), ww = h(2, 2) - 2 * h(0, 2) + h(0, 0);
      const double vw = h(1, 2) - h(0, 1) - h(0, 2) + h(0, 0);
      const std::size_t at = ((i / width) * quartic_control_count + k) * 3 * width + i % width;
      table.first[at] = basis.value[k];
      table.first[at + width] = du_v;
      table.first[at + 2 * width] = du_w;
      table.second[at] = vv;
      table.second[at + width] = vw;
      table.second[at + 2 * width] = ww;
    }
  }
  return table;
}

Vector3 evaluate_side(const QuarticPatch& patch, int side, double x, double one_minus_x) {
  const auto& index = side_controls[static_cast<std::size_t>(side)];
  const auto control = [&](std::size_t i) -> const Vector3& { return patch.control[index[i]]; };
  const double y = one_minus_x, xx = x * x, yy = y * y;
  const double b0 = yy * yy, b4 = xx * xx, b1 = 4 * (yy * y) * x, b3 = 4 * (xx * x) * y, b2 = 6 * (xx * yy);
  return (b0 * control(0) + b4 * control(4)) + (b1 * control(1) + b3 * control(3)) + b2 * control(2);
}

PatchPoint evaluate_patch(const QuarticPatch& patch, const Vector2& parameter, Order order) {
  const double v = parameter.x(), w = parameter.y(), u = 1 - v - w;
  const QuarticBasis basis = quartic_basis(u, v, w);
  PatchPoint point;
  point.position = point.ds = point.dt = point.dss = point.dst = point.dtt = Vector3::Zero();
  for (std::size_t k = 0; k < quartic_control_count; ++k) {
    const Vector3& d = patch.control[k];
    const auto gradient = basis.gradient.row(Eigen::Index(k));
    point.position += basis.value[k] * d;
    point.ds += (gradient(1) - gradient(0)) * d;
    point.dt += (gradient(2) - gradient(0)) * d;
    if (order == Order::second) {
      const Eigen::Matrix3d& h = basis.hessian[k];
      point.dss += (h(1, 1) - 2 * h(0, 1) + h(0, 0)) * d;
      point.dst += (h(1, 2) - h(0, 1) - h(0, 2) + h(0, 0)) * d;
      point.dtt += (h(2, 2) - 2 * h(0, 2) + h(0, 0)) * d;
    }
  }
  if (const OnSide on = side_of(u, v, w); on.side >= 0)
    point.position = evaluate_side(patch, on.side, on.x, on.one_minus_x);
  return point;
}

std::shared_ptr<const QuarticGridTable> QuarticTables::table(int density) const {
  const std::lock_guard lock(mutex_);
  auto& table = tables_[density];
  if (!table) {
    const GridPattern pattern{Domain::triangle, density};
    QuarticGridTable made = quartic_point_table(pattern.parameters());
    made.pattern = pattern;
    table = std::make_shared<QuarticGridTable>(std::move(made));
  }
  return table;
}

QuarticPatchSet::QuarticPatchSet(QuarticPatchArray patches, std::shared_ptr<const QuarticTables> tables)
    : patches_(std::move(patches)), tables_(std::move(tables)) {}

ExactForm QuarticPatchSet::exact_form(Index patch) const {
  const auto& control = patches_[patch].control;
  PairedQuartic out{control, 0};
  for (const std::size_t k : {quartic::d211w, quartic::d121w, quartic::d112v})
    out.pair_distance = std::max(out.pair_distance, (control[k] - control[k + 1]).norm());
  return out;
}

PatchPoint QuarticPatchSet::evaluate(Index patch, const Vector2& parameter, Order order) const {
  return evaluate_patch(patches_[patch], parameter, order);
}

void QuarticPatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                    std::span<Vector3> positions, std::span<Vector3> normals) const {
  HARIKO_ASSERT(pattern.domain == Domain::triangle, "quartic patches are triangles");
  const auto table = tables_->table(pattern.density);
  const std::size_t points = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(positions.size() >= patches.size() * points && normals.size() >= patches.size() * points,
                "output arrays are too small");
  const std::array<std::vector<int>, 3> sides{pattern.side(0), pattern.side(1), pattern.side(2)};
  const double n = pattern.density;
  const QuarticKernel kernel = quartic_kernel();
  std::vector<Vector2> parameters;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const QuarticPatch& patch = patches_[patches[k]];
    Vector3* position = positions.data() + k * points;
    Vector3* normal = normals.data() + k * points;
    const bool degenerate = kernel.position_normal(patch, *table, points, position, normal);
    for (int side = 0; side < 3; ++side)
      for (std::size_t i = 0; i < sides[std::size_t(side)].size(); ++i)
        position[sides[std::size_t(side)][i]] =
            evaluate_side(patch, side, double(i) / n, (n - double(i)) / n);
    if (!degenerate) continue;
    if (parameters.empty()) parameters = pattern.parameters();
    for (std::size_t i = 0; i < points; ++i)
      if (normal[i].isZero(0)) normal[i] = inner_normal(patches[k], parameters[i]);
  }
}

void QuarticPatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                    std::span<PatchPoint> out) const {
  HARIKO_ASSERT(pattern.domain == Domain::triangle, "quartic patches are triangles");
  const auto table = tables_->table(pattern.density);
  const std::size_t points = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(out.size() >= patches.size() * points, "output array is too small");
  const std::array<std::vector<int>, 3> sides{pattern.side(0), pattern.side(1), pattern.side(2)};
  const double n = pattern.density;
  const QuarticKernel kernel = quartic_kernel();
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const QuarticPatch& patch = patches_[patches[k]];
    PatchPoint* point = out.data() + k * points;
    kernel.second_order(patch, *table, points, point);
    for (int side = 0; side < 3; ++side)
      for (std::size_t i = 0; i < sides[std::size_t(side)].size(); ++i)
        point[sides[std::size_t(side)][i]].position =
            evaluate_side(patch, side, double(i) / n, (n - double(i)) / n);
  }
}

namespace {

/// Batch evaluation by tables of the basis functions at the parameters; points on sides by the curve of the
/// side.
class QuarticBatch final : public BatchEvaluation {
 public:
  QuarticBatch(const QuarticPatchArray& patches, std::span<const Vector2> parameters)
      : patches_(patches), table_(quartic_point_table(parameters)), count_(parameters.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      const Vector2& p = parameters[i];
      if (const OnSide on = side_of(1 - p.x() - p.y(), p.x(), p.y()); on.side >= 0)
        on_sides_.emplace_back(i, on);
    }
  }

  void evaluate(std::span<const Index> patches, Order order, std::span<PatchPoint> points) const override {
    HARIKO_ASSERT(points.size() >= patches.size() * count_, "output array is too small");
    const auto kernel = order == Order::second ? kernel_.second_order : kernel_.first_order;
    PatchPoint* out = points.data();
    for (const Index index : patches) {
      const QuarticPatch& patch = patches_[index];
      kernel(patch, table_, count_, out);
      for (const auto& [i, on] : on_sides_)
        out[i].position = evaluate_side(patch, on.side, on.x, on.one_minus_x);
      out += count_;
    }
  }

 private:
  const QuarticPatchArray& patches_;
  QuarticGridTable table_;
  std::size_t count_;
  std::vector<std::pair<std::size_t, OnSide>> on_sides_;
  QuarticKernel kernel_ = quartic_kernel();
};

}  // namespace

std::unique_ptr<const BatchEvaluation> QuarticPatchSet::batch(std::vector<Vector2> parameters) const {
  return std::make_unique<QuarticBatch>(patches_, parameters);
}

CornerSecondOrder QuarticPatchSet::second_order_at_corner(Index patch, int corner) const {
  const QuarticPatch& p = patches_[patch];
  const std::size_t first = 12 + 2 * static_cast<std::size_t>(corner);
  double size = 0;
  for (std::size_t k = 1; k < quartic_control_count; ++k)
    size = std::max(size, (p.control[k] - p.control[0]).lpNorm<Eigen::Infinity>());
  const bool equal = (p.control[first] - p.control[first + 1]).lpNorm<Eigen::Infinity>() <= 1e-12 * size;
  return equal ? CornerSecondOrder::exact : CornerSecondOrder::direction_dependent;
}

}  // namespace hariko
