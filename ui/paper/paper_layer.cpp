#include "ui/paper/paper_layer.hpp"

#include <utility>

#include "ui/view/navigation.hpp"

namespace hariko {

namespace {

constexpr double hover_reach = 5;  // design pixels

class PaperLayer final : public ViewLayer {
 public:
  bool hover(const ToolContext& context, const Vector2& pixel) override {
    const PaperSolid* paper = context.scene.paper();
    if (!paper) return false;
    const Editor& editor = context.editor;
    const double reach = hover_reach * editor.pixel_scale * editor.camera().pixel_length(editor.viewport);
    context.editor.paper.hovered = paper_under(*paper, context.projector().ray(pixel), reach);
    here_ = true;
    return true;
  }

  void leave(const ToolContext& context) override {
    if (std::exchange(here_, false)) context.editor.paper.hovered = {};
  }

  std::optional<std::unique_ptr<Tool>> press(const ToolContext& context, const PointerEvent& press) override {
    PaperState& state = context.editor.paper;
    if (!context.scene.paper() || press.button != PointerButton::left || state.hovered.facet == no_index ||
        navigation_of(context.editor, press))
      return {};
    state.selected = state.hovered.facet;
    return std::optional<std::unique_ptr<Tool>>(nullptr);
  }

 private:
  bool here_ = false;  ///< what is hovered of the paper is hovered in the views
};

}  // namespace

std::unique_ptr<ViewLayer> make_paper_layer() {
  return std::make_unique<PaperLayer>();
}

}  // namespace hariko
