#include "core/envelope/scene_symmetry.hpp"

#include <algorithm>

#include "core/envelope/solid_shape.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

namespace {

constexpr double nearly = 1e-9;     ///< distance of coinciding points, relative to the size
constexpr double rounding = 1e-13;  ///< precision of positions, relative to their distance from the origin
constexpr int places = 24;          ///< number of points of a solid that are compared with its image

/// Sample points that identify a solid among others of its kind.
std::vector<Vector3> places_of(const SolidShape& shape) {
  std::vector<Vector3> out = shape.surface_points(places);
  for (const SharpCurve& curve : shape.sharp_curves())
    for (const double share : {0.0, 0.3, 1.0}) out.push_back(curve.at(share));
  return out;
}

/// Whether both shapes are the same set of points.
bool same(const SolidShape& a, const SolidShape& b) {
  const double tolerance = nearly * a.reach() + rounding * a.centre().norm();
  const auto lies_on = [&](const SolidShape& from, const SolidShape& to) {
    return std::ranges::all_of(places_of(from),
                               [&](const Vector3& p) { return std::abs(to.distance(p)) <= tolerance; });
  };
  return lies_on(a, b) && lies_on(b, a);
}

/// Gives a solid the pulls of another one of the same form and place, unless it has them.
void add_pulls(Solid& solid, const Solid& from, double reach) {
  for (const Pull& pull : from.pulls) {
    const Vector3 at = placed(from, pull.place);
    const bool known = std::ranges::any_of(solid.pulls, [&](const Pull& own) {
      return (placed(solid, own.place) - at).norm() <= nearly * reach;
    });
    if (!known) solid.pulls.push_back({own_place(solid, at), pull.radius});
  }
}

void add_images(EnvelopedScene& scene) {
  const std::vector<Solid> authored = scene.input.solids;
  std::vector<SolidShape> shapes;
  for (const Solid& solid : authored) shapes.emplace_back(solid, Vector3::Zero());
  std::vector<char> paired(authored.size(), 0);
  for (Index k = 0; k < authored.size(); ++k) {
    if (paired[k]) continue;
    const Solid image = reflected(authored[k], *scene.mirror);
    const SolidShape shape(image, Vector3::Zero());
    Index other = k;
    while (other < authored.size() &&
           !(!paired[other] && authored[other].kind == image.kind &&
             authored[other].roundness == image.roundness && same(shape, shapes[other])))
      ++other;
    if (other < authored.size()) {
      paired[other] = 1;
      std::vector<Solid>& solids = scene.input.solids;
      add_pulls(solids[other], image, shape.reach());
      if (other != k) add_pulls(solids[k], reflected(authored[other], *scene.mirror), shape.reach());
    } else {
      scene.input.solids.push_back(image);
      scene.image_of.push_back(k);
    }
  }
}

}  // namespace

Solid reflected(const Solid& solid, Eigen::Index axis) {
  // All kinds are symmetric in their own y: M R M_y is a rotation, with these angles.
  Solid out = solid;
  out.position[axis] = -out.position[axis];
  const Vector3& r = solid.rotation;
  out.rotation = axis == 0   ? Vector3(-r.x(), r.y(), 180 - r.z())
                 : axis == 1 ? Vector3(-r.x(), r.y(), -r.z())
                             : Vector3(180 - r.x(), -r.y(), r.z());
  for (Vector3& p : out.points) p.y() = -p.y();
  for (Pull& pull : out.pulls) pull.place.y() = -pull.place.y();
  return out;
}

EnvelopedScene enveloped_scene(const EnvelopeInput& input) {
  EnvelopedScene out;
  out.input = input;
  for (Index k = 0; k < input.solids.size(); ++k) out.image_of.push_back(k);
  if (input.settings.symmetry != SymmetryPlane::none) {
    out.mirror = static_cast<Eigen::Index>(input.settings.symmetry) - 1;
    add_images(out);
  }
  std::vector<Vector3> corners;
  for (const Solid& solid : out.input.solids) {
    const Eigen::AlignedBox3d box = box_of(solid);
    corners.push_back(box.min());
    corners.push_back(box.max());
  }
  out.origin = origin_for(corners);
  if (out.mirror) out.origin[*out.mirror] = 0;
  return out;
}

std::vector<Solid> images_of(const EnvelopeInput& input) {
  if (input.settings.symmetry == SymmetryPlane::none) return {};
  std::vector<Solid> all = enveloped_scene(input).input.solids;
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(input.solids.size()));
  return all;
}

}  // namespace hariko
