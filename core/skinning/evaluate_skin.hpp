#pragma once

// From a skin to its control mesh and surface: a pure function, with a cache of what depends on connectivity.

#include <memory>
#include <vector>

#include "core/skinning/column_memory.hpp"
#include "core/skinning/skin_mesh.hpp"
#include "core/skinning/skin_work.hpp"
#include "core/skinning/subdivision_surface.hpp"

namespace hariko {

struct SkinResult {
  Skin skin;  ///< what it was made from
  SkinPlan plan;
  SkinMesh mesh;
  std::vector<Message> warnings;  ///< W_SPACING, W_SECTION_NOT_EXACT, W_FOLD, W_TWIST
};

/// The control mesh. Errors: those of `plan_skin`, `pleat_mesh` and `smooth_mesh`.
Result<SkinResult> evaluate_skin(const Skin& skin, const SkinWork& work = {});

struct SkinSurface {
  SkinResult result;
  Surface surface;
};

/// Keeps the topology of the last surface, which a dragged point does not change, and columns of sections
/// that stay. Calls must not overlap.
class SkinSurfacer {
 public:
  /// `origin`: the skin's points are relative to it. The surface knows the result, without the warnings that
  /// need the surface. Errors: those of `evaluate_skin`, E_CONTROL_MESH. Adds
  /// the measured distance to W_SECTION_NOT_EXACT. `work.columns` is the surfacer's own. Unless `work.moving`
  /// the result does not depend on earlier calls.
  Result<SkinSurface> surface(const Skin& skin, const Vector3& origin, const SkinWork& work = {});

 private:
  std::shared_ptr<const SubdivisionTopology> topology_;
  ColumnMemory columns_;
};

/// How far the surface is from each section: the largest distance of 33 points an edge of the section's row
/// to the section's curve; and, where the row has the section's points, the largest distance at equal
/// parameters.
struct SectionMiss {
  double largest = 0, root_mean_square = 0;
  double same_parameter = -1;  ///< -1 where it has no meaning
};
std::vector<SectionMiss> section_misses(const Skin& skin, const SkinMesh& mesh, const Surface& surface);

}  // namespace hariko
