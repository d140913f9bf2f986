// Select: a click chooses what is under the pointer; a drag that begins on an element moves it, one that
// begins beside draws a box or a lasso.

#include <algorithm>

#include "ui/editor/object_kind.hpp"
#include "ui/view/region_tool.hpp"
#include "ui/view/transform_tool.hpp"

namespace hariko {

namespace {

using How = Selection::How;

How how_of(const PointerEvent& press) {
  return press.control ? How::remove : press.shift ? How::add : How::replace;
}

class SelectTool final : public Tool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    press_ = press;
    before_ = context.editor.selection;
    context.editor.left_out.reset();
    under_ = elements_under(context, press.pixel);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    if (event.kind == PointerEvent::Kind::release) {
      click(context.editor);
      return ToolState::commit;
    }
    if ((event.pixel - press_.pixel).norm() <= drag_threshold * context.editor.pixel_scale)
      return ToolState::stay;
    if (under_.empty() || press_.control || is_backdrop(context.editor)) {
      successor_ = make_region_tool(false);
      return ToolState::commit;
    }
    // Dragging a chosen element moves all that are chosen, another one is chosen first.
    Selection& selection = context.editor.selection;
    const auto chosen =
        std::ranges::find_if(under_, [&](const ElementRef& ref) { return selection.contains(ref); });
    if (chosen == under_.end()) selection.select(under_.front(), press_.shift ? How::add : How::replace);
    successor_ = make_transform_tool(TransformKind::move, DrivenBy::element);
    return ToolState::commit;
  }

  void cancel(ToolContext& context) override { context.editor.selection = before_; }
  std::string hint(const Language& tr) const override { return tr("Release to select, drag to move"); }
  std::unique_ptr<Tool> successor() override { return std::move(successor_); }

 private:
  void click(Editor& editor) {
    const How how = how_of(press_);
    if (under_.empty()) {
      editor.last_click.reset();
      if (how != How::replace) return;
      if (editor.mode == ElementMode::object)
        editor.selection.clear_objects();
      else
        editor.selection.clear_elements();
      return;
    }
    const bool plain = how == How::replace;
    if (press_.clicks == 2 || (press_.alt && editor.mode == ElementMode::edge)) {
      if (select_path(editor, press_.alt && press_.control, plain || press_.alt ? How::replace : how)) return;
    }
    std::size_t index = 0;
    const auto& last = editor.last_click;
    const bool again = last && (last->pixel - press_.pixel).norm() <= drag_threshold * editor.pixel_scale &&
                       last->index < under_.size() && editor.selection.contains(under_[last->index]);
    if ((plain && again) || (press_.alt && again)) index = (last->index + 1) % under_.size();
    editor.selection.select(under_[index], how);
    editor.last_click = LastClick{press_.pixel, index};
  }

  /// A picture that is not chosen is what one draws a box over: it does not come along with the pointer.
  bool is_backdrop(const Editor& editor) const {
    const Object* object = editor.document().find(under_.front().object);
    return object && object_kind(*object).is_backdrop() &&
           std::ranges::none_of(under_,
                                [&](const ElementRef& ref) { return editor.selection.contains(ref); });
  }

  /// Selects what continues the clicked element: the loop or ring of an edge, all round a vertex or face.
  bool select_path(Editor& editor, bool ring, How how) const {
    const std::size_t index =
        editor.last_click && editor.last_click->index < under_.size() ? editor.last_click->index : 0;
    const ElementRef& ref = under_[press_.alt ? 0 : index];
    const Object* object = editor.document().find(ref.object);
    if (!object) return false;
    const ElementSelection elements = object_kind(*object).continued(*object, ref.element, ring);
    if (elements.empty()) return false;
    editor.selection.select(ref.object, elements, how);
    editor.selection.active = ref.object;
    editor.selection.last = ref;
    return true;
  }

  PointerEvent press_;
  Selection before_;
  std::vector<ElementRef> under_;  ///< nearest first
  std::unique_ptr<Tool> successor_;
};

}  // namespace

std::unique_ptr<Tool> make_select_tool() {
  return std::make_unique<SelectTool>();
}

}  // namespace hariko
