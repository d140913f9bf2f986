#include "core/envelope/ball/closing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace hariko {

namespace {

/// Region that the ball's centre must not enter: a ball inside a solid, enlarged by the radius of the rolling
/// one.
struct Obstacle {
  Vector3 centre;
  double radius;
};

constexpr std::size_t most_obstacles = 8;
constexpr int first_rounds = 8;         ///< each adds an obstacle
constexpr std::size_t most_planes = 4;  ///< three determine a displacement; a fourth to choose among
constexpr int most_steps = 8;
constexpr double search_width = 2.5;  ///< distance in radii within which a search hardly leaves a node
constexpr double least_stiffness = 0.05;
constexpr double no_value = -1e200;  ///< less than any real value
/// Fraction of the radius by which the smallest ball reaches deeper than the largest all in a slot.
constexpr double all_slot = 0.75;

/// Nearest point to x outside a few obstacles, among the points that lie on the last one.
class NearestOutside {
 public:
  NearestOutside(const Vector3& x, std::span<const Obstacle> obstacles) : x_(x), obstacles_(obstacles) {
    const std::size_t last = obstacles.size() - 1;
    on_one(obstacles[last]);
    for (std::size_t i = 0; i < last; ++i) {
      const auto round = circle(obstacles[last], obstacles[i]);
      if (!round) continue;
      on_two(obstacles[last], *round);
      for (std::size_t j = 0; j < i; ++j) on_three(obstacles[last], *round, obstacles[j]);
    }
  }
  const std::optional<Vector3>& found() const { return best_; }

 private:
  void offer(const Vector3& y) {
    const double square = (y - x_).squaredNorm();
    if (!(square < least_)) return;
    for (const Obstacle& o : obstacles_)
      if ((y - o.centre).squaredNorm() < o.radius * o.radius * (1 - 1e-9)) return;
    least_ = square;
    best_ = y;
  }
  void on_one(const Obstacle& o) {
    const Vector3 away = x_ - o.centre;
    if (const double length = away.norm(); length > 0) offer(o.centre + o.radius / length * away);
  }
  /// Circle of intersection of two spheres: its axis, a unit vector from p to q, which are `apart`, the
  /// distance of its centre along it, and its radius.
  struct Circle {
    Vector3 axis;
    double apart, way, radius;
  };
  static std::optional<Circle> circle(const Obstacle& p, const Obstacle& q) {
    const Vector3 axis = q.centre - p.centre;
    const double apart = axis.norm();
    const double way = 0.5 * (apart + (p.radius - q.radius) * (p.radius + q.radius) / apart);
    const double square = (p.radius - way) * (p.radius + way);
    if (!(apart > 0) || !(square > 0)) return {};
    return Circle{axis / apart, apart, way, std::sqrt(square)};
  }
  void on_two(const Obstacle& p, const Circle& round) {
    const Vector3 &n = round.axis, middle = p.centre + round.way * n;
    Vector3 side = x_ - middle;
    side -= side.dot(n) * n;
    double length = side.norm();
    if (!(length > 1e-12 * p.radius)) {
      side = n.unitOrthogonal();
      length = 1;
    }
    offer(middle + round.radius / length * side);
  }
  void on_three(const Obstacle& p, const Circle& round, const Obstacle& r) {
    const Vector3 &ex = round.axis, to = r.centre - p.centre;
    const double i = ex.dot(to);
    const Vector3 across = to - i * ex;
    const double j = across.norm();
    if (!(j > 1e-9 * round.apart)) return;
    const Vector3 ey = across / j;
    const double x = round.way;
    const double y = 0.5 * ((p.radius - r.radius) * (p.radius + r.radius) + i * i + j * j - 2 * i * x) / j;
    const double square = (p.radius - x) * (p.radius + x) - y * y;
    if (!(square >= 0)) return;
    const Vector3 middle = p.centre + x * ex + y * ey, up = std::sqrt(square) * ex.cross(ey);
    offer(middle + up);
    offer(middle - up);
  }

  const Vector3& x_;
  std::span<const Obstacle> obstacles_;
  double least_ = 1e300;
  std::optional<Vector3> best_;
};

/// Half-space: a displacement must have at least length `least` along `direction`, a unit vector.
struct TangentPlane {
  Vector3 direction;
  double least;
  Index solid;
};

/// Displacement with the planes in which it lies: the target plus the sum of the multipliers times their
/// directions.
struct TangentStep {
  Vector3 way;
  std::array<std::size_t, 3> planes;
  int active;
  Vector3 multipliers = Vector3::Zero();
};

/// Nearest displacement to `target` that lies in all of `active` planes; nothing where it leaves a
/// half-space, or where a multiplier is negative.
std::optional<TangentStep> step_on(const std::array<std::size_t, 3>& of, int active, const Vector3& target,
                                   std::span<const TangentPlane> planes, double slack) {
  constexpr double least_volume = 1e-12;  ///< square of the volume that the unit directions span
  const auto direction = [&](std::size_t i) -> const Vector3& { return planes[of[i]].direction; };
  const auto miss = [&](std::size_t i) { return planes[of[i]].least - direction(i).dot(target); };
  TangentStep out{target, of, active};
  if (active == 1) {
    out.multipliers[0] = miss(0);
    out.way += out.multipliers[0] * direction(0);
  } else if (active == 2) {
    const Vector3 &a = direction(0), &b = direction(1);
    const double cosine = a.dot(b), square = 1 - cosine * cosine, miss_a = miss(0), miss_b = miss(1);
    if (!(square > least_volume)) return {};
    out.multipliers.head<2>() << (miss_a - cosine * miss_b) / square, (miss_b - cosine * miss_a) / square;
    out.way += out.multipliers[0] * a + out.multipliers[1] * b;
  } else if (active == 3) {
    const Vector3 &a = direction(0), &b = direction(1), &c = direction(2);
    const Vector3 bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
    const double volume = a.dot(bc);
    if (!(volume * volume > least_volume)) return {};
    const Vector3 shift = (miss(0) * bc + miss(1) * ca + miss(2) * ab) / volume;
    out.multipliers = Vector3(bc.dot(shift), ca.dot(shift), ab.dot(shift)) / volume;
    out.way += shift;
  }
  if (out.multipliers.minCoeff() < 0) return {};
  for (const TangentPlane& plane : planes)
    if (plane.direction.dot(out.way) < plane.least - slack) return {};
  return out;
}

/// Displacement in the intersection of all half-spaces nearest to `target`.
std::optional<TangentStep> tangent_step(const Vector3& target, std::span<const TangentPlane> planes,
                                        double slack) {
  std::optional<TangentStep> out = step_on({}, 0, target, planes, slack);
  // A feasible displacement with non-negative multipliers is the nearest, and the only one.
  for (std::size_t i = 0; i < planes.size() && !out; ++i) {
    out = step_on({i}, 1, target, planes, slack);
    for (std::size_t j = 0; j < i && !out; ++j) {
      out = step_on({i, j}, 2, target, planes, slack);
      for (std::size_t k = 0; k < j && !out; ++k) out = step_on({i, j, k}, 3, target, planes, slack);
    }
  }
  return out;
}

}  // namespace

void ClosingReach::include(const Vector3& other, double within) {
  const double way = (other - about).norm();
  if (way + within <= reach) return;
  if (way + reach <= within) {
    about = other;
    reach = within;
    return;
  }
  const double both = 0.5 * (way + reach + within);
  about += (both - reach) / way * (other - about);
  reach = both;
}

/// Search that adds obstacles where a centre lies too near to a solid, until none does: each is a ball inside
/// the solid, so the centre found is never farther from x than the right one.
struct Closing::Search {
  Search(const Closing& of, const Vector3& at) : closing(of), x(at) {
    // A little more than the width, for rounding.
    const double width = (1 + 1e-9) * search_width * closing.radius_;
    about_x.reserve(closing.all_.size());
    for (const Index i : closing.all_)
      if (!closing.solids_.is_farther(i, x, width)) about_x.push_back(i);
  }

  const Closing& closing;
  const Vector3& x;
  std::vector<Index> about_x;  ///< numbers of the solids within the search's width, in order
  std::array<Obstacle, most_obstacles> obstacles = {};
  std::size_t count = 0;
  ClosedDistance best = {-1e300, {}, true};
  /// Ball that holds all places where solids were asked for, each with the distance from which on they change
  /// nothing.
  ClosingReach asked = {};

  /// Offers a centre y, where `room` is the distance from y to the solids, at most the ball's radius. A ball
  /// that penetrates a solid is refused.
  bool offer(const Vector3& y, double room) {
    if (room < closing.radius_ - closing.accuracy_) return false;
    if (const double value = room - (y - x).norm(); value > best.value) best.value = value, best.centre = y;
    return true;
  }

  /// Solids among which are all that are nearer to y than `within`, in order.
  std::span<const Index> solids_within(const Vector3& y, double within) const {
    const double left = search_width * closing.radius_ - within;
    return left > 0 && (y - x).squaredNorm() < left * left ? about_x : closing.all_;
  }

  /// Nearest solid, and its distance, where that is less than the ball's radius.
  NearestSolid room_at(const Vector3& y) {
    NearestSolid out{no_index, closing.radius_};
    for (const Index i : solids_within(y, closing.radius_)) {
      if (closing.solids_.is_farther(i, y, out.distance)) continue;
      if (const double e = closing.solids_.distance(i, y); e < out.distance) out = {i, e};
    }
    asked.include(y, out.distance);
    return out;
  }

  /// Returns true where the ball about y penetrates nothing; else adds the solid that it penetrates most as
  /// an obstacle.
  bool look(const Vector3& y) {
    const NearestSolid room = room_at(y);
    if (offer(y, room.distance)) return true;
    add(room.solid, y);
    return false;
  }

  void add(Index solid, const Vector3& y) {
    const SolidPlace at = closing.solids_[solid].shape.place(y);
    if (count == most_obstacles) std::shift_left(obstacles.begin(), obstacles.end(), 1), --count;
    obstacles[count++] = {at.core, at.core_radius + closing.solids_[solid].growth + closing.radius_};
  }

  ClosedDistance run(const Vector3& start) {
    // The solids that the ball about the start touches keep it away from x.
    const double touched = closing.radius_ + closing.accuracy_;
    asked.include(start, touched);
    for (const Index i : solids_within(start, touched)) {
      if (count + 2 >= most_obstacles) break;
      if (!closing.solids_.is_farther(i, start, touched) && closing.solids_.distance(i, start) < touched)
        add(i, start);
    }
    Vector3 y = start;
    for (int round = 0; round < first_rounds; ++round) {
      if (look(y)) break;
      const NearestOutside nearest(x, std::span(obstacles).first(count));
      if (!nearest.found()) break;
      y = *nearest.found();
    }
    slide(y);
    if (best.value < no_value) lift(y);
    return best;
  }

  /// Searches farther out on the ray from x, where the ball has room, if both methods ended too near to a
  /// solid.
  void lift(const Vector3& towards) {
    Vector3 way = towards - x;
    if (!(way.norm() > closing.accuracy_)) way = closing.radius_ * Vector3::UnitZ();
    const auto has_room = [&](double share) {
      return offer(x + share * way, room_at(x + share * way).distance);
    };
    double low = 0, high = 1;
    for (int k = 0; k < 40 && !has_room(high); ++k) low = high, high *= 2;
    for (int k = 0; k < 16; ++k) {
      const double middle = 0.5 * (low + high);
      (has_room(middle) ? high : low) = middle;
    }
    // Fallback value: a ball at the distance of its own radius.
    if (best.value < no_value)
      best.value = std::min(room_at(x).distance, 0.0) - closing.radius_, best.centre = x;
  }

  /// Tangent planes of the solids nearest to the ball about y.
  std::size_t planes_about(const Vector3& y, double slack, std::array<TangentPlane, most_planes>& planes) {
    const double radius = closing.radius_;
    std::size_t found = 0;
    double least = radius;
    for (const Index i : solids_within(y, radius + slack)) {
      if (closing.solids_.is_farther(i, y, radius + slack)) continue;
      const SolidPlace at = closing.solids_[i].shape.place(y);
      const double e = at.distance - closing.solids_[i].growth;
      least = std::min(least, e);
      if (e >= radius + slack) continue;
      const TangentPlane one{at.gradient, radius - e, i};
      // Sorted with the nearest solids first.
      if (found == most_planes && planes[found - 1].least >= one.least) continue;
      std::size_t to = found < most_planes ? found++ : found - 1;
      for (; to > 0 && planes[to - 1].least < one.least; --to) planes[to] = planes[to - 1];
      planes[to] = one;
    }
    asked.include(y, found == most_planes ? radius - planes.back().least : radius + slack);
    offer(y, least);
    return found;
  }

  /// Rolls the ball along two solids at once; the step length takes their curvature into account.
  Vector3 rolled(const Vector3& y, const TangentStep& step, std::span<const TangentPlane> planes) const {
    const TangentPlane &a = planes[step.planes[0]], &b = planes[step.planes[1]];
    const Vector3 along = a.direction.cross(b.direction).stableNormalized();
    const double far = along.dot(step.way), trial = 0.01 * closing.radius_;
    const auto bend = [&](const TangentPlane& plane) {
      return along.dot(closing.solids_[plane.solid].shape.place(y + trial * along).gradient -
                       plane.direction) /
             trial;
    };
    const double stiffness = 1 - step.multipliers[0] * bend(a) - step.multipliers[1] * bend(b);
    return step.way + (far / std::max(stiffness, least_stiffness) - far) * along;
  }

  /// Improves a nearly correct centre by steps in tangent planes; true where they end.
  bool slide(Vector3 y) {
    const double accuracy = closing.accuracy_;
    std::array<TangentPlane, most_planes> planes;
    double slack = 0.25 * closing.radius_;
    bool ended = false;
    for (int round = 0; round < most_steps && !ended; ++round) {
      const std::span<const TangentPlane> near(planes.data(), planes_about(y, slack, planes));
      const std::optional<TangentStep> step = tangent_step(x - y, near, 0.1 * accuracy);
      if (!step) return false;
      const Vector3 way = step->active == 2 ? rolled(y, *step, near) : step->way;
      y += way;
      slack = std::max(2 * way.norm(), accuracy);
      ended = way.norm() < accuracy;
    }
    offer(y, room_at(y).distance);
    return ended;
  }
};

ClosedDistance Closing::at(const Vector3& x, const Vector3* start, ClosingReach* reach, bool thorough) const {
  const auto depends = [&](const ClosingReach& on) {
    if (reach) *reach = on;
  };
  const NearestSolid nearest = solids_.nearest(x);
  if (nearest.distance >= radius_) {
    depends({x, nearest.distance, no_index});
    return {nearest.distance, x, false};
  }
  const SolidShape& shape = solids_[nearest.solid].shape;
  const Vector3 y = x + (radius_ - nearest.distance) * shape.place(x).gradient;
  const auto blocks = [&](Index i) {
    // Straight away from a convex solid the distance grows by as much as the way.
    if (i == nearest.solid && shape.is_convex()) return false;
    return !solids_.is_farther(i, y, radius_ - accuracy_) && solids_.distance(i, y) < radius_ - accuracy_;
  };
  Index blocker = 0;
  while (blocker < solids_.size() && !blocks(blocker)) ++blocker;
  if (blocker == solids_.size()) {
    // Solids beyond the ball about y are beyond the one about x that touches the nearest solid.
    depends({y, radius_, no_index});
    return {nearest.distance, y, false};
  }
  Search search{*this, x};
  search.asked.include(x, nearest.distance);
  const bool ended = start && search.slide(*start);
  if (search.best.value <= no_value || (thorough && !ended)) search.run(y);
  depends({search.asked.about, search.asked.reach, blocker});
  return search.best;
}

ClosedDistance Closing::improved(const Vector3& x, const ClosedDistance& known, const Vector3& start,
                                 ClosingReach* reach) const {
  Search other{*this, x};
  other.slide(start);
  if (reach) *reach = other.asked;
  return other.best.value > known.value ? other.best : known;
}

SlotTest slot_test(const Closing& smaller, const Closing& larger, double radius, const Vector3& x,
                   const ClosedDistance& here) {
  SlotTest out;
  out.known = true;
  if (here.value >= larger.radius()) return out;
  const auto value_of = [&](const Closing& ball, ClosingReach& reach) {
    const Vector3 start = x + ball.radius() / radius * (here.centre - x);
    return ball.at(x, &start, &reach).value;
  };
  // A smaller ball has the same value where one solid alone determines it.
  const double inner = here.crease ? value_of(smaller, out.smaller) : here.value;
  const double gain = (inner - value_of(larger, out.larger)) / radius;
  const double t = std::clamp((gain - no_slot) / (all_slot - no_slot), 0.0, 1.0);
  out.share = t * t * (3 - 2 * t);
  return out;
}

}  // namespace hariko
