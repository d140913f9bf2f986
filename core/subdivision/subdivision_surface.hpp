#pragma once

// Catmull-Clark surfaces: the limit of a control mesh as a PatchSet and a Surface.

#include <memory>
#include <vector>

#include "core/subdivision/subdivision_topology.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

struct SkinResult;

/// Patches of a Catmull-Clark surface.
class SubdivisionPatchSet final : public PatchSet {
 public:
  /// Makes the patches, with one position per vertex of the topology's mesh (asserted). `skin`: the skin
  /// result that the mesh comes from, if any.
  SubdivisionPatchSet(std::shared_ptr<const SubdivisionTopology> topology, std::vector<Vector3> positions,
                      std::shared_ptr<const SkinResult> skin = {});

  const SubdivisionTopology& topology() const { return *topology_; }
  const std::shared_ptr<const SubdivisionTopology>& shared_topology() const { return topology_; }
  /// Positions of the control points.
  const std::vector<Vector3>& control_points() const { return positions_; }
  /// Skin result with the meaning of the control vertices; null without a skin.
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
  /// Undefined at extraordinary vertices and at the ends of semi-sharp creases.
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override {
    return topology_->second_order(patch, corner);
  }

  void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const override;
  /// 6 where the patch is a bicubic polynomial; 0 (no bound) for others.
  int hull_degree(Index patch) const override { return topology_->polynomial(patch) ? 6 : 0; }
  void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
            std::span<HullBall> out) const override;
  ExactForm exact_form(Index patch) const override { return SubdivisionPatch{topology_->polynomial(patch)}; }

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

/// Makes the surface of control points relative to `origin`. A patch comes from face `provenance.element` of
/// the mesh; nodes have normals except on creases and corners. O(patches).
Surface subdivision_surface(const Vector3& origin, std::shared_ptr<const SubdivisionTopology> topology,
                            std::vector<Vector3> positions, std::shared_ptr<const SkinResult> skin = {});
/// Makes the surface with a new topology. Errors: those of `SubdivisionTopology::make`.
Result<Surface> subdivision_surface(const Vector3& origin, const ControlMesh& mesh);

/// Subdivision patches of a surface; null for surfaces of other kinds.
inline const SubdivisionPatchSet* subdivision_patches(const Surface& surface) {
  return surface.patch_count() > 0 ? dynamic_cast<const SubdivisionPatchSet*>(&surface.patches()) : nullptr;
}

}  // namespace hariko
