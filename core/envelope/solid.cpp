#include "core/envelope/solid.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/solvers/small_solver.hpp"

namespace hariko {

namespace {

bool positive(double x) {
  return std::isfinite(x) && x > 0;
}

/// Largest length of a scene, for which no product of three lengths overflows.
constexpr double largest_length = 1e12;

class SolidCheck {
 public:
  SolidCheck(const Solid& solid, std::size_t index) : solid_(solid), index_(index) {}

  Result<Done> check() {
    sizes();
    shape();
    if (!solid_.position.allFinite() || solid_.position.cwiseAbs().maxCoeff() > largest_length)
      fail(e_solid_place, "position is not a finite place", "Give it three finite numbers.");
    if (!solid_.rotation.allFinite())
      fail(e_solid_place, "rotation is not finite", "Give it three angles in degrees.");
    for (int i = 0; i < 3; ++i)
      if (!positive(solid_.scale[i]))
        fail(e_solid_size, "scale must be positive", "Give it three positive factors.");
    if (solid_.roundness && !(*solid_.roundness > 0 && *solid_.roundness <= 1))
      fail(e_envelope_setting, "roundness must be above 0 and at most 1", "Choose a value such as 0.35.");
    if (solid_.bridge && solid_.bridge->ball_radius) length(*solid_.bridge->ball_radius, "ball_radius");
    if (!error_) pulls();
    if (error_) return *error_;
    return Done{};
  }

 private:
  void fail(Code code, const std::string& what, std::string remedy) {
    if (error_) return;
    error_ = make_error(
        code,
        "Solid " + std::to_string(index_) + " (" + std::string(name_of(solid_.kind)) + "): " + what + ".",
        std::move(remedy), {Element::Kind::object, index_});
  }
  void length(double value, const char* field) {
    if (!positive(value) || value > largest_length)
      fail(e_solid_size, std::string(field) + " must be a positive length", "Make it larger than zero.");
  }
  void sizes() {
    const SolidKind kind = solid_.kind;
    if (kind == SolidKind::box)
      for (int i = 0; i < 3; ++i) length(solid_.size[i], "size");
    else if (kind != SolidKind::polyhedron)
      length(solid_.radius, "radius");
    if (kind == SolidKind::cylinder || kind == SolidKind::cone || kind == SolidKind::prism ||
        kind == SolidKind::pyramid)
      length(solid_.height, "height");
    if (kind == SolidKind::capsule) length(solid_.length, "length");
    if (kind == SolidKind::torus) length(solid_.tube, "tube");
  }
  void shape() {
    const SolidKind kind = solid_.kind;
    if ((kind == SolidKind::prism || kind == SolidKind::pyramid) &&
        (solid_.sides < 3 || solid_.sides > max_solid_sides))
      fail(e_solid_sides, "sides must be 3 to " + std::to_string(max_solid_sides),
           "Choose a number such as 6.");
    if (kind == SolidKind::torus && !(solid_.tube < solid_.radius))
      fail(e_solid_tube, "tube must be smaller than radius", "Make the tube thinner or the radius larger.");
    if (kind == SolidKind::polyhedron) points();
  }
  void points() {
    const std::string name = "vertices";
    if (solid_.points.size() < 4) {
      fail(e_solid_points, name + " must be at least 4 points", "Add points.");
      return;
    }
    if (solid_.points.size() > max_solid_points)
      fail(e_solid_points, name + " must be at most " + std::to_string(max_solid_points) + " points",
           "Leave points out that lie inside.");
    Vector3 mean = Vector3::Zero();
    for (const Vector3& p : solid_.points) {
      if (!p.allFinite() || p.cwiseAbs().maxCoeff() > largest_length) {
        fail(e_solid_points, name + " has a point that is not finite",
             "Give every point finite coordinates.");
        return;
      }
      mean += p / double(solid_.points.size());
    }
    double size = 0;
    for (const Vector3& p : solid_.points) size = std::max(size, (p - mean).norm());
    if (size == 0) {
      fail(e_solid_flat, name + " lie in one point", "Move them apart.");
      return;
    }
    Matrix3 spread = Matrix3::Zero();
    for (const Vector3& p : solid_.points) spread += (p - mean) * (p - mean).transpose() / (size * size);
    const double least = symmetric_axes(spread).values[0];
    if (!(std::sqrt(std::max(least, 0.0)) > 1e-9))
      fail(e_solid_flat, name + " lie in a plane", "Move one of them out of the plane.");
  }

  void pulls() {
    if (solid_.pulls.size() > max_pulls)
      fail(e_solid_pull, "the surface can be pulled at " + std::to_string(max_pulls) + " places at the most",
           "Remove some of its pulls.");
    const Eigen::AlignedBox3d box = box_of(solid_);
    for (const Pull& pull : solid_.pulls) {
      length(pull.radius, "radius of a pull");
      const Vector3 at = placed(solid_, pull.place);
      if (!((at - box.center()).norm() <= farthest_pull * box.diagonal().norm()))
        fail(e_solid_pull, "a pull is farther away than twice the solid's size",
             "Pull less far, or place another solid there.");
    }
  }

  const Solid& solid_;
  std::size_t index_;
  std::optional<Message> error_;
};

Message setting_error(const char* name, const char* range) {
  return make_error(e_envelope_setting, std::string("The setting \"") + name + "\" must be " + range + ".",
                    "Choose a value in this range.");
}

}  // namespace

Result<Done> check_solid(const Solid& solid, std::size_t index) {
  return SolidCheck(solid, index).check();
}

Result<Done> check_envelope(const EnvelopeInput& input) {
  if (input.solids.empty())
    return make_error(e_no_solids, "There are no solids to envelop.", "Place at least one solid.");
  if (input.solids.size() > max_solids)
    return make_error(e_too_many_solids,
                      "There are " + std::to_string(input.solids.size()) +
                          " solids; an envelope has at most " + std::to_string(max_solids) + ".",
                      "Distribute them over several objects.");
  for (std::size_t k = 0; k < input.solids.size(); ++k)
    if (auto checked = check_solid(input.solids[k], k); !checked) return checked;
  const EnvelopeSettings& s = input.settings;
  if (!(s.roundness > 0 && s.roundness <= 1)) return setting_error("roundness", "above 0 and at most 1");
  if (!(s.clearance >= 0 && s.clearance <= largest_length))
    return setting_error("clearance", "a length of at least 0");
  if (s.method == EnvelopeMethod::ball && !(positive(s.rounding) && s.rounding <= largest_length))
    return setting_error("rounding", "a length above 0");
  if (s.ball_radius && !(positive(*s.ball_radius) && *s.ball_radius <= largest_length))
    return setting_error("ball_radius", "a length above 0, or \"hull\"");
  return Done{};
}

Eigen::AlignedBox3d box_of(const Solid& solid) {
  Eigen::AlignedBox3d own;
  const double r = solid.radius, height = solid.height;
  const auto upright = [&](double radius, double low, double high) {
    own.extend(Vector3(-radius, -radius, low)).extend(Vector3(radius, radius, high));
  };
  switch (solid.kind) {
    case SolidKind::box:
      own.extend(Vector3(-0.5 * solid.size)).extend(Vector3(0.5 * solid.size));
      break;
    case SolidKind::sphere:
      upright(r, -r, r);
      break;
    case SolidKind::cylinder:
    case SolidKind::prism:
      upright(r, -height / 2, height / 2);
      break;
    case SolidKind::cone:
    case SolidKind::pyramid:
      upright(r, -height / 4, 3 * height / 4);
      break;
    case SolidKind::capsule:
      upright(r, -solid.length / 2 - r, solid.length / 2 + r);
      break;
    case SolidKind::torus:
      upright(r + solid.tube, -solid.tube, solid.tube);
      break;
    case SolidKind::polyhedron:
      for (const Vector3& point : solid.points) own.extend(point);
      break;
  }
  Eigen::AlignedBox3d out;
  const Matrix3 rotation = solid_rotation(solid.rotation);
  for (int i = 0; i < 8 && !own.isEmpty(); ++i) {
    const Vector3 corner = own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    out.extend(Vector3(solid.position + rotation * corner.cwiseProduct(solid.scale)));
  }
  return out;
}

Vector3 placed(const Solid& solid, const Vector3& own) {
  return solid.position + solid_rotation(solid.rotation) * own.cwiseProduct(solid.scale);
}

Vector3 own_place(const Solid& solid, const Vector3& point) {
  return (solid_rotation(solid.rotation).transpose() * (point - solid.position)).cwiseQuotient(solid.scale);
}

Matrix3 solid_rotation(const Vector3& degrees) {
  const Vector3 a = degrees * (std::numbers::pi / 180);
  return (Eigen::AngleAxisd(a.z(), Vector3::UnitZ()) * Eigen::AngleAxisd(a.y(), Vector3::UnitY()) *
          Eigen::AngleAxisd(a.x(), Vector3::UnitX()))
      .toRotationMatrix();
}

void add_polygon(std::vector<Vector3>& points, std::uint32_t sides, double radius, double z, double phase) {
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double a = 2 * std::numbers::pi * (k + phase) / sides;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
  }
}

}  // namespace hariko
