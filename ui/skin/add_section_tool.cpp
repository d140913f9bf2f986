#include "ui/skin/add_section_tool.hpp"

#include <GLFW/glfw3.h>

#include "core/skinning/sections/skin_places.hpp"
#include "ui/editor/probe.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/pointing_tool.hpp"

namespace hariko {

namespace {

class AddSectionTool final : public PointingTool {
 public:
  explicit AddSectionTool(AddSection add) : add_(std::move(add)) {}

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    if (!shown_skin(context.editor)) return ToolState::commit;
    pointer_ = event.pixel;
    error_.clear();
    look(context);
    if (event.kind == PointerEvent::Kind::press) add(context);
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext&, const KeyPress& press) override {
    if (press.chord.key == GLFW_KEY_ENTER || press.chord.key == GLFW_KEY_KP_ENTER) return ToolState::commit;
    if (press.chord.control || press.chord.alt || press.text == 0) return std::nullopt;
    return ToolState::stay;
  }

  void cancel(ToolContext&) override {}

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Object* object = shown_skin(context.editor);
    if (object && place_) {
      const Projector projector = context.projector();
      std::optional<Vector2> last;
      for (const Vector3& point : sketch_) {
        const auto at = pixel_of(*object, projector, point);
        if (at && last)
          overlay.list.AddLine(on_screen(overlay, *last), on_screen(overlay, *at), palette().hot,
                               overlay.metrics.px(2.5F));
        last = at;
      }
    }
    draw_value_label(overlay, pointer_, error_.empty() ? value_text(context.editor.language) : error_,
                     !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    return value_text(tr) + "   |   " + tr("Click the surface where a section is wanted   Enter or Esc ends");
  }

 private:
  void look(const ToolContext& context) override {
    place_.reset();
    const Object* object = shown_skin(context.editor);
    const Surface* surface = object ? shown_surface(context.editor, *object) : nullptr;
    const SubdivisionPatchSet* patches = surface ? subdivision_patches(*surface) : nullptr;
    if (!patches || !patches->skin()) return;
    const auto hit = surface_point(context.scene, context.projector().ray(pointer_));
    if (!hit || hit->object != object->id || hit->patch >= patches->patch_count()) return;
    const SkinResult& result = *patches->skin();
    place_ = place_on_path(patches->topology(), vertex_places(result.skin, result.mesh),
                           result.skin.path.closed, hit->patch, hit->parameter);
    if (place_) sketch_ = section_sketch(cache_.of(context.editor, *object), *place_);
  }

  void add(ToolContext& context) {
    if (place_)
      add_(shown_skin(context.editor)->id, *place_);
    else
      error_ = context.editor.language("Click the surface of the skin.");
  }

  std::string value_text(const Language& tr) const {
    std::string text = tr("Section");
    if (place_) text += "  " + fixed_text(100 * *place_, 1) + " %";
    return text;
  }

  AddSection add_;
  SkinViewCache cache_;
  std::optional<double> place_;  ///< on the path, under the pointer
  std::vector<Vector3> sketch_;
  std::string error_;
};

}  // namespace

std::unique_ptr<Tool> make_add_section_tool(AddSection add) {
  return std::make_unique<AddSectionTool>(std::move(add));
}

}  // namespace hariko
