#include "core/gaussmap/outlines/interpolate_normals.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/base/assert.hpp"
#include "core/geometry/polygon.hpp"
#include "core/geometry/rotation.hpp"

namespace hariko {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

Vector3 rejection(const Vector3& v, const Vector3& unit) {
  return v - v.dot(unit) * unit;
}

/// Rotation-minimising frame of a loop: unit vectors perpendicular to it.
class LoopFrame {
 public:
  explicit LoopFrame(std::span<const Vector3> points) : tangents_(loop_tangents(points)) {
    const std::size_t count = points.size();
    Vector3 first = rejection(vector_area(points), tangents_[0]);
    first = first.norm() > 1e-9 * vector_area(points).norm() && first.norm() > 0
                ? Vector3(first.normalized())
                : tangents_[0].unitOrthogonal();
    lengths_.push_back(0);
    references_.push_back(first);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3 chord = points[(i + 1) % count] - points[i];
      lengths_.push_back(lengths_.back() + chord.norm());
      references_.push_back(carried_along(references_[i], tangents_[i], tangents_[(i + 1) % count], chord));
    }
    // Distributes the closing angle of the frame evenly over the length.
    const double closing = angle(0, references_.back());
    references_.pop_back();
    for (std::size_t i = 0; i < count; ++i) references_[i] = at(i, -closing * lengths_[i] / lengths_.back());
  }

  const Vector3& tangent(std::size_t i) const { return tangents_[i]; }
  /// Arc length up to each point; the last entry is the whole length.
  const std::vector<double>& lengths() const { return lengths_; }
  /// Angle from the reference to a vector, about the loop.
  double angle(std::size_t i, const Vector3& v) const {
    return std::atan2(v.dot(tangents_[i].cross(references_[i])), v.dot(references_[i]));
  }
  Vector3 at(std::size_t i, double angle) const {
    return rejection(std::cos(angle) * references_[i] + std::sin(angle) * tangents_[i].cross(references_[i]),
                     tangents_[i])
        .normalized();
  }

 private:
  std::vector<Vector3> tangents_, references_;
  std::vector<double> lengths_;
};

/// Smooth function round a loop that stays between its given values: cubic pieces with harmonic means for
/// slopes (Fritsch and Butland 1984). It may gain a constant on each round.
class AngleCurve {
 public:
  /// Makes the function. `places` ascending, below `period`; values of the second round are larger by `gain`.
  AngleCurve(std::vector<double> places, std::vector<double> values, double period, double gain)
      : places_(std::move(places)), values_(std::move(values)), period_(period) {
    places_.push_back(places_[0] + period);
    values_.push_back(values_[0] + gain);
    const std::size_t count = places_.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      const double before = slope((i + count - 1) % count), after = slope(i);
      slopes_.push_back(before * after > 0 ? 2 * before * after / (before + after) : 0);
    }
    slopes_.push_back(slopes_[0]);
  }
  double at(double place) const {
    double shift = 0;
    if (place < places_[0]) {
      place += period_;
      shift = values_[0] - values_.back();
    }
    std::size_t i = 0;
    while (i + 2 < places_.size() && places_[i + 1] <= place) ++i;
    const double length = places_[i + 1] - places_[i], x = (place - places_[i]) / length, y = 1 - x;
    return shift + y * y * (1 + 2 * x) * values_[i] + x * x * (1 + 2 * y) * values_[i + 1] +
           length * (x * y * y * slopes_[i] - x * x * y * slopes_[i + 1]);
  }

 private:
  double slope(std::size_t i) const { return (values_[i + 1] - values_[i]) / (places_[i + 1] - places_[i]); }
  std::vector<double> places_, values_, slopes_;
  double period_;
};

}  // namespace

std::vector<Vector3> loop_tangents(std::span<const Vector3> points) {
  const std::size_t count = points.size();
  std::vector<Vector3> out;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 &after = points[(i + 1) % count], chord = after - points[(i + count - 1) % count];
    out.push_back((chord.norm() > 0 ? chord : Vector3(after - points[i])).stableNormalized());
  }
  return out;
}

Vector3 vector_area(std::span<const Vector3> points) {
  return newell_normal(points) / 2;
}

std::vector<Vector3> spread_normals(std::span<const Vector3> points,
                                    std::span<const std::pair<std::size_t, Vector3>> given) {
  HARIKO_ASSERT(points.size() >= 3, "a loop");
  const LoopFrame frame(points);
  std::vector<double> places, angles;
  for (const auto& [place, normal] : given) {
    const Vector3 across = rejection(normal, frame.tangent(place));
    if (!(across.norm() > 1e-9 * normal.norm())) continue;
    double angle = frame.angle(place, across);
    if (!angles.empty()) angle = angles.back() + std::remainder(angle - angles.back(), full_turn);
    places.push_back(frame.lengths()[place]);
    angles.push_back(angle);
  }
  std::vector<Vector3> out;
  if (angles.empty()) return tilted_normals(points, vector_area(points), 0);
  // From the last value to the first one by the shorter way, too.
  const double back = std::remainder(angles.front() - angles.back(), full_turn);
  const double gain = angles.back() + back - angles.front();
  const AngleCurve curve(std::move(places), std::move(angles), frame.lengths().back(), gain);
  for (std::size_t i = 0; i < points.size(); ++i) out.push_back(frame.at(i, curve.at(frame.lengths()[i])));
  return out;
}

std::vector<Vector3> tilted_normals(std::span<const Vector3> points, const Vector3& axis, double tilt) {
  std::vector<Vector3> out;
  for (const Vector3& tangent : loop_tangents(points)) {
    Vector3 up = rejection(axis.stableNormalized(), tangent);
    up = up.norm() > 1e-9 ? Vector3(up.normalized()) : tangent.unitOrthogonal();
    out.push_back(std::cos(tilt) * up + std::sin(tilt) * tangent.cross(up));
  }
  return out;
}

}  // namespace hariko
