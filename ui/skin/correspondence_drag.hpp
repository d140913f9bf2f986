#pragma once

// Drags of correspondences: of the diamond of a merge along the lines of its strip, and of the end of a line
// from point to point of its section.

#include "core/skinning/edit/edit_correspondence.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

/// Place of a drag in the picture.
struct DragPlace {
  const Object& object;
  Projector projector;
  Vector2 pixel;
  double pixel_scale = 1;
  bool free = false;  ///< without snapping
};

/// From the press on: the skin and what was shown of it then.
class MergeDrag {
 public:
  MergeDrag(const Skin& skin, const SkinView& view, std::size_t diamond);
  /// The merge moves to the place of a line that is nearest to the pointer, and on that line to a row within
  /// 8 pixels. Errors: those of `move_merge`.
  Result<CorrespondenceEdit> to(const DragPlace& place);
  /// Place where the lines meet now, 0 at the strip's first section .. 1.
  double along() const { return along_; }

 private:
  Skin skin_;
  SkinView view_;
  SkinView::Diamond diamond_;
  double along_ = 0;
};

/// The end of a line that can be taken hold of, a little inside of it.
struct LineEnd {
  std::size_t line = 0;
  bool at_b = false;
  Vector2 pixel = Vector2::Zero();
};
/// Both ends of a line on the picture, the nearer to a pixel first; none where the line cannot be seen or is
/// too short to have two.
std::vector<LineEnd> line_ends(const SkinView& view, const Object& object, const Projector& projector,
                               std::size_t line, const Vector2& pixel, double pixel_scale);
/// End of the line within 8 pixels.
std::optional<LineEnd> line_end_at(const SkinView& view, const Object& object, const Projector& projector,
                                   std::size_t line, const Vector2& pixel, double pixel_scale);

class LineEndDrag {
 public:
  LineEndDrag(const Skin& skin, const SkinView& view, const LineEnd& end);
  /// The end goes to the point of its section that is nearest to the pointer. Errors: those of
  /// `move_line_end`.
  Result<CorrespondenceEdit> to(const DragPlace& place);
  /// The other end, for a line to the pointer.
  const Vector3& anchor() const { return anchor_; }

 private:
  Skin skin_;
  std::uint32_t from_ = 0, other_ = 0;
  std::vector<SkinView::Handle> points_;  ///< points of the section
  Vector3 anchor_ = Vector3::Zero();
};

}  // namespace hariko
