#include <cmath>
#include <numbers>

#include "core/envelope/solid_shape.hpp"

namespace hariko {

namespace {

/// Weight of the centres, relative to the weight 1 of the distance between the ends.
constexpr double drawn_share = 0.05;
constexpr int bridge_rounds = 100;        ///< each leaves at most 1.05^-2 of the error, all of them 6e-5
constexpr double shortest_bridge = 1e-3;  ///< length relative to the radius: a capsule must have a length

Vector3 nearest_in(const SolidShape& shape, const Vector3& point) {
  const SolidPlace place = shape.place(point);
  return place.distance > 0 ? Vector3(point - place.distance * place.gradient) : point;
}

}  // namespace

Solid bridge_between(const Solid& a, const Solid& b, double radius) {
  const Vector3 origin = 0.5 * (a.position + b.position);
  const SolidShape from(a, origin), to(b, origin);
  // Minimises the sum of the distance and the pulls to the centres, for each end in turn.
  Vector3 p = from.centre(), q = to.centre();
  for (int round = 0; round < bridge_rounds; ++round) {
    q = nearest_in(to, (p + drawn_share * to.centre()) / (1 + drawn_share));
    p = nearest_in(from, (q + drawn_share * from.centre()) / (1 + drawn_share));
  }
  Solid out;
  out.kind = SolidKind::capsule;
  out.radius = radius;
  out.bridge = Bridge{{a.id, b.id}, {}};
  out.length = std::max((q - p).norm(), shortest_bridge * radius);
  out.position = origin + 0.5 * (p + q);
  const Vector3 way = q - p;
  constexpr double degrees = 180 / std::numbers::pi;
  const double aside = std::hypot(way.x(), way.y());
  out.rotation = {0, degrees * std::atan2(aside, way.z()),
                  aside > 0 ? degrees * std::atan2(way.y(), way.x()) : 0};
  return out;
}

}  // namespace hariko
