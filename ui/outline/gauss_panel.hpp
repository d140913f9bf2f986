#pragma once

// GaussPanel: the Gauss sphere of the active outline beside its views. It turns with the active view; sites
// and points of the outline are lit and chosen in both.

#include <set>

#include "core/gaussmap/sphere/gauss_sphere.hpp"
#include "ui/editor/gauss_view.hpp"
#include "ui/editor/surface_view.hpp"
#include "ui/view/view_layer.hpp"
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

class GaussPanel {
 public:
  /// `pointed`: the point of a surface under the pointer, in the views of the model.
  void draw(PanelContext& context, GaussView& view, const PanelRect& rect,
            const std::optional<SurfacePoint>& pointed);
  /// Hint of what pressing would do here; empty where the pointer is elsewhere.
  const std::string& hint() const { return hint_; }

 private:
  void toolbar(PanelContext& context, GaussView& view, float width);
  void step_bar(PanelContext& context, GaussView& view, float width);
  void sphere(PanelContext& context, GaussView& view, const PanelRect& rect,
              const std::optional<SurfacePoint>& pointed);
  void say(PanelContext& context, const std::string& text, const std::string& remedy, bool wrong,
           const PanelRect& rect) const;
  SpherePlace place_in(const Editor& editor, const GaussView& view, const PanelRect& rect) const;
  void point_at(PanelContext& context, GaussView& view, const SpherePlace& place, bool hovered);
  void press_and_drag(PanelContext& context, GaussView& view, const SpherePlace& place, bool hovered);

  float zoom_ = 1;  ///< about the middle of the image
  bool dragged_ = false;
  std::string hint_;
};

/// Draws the active outline's control points and planes over the picture of the model: those of the sites
/// that are hovered, selected and inserted last, and all points while sites are left out.
std::unique_ptr<ViewLayer> make_gauss_layer();

}  // namespace hariko
