#pragma once

// Drawing the Gauss sphere: where directions are on the screen, and everything that is drawn there.

#include <set>

#include "core/gaussmap/sphere/gauss_sphere.hpp"
#include "ui/editor/gauss_view.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// The unit sphere seen from afar, in the directions of a camera.
struct SpherePlace {
  Matrix3 to_camera =
      Matrix3::Identity();  ///< from the object's directions to x right, y up, z to the viewer
  ImVec2 centre;
  float radius = 1;

  ImVec2 to_screen(const Vector3& direction) const {
    const Vector3 seen = to_camera * direction;
    return {centre.x + radius * static_cast<float>(seen.x()),
            centre.y - radius * static_cast<float>(seen.y())};
  }
  /// 1 nearest to the viewer, below 0 on the far side.
  double depth(const Vector3& direction) const { return to_camera.row(2).dot(direction); }
};

struct SphereHighlights {
  std::optional<Index> hovered;
  std::set<Index> selected;
  std::optional<Vector3> pointed;  ///< the surface's normal under the pointer
};

/// `list` is clipped to the view.
void draw_gauss_sphere(ImDrawList& list, const Metrics& metrics, const GaussView& view,
                       const SpherePlace& place, const SphereHighlights& highlights);

/// The nearest of the sites on the near side within `reach` pixels, nothing where there is none.
std::optional<Index> site_under(const GaussView& view, const SpherePlace& place, ImVec2 pixel, float reach);

}  // namespace hariko
