#include "ui/polyhedron/cutting_tools.hpp"

#include <vector>

#include "core/modeling/cuts/knife_path.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "ui/editor/operations.hpp"
#include "ui/polyhedron/refined_lines.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

constexpr double vertex_radius = 11, edge_radius = 14, point_radius = 10;  // design pixels
constexpr double least_share = 1e-3;  ///< nearer to an end the end is meant

/// A place where a point can be put.
struct Place {
  enum class Kind { vertex, edge, middle, point };
  Kind kind = Kind::vertex;
  CutPoint point;
  std::optional<Vector3> shown = std::nullopt;  ///< point under the pointer on what is shown of the edge
};

bool same(const CutPoint& a, const CutPoint& b) {
  if (a.index() != b.index()) return false;
  if (const auto* vertex = std::get_if<VertexId>(&a)) return *vertex == std::get<VertexId>(b);
  const auto &p = std::get<EdgePoint>(a), &q = std::get<EdgePoint>(b);
  return p.edge == q.edge && p.share == q.share;
}

class KnifeTool final : public ModalTool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    lines_.on_surface = context.editor.settings.refine_on_surface;
    look(context, press.control);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    if (event.kind == PointerEvent::Kind::release) return ToolState::stay;
    look(context, event.control);
    if (event.kind == PointerEvent::Kind::press) put(context);
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    const KeyChord& chord = press.chord;
    if (chord.key == Key::enter || chord.key == Key::space) return confirm(context);
    if (chord.key == Key::backspace) {
      if (!legs_.empty()) legs_.pop_back();
      lay_lines(context);
      look(context, false);
      return ToolState::stay;
    }
    if (is_position_key(press)) {
      Settings& settings = context.editor.settings;
      settings.refine_on_surface = lines_.on_surface = !settings.refine_on_surface;
      lay_lines(context);
      look(context, false);
      return ToolState::stay;
    }
    return unused_key(press);
  }

  void cancel(ToolContext&) override {}

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    draw_line(context, overlay, made_, true);
    if (!made_.points.empty()) {
      if (!next_.line.empty() && error_.empty())
        draw_line(context, overlay, next_, false);
      else if (const auto from = context.projector().project(made_.points.back()))
        draw_dashed_line(overlay, from->head<2>(), pointer_,
                         error_.empty() ? palette().hot : palette().warning);
    }
    if (place_) draw_place(context, overlay);
    const Language& tr = context.editor.language;
    draw_value_label(overlay, pointer_, error_.empty() ? value_text(tr) : error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    return value_text(tr) + "   |   " +
           tr("Click vertices and edges   Ctrl: middle of the edge   Backspace: last point   Enter cuts   "
              "Esc "
              "cancels") +
           "   " + position_hint(tr, lines_.on_surface);
  }

 private:
  /// Leg of the path that one click added: the points that the line passes, and its end.
  using Leg = std::vector<CutPoint>;
  /// A part of the path as it will lie, in the document's space.
  struct Laid {
    std::vector<Vector3> points, line;
  };

  const Object* cut_object(const ToolContext& context) const {
    const Object* object = context.editor.document().find(object_);
    return object && object->polyhedron() ? object : nullptr;
  }

  std::vector<CutPoint> path() const {
    std::vector<CutPoint> out;
    for (const Leg& leg : legs_) out.insert(out.end(), leg.begin(), leg.end());
    return out;
  }

  Laid lay(const ToolContext& context, const Object& object, const std::vector<CutPoint>& points) {
    Laid out;
    for (std::size_t i = 0; i < points.size(); ++i) {
      out.points.push_back(lines_.point(context.editor, object, points[i]));
      if (i == 0) continue;
      const auto piece = lines_.line(context.editor, object, points[i - 1], points[i]);
      out.line.insert(out.line.end(), piece.begin(), piece.end());
    }
    return out;
  }

  void lay_lines(const ToolContext& context) {
    const Object* object = cut_object(context);
    made_ = object ? lay(context, *object, path()) : Laid();
  }

  /// Finds the place under the pointer and the way to it, or why there is none.
  void look(const ToolContext& context, bool middles) {
    place_.reset();
    ahead_.clear();
    next_ = {};
    error_.clear();
    PickOptions options;
    options.vertex_radius = middles ? 0 : vertex_radius;
    options.edge_radius = edge_radius;
    options.faces = options.use_surface = false;
    options.vertices = !middles;
    options.visible_only = !context.editor.view.x_ray && !context.editor.selecting.through;
    for (const PickHit& hit : pick_all(context.scene.scene(), context.projector(), pointer_, options)) {
      const ObjectId id = context.scene.object_id(hit.object);
      const Object* object = context.editor.document().find(id);
      if (!object || !object->polyhedron() || (!legs_.empty() && id != object_)) continue;
      if (hit.kind == Element::Kind::edge && !hit.share) continue;  // the image of an edge cannot be cut
      object_ = id;
      place_ = place_of(context, *object, hit, middles);
      if (place_->kind == Place::Kind::edge)
        place_->shown = hit.point;
      else
        place_->shown = lines_.point(context.editor, *object, place_->point);
      break;
    }
    if (place_ && !legs_.empty()) look_ahead(context);
  }

  Place place_of(const ToolContext& context, const Object& object, const PickHit& hit, bool middles) {
    if (hit.kind == Element::Kind::vertex)
      return {Place::Kind::vertex, VertexId{static_cast<std::uint32_t>(hit.element.id)}};
    const EdgeId edge = EdgeId::from_packed(hit.element.id);
    if (middles) return {Place::Kind::middle, EdgePoint{edge, 0.5}};
    // A point of the path attracts: so a cut can be closed.
    for (const CutPoint& point : path()) {
      const auto* on = std::get_if<EdgePoint>(&point);
      if (!on || on->edge != edge) continue;
      const auto at = context.projector().project(lines_.point(context.editor, object, point));
      if (at && (at->head<2>() - pointer_).norm() < point_radius * context.editor.pixel_scale)
        return {Place::Kind::point, point};
    }
    const auto& ends = context.scene.scene().objects[hit.object].polyhedron;
    const bool forward = ends->vertex_ids[ends->edges[hit.index][0]] == edge.low;
    const double share = forward ? *hit.share : 1 - *hit.share;
    if (!(share > least_share)) return {Place::Kind::vertex, edge.low};
    if (share > 1 - least_share) return {Place::Kind::vertex, edge.high};
    return {Place::Kind::edge, EdgePoint{edge, share}};
  }

  /// The line from the last point to the place, as it runs over the faces where it is seen.
  void look_ahead(const ToolContext& context) {
    const Object& object = *cut_object(context);
    const PolyhedronSource& source = *object.polyhedron();
    const CutPoint from = legs_.back().back();
    if (same(from, place_->point)) return;
    const auto straight = [&](const CutPoint& point) {
      return object.transform.apply(source.origin + position_of(source.polyhedron, point));
    };
    const Camera camera = context.editor.camera();
    const Vector3 a = straight(from), b = straight(place_->point);
    const Vector3 normal =
        camera.orthographic ? camera.forward().cross(b - a) : (a - camera.eye()).cross(b - camera.eye());
    auto between =
        knife_path(source.polyhedron, from, place_->point, object.transform.rotation.conjugate() * normal);
    if (!between) return void(refuse(context, between.error()));
    ahead_ = std::move(between).value();
    if (lines_.on_surface) cross_curves(context, object, from);
    ahead_.push_back(place_->point);
    std::vector<CutPoint> next{from};
    next.insert(next.end(), ahead_.begin(), ahead_.end());
    next_ = lay(context, object, next);
  }

  /// Edges on the way are crossed where the line on the screen crosses their curves.
  void cross_curves(const ToolContext& context, const Object& object, const CutPoint& from) {
    const Vector3 a = lines_.point(context.editor, object, from),
                  b = lines_.point(context.editor, object, place_->point);
    for (CutPoint& point : ahead_) {
      auto* on = std::get_if<EdgePoint>(&point);
      if (!on) continue;
      const double share = share_seen_between(context, object_, *on, a, b);
      if (share > least_share && share < 1 - least_share) on->share = share;
    }
  }

  void put(const ToolContext& context) {
    if (!place_) return void(refuse(context, "Click a vertex or an edge."));
    if (!error_.empty()) return;
    if (legs_.empty()) {
      legs_.push_back({place_->point});
      return lay_lines(context);
    }
    if (ahead_.empty()) return;  // the last point once more
    std::vector<CutPoint> longer = path();
    longer.insert(longer.end(), ahead_.begin(), ahead_.end());
    const auto done = cut(context, longer, nullptr);
    if (!done) return void(refuse(context, done.error()));
    legs_.push_back(ahead_);
    ahead_.clear();
    next_ = {};
    lay_lines(context);
  }

  /// Keeps the surface's form, if that is wanted, where it finds `kept`: what the path is tried with need
  /// not.
  Result<ModeledDocument> cut(const ToolContext& context, const std::vector<CutPoint>& along,
                              FormToKeep* kept) const {
    return edit_polyhedron(context.editor.history.current(), object_, [&](const PolyhedronSource& source) {
      if (kept) *kept = form_for_refinement(context.editor, source);
      return cut_path(source, along, kept ? kept->pointer() : nullptr);
    });
  }

  ToolState confirm(ToolContext& context) {
    Editor& editor = context.editor;
    FormToKeep kept;
    const auto done = cut(context, path(), &kept);
    if (!done) return refuse(context, done.error());
    if (!editor.commit(done->document, translatable("Knife"))) return ToolState::cancel;
    select_result(editor, object_, done->selection);
    say_form_lost(editor, kept.lost);
    return ToolState::commit;
  }

  static void draw_line(const ToolContext& context, const ToolOverlay& overlay, const Laid& laid, bool made) {
    const Projector projector = context.projector();
    const float half = overlay.metrics.px(3);
    draw_polyline(overlay, projector, laid.line, palette().hot, made ? 2.0F : 1.4F);
    for (const Vector3& point : laid.points)
      if (const auto at = projector.project(point)) {
        const ImVec2 p = on_screen(overlay, at->head<2>());
        if (made)
          overlay.list.AddRectFilled({p.x - half, p.y - half}, {p.x + half, p.y + half}, palette().hot);
        else
          overlay.list.AddCircleFilled(p, overlay.metrics.px(2.5F), palette().hot);
      }
  }

  /// Mark of what the point would snap to: a square round vertices and points, a triangle on middles, a
  /// circle else.
  void draw_place(const ToolContext& context, const ToolOverlay& overlay) const {
    const auto at = place_->shown ? context.projector().project(*place_->shown) : std::nullopt;
    if (!at) return;
    const ImVec2 p = on_screen(overlay, at->head<2>());
    const float r = overlay.metrics.px(7), thick = overlay.metrics.px(1.8F);
    const ImU32 colour = error_.empty() ? palette().text : palette().warning;
    const auto mark = [&](ImU32 in, float width) {
      if (place_->kind == Place::Kind::middle)
        overlay.list.AddTriangle({p.x, p.y - r}, {p.x + r, p.y + 0.75F * r}, {p.x - r, p.y + 0.75F * r}, in,
                                 width);
      else if (place_->kind == Place::Kind::edge)
        overlay.list.AddCircle(p, r, in, 0, width);
      else
        overlay.list.AddRect({p.x - r, p.y - r}, {p.x + r, p.y + r}, in, 0, 0, width);
    };
    mark(with_alpha(palette().window, 0.8F), 2.2F * thick);
    mark(colour, thick);
  }

  std::string value_text(const Language& tr) const {
    std::string text = tr("Knife");
    if (!legs_.empty()) text += "  " + tr.counted(legs_.size(), "1 point", "{0} points");
    if (!place_) return text;
    switch (place_->kind) {
      case Place::Kind::vertex:
        return text + "   " + tr("Vertex");
      case Place::Kind::middle:
        return text + "   " + tr("Middle");
      case Place::Kind::point:
        return text + "   " + tr("On the cut");
      case Place::Kind::edge:
        return text + "   " + fixed_text(100 * std::get<EdgePoint>(place_->point).share, 0) + " %";
    }
    return text;
  }

  RefinedLines lines_;
  ObjectId object_;        ///< the one that is cut, or was pointed at last
  std::vector<Leg> legs_;  ///< one for every click
  std::optional<Place> place_;
  std::vector<CutPoint> ahead_;  ///< from the last point to the place, without the former
  Laid made_, next_;             ///< the path, and the line from its end to the place
};

}  // namespace

std::unique_ptr<Tool> make_knife_tool() {
  return std::make_unique<KnifeTool>();
}

}  // namespace hariko
