#pragma once

// Marks on surfaces that can be seen, and so be taken hold of: those of the active skin, and other handles.

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "render/scene.hpp"
#include "render/surface_occlusion.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

/// Surfaces hide what lies behind them. Points of paths and places on them are never hidden: paths run inside
/// of tubes.
class SkinSight {
 public:
  SkinSight(const Editor& editor, const Projector& projector, const SkinView& view, const Object& object);

  /// Whether surfaces hide a point in the object's space.
  bool hides(const Vector3& point) const;
  bool hides_handle(std::size_t index) const { return hidden_[index] != 0; }
  /// Hidden points are shown (palely) and can be taken hold of: x-ray, or selecting through.
  bool through() const { return through_; }
  /// Section points that cannot be taken hold of; none where hidden ones can.
  std::set<std::uint32_t> hidden_points() const;
  /// `skin_hit` of what can be taken hold of.
  SkinHit hit(const Projector& projector, const Vector2& pixel, double pixel_scale) const;

 private:
  const SkinView& view_;
  const Object& object_;
  bool through_;
  SurfaceOcclusion occlusion_;
  std::vector<char> hidden_;  ///< one for each handle
};

/// Sight of handles that the shown surfaces hide; kept as long as neither they nor the view change.
class HandleSight {
 public:
  /// To be called before `hides`, in every frame.
  void look(const Editor& editor);
  /// Never while the designer sees or selects through surfaces.
  bool hides(const Vector3& world) const { return view_ && view_->occlusion.hides(world); }

 private:
  struct View {
    Camera camera;
    PixelSize viewport;
    std::optional<SectionPlane> section;
    std::vector<SceneObject> surfaces;
    SurfaceOcclusion occlusion;
  };
  std::optional<View> view_;
};

/// Meshes and transforms of all objects whose surface is shown and is that of the document.
std::vector<SceneObject> shown_surfaces(const Editor& editor);

}  // namespace hariko
