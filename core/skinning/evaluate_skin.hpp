#pragma once

// Evaluation of a skin to its control mesh and surface: a pure function, with a cache of data that depend on
// connectivity only.

#include <memory>
#include <vector>

#include "core/skinning/columns/column_cache.hpp"
#include "core/skinning/columns/skin_context.hpp"
#include "core/skinning/columns/skin_mesh.hpp"
#include "core/subdivision/subdivision_surface.hpp"

namespace hariko {

/// Control mesh of a skin with its plan and warnings.
struct SkinResult {
  Skin skin;  ///< skin that the mesh was made from
  SkinPlan plan;
  SkinMesh mesh;
  std::vector<Message> warnings;  ///< W_SPACING, W_SECTION_NOT_EXACT, W_FOLD, W_TWIST
};

/// Makes the control mesh. Errors: those of `plan_skin`, `pleat_mesh` and `smooth_mesh`, E_CANCELLED.
Result<SkinResult> evaluate_skin(const Skin& skin, const SkinWork& work = {});

/// Surface of a skin with the control mesh.
struct SkinSurface {
  SkinResult result;
  Surface surface;
};

/// Makes surfaces of skins. Caches the topology of the last surface, which dragging a point does not change,
/// and the columns of unchanged sections. Calls must not overlap.
class SkinSurfacer {
 public:
  /// Makes the surface; the skin's points are relative to `origin`. The surface refers to the result, without
  /// the warnings that need the surface. Errors: those of `evaluate_skin`, E_CONTROL_MESH. Adds the measured
  /// distance to W_SECTION_NOT_EXACT. `work.columns` is replaced by the surfacer's own cache. Unless
  /// `work.moving` the result does not depend on earlier calls.
  Result<SkinSurface> surface(const Skin& skin, const Vector3& origin, const SkinWork& work = {});

 private:
  std::shared_ptr<const SubdivisionTopology> topology_;
  ColumnCache columns_;
};

/// Distance of the surface from a section: the largest over 33 points per edge of the section's row to the
/// section's curve; and, where the row has the section's points, the largest distance at equal parameters.
struct SectionMiss {
  double largest = 0, root_mean_square = 0;
  double same_parameter = -1;  ///< -1 where undefined
};
/// Distances of the surface from all sections, in their order.
std::vector<SectionMiss> section_misses(const Skin& skin, const SkinMesh& mesh, const Surface& surface);

}  // namespace hariko
