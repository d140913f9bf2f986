#pragma once

// SkinRig: an editor that shows a skin, whose surface is computed at once.

#include <map>

#include "core/skinning/evaluate_skin.hpp"
#include "tests/app/tool_rig.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko::test {

inline Document skin_document(const Skin& skin) {
  return add_object({}, "skin", Source(SkinSource{skin, {}}), {}).value().document;
}

struct SkinRig : Rig {
  SkinRig(const Skin& skin, StandardView from) : Rig(skin_document(skin)) {
    editor.set_camera(Camera::standard(from));
    editor.frame_all(true);
    editor.views = &views;
    update();
  }
  /// As the worker does after a change.
  void update() {
    SurfaceView& shown = views[object().id];
    if (auto made = SkinSurfacer().surface(skin(), Vector3::Zero())) {
      shown.surface = made->surface;
      shown.mesh = DisplayMesh::build(shown.surface, {});
    }
    shown.object = editor.document().objects[0];
    view = view_of(skin(), &shown.surface);
    scene.update(editor);
  }
  const Object& object() const { return *editor.document().objects[0]; }
  const Skin& skin() const { return *object().skin()->skin; }

  std::map<ObjectId, SurfaceView> views;
  SkinView view;
};

}  // namespace hariko::test
