#pragma once

// Catmull-Clark surfaces: the limit of a control mesh as a PatchSet and a Surface.

#include <memory>
#include <vector>

#include "core/skinning/subdivision_topology.hpp"
#include "core/surface/facet_evaluation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

struct SkinResult;

class SubdivisionPatchSet final : public PatchSet, public FacetEvaluation {
 public:
  /// One position a vertex of the topology's mesh (asserted). `skin`: what made the mesh, where a skin did.
  SubdivisionPatchSet(std::shared_ptr<const SubdivisionTopology> topology, std::vector<Vector3> positions,
                      std::shared_ptr<const SkinResult> skin = {});

  const SubdivisionTopology& topology() const { return *topology_; }
  const std::shared_ptr<const SubdivisionTopology>& shared_topology() const { return topology_; }
  /// The control points.
  const std::vector<Vector3>& control_points() const { return positions_; }
  /// What the vertices of the control mesh stand for; null where no skin made it.
  const std::shared_ptr<const SkinResult>& skin() const { return skin_; }
  /// Limit position of a control vertex that some face uses.
  Vector3 limit_position(Index vertex) const;

  Domain domain() const override { return Domain::square; }
  Index patch_count() const override { return topology_->patch_count(); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern, std::span<Vector3> positions,
                     std::span<Vector3> normals) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                     std::span<PatchPoint> points) const override;
  /// Undefined at extraordinary vertices and where creases fade.
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override {
    return topology_->second_order(patch, corner);
  }

  void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const override;
  void first_order(Index patch, std::span<const Vector2> parameters,
                   std::span<PatchPoint> out) const override;
  /// 6 where the patch is a bicubic polynomial; others have no bound.
  int hull_degree(Index patch) const override { return topology_->polynomial(patch) ? 6 : 0; }
  void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
            std::span<HullBall> out) const override;

 private:
  std::vector<Vector3> gather(Index patch) const;
  Vector3 position_at(Index patch, const Vector2& parameter) const;
  Vector3 corner_position(Index patch, int corner) const;
  template <class Each>
  void for_border(Index patch, const GridPattern& pattern, const Each& each) const;

  std::shared_ptr<const SubdivisionTopology> topology_;
  std::vector<Vector3> positions_;
  std::shared_ptr<const SkinResult> skin_;
};

/// The surface of control points relative to `origin`. A patch comes from face `provenance.element` of the
/// mesh; nodes have normals except on creases and corners. O(patches).
Surface subdivision_surface(const Vector3& origin, std::shared_ptr<const SubdivisionTopology> topology,
                            std::vector<Vector3> positions, std::shared_ptr<const SkinResult> skin = {});
/// The same with a topology of its own. Errors: those of `SubdivisionTopology::make`.
Result<Surface> subdivision_surface(const Vector3& origin, const ControlMesh& mesh);

/// The patches of a surface that was made here, null for others.
inline const SubdivisionPatchSet* subdivision_patches(const Surface& surface) {
  return surface.patch_count() > 0 ? dynamic_cast<const SubdivisionPatchSet*>(&surface.patches()) : nullptr;
}

}  // namespace hariko
