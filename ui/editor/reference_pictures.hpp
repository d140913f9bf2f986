#pragma once

// Reference pictures in the window: as a scene draws them, what is under the pointer, where a new one lies.

#include <vector>

#include "ui/editor/editor.hpp"

namespace hariko {

/// Pictures of the visible objects; none while only surfaces are looked at.
std::vector<ScenePicture> scene_pictures(const Editor& editor);

/// Pictures under a pixel of the active view that can be moved, the nearest first: locked ones let clicks
/// through.
std::vector<ObjectId> pictures_under(const Editor& editor, const Projector& projector, const Vector2& pixel);

/// The active object, if it is a picture; else null.
const Object* active_picture(const Editor& editor);

/// Pictures whose files are not there or cannot be read, in the order of the document.
std::vector<ObjectId> missing_pictures(const Editor& editor);

/// Place of a new picture: in the plane through zero that the camera looks at most squarely, over four
/// fifths of the view. From a side it is behind what is modelled and belongs to that view.
struct PicturePlace {
  Similarity transform;
  double width = 1;
  PictureLook look;
};
PicturePlace place_for_picture(const Camera& camera, PixelSize view, PixelSize picture);

/// Turns the view to where it sees a picture squarely, unless it sees it already from somewhere.
void look_at_picture(Editor& editor, const Object& object);

}  // namespace hariko
