#include "core/envelope/ball/closing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hariko {

namespace {

/// Region that the ball's centre must not enter: a ball inside a solid, enlarged by the radius of the rolling
/// one.
struct Obstacle {
  Vector3 centre;
  double radius;
};

constexpr std::size_t most_obstacles = 8;
constexpr int first_rounds = 8;
constexpr std::size_t most_planes = 4;
constexpr int most_steps = 8;
constexpr double least_stiffness = 0.05;
constexpr double no_value = -1e200;  ///< less than any real value

/// Nearest point to x outside a few obstacles, among the points that lie on the last one.
class NearestOutside {
 public:
  NearestOutside(const Vector3& x, std::span<const Obstacle> obstacles) : x_(x), obstacles_(obstacles) {
    const std::size_t last = obstacles.size() - 1;
    on_one(obstacles[last]);
    for (std::size_t i = 0; i < last; ++i) {
      on_two(obstacles[last], obstacles[i]);
      for (std::size_t j = 0; j < i; ++j) on_three(obstacles[last], obstacles[i], obstacles[j]);
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
  /// Circle of intersection of two spheres: distance of its centre along the unit vector from p to q, and its
  /// radius.
  static std::optional<std::pair<double, double>> circle(const Obstacle& p, const Obstacle& q, double apart) {
    const double way = 0.5 * (apart + (p.radius - q.radius) * (p.radius + q.radius) / apart);
    const double square = (p.radius - way) * (p.radius + way);
    if (!(apart > 0) || !(square > 0)) return {};
    return std::pair{way, std::sqrt(square)};
  }
  void on_two(const Obstacle& p, const Obstacle& q) {
    const Vector3 axis = q.centre - p.centre;
    const double apart = axis.norm();
    const auto round = circle(p, q, apart);
    if (!round) return;
    const Vector3 n = axis / apart, middle = p.centre + round->first * n;
    Vector3 side = x_ - middle;
    side -= side.dot(n) * n;
    double length = side.norm();
    if (!(length > 1e-12 * p.radius)) {
      side = n.unitOrthogonal();
      length = 1;
    }
    offer(middle + round->second / length * side);
  }
  void on_three(const Obstacle& p, const Obstacle& q, const Obstacle& r) {
    const Vector3 axis = q.centre - p.centre;
    const double apart = axis.norm();
    const auto round = circle(p, q, apart);
    if (!round) return;
    const Vector3 ex = axis / apart, to = r.centre - p.centre;
    const double i = ex.dot(to);
    const Vector3 across = to - i * ex;
    const double j = across.norm();
    if (!(j > 1e-9 * apart)) return;
    const Vector3 ey = across / j;
    const double x = round->first;
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

/// Displacement in the intersection of all half-spaces nearest to `target`, with the active planes.
class TangentStep {
 public:
  TangentStep(const Vector3& target, std::span<const TangentPlane> planes, double slack)
      : target_(target), planes_(planes), slack_(slack) {
    offer(target, {}, 0);
    // A feasible displacement with non-negative multipliers is the nearest, and the only one.
    for (std::size_t i = 0; i < planes.size() && !found(); ++i) {
      on_planes({i}, 1);
      for (std::size_t j = 0; j < i && !found(); ++j) {
        on_planes({i, j}, 2);
        for (std::size_t k = 0; k < j && !found(); ++k) on_planes({i, j, k}, 3);
      }
    }
  }

  bool found() const { return found_; }
  const Vector3& way() const { return way_; }
  int active() const { return active_; }
  std::size_t plane(std::size_t i) const { return of_[i]; }
  /// Multipliers of the active planes: the displacement is target plus the sum of them times the directions.
  double multiplier(std::size_t i) const { return multipliers_[Eigen::Index(i)]; }

 private:
  void offer(const Vector3& way, const std::array<std::size_t, 3>& of, int active,
             const Vector3& multipliers = Vector3::Zero()) {
    for (const TangentPlane& plane : planes_)
      if (plane.direction.dot(way) < plane.least - slack_) return;
    found_ = true;
    way_ = way;
    of_ = of;
    active_ = active;
    multipliers_ = multipliers;
  }

  /// Nearest displacement that lies in all of these planes.
  void on_planes(const std::array<std::size_t, 3>& of, int count) {
    constexpr double least_volume = 1e-12;  ///< square of the volume that the unit directions span
    const Vector3 &a = planes_[of[0]].direction, &b = planes_[of[1]].direction, &c = planes_[of[2]].direction;
    const auto miss = [&](std::size_t i) {
      return planes_[of[i]].least - planes_[of[i]].direction.dot(target_);
    };
    Vector3 multipliers = Vector3::Zero();
    Vector3 way = target_;
    if (count == 1) {
      multipliers[0] = miss(0);
      way += multipliers[0] * a;
    } else if (count == 2) {
      const double cosine = a.dot(b), square = 1 - cosine * cosine, miss_a = miss(0), miss_b = miss(1);
      if (!(square > least_volume)) return;
      multipliers.head<2>() << (miss_a - cosine * miss_b) / square, (miss_b - cosine * miss_a) / square;
      way += multipliers[0] * a + multipliers[1] * b;
    } else {
      const Vector3 bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
      const double volume = a.dot(bc);
      if (!(volume * volume > least_volume)) return;
      const Vector3 shift = (miss(0) * bc + miss(1) * ca + miss(2) * ab) / volume;
      multipliers = Vector3(bc.dot(shift), ca.dot(shift), ab.dot(shift)) / volume;
      way += shift;
    }
    if (multipliers.minCoeff() < 0) return;
    offer(way, of, count, multipliers);
  }

  const Vector3& target_;
  std::span<const TangentPlane> planes_;
  double slack_;
  bool found_ = false;
  Vector3 way_ = Vector3::Zero(), multipliers_ = Vector3::Zero();
  std::array<std::size_t, 3> of_{};
  int active_ = 0;
};

}  // namespace

/// Search that adds obstacles where a centre lies too near to a solid, until none does: each is a ball inside
/// the solid, so the centre found is never farther from x than the right one.
struct Closing::Search {
  const Closing& closing;
  const Vector3& x;
  std::span<const Index> among;
  std::array<Obstacle, most_obstacles> obstacles = {};
  std::size_t count = 0;
  ClosedDistance best = {-1e300, {}, true};

  /// Offers a centre y, where `room` is the distance from y to the solids, at most the ball's radius. A ball
  /// that penetrates a solid is refused.
  bool offer(const Vector3& y, double room) {
    if (room < closing.radius_ - closing.accuracy_) return false;
    if (const double value = room - (y - x).norm(); value > best.value) best.value = value, best.centre = y;
    return true;
  }
  NearestSolid room_at(const Vector3& y) const {
    NearestSolid out{no_index, closing.radius_};
    for (const Index i : among) {
      if (closing.solids_.is_farther(i, y, out.distance)) continue;
      if (const double e = closing.solids_.distance(i, y); e < out.distance) out = {i, e};
    }
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
    for (const Index i : among) {
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
    offer(y, least);
    return found;
  }

  /// Rolls the ball along two solids at once; the step length takes their curvature into account.
  Vector3 rolled(const Vector3& y, const TangentStep& step, std::span<const TangentPlane> planes) const {
    const TangentPlane &a = planes[step.plane(0)], &b = planes[step.plane(1)];
    const Vector3 along = a.direction.cross(b.direction).stableNormalized();
    const double far = along.dot(step.way()), trial = 0.01 * closing.radius_;
    const auto bend = [&](const TangentPlane& plane) {
      return along.dot(closing.solids_[plane.solid].shape.place(y + trial * along).gradient -
                       plane.direction) /
             trial;
    };
    const double stiffness = 1 - step.multiplier(0) * bend(a) - step.multiplier(1) * bend(b);
    return step.way() + (far / std::max(stiffness, least_stiffness) - far) * along;
  }

  /// Improves a nearly correct centre by steps in tangent planes.
  void slide(Vector3 y) {
    const double accuracy = closing.accuracy_;
    std::array<TangentPlane, most_planes> planes;
    double slack = 0.25 * closing.radius_;
    for (int round = 0; round < most_steps; ++round) {
      const std::span<const TangentPlane> about(planes.data(), planes_about(y, slack, planes));
      const TangentStep step(x - y, about, 0.1 * accuracy);
      if (!step.found()) return;
      const Vector3 way = step.active() == 2 ? rolled(y, step, about) : step.way();
      y += way;
      slack = std::max(2 * way.norm(), accuracy);
      if (way.norm() < accuracy) {
        planes_about(y, 0, planes);
        return;
      }
    }
    planes_about(y, 0, planes);
  }
};

ClosedDistance Closing::search(const Vector3& x, const Vector3& start, std::span<const Index> among) const {
  Search search{*this, x, among};
  // The solids that the ball about the start touches keep it away from x.
  for (const Index i : among) {
    if (search.count + 2 >= most_obstacles) break;
    if (!solids_.is_farther(i, start, radius_ + accuracy_) &&
        solids_.distance(i, start) < radius_ + accuracy_)
      search.add(i, start);
  }
  return search.run(start);
}

ClosedDistance Closing::at(const Vector3& x, std::span<const Index> among, const Vector3* start) const {
  const NearestSolid nearest = solids_.nearest(x, among);
  if (nearest.distance >= radius_) return {nearest.distance, x, false};
  const SolidShape& shape = solids_[nearest.solid].shape;
  const Vector3 y = x + (radius_ - nearest.distance) * shape.place(x).gradient;
  const bool free = std::ranges::all_of(among, [&](Index i) {
    // Straight away from a convex solid the distance grows by as much as the way.
    if (i == nearest.solid && shape.is_convex()) return true;
    return solids_.is_farther(i, y, radius_ - accuracy_) || solids_.distance(i, y) >= radius_ - accuracy_;
  });
  if (free) return {nearest.distance, y, false};
  if (start) {
    Search near{*this, x, among};
    near.slide(*start);
    if (near.best.value > no_value) return near.best;
  }
  return search(x, y, among);
}

ClosedDistance Closing::improved(const Vector3& x, const ClosedDistance& known, const Vector3& start,
                                 std::span<const Index> among) const {
  Search other{*this, x, among};
  other.slide(start);
  return other.best.value > known.value ? other.best : known;
}

}  // namespace hariko
