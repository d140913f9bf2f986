// Select: a click chooses what is under the pointer; a drag that begins on an element moves it.

#include "ui/tools/transform_tool.hpp"

namespace hariko {

namespace {

class SelectTool final : public Tool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    press_ = press;
    before_ = context.editor.selection;
    if (const auto hit = pick_element(context, press.pixel))
      element_ =
          element_at(context.editor.document(), context.scene.object_id(hit->object), hit->kind, hit->index);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    if (event.kind == PointerEvent::Kind::release) {
      click(context.editor);
      return ToolState::commit;
    }
    if (!element_ || (event.pixel - press_.pixel).norm() <= drag_threshold) return ToolState::stay;
    // Dragging a chosen element moves all that are chosen, another one is chosen first.
    if (!context.editor.selection.contains(*element_))
      context.editor.selection.select(*element_,
                                      press_.shift ? Selection::How::add : Selection::How::replace);
    drags_ = true;
    return ToolState::commit;
  }

  void cancel(ToolContext& context) override { context.editor.selection = before_; }
  std::string hint(const Language& tr) const override { return tr("Release to select, drag to move"); }
  std::unique_ptr<Tool> successor() override {
    return drags_ ? make_transform_tool(TransformKind::move, DrivenBy::element) : nullptr;
  }

 private:
  void click(Editor& editor) const {
    using How = Selection::How;
    if (element_)
      editor.selection.select(*element_, press_.control ? How::remove
                                         : press_.shift ? How::add
                                                        : How::replace);
    else if (!press_.control && !press_.shift)
      editor.selection.clear_elements();
  }

  PointerEvent press_;
  Selection before_;
  std::optional<ElementRef> element_;
  bool drags_ = false;
};

}  // namespace

std::unique_ptr<Tool> make_select_tool() {
  return std::make_unique<SelectTool>();
}

}  // namespace hariko
