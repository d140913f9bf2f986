#include "core/skinning/section_direction.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace hariko {

namespace {

Vector3 area_vector(const SkinSection& section) {
  Vector3 sum = Vector3::Zero();
  const Vector3 base = section.points[0].position;
  for (std::size_t i = 1; i + 1 < section.points.size(); ++i)
    sum += (section.points[i].position - base).cross(section.points[i + 1].position - base);
  return sum;
}

/// Sum of squared distances at equal parameters, relative to the places on the path.
double gap(const SkinSection& a, const Vector3& at_a, const SkinSection& b, const Vector3& at_b,
           bool turned) {
  constexpr int samples = 32;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double u = double(i) / (samples - 1);
    const Vector3 p = evaluate(a.curve(), u).position - at_a;
    sum += (p - (evaluate(b.curve(), turned ? 1 - u : u).position - at_b)).squaredNorm();
  }
  return sum;
}

}  // namespace

Skin turn_sections(Skin skin) {
  if (skin.path.size() < (skin.path.closed ? 3 : 2)) return skin;
  const SkinSection* before = nullptr;
  double sign = 0;
  for (SkinSection& section : skin.sections) {
    if (section.size() < 2) continue;
    bool turn = false;
    const CurvePoint place = evaluate(skin.path, section.v);
    if (section.closed) {
      const double own = area_vector(section).dot(place.first);
      if (sign == 0) sign = own;
      turn = own * sign < 0;
    } else if (before) {
      const Vector3 at_before = evaluate(skin.path, before->v).position;
      const double straight = gap(*before, at_before, section, place.position, false);
      turn = gap(*before, at_before, section, place.position, true) < 0.99 * straight;
    }
    if (turn && !section.direction_chosen) std::reverse(section.points.begin(), section.points.end());
    before = &section;
  }
  return skin;
}

}  // namespace hariko
