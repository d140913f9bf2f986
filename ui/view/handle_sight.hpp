#pragma once

// Which of the handles on surfaces can be seen.

#include <optional>
#include <vector>

#include "render/surface_occlusion.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// What the shown surfaces hide; kept as long as neither they nor the view change.
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

}  // namespace hariko
