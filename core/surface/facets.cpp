#include "core/surface/facets.hpp"

#include <Eigen/Geometry>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

class FacetPatches final : public PatchSet {
 public:
  FacetPatches(std::span<const Vector3> positions, std::vector<std::array<Index, 3>> triangles)
      : positions_(positions.begin(), positions.end()), triangles_(std::move(triangles)) {}

  Domain domain() const override { return Domain::triangle; }
  Index patch_count() const override { return static_cast<Index>(triangles_.size()); }

  PatchPoint evaluate(Index patch, const Vector2& parameter, Order) const override {
    const auto& [a, b, c] = triangles_[patch];
    PatchPoint point;
    point.ds = positions_[b] - positions_[a];
    point.dt = positions_[c] - positions_[a];
    // Corners keep their bits.
    if (parameter.x() == 1)
      point.position = positions_[b];
    else if (parameter.y() == 1)
      point.position = positions_[c];
    else
      point.position = positions_[a] + parameter.x() * point.ds + parameter.y() * point.dt;
    return point;
  }
  CornerSecondOrder second_order_at_corner(Index, int) const override { return CornerSecondOrder::exact; }

 private:
  std::vector<Vector3> positions_;
  std::vector<std::array<Index, 3>> triangles_;
};

}  // namespace

Surface facet_surface(const Vector3& origin, std::span<const Vector3> positions,
                      std::vector<std::array<Index, 3>> triangles, std::span<const Element> sources) {
  HARIKO_ASSERT(sources.size() == triangles.size(), "one source a triangle");
  Surface::Parts parts;
  parts.origin = origin;
  std::vector<Index> nodes;
  nodes.reserve(3 * triangles.size());
  for (const auto& triangle : triangles) nodes.insert(nodes.end(), triangle.begin(), triangle.end());
  std::vector<Provenance> provenance;
  provenance.reserve(sources.size());
  for (const Element& source : sources) provenance.push_back({source, 0});
  parts.node_count = static_cast<Index>(positions.size());
  parts.node_normals = std::make_shared<const std::vector<Vector3>>(positions.size(), Vector3::Zero());
  parts.corner_nodes = std::make_shared<const std::vector<Index>>(std::move(nodes));
  parts.provenance = std::make_shared<const std::vector<Provenance>>(std::move(provenance));
  parts.seams = std::make_shared<const std::vector<Seam>>();
  parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>();
  parts.boundary_sources = std::make_shared<const std::vector<Element>>();
  parts.patches = std::make_shared<const FacetPatches>(positions, std::move(triangles));
  return Surface(std::move(parts));
}

}  // namespace hariko
