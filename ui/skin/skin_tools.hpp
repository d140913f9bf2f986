#pragma once

// Tools of skins: they drag points, draw paths and sections, add sections and slide them along the path, and
// say by strokes which points of neighbouring sections belong together.

#include <cstdint>
#include <functional>
#include <set>

#include "core/skinning/edit/edit_correspondence.hpp"
#include "core/skinning/edit/stroke.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/tool.hpp"
#include "ui/view/view_layer.hpp"

namespace hariko {

/// The tool for a left press on something of the active skin; null where there is nothing.
std::unique_ptr<Tool> skin_tool_at(const ToolContext& context, const PointerEvent& press);

/// Modal: a new skin. First its path on the ground, then its first and its last section in planes across the
/// path, which the view turns to (see CurveSketch). Enter goes on to the next curve; after the last one the
/// skin is one step. Backspace in an empty curve goes back to the one before.
std::unique_ptr<Tool> make_draw_skin_tool();

/// Modal: one more section of the active skin. A click on the path says where, then it is drawn in the plane
/// across the path there.
std::unique_ptr<Tool> make_draw_section_tool();

/// Adds a section to a skin at a place of its path, as soon as it is made.
using AddSection = std::function<void(ObjectId, double place)>;

/// Modal: the section follows the pointer over the surface as a line, a click adds it. Enter or Esc ends.
std::unique_ptr<Tool> make_add_section_tool(AddSection add);

/// Held, for a press on the section's place on the path: a click selects the section's points, a drag slides
/// it. Modal, from a command: the pointer slides it, digits type its place in percent, a click or Enter
/// confirms. It snaps to points of the path; Alt: freely.
std::unique_ptr<Tool> make_slide_section_tool(std::uint32_t section, bool modal);

/// Edit that a stroke over a skin makes, by what lies under it. Errors with a hint for a stroke that means
/// nothing: E_NO_GESTURE; else those of the edits. `hidden`: points that cannot be seen; lines neither begin
/// nor end there, and closed curves do not go round them.
Result<CorrespondenceEdit> gesture_edit(const Skin& skin, const SkinView& view, const Object& object,
                                        const Projector& projector, const Stroke& stroke, double pixel_scale,
                                        const std::set<std::uint32_t>& hidden = {});
inline constexpr Code e_no_gesture{"E_NO_GESTURE"};

/// Modal, for the active skin. Each stroke is one step.
std::unique_ptr<Tool> make_correspond_tool();

class SkinOverlay final : public ViewLayer {
 public:
  std::optional<std::unique_ptr<Tool>> press(const ToolContext& context, const PointerEvent& press) override;
  /// Draws where the active object is a skin. Marks, in the active view only: "skin.point.<id>",
  /// "skin.limit.<id>", "skin.path.<number>", "skin.rail.<number>" (of the second rail),
  /// "skin.place.<section>", "skin.diamond.<id>", "skin.mirror" (a corner of its plane).
  void draw(const ToolContext& context, const LayerPane& pane) override;

 private:
  SkinViewCache cache_;
};

}  // namespace hariko
