#include "core/envelope/cage_frames.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace hariko {

namespace {

constexpr int ascent_steps = 200, bisections = 20;
constexpr double near_least = 1e-3;
constexpr double least_own = 0.05;  ///< of a solid's own frame

double least_product(std::span<const Vector3> normals, const Vector3& n) {
  double out = 1;
  for (const Vector3& m : normals) out = std::min(out, m.dot(n));
  return out;
}

/// From `n` towards the maximin normal as little as gives every corner `wanted`, or `share` of the best.
Vector3 moved(std::span<const Vector3> corners, const Vector3& n, double wanted, double share) {
  const Vector3 best = maximin_normal(corners);
  const double limit = std::min(wanted, share * least_product(corners, best));
  if (least_product(corners, n) >= limit) return n;
  const auto blend = [&](double x) -> Vector3 { return ((1 - x) * n + x * best).stableNormalized(); };
  double low = 0, high = 1;
  for (int round = 0; round < bisections; ++round) {
    const double x = 0.5 * (low + high);
    (least_product(corners, blend(x)) >= limit ? high : low) = x;
  }
  return blend(high);
}

}  // namespace

Vector3 maximin_normal(std::span<const Vector3> normals) {
  Vector3 x = Vector3::Zero();
  for (const Vector3& m : normals) x += m;
  x = x.stableNormalized();
  if (x.isZero(0)) x = normals[0];
  Vector3 best = x;
  double most = least_product(normals, x);
  for (int k = 0; k < ascent_steps; ++k) {
    const double least = least_product(normals, x);
    Vector3 pull = Vector3::Zero();
    int count = 0;
    for (const Vector3& m : normals)
      if (m.dot(x) <= least + near_least) pull += m, ++count;
    x = (x + 0.5 / (k + 2) * pull / count).stableNormalized();
    if (const double now = least_product(normals, x); now > most) most = now, best = x;
  }
  return best;
}

void put_on_solid(CageVertex& vertex, const PlacedSolid& solid) {
  vertex.unit = solid.to_unit * (vertex.position - solid.centre);
  vertex.radial = (vertex.position - solid.centre).stableNormalized();
  vertex.normal = (solid.to_unit.transpose() * vertex.unit).stableNormalized();
  vertex.guarded = false;
}

void set_valley_frames(NetworkCage& cage) {
  std::vector<std::vector<Vector3>> corners(cage.vertices.size());
  for (const CageFace& face : cage.faces) {
    const Vector3 newell = newell_normal(face.loop, cage.vertices);
    const std::size_t n = face.loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3& at = cage.vertices[face.loop[i]].position;
      const Vector3 next = cage.vertices[face.loop[(i + 1) % n]].position - at;
      const Vector3 before = cage.vertices[face.loop[(i + n - 1) % n]].position - at;
      const Vector3 own = next.cross(before).stableNormalized();
      corners[face.loop[i]].push_back(own.dot(newell) > 0 ? own : newell);
    }
  }
  for (std::size_t v = 0; v < corners.size(); ++v) {
    CageVertex& vertex = cage.vertices[v];
    if (corners[v].empty()) continue;
    if (vertex.solid == no_index) {
      vertex.normal = vertex.radial = moved(corners[v], vertex.outward, 1, 0.9);
      continue;
    }
    const bool seen = least_product(corners[v], vertex.radial) >= least_own;
    if (seen && least_product(corners[v], vertex.normal) >= least_own) continue;
    vertex.normal = moved(corners[v], vertex.normal, 0.2, 0.8);
    if (!seen) vertex.radial = vertex.normal;
    vertex.guarded = true;
  }
}

}  // namespace hariko
