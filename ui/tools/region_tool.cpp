#include "ui/tools/region_tool.hpp"

#include <algorithm>

#include "render/region_picking.hpp"
#include "ui/tools/overlay_drawing.hpp"

namespace hariko {

namespace {

using How = Selection::How;

class RegionTool final : public Tool {
 public:
  explicit RegionTool(bool modal) : modal_(modal) {}
  bool modal() const override { return modal_; }

  void begin(ToolContext& context, const PointerEvent& press) override {
    before_ = context.editor.selection;
    lasso_ = context.editor.selecting.lasso;
    at_ = press.pixel;
    if (!modal_) start(context, press);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    at_ = event.pixel;
    if (modal_ && event.kind == PointerEvent::Kind::press) start(context, event);
    if (!drawing_) return ToolState::stay;
    if (lasso_ && (path_.back() - at_).norm() > 2 * context.editor.pixel_scale) path_.push_back(at_);
    choose(context);
    return event.kind == PointerEvent::Kind::release ? ToolState::commit : ToolState::stay;
  }

  void cancel(ToolContext& context) override { context.editor.selection = before_; }

  std::string hint(const Language& tr) const override {
    if (!drawing_)
      return lasso_ ? tr("Draw a lasso   Shift adds   Ctrl removes   Esc cancels")
                    : tr("Drag a box   Shift adds   Ctrl removes   Esc cancels");
    if (lasso_) return tr("Lasso takes what lies inside");
    return crossing() ? tr("Crossing box takes what it touches") : tr("Window box takes what lies inside");
  }

  void draw(const ToolContext&, const ToolOverlay& overlay) const override {
    const ImU32 line = palette().secondary, fill = (line & 0x00ffffff) | (0x26U << IM_COL32_A_SHIFT);
    if (!drawing_) {
      const ImVec2 at = on_screen(overlay, at_);
      overlay.list.AddLine({at.x - 4000, at.y}, {at.x + 4000, at.y}, fill | (0x60U << IM_COL32_A_SHIFT));
      overlay.list.AddLine({at.x, at.y - 4000}, {at.x, at.y + 4000}, fill | (0x60U << IM_COL32_A_SHIFT));
      return;
    }
    if (lasso_) {
      for (std::size_t i = 0; i < path_.size(); ++i)
        overlay.list.AddLine(on_screen(overlay, path_[i]), on_screen(overlay, path_[(i + 1) % path_.size()]),
                             line, overlay.metrics.px(1.5F));
      return;
    }
    const Vector2 a = path_.front(), b = at_;
    overlay.list.AddRectFilled(on_screen(overlay, a.cwiseMin(b)), on_screen(overlay, a.cwiseMax(b)), fill);
    if (!crossing()) {
      overlay.list.AddRect(on_screen(overlay, a.cwiseMin(b)), on_screen(overlay, a.cwiseMax(b)), line, 0, 0,
                           overlay.metrics.px(1.2F));
      return;
    }
    const Vector2 c(a.x(), b.y()), d(b.x(), a.y());
    for (const auto& [from, to] : {std::pair(a, c), std::pair(c, b), std::pair(b, d), std::pair(d, a)})
      draw_dashed_line(overlay, from, to, line);
  }

 private:
  bool crossing() const { return at_.x() < path_.front().x(); }

  void start(const ToolContext& context, const PointerEvent& press) {
    drawing_ = true;
    path_ = {press.pixel};
    how_ = press.control ? How::remove : press.shift ? How::add : How::replace;
    const Editor& editor = context.editor;
    if (!editor.view.x_ray && !editor.selecting.through)
      occlusion_.emplace(context.scene.scene(), context.projector());
  }

  void choose(ToolContext& context) {
    Editor& editor = context.editor;
    Selection selection = before_;
    if (how_ == How::replace && editor.mode == ElementMode::object) selection.clear_objects();
    if (how_ == How::replace && editor.mode != ElementMode::object) selection.clear_elements();
    const Scene& scene = context.scene.scene();
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      take(editor, selection, scene.objects[i], context.scene.object_id(i), context.projector());
    editor.selection = selection;
  }

  void take(const Editor& editor, Selection& selection, const SceneObject& shown, ObjectId id,
            const Projector& projector) const {
    const Object* object = editor.document().find(id);
    if (!object || !shown.polyhedron) return;
    Highlights held = lasso_ ? pick_lasso(shown, projector, path_)
                             : pick_box(shown, projector, {path_.front(), at_}, crossing());
    const How how = how_ == How::remove ? How::remove : How::add;
    if (editor.mode == ElementMode::object) {
      const bool taken =
          !lasso_ && crossing() ? !held.empty() : held.vertices.size() == shown.polyhedron->positions.size();
      if (taken && !held.empty()) selection.select({id, element_of(id)}, how);
      return;
    }
    if (!(object->cage() || object->outline()) || !shown.elements_pickable) return;
    if (editor.mode != ElementMode::vertex) held.vertices.clear();
    if (editor.mode != ElementMode::edge) held.edges.clear();
    if (editor.mode != ElementMode::face) held.faces.clear();
    if (occlusion_) held = occlusion_->visible(held, shown);
    ElementSelection elements;
    for (const Index v : held.vertices) elements.vertices.insert(shown.polyhedron->vertex_ids[v]);
    if (const Polyhedron* polyhedron = object->cage()) {
      for (const Index e : held.edges) elements.edges.insert(polyhedron->edge_id(e));
      for (const Index f : held.faces) elements.faces.insert(polyhedron->face_id(f));
    }
    if (elements.empty()) return;
    selection.select(id, elements, how);
    if (selection.of(selection.active).empty()) selection.active = id;
  }

  bool modal_, lasso_ = false, drawing_ = false;
  How how_ = How::replace;
  Selection before_;
  std::vector<Vector2> path_;  ///< the box's first corner, or the lasso
  Vector2 at_ = Vector2::Zero();
  std::optional<Occlusion> occlusion_;
};

}  // namespace

std::unique_ptr<Tool> make_region_tool(bool modal) {
  return std::make_unique<RegionTool>(modal);
}

}  // namespace hariko
