#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/envelope/network/curve_network.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {

namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double widest_sector = 150 * radians, narrowest_sector = 20 * radians;
constexpr double parabola_angle = 18 * radians;

struct Side {
  Vector3 middle, tangent, normal;  ///< midpoint Pd, unit tangent, outward normal nd
  double weight;
};

class FaceSplitter {
 public:
  FaceSplitter(std::span<const RibbonCurve> loop, const NetworkSolid* solid) : loop_(loop), solid_(solid) {}

  FaceSplit split() {
    take_sides();
    place_centre();
    spread();
    FaceSplit out;
    out.centre = centre_;
    out.normal = normal_;
    for (std::size_t k = 0; k < sides_.size(); ++k) out.spokes.push_back(spoke(k));
    return out;
  }

 private:
  void take_sides() {
    for (const RibbonCurve& curve : loop_) {
      const Vector3 across = 0.5 * (curve.across[0] + curve.across[1]);
      Side side;
      side.middle = curve.middle();
      side.tangent = curve.middle_derivative().stableNormalized();
      side.normal = side.tangent.cross(across).stableNormalized();
      side.weight = curve.halves().first.curve[3].w();
      sides_.push_back(side);
      normal_ += side.normal;
      mean_ += side.middle / double(loop_.size());
    }
    normal_ = normal_.stableNormalized();
    if (normal_.isZero(0)) normal_ = Vector3::UnitZ();
  }

  Vector3 flattened(const Vector3& v) const { return v - v.dot(normal_) * normal_; }

  /// Direction towards a point in the tangent plane at a side's midpoint; never along the side or out of the
  /// face.
  Vector3 aim(const Side& side, const Vector3& target) const {
    const Vector3 q = target - side.middle;
    Vector3 c = q - q.dot(side.normal) * side.normal;
    const Vector3 inward = side.normal.cross(side.tangent);
    const double size = c.norm();
    const double in = std::max(c.dot(inward), 0.25 * size);
    const double along = std::clamp(c.dot(side.tangent), -1.2 * in, 1.2 * in);
    c = in * inward + along * side.tangent;
    const double wanted = flattened(q).norm(), has = flattened(c).norm();
    return has > 0 ? Vector3(c * std::min(2.0, wanted / has)) : c;
  }

  void place_centre() {
    Vector3 reached = Vector3::Zero();
    for (const Side& side : sides_) reached += (side.middle + 0.5 * aim(side, mean_)) / double(sides_.size());
    centre_ = mean_ + (reached - mean_).dot(normal_) * normal_;
    if (solid_) move_to_primitive();
  }

  /// Moves the centre outwards on a primitive part. The paper moves it to the arcs' radius, which holds for
  /// arcs about the centroid only; here the move is proportional to the arcs' sagitta.
  void move_to_primitive() {
    const auto to_unit = [&](const Vector3& p) -> Vector3 { return solid_->to_unit * (p - solid_->centre); };
    const Vector3 ray = to_unit(centre_).stableNormalized();
    Vector3 area = Vector3::Zero(), corner_mean = Vector3::Zero();
    double radius = 0, share = 0, shares = 0;
    const Vector3 first = to_unit(loop_[0].start());
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      const Vector3 a = to_unit(loop_[k].start()), b = to_unit(loop_[k].end());
      area += (a - first).cross(b - first);
      corner_mean += a / double(loop_.size());
      radius += a.norm() / double(loop_.size());
      const double chord = (0.5 * (a + b)).norm(), ends = 0.5 * (a.norm() + b.norm());
      if (ends - chord > 1e-9 * ends) {
        share += (to_unit(sides_[k].middle).norm() - chord) / (ends - chord);
        ++shares;
      }
    }
    if (shares == 0 || !(std::abs(area.dot(ray)) > 1e-12 * area.norm())) return;
    const double h = area.dot(corner_mean) / area.dot(ray);
    const double length = h + share / shares * (radius - h);
    if (!(length > 0) || !std::isfinite(length)) return;
    centre_ = solid_->world(length * ray);
    const Vector3 n = (solid_->to_unit.transpose() * ray).stableNormalized();
    if (n.dot(normal_) > 0) normal_ = n;
  }

  /// Chooses the directions of the spokes at the centre: in the loop's order, no sector too wide or too
  /// narrow.
  void spread() {
    const std::size_t n = sides_.size();
    std::vector<Vector3> outward;
    for (const Side& side : sides_) outward.push_back(flattened(side.middle - centre_));
    const Vector3 x = outward[0].stableNormalized(), y = normal_.cross(x);
    std::vector<double> sector;
    double total = 0;
    for (std::size_t k = 0; k < n; ++k) {
      sector.push_back(signed_angle(outward[k], outward[(k + 1) % n], normal_));
      total += sector[k];
    }
    // If the sectors do not add up to one turn, the loop winds differently round the centre and even sectors
    // are used.
    const bool once = std::abs(total - 2 * std::numbers::pi) < 1e-6;
    const double even = 2 * std::numbers::pi / double(n);
    const double narrow = std::min(narrowest_sector, 0.6 * even);
    const auto good = [&](double blend) {
      return std::ranges::all_of(sector, [&](double s) {
        const double b = s + blend * (even - s);
        return b >= narrow && b <= std::max(widest_sector, even);
      });
    };
    spread_ = !once || !good(0);
    directions_ = outward;
    if (!spread_) return;
    int step = 1;
    while (step < 41 && !(once && good(step / 41.0))) ++step;
    const double blend = step / 41.0;
    std::vector<double> angle(n, 0);
    for (std::size_t k = 1; k < n; ++k)
      angle[k] = angle[k - 1] + sector[k - 1] + blend * (even - sector[k - 1]);
    if (!once)
      for (std::size_t k = 0; k < n; ++k) angle[k] = even * double(k);
    // Rotates the star to the mean direction of the sides.
    double sine = 0, cosine = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double a = std::atan2(outward[k].dot(y), outward[k].dot(x));
      sine += std::sin(a - angle[k]);
      cosine += std::cos(a - angle[k]);
    }
    const double turn = std::atan2(sine, cosine);
    for (std::size_t k = 0; k < n; ++k)
      directions_[k] = outward[k].norm() * (std::cos(angle[k] + turn) * x + std::sin(angle[k] + turn) * y);
  }

  RibbonCurve spoke(std::size_t k) const {
    const Side& side = sides_[k];
    const Vector3 c = aim(side, centre_);
    Vector3 p1 = side.middle + c / 3, p2 = centre_ + directions_[k] / 3;
    const double denominator = c.dot(normal_);
    const double t = denominator != 0 ? (centre_ - side.middle).dot(normal_) / denominator : -1;
    if (!spread_ && t > 0.2 && t < 0.8) {
      const Vector3 pm = side.middle + t * c, back = pm - centre_;
      if (back.dot(directions_[k]) > std::cos(parabola_angle) * back.norm() * directions_[k].norm()) {
        p1 = (side.middle + 2 * pm) / 3;
        p2 = (centre_ + 2 * pm) / 3;
      }
    }
    const double w = side.weight;
    RibbonCurve out;
    // The end on the side equals that of the side's halves, bit for bit.
    out.curve = {loop_[k].halves().first.curve[3], homogeneous(p1, (2 * w + 1) / 3),
                 homogeneous(p2, (w + 2) / 3), homogeneous(centre_)};
    out.across = {side.normal.cross(p1 - side.middle).stableNormalized(),
                  normal_.cross(centre_ - p2).stableNormalized()};
    return out;
  }

  std::span<const RibbonCurve> loop_;
  const NetworkSolid* solid_;
  std::vector<Side> sides_;
  Vector3 normal_ = Vector3::Zero(), mean_ = Vector3::Zero(), centre_ = Vector3::Zero();
  std::vector<Vector3> directions_;
  bool spread_ = false;
};

}  // namespace

FaceSplit split_face(std::span<const RibbonCurve> loop, const NetworkSolid* solid) {
  return FaceSplitter(loop, solid).split();
}

std::vector<std::array<RibbonCurve, 4>> split_loops(std::span<const RibbonCurve> loop,
                                                    const FaceSplit& split) {
  std::vector<std::array<RibbonCurve, 4>> out;
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = (k + n - 1) % n;
    out.push_back({loop[k].halves().first, split.spokes[k], split.spokes[before].reversed(),
                   loop[before].halves().second});
  }
  return out;
}

}  // namespace hariko
