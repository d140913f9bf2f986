#pragma once

// GaussPanel: the Gauss sphere of the active outline beside its views. It turns with the active view; sites
// and points of the outline are lit and chosen in both.

#include "ui/base/surface_point.hpp"
#include "ui/outline/gauss_drawing.hpp"
#include "ui/view/view_layer.hpp"

namespace hariko {

class GaussPanel {
 public:
  /// `pointed`: the point of a surface under the pointer, in the views of the model.
  void draw(PanelContext& context, GaussView& view, const PanelRect& rect,
            const std::optional<SurfacePoint>& pointed);
  /// What pressing would do here; empty where the pointer is elsewhere.
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
