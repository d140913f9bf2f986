#include "ui/view/region_tool.hpp"

#include <map>

#include "render/region_picking.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/skin_sight.hpp"

namespace hariko {

namespace {

using How = Selection::How;

/// Points and lines as a polyhedron without faces, for regions.
class RegionMarks {
 public:
  void point(const Vector3& at, VertexId id) {
    if (out_->positions.empty()) out_->origin = at;
    const Vector3 p = at - out_->origin;
    out_->positions.push_back({float(p.x()), float(p.y()), float(p.z())});
    out_->vertex_ids.push_back(id);
    out_->box.extend(p);
  }
  void line(const std::vector<Vector3>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      point(points[i], VertexId{});
      const auto end = Index(out_->positions.size() - 1);
      if (i > 0) out_->edges.push_back({end - 1, end});
    }
  }
  std::shared_ptr<const DisplayPolyhedron> finish() {
    out_->edge_kinds.assign(out_->edges.size(), EdgeKind::plain);
    return std::move(out_);
  }

 private:
  std::shared_ptr<DisplayPolyhedron> out_ = std::make_shared<DisplayPolyhedron>();
};

/// The curves of a skin, which stand for it as a whole: its scene has no polyhedron.
std::shared_ptr<const DisplayPolyhedron> curves_of(const Skin& skin) {
  const SkinView view = view_of(skin, nullptr);
  RegionMarks marks;
  for (const SkinView::Section& section : view.sections) marks.line(section.curve);
  for (const auto& path : view.paths) marks.line(path);
  return marks.finish();
}

/// Boxes and lassos take what is hidden, too.
bool takes_hidden(const Editor& editor) {
  return editor.view.x_ray || editor.selecting.regions_through(editor.camera().orthographic);
}

std::set<std::uint32_t> hidden_points_of(const Editor& editor, const Object& object,
                                         const Projector& projector) {
  const SkinView view = view_of(*object.skin()->skin, shown_surface(editor, object));
  return SkinSight(editor, projector, view, object).hidden_points();
}

/// The points of a skin, as vertices with the ids of a selection.
std::shared_ptr<const DisplayPolyhedron> points_of(const Editor& editor, const Object& object) {
  const SkinView view = view_of(*object.skin()->skin, shown_surface(editor, object));
  RegionMarks marks;
  for (const SkinView::Handle& handle : view.handles) {
    const bool own =
        handle.kind == SkinView::Handle::Kind::control || handle.kind == SkinView::Handle::Kind::path;
    if (own) marks.point(handle.position, VertexId{handle.id});
  }
  return marks.finish();
}

/// Ids of bodies of which a region holds all points, or anything at all where it crosses.
std::set<VertexId> bodies_in(const DisplayPolyhedron& shown, const Highlights& held, bool crossing) {
  std::set<VertexId> out;
  if (crossing) {
    for (const Index v : held.vertices) out.insert(shown.vertex_ids[v]);
    for (const Index e : held.edges) out.insert(shown.vertex_ids[shown.edges[e][0]]);
    for (const Index f : held.faces) out.insert(VertexId{shown.face_ids[f].value});
    return out;
  }
  std::map<VertexId, std::size_t> missing;
  for (const VertexId id : shown.vertex_ids) ++missing[id];
  for (const Index v : held.vertices)
    if (--missing[shown.vertex_ids[v]] == 0) out.insert(shown.vertex_ids[v]);
  return out;
}

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
    if (event.kind != PointerEvent::Kind::release) return ToolState::stay;
    context.editor.left_out.reset();
    if (left_out_ > 0) context.editor.left_out = LeftOut{left_out_, context.editor.selection};
    return ToolState::commit;
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
    if (!takes_hidden(editor)) sight_.emplace(context.scene.scene(), context.projector());
  }

  void choose(ToolContext& context) {
    Editor& editor = context.editor;
    Selection selection = before_;
    if (how_ == How::replace && editor.mode == ElementMode::object) selection.clear_objects();
    if (how_ == How::replace && editor.mode != ElementMode::object) selection.clear_elements();
    const Scene& scene = context.scene.scene();
    left_out_ = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      take(editor, selection, scene.objects[i], context.scene.object_id(i), context.projector());
    editor.selection = selection;
  }

  bool crosses() const { return !lasso_ && crossing(); }
  Highlights held_of(const SceneObject& shown, const Projector& projector, const ElementKinds& kinds) const {
    return lasso_ ? pick_lasso(shown, projector, path_, kinds)
                  : pick_box(shown, projector, {path_.front(), at_}, crossing(), kinds);
  }

  void take(const Editor& editor, Selection& selection, SceneObject shown, ObjectId id,
            const Projector& projector) {
    const Object* object = editor.document().find(id);
    if (!object || (editor.view.surfaces_only && editor.mode != ElementMode::object)) return;
    const bool whole = editor.mode == ElementMode::object;
    if (shown.copy && !whole) return;  // elements are those at the own place
    if (object_kind(*object).elements_shown() == ElementsShown::layer) {
      if (!whole && object != shown_skin(editor)) return;  // its points are not shown
      shown.polyhedron = whole ? curves_of(*object->skin()->skin) : points_of(editor, *object);
      if (!whole && !takes_hidden(editor) && !hidden_points_.contains(id))
        hidden_points_[id] = hidden_points_of(editor, *object, projector);
    }
    if (!shown.polyhedron || shown.polyhedron->positions.empty()) return;
    ElementKinds kinds;
    if (!whole && object->cage())
      kinds = {editor.mode == ElementMode::vertex, editor.mode == ElementMode::edge,
               editor.mode == ElementMode::face};
    const Highlights held = held_of(shown, projector, kinds);
    const How how = how_ == How::remove ? How::remove : How::add;
    if (whole) {
      const bool taken =
          crosses() ? !held.empty() : held.vertices.size() == shown.polyhedron->positions.size();
      if (taken && !held.empty()) selection.select({id, element_of(id)}, how);
      return;
    }
    const ElementSelection elements = elements_of(editor, *object, shown, held);
    if (elements.empty()) return;
    selection.select(id, elements, how);
    if (selection.of(selection.active).empty()) selection.active = id;
  }

  ElementSelection elements_of(const Editor& editor, const Object& object, const SceneObject& shown,
                               Highlights held) {
    ElementSelection out;
    const ObjectKind& kind = object_kind(object);
    if (kind.elements_shown() == ElementsShown::bodies) {
      if (shown.show_polyhedron) out.vertices = bodies_in(*shown.polyhedron, held, crosses());
      return kind.existing(object, std::move(out));
    }
    if (kind.elements_shown() == ElementsShown::layer) {
      std::set<VertexId> left;
      const auto hidden = hidden_points_.find(object.id);
      for (const Index v : held.vertices) {
        const VertexId point = shown.polyhedron->vertex_ids[v];
        const bool seen = hidden == hidden_points_.end() || !hidden->second.contains(point.value);
        (seen ? out.vertices : left).insert(point);
      }
      left_out_ += left.size();
      return out;
    }
    if (kind.elements_shown() == ElementsShown::none || !shown.elements_pickable) return out;
    if (editor.mode != ElementMode::vertex) held.vertices.clear();
    if (editor.mode != ElementMode::edge) held.edges.clear();
    if (editor.mode != ElementMode::face) held.faces.clear();
    if (sight_) {
      const auto count = [](const Highlights& h) {
        return h.vertices.size() + h.edges.size() + h.faces.size();
      };
      const Highlights seen = sight_->visible(held, shown);
      left_out_ += count(held) - count(seen);
      held = seen;
    }
    for (const Index v : held.vertices) out.vertices.insert(shown.polyhedron->vertex_ids[v]);
    if (const Polyhedron* polyhedron = object.cage()) {
      for (const Index e : held.edges) out.edges.insert(polyhedron->edge_id(e));
      for (const Index f : held.faces) out.faces.insert(polyhedron->face_id(f));
    }
    return out;
  }

  bool modal_, lasso_ = false, drawing_ = false;
  How how_ = How::replace;
  Selection before_;
  std::vector<Vector2> path_;  ///< the box's first corner, or the lasso
  Vector2 at_ = Vector2::Zero();
  std::optional<RegionSight> sight_;  ///< nothing where hidden elements are taken, too
  std::map<ObjectId, std::set<std::uint32_t>> hidden_points_;  ///< points of skins, as the region began
  std::size_t left_out_ = 0;
};

}  // namespace

std::unique_ptr<Tool> make_region_tool(bool modal) {
  return std::make_unique<RegionTool>(modal);
}

}  // namespace hariko
