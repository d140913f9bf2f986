#include "core/surface/surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

bool is_fraction(double x) {
  return x >= 0 && x <= 1;
}

/// Index of the corner at a parameter, or -1.
int corner_at(Domain domain, const Vector2& parameter) {
  for (int c = 0; c < corner_count(domain); ++c)
    if ((corner_parameter(domain, c) - parameter).cwiseAbs().maxCoeff() <= 1e-12) return c;
  return -1;
}

}  // namespace

Surface::Surface(Parts parts) : parts_(std::move(parts)) {
  HARIKO_ASSERT(parts_.patches && parts_.seams && parts_.provenance && parts_.corner_nodes &&
                    parts_.node_normals && parts_.boundary_sides && parts_.boundary_sources,
                "every part of a surface must be given");
  HARIKO_ASSERT(parts_.origin.allFinite(), "the origin must be finite");
  const std::size_t patches = patch_count();
  const auto corners = static_cast<std::size_t>(corner_count(domain()));
  HARIKO_ASSERT(parts_.provenance->size() == patches, "one provenance a patch");
  HARIKO_ASSERT(parts_.corner_nodes->size() == patches * corners, "one node a corner");
  HARIKO_ASSERT(parts_.node_normals->size() == parts_.node_count, "one normal a node");
  HARIKO_ASSERT(parts_.boundary_sides->size() == parts_.boundary_sources->size(),
                "one source a boundary side");
  for (const Index node : *parts_.corner_nodes) HARIKO_ASSERT(node < parts_.node_count, "node out of range");
  const auto valid = [&](const PatchSide& side) { return side.patch < patches && side.side < corners; };
  for (const Seam& seam : *parts_.seams) {
    HARIKO_ASSERT(valid(seam.first) && valid(seam.second), "a seam names a side that does not exist");
    HARIKO_ASSERT(is_fraction(seam.first_begin) && is_fraction(seam.first_end) &&
                      is_fraction(seam.second_begin) && is_fraction(seam.second_end),
                  "a seam must lie within its sides");
  }
  for (const PatchSide& side : *parts_.boundary_sides)
    HARIKO_ASSERT(valid(side), "a boundary side does not exist");
}

Surface Surface::with_patches(std::shared_ptr<const PatchSet> patches,
                              std::shared_ptr<const std::vector<Vector3>> node_normals) const {
  HARIKO_ASSERT(patches && node_normals, "patches and normals must be given");
  HARIKO_ASSERT(patches->patch_count() == patch_count() && patches->domain() == domain(),
                "the patches must fit the adjacency");
  HARIKO_ASSERT(node_normals->size() == parts_.node_count, "one normal a node");
  Surface out;
  out.parts_ = parts_;
  out.parts_.patches = std::move(patches);
  out.parts_.node_normals = std::move(node_normals);
  return out;
}

double Surface::patch_scale(Index patch) const {
  const int corners = corner_count(domain());
  std::array<Vector3, 4> position;
  for (int c = 0; c < corners; ++c)
    position[static_cast<std::size_t>(c)] =
        patches().evaluate(patch, corner_parameter(domain(), c), Order::first).position;
  double scale = 0;
  for (int a = 0; a < corners; ++a)
    for (int b = a + 1; b < corners; ++b)
      scale = std::max(
          scale, (position[static_cast<std::size_t>(a)] - position[static_cast<std::size_t>(b)]).norm());
  return scale;
}

Vector3 Surface::normal(Index patch, const Vector2& parameter) const {
  HARIKO_ASSERT(patch < patch_count(), "no such patch");
  const double scale = patch_scale(patch);
  const auto at = [&](const Vector2& q) -> Vector3 {
    const PatchPoint point = patches().evaluate(patch, q, Order::first);
    const Vector3 cross = point.ds.cross(point.dt);
    const double length = cross.norm();
    if (!(length > 1e-12 * scale * scale)) return Vector3::Zero();
    return cross / length;
  };
  if (const Vector3 n = at(parameter); !n.isZero(0)) return n;
  if (const int corner = corner_at(domain(), parameter); corner >= 0)
    if (const Vector3& n = node_normal(node(patch, corner)); !n.isZero(0)) return n;
  return at(parameter + 1e-4 * (centre_parameter(domain()) - parameter));
}

}  // namespace hariko
