#include "core/patching/cross_boundary_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "core/base/index_list.hpp"
#include "core/base/solvers/dense_solver.hpp"
#include "core/base/solvers/least_squares.hpp"
#include "core/patching/quartic/quartic_basis.hpp"

namespace hariko {

namespace {

constexpr double fit_tolerance = 1e-9;  ///< relative to the net's size; also for the rank of the conditions
constexpr double smallest_share = 0.125;
constexpr double straight_tolerance = 1e-6;  ///< for three points of a row to count as smooth

/// Number of unknowns of a side, 1 / lambda, l1 / lambda, l2 / lambda, in which the new row is linear.
constexpr Eigen::Index unknowns = 3;
using RowMatrix = Eigen::Matrix<double, 3, unknowns>;

/// Matrix of the new row's dependence on the unknowns: P(i,1) - P(i,0) = matrix * unknowns.
RowMatrix dependence(const std::array<Vector3, 4>& curve, const CrossRow& row, int i) {
  const Vector3 d0 = curve[1] - curve[0], d1 = curve[2] - curve[1], d2 = curve[3] - curve[2];
  const std::array<Vector3, 4> first{3 * d0, 2 * d1, d2, Vector3::Zero()};
  const std::array<Vector3, 4> second{Vector3::Zero(), d0, 2 * d1, 3 * d2};
  RowMatrix out;
  out << 4 * row[std::size_t(i)], -first[std::size_t(i)], -second[std::size_t(i)];
  return out / 3;
}

/// Smooth joint of an adapting row across the end of an inner side: beyond - end = ratio (end - inner).
struct RowJoint {
  Index inner, end, beyond;
  double ratio;
};

/// Joints at both ends of a side where the net's row is smooth.
std::vector<RowJoint> row_joints(const BicubicNet& net, const std::vector<Index>& same, NetSide side) {
  std::vector<RowJoint> out;
  const int places = int(places_of(net, side.side));
  const SideRows own = side_rows(net, side);
  for (const bool forwards : {true, false}) {
    // The next place along the grid's side; in a closed grid the first follows the last.
    int place = int(side.place) + (forwards ? 1 : -1);
    const Index end = same[own.row[forwards ? 3 : 0]], inner = same[own.row[forwards ? 2 : 1]];
    if (place < 0 || place >= places) {
      place = (place + places) % places;
      const SideRows other = side_rows(net, {side.side, Index(place)});
      if (same[other.row[forwards ? 0 : 3]] != end) continue;
    }
    const SideRows other = side_rows(net, {side.side, Index(place)});
    const Index beyond = same[other.row[forwards ? 1 : 2]];
    const Vector3 a = net.points[end] - net.points[inner], b = net.points[beyond] - net.points[end];
    const double ratio = a.squaredNorm() > 0 ? b.dot(a) / a.squaredNorm() : 0;
    if (!(ratio > 0) || (b - ratio * a).norm() > straight_tolerance * b.norm()) continue;
    out.push_back({inner, end, beyond, ratio});
  }
  return out;
}

class Fit {
 public:
  Fit(const BicubicNet& net, const std::vector<AdaptingSide>& sides, const std::set<Index>& held,
      const std::vector<Index>& same, const std::vector<RowJoint>& joints)
      : net_(net), sides_(sides), held_(held), same_(same), joints_(joints) {}

  /// New positions of points, or nothing where the sides have no common solution.
  std::optional<std::map<Index, Vector3>> solve() {
    collect();
    auto x = minimum({});
    if (x && !positive(*x)) {
      // Lambda would change its sign: the first side gets a natural one.
      Eigen::VectorXd row = Eigen::VectorXd::Zero(x->size());
      row[0] = 1;
      x = minimum(std::pair{row, natural(0)});
    }
    if (!x || !positive(*x)) return std::nullopt;
    std::map<Index, Vector3> out;
    for (std::size_t k = 0; k < sides_.size(); ++k)
      for (int i = 0; i < 4; ++i)
        out[target(k, i)] = base(k, i) + matrix(k, i) * x->segment<unknowns>(Eigen::Index(k) * unknowns);
    return out;
  }

 private:
  SideRows rows(std::size_t k) const { return side_rows(net_, sides_[k].side); }
  Index target(std::size_t k, int i) const { return same_[rows(k).row[std::size_t(i)]]; }
  const Vector3& base(std::size_t k, int i) const { return net_.points[rows(k).curve[std::size_t(i)]]; }
  RowMatrix matrix(std::size_t k, int i) const {
    const SideRows at = rows(k);
    std::array<Vector3, 4> curve;
    for (std::size_t n = 0; n < 4; ++n) curve[n] = net_.points[at.curve[n]];
    return dependence(curve, sides_[k].row, i);
  }
  double natural(std::size_t k) const {
    double present = 0, wanted = 0;
    for (int i = 0; i < 4; ++i) {
      present += (net_.points[target(k, i)] - base(k, i)).norm();
      wanted += 4 * sides_[k].row[std::size_t(i)].norm() / 3;
    }
    return wanted > 0 ? present / wanted : 1;
  }
  bool positive(const Eigen::VectorXd& x) const {
    for (std::size_t k = 0; k < sides_.size(); ++k)
      if (!(x[Eigen::Index(k) * unknowns] >= smallest_share * natural(k))) return false;
    return true;
  }

  void collect() {
    const Eigen::Index n = unknowns * Eigen::Index(sides_.size());
    objective_ = Eigen::MatrixXd::Zero(n, n);
    pull_ = Eigen::VectorXd::Zero(n);
    std::vector<std::pair<Eigen::MatrixXd, Vector3>> conditions;
    std::map<Index, std::pair<std::size_t, int>> claimed;
    Eigen::AlignedBox3d box;
    for (const Vector3& point : net_.points) box.extend(point);
    size_ = box.diagonal().norm();
    for (std::size_t k = 0; k < sides_.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        const RowMatrix m = matrix(k, i);
        const Eigen::Index at = unknowns * Eigen::Index(k);
        const Vector3 present = net_.points[target(k, i)] - base(k, i);
        objective_.block<unknowns, unknowns>(at, at) += m.transpose() * m;
        pull_.segment<unknowns>(at) += m.transpose() * present;
        Eigen::MatrixXd condition = Eigen::MatrixXd::Zero(3, n);
        condition.middleCols<unknowns>(at) = m;
        if (held_.contains(target(k, i))) conditions.emplace_back(condition, present);
        const auto [first, fresh] = claimed.try_emplace(target(k, i), k, i);
        if (fresh) continue;
        const auto [other, j] = first->second;
        condition.middleCols<unknowns>(unknowns * Eigen::Index(other)) -= matrix(other, j);
        conditions.emplace_back(condition, base(other, j) - base(k, i));
      }
    for (const RowJoint& joint : joints_) {
      const auto first = claimed.find(joint.inner), middle = claimed.find(joint.end),
                 last = claimed.find(joint.beyond);
      if (first == claimed.end() || middle == claimed.end() || last == claimed.end()) continue;
      Eigen::MatrixXd condition = Eigen::MatrixXd::Zero(3, n);
      Vector3 value = Vector3::Zero();
      const auto add = [&](double factor, const std::pair<std::size_t, int>& at) {
        condition.middleCols<unknowns>(unknowns * Eigen::Index(at.first)) +=
            factor * matrix(at.first, at.second);
        value -= factor * base(at.first, at.second);
      };
      add(1, last->second);
      add(-(1 + joint.ratio), middle->second);
      add(joint.ratio, first->second);
      conditions.emplace_back(condition, value);
    }
    conditions_.resize(3 * Eigen::Index(conditions.size()), n);
    values_.resize(conditions_.rows());
    for (std::size_t c = 0; c < conditions.size(); ++c) {
      conditions_.middleRows<3>(3 * Eigen::Index(c)) = conditions[c].first;
      values_.segment<3>(3 * Eigen::Index(c)) = conditions[c].second;
    }
  }

  /// Least-squares solution under the conditions; `extra` is one more condition.
  std::optional<Eigen::VectorXd> minimum(
      const std::optional<std::pair<Eigen::VectorXd, double>>& extra) const {
    Eigen::MatrixXd a = conditions_ / size_;
    Eigen::VectorXd b = values_ / size_;
    if (extra) {
      a.conservativeResize(a.rows() + 1, pull_.size());
      b.conservativeResize(b.size() + 1);
      a.bottomRows<1>() = extra->first.transpose();
      b[b.size() - 1] = extra->second;
    }
    Eigen::VectorXd x = Eigen::VectorXd::Zero(pull_.size());
    Eigen::MatrixXd free = Eigen::MatrixXd::Identity(pull_.size(), pull_.size());
    if (a.rows() > 0) {
      LeastSquares all = all_least_squares(a, b, fit_tolerance);
      x = std::move(all.shortest);
      const Eigen::VectorXd error = matrix_product(a, x) - b;
      if (error.lpNorm<Eigen::Infinity>() > fit_tolerance) return std::nullopt;
      free = std::move(all.free);
    }
    if (free.cols() > 0) {
      const Eigen::MatrixXd reduced = matrix_product(transposed_product(free, objective_), free);
      const Eigen::VectorXd rest = pull_ - matrix_product(objective_, x);
      x += matrix_product(free, solve_least_squares(reduced, transposed_product(free, rest)));
    }
    return x;
  }

  const BicubicNet& net_;
  const std::vector<AdaptingSide>& sides_;
  const std::set<Index>& held_;
  const std::vector<Index>& same_;
  const std::vector<RowJoint>& joints_;
  Eigen::MatrixXd objective_, conditions_;
  Eigen::VectorXd pull_, values_;
  double size_ = 1;
};

/// Number of the first of all points that coincide in a closed net, for each point.
std::vector<Index> same_points(const BicubicNet& net) {
  std::vector<Index> out = ascending_indices(net.points.size());
  bool closed_s = true, closed_t = true;
  for (Index j = 0; j < net.height(); ++j) closed_s = closed_s && net.at(0, j) == net.at(net.width() - 1, j);
  for (Index i = 0; i < net.width(); ++i) closed_t = closed_t && net.at(i, 0) == net.at(i, net.height() - 1);
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 0; i < net.width(); ++i)
      out[net.index(i, j)] =
          net.index(closed_s && i + 1 == net.width() ? 0 : i, closed_t && j + 1 == net.height() ? 0 : j);
  return out;
}

/// Keeps rows smooth across inner sides that end on an adapting side: the point beyond follows. Points that
/// adapting sides determine keep their positions.
void follow(const BicubicNet& before, const std::vector<RowJoint>& joints, const std::set<Index>& held,
            std::map<Index, Vector3>& moved) {
  const std::map<Index, Vector3> given = moved;
  for (const RowJoint& joint : joints) {
    if (!given.contains(joint.end) || given.contains(joint.beyond) || held.contains(joint.beyond)) continue;
    const auto inner = given.find(joint.inner);
    const Vector3& from = inner == given.end() ? before.points[joint.inner] : inner->second;
    const Vector3& end = given.at(joint.end);
    moved[joint.beyond] = end + joint.ratio * (end - from);
  }
}

CrossRow quartic_row(std::span<const Vector3> d, bool reversed) {
  using namespace quartic;
  if (reversed) return {d[d004] - d[d103], d[d013] - d[d112u], d[d022] - d[d121u], d[d031] - d[d130]};
  return {d[d040] - d[d130], d[d031] - d[d121u], d[d022] - d[d112u], d[d013] - d[d103]};
}

}  // namespace

CrossRow cross_row(const PatchSet& patches, Index patch, bool reversed) {
  const ExactForm form = patches.exact_form(patch);
  if (const auto* quartic = std::get_if<PairedQuartic>(&form))
    return quartic_row(quartic->controls, reversed);
  const auto* chart = std::get_if<ChartPatch>(&form);
  HARIKO_ASSERT(chart, "patches of a polyhedron's surface");
  CrossRow row = chart->charts->side_cross_derivative(patch);
  for (Vector3& vector : row) vector *= -0.25;
  if (reversed) std::reverse(row.begin(), row.end());
  return row;
}

AdaptedNet adapted_net(const BicubicNet& net, const std::vector<AdaptingSide>& sides,
                       const std::vector<NetSide>& held) {
  AdaptedNet out{net, {}, {}};
  const std::vector<Index> same = same_points(net);
  std::set<Index> still;
  const auto hold = [&](NetSide side) {
    for (const Index point : side_rows(net, side).curve) still.insert(same[point]);
  };
  for (const NetSide side : held) hold(side);
  for (const AdaptingSide& side : sides) hold(side.side);
  std::vector<AdaptingSide> accepted;
  std::vector<RowJoint> joints;
  std::map<Index, Vector3> moved;
  for (const AdaptingSide& side : sides) {
    accepted.push_back(side);
    const std::vector<RowJoint> own = row_joints(net, same, side.side);
    std::vector<RowJoint> all = joints;
    all.insert(all.end(), own.begin(), own.end());
    auto fit = Fit(net, accepted, still, same, all).solve();
    bool kinked = false;
    if (!fit) {
      // Tangent planes along whole sides take precedence over the smoothness of an inner side.
      std::erase_if(all, [&](const RowJoint& joint) {
        return std::any_of(own.begin(), own.end(),
                           [&](const RowJoint& mine) { return mine.end == joint.end; });
      });
      fit = Fit(net, accepted, still, same, all).solve();
      kinked = fit.has_value();
    }
    out.adapted.push_back(fit.has_value());
    out.kinked.push_back(kinked);
    if (fit) {
      moved = std::move(*fit);
      joints = std::move(all);
    } else {
      accepted.pop_back();
    }
  }
  follow(net, joints, still, moved);
  for (Index p = 0; p < out.net.points.size(); ++p)
    if (const auto found = moved.find(same[p]); found != moved.end()) out.net.points[p] = found->second;
  return out;
}

}  // namespace hariko
