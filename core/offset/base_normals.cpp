#include "core/offset/base_normals.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {

namespace {

/// Fraction of the way to the centre where a patch is evaluated instead of at its degenerate points.
constexpr double inward_step = 1e-4;
constexpr std::array<double, 5> seam_samples{0.1, 0.3, 0.5, 0.7, 0.9};

/// Derivatives of the unit normal of m = ds x dt: (dm - n (n . dm)) / |m|.
void add_normal_derivatives(const PatchPoint& p, NormalPoint& out) {
  const Vector3 m = p.ds.cross(p.dt);
  const double length = m.norm();
  if (!(length > 0)) return;
  const Vector3 n = m / length;
  const auto derivative = [&](const Vector3& dm) -> Vector3 { return (dm - n * n.dot(dm)) / length; };
  out.normal_s = derivative(p.dss.cross(p.dt) + p.ds.cross(p.dst));
  out.normal_t = derivative(p.dst.cross(p.dt) + p.ds.cross(p.dtt));
}

double between(double begin, double end, double x) {
  return begin + x * (end - begin);
}

}  // namespace

BaseNormals::BaseNormals(const Surface& base)
    : base_(base), corners_(std::size_t(corner_count(base.domain()))) {
  HARIKO_ASSERT(base.patch_count() > 0, "normals of a surface without patches");
  find_shrunk();
  find_sharp();
  find_groups();
}

Vector3 BaseNormals::plain_normal(const PatchSide& side, double x) const {
  const Vector2 parameter = side_parameter(base_.domain(), side.side, x);
  return base_.patches().normal_at(side.patch, parameter,
                                   base_.patches().evaluate(side.patch, parameter, Order::first));
}

void BaseNormals::find_shrunk() {
  shrunk_.assign(corners_ * base_.patch_count(), 0);
  for (Index patch = 0; patch < base_.patch_count(); ++patch) {
    const double limit = 1e-9 * base_.patch_scale(patch);
    for (int side = 0; side < int(corners_); ++side) {
      const auto at = [&](double x) {
        return base_.patches()
            .evaluate(patch, side_parameter(base_.domain(), side, x), Order::first)
            .position;
      };
      const Vector3 begin = at(0);
      bool point = true;
      for (const double x : {1.0, 0.5, 0.25, 0.75}) point = point && (at(x) - begin).norm() <= limit;
      shrunk_[slot(patch, side)] = point;
    }
  }
}

void BaseNormals::find_sharp() {
  const std::vector<Seam>& seams = base_.seams();
  sharp_.assign(seams.size(), 0);
  leaders_.assign(corners_ * base_.patch_count(), {});
  for (std::size_t i = 0; i < seams.size(); ++i) {
    const Seam& seam = seams[i];
    if (seam.intended == Continuity::g0)
      for (const double x : seam_samples) {
        const Vector3 a = plain_normal(seam.first, between(seam.first_begin, seam.first_end, x));
        const Vector3 b = plain_normal(seam.second, between(seam.second_begin, seam.second_end, x));
        if (std::atan2(a.cross(b).norm(), a.dot(b)) > sharp_seam_angle) sharp_[i] = 1;
      }
    if (!sharp_[i] && is_full(seam)) leaders_[slot(seam.second.patch, seam.second.side)] = seam.first;
  }
}

void BaseNormals::find_groups() {
  const auto patches = base_.patch_count();
  DisjointSets sets(corners_ * patches);
  const auto corner_of = [&](const PatchSide& side, double x) {
    if (x != 0 && x != 1) return no_index;
    return Index(slot(side.patch, (side.side + int(x)) % int(corners_)));
  };
  for (std::size_t i = 0; i < base_.seams().size(); ++i) {
    const Seam& seam = base_.seams()[i];
    if (sharp_[i]) continue;
    const std::array<Index, 4> ends{
        corner_of(seam.first, seam.first_begin), corner_of(seam.second, seam.second_begin),
        corner_of(seam.first, seam.first_end), corner_of(seam.second, seam.second_end)};
    for (const std::size_t k : {0U, 2U})
      if (ends[k] != no_index && ends[k + 1] != no_index) sets.join(ends[k], ends[k + 1]);
  }
  for (Index patch = 0; patch < patches; ++patch)
    for (int side = 0; side < int(corners_); ++side)
      if (shrunk_[slot(patch, side)])
        sets.join(Index(slot(patch, side)), Index(slot(patch, (side + 1) % int(corners_))));
  groups_.resize(corners_ * patches);
  group_normals_.assign(corners_ * patches, Vector3::Zero());
  std::vector<Vector3> sums(corners_ * patches, Vector3::Zero());
  for (Index patch = 0; patch < patches; ++patch)
    for (int corner = 0; corner < int(corners_); ++corner) {
      const Index group = sets.find(Index(slot(patch, corner)));
      groups_[slot(patch, corner)] = group;
      sums[group] += plain_normal({patch, std::uint8_t(corner)}, 0);
      // The normal of the node, where it has one, is exact also at degenerate corners.
      const Vector3& node = base_.node_normal(base_.node(patch, corner));
      if (group_normals_[group].isZero(0)) group_normals_[group] = node;
    }
  for (std::size_t group = 0; group < sums.size(); ++group)
    if (group_normals_[group].isZero(0)) group_normals_[group] = sums[group].stableNormalized();
}

BaseNormals::Border BaseNormals::border_of(const Vector2& parameter) const {
  const double s = parameter.x(), t = parameter.y();
  if (t == 0) return {0, s};
  if (base_.domain() == Domain::triangle) {
    if (s == 0) return {2, 1 - t};
    return s + t == 1 ? Border{1, t} : Border{};
  }
  if (s == 1) return {1, t};
  if (t == 1) return {2, 1 - s};
  return s == 0 ? Border{3, 1 - t} : Border{};
}

Vector3 BaseNormals::normal(Index patch, const Vector2& parameter, const PatchPoint& point) const {
  const Border border = border_of(parameter);
  if (border.side < 0) return base_.patches().normal_at(patch, parameter, point);
  const std::size_t here = slot(patch, border.side);
  if (border.x == 0 || shrunk_[here]) return group_normals_[groups_[here]];
  if (border.x == 1) return group_normals_[groups_[slot(patch, (border.side + 1) % int(corners_))]];
  if (const PatchSide& leader = leaders_[here]; leader.patch != no_index)
    return plain_normal(leader, 1 - border.x);
  return base_.patches().normal_at(patch, parameter, point);
}

NormalPoint BaseNormals::at(Index patch, const Vector2& parameter) const {
  const PatchSet& patches = base_.patches();
  PatchPoint point = patches.evaluate(patch, parameter, Order::second);
  NormalPoint out{point.position, point.ds, point.dt, normal(patch, parameter, point)};
  bool regular = !unit_normal(point).isZero(0);
  if (const Border border = border_of(parameter); border.side >= 0 && (border.x == 0 || border.x == 1)) {
    const int corner = (border.side + int(border.x)) % int(corners_);
    regular = regular && patches.second_order_at_corner(patch, corner) == CornerSecondOrder::exact;
  }
  if (!regular)
    point = patches.evaluate(patch, parameter + inward_step * (centre_parameter(base_.domain()) - parameter),
                             Order::second);
  add_normal_derivatives(point, out);
  return out;
}

SidePoint BaseNormals::on_side(const PatchSide& side, double x) const {
  const Domain domain = base_.domain();
  const Vector2 along = side_parameter(domain, side.side, 1) - side_parameter(domain, side.side, 0);
  const NormalPoint p = at(side.patch, side_parameter(domain, side.side, x));
  return {p.position, p.position_s * along.x() + p.position_t * along.y(), p.normal,
          p.normal_s * along.x() + p.normal_t * along.y()};
}

}  // namespace hariko
