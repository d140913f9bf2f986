#include "ui/polyhedron/cutting_tools.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/modeling/cuts/loop_cut.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/selection/edge_paths.hpp"
#include "ui/editor/numeric_input.hpp"
#include "ui/editor/operations.hpp"
#include "ui/polyhedron/refined_lines.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

namespace {

constexpr double fine_share = 0.1;
constexpr double most_slide = 0.98;
constexpr int most_shown = 40;  ///< lines before the click

class LoopCutTool final : public PointingTool {
 public:
  ToolState update(ToolContext& context, const PointerEvent& event) override {
    const Vector2 by = event.pixel - pointer_;
    pointer_ = event.pixel;
    if (!sliding_) {
      if (event.kind == PointerEvent::Kind::move) look(context);
      if (event.kind == PointerEvent::Kind::press) choose(context);
      return ToolState::stay;
    }
    if (event.kind == PointerEvent::Kind::move && !input_.active()) slide(context, by, event);
    return event.kind == PointerEvent::Kind::press ? confirm(context) : ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    if (press.chord.key == Key::enter) {
      if (!sliding_ && !choose(context)) return ToolState::stay;
      return confirm(context);
    }
    if (!input_.active() && is_position_key(press)) {
      Settings& settings = context.editor.settings;
      settings.refine_on_surface = !settings.refine_on_surface;
      lines_.on_surface = settings.refine_on_surface;
      sliding_ ? show(context) : find_cuts(context);
      return ToolState::stay;
    }
    if (input_.key(press)) {
      const double number = input_.value().value_or(0);
      if (sliding_)
        options_.slide = number / 100;
      else
        options_.count = static_cast<int>(std::clamp(std::round(number), 1.0, double(max_cuts)));
      sliding_ ? show(context) : find_cuts(context);
      return ToolState::stay;
    }
    return unused_key(press);
  }

  bool wheel(ToolContext& context, double steps, const PointerEvent&) override {
    if (!sliding_) input_.clear();
    options_.count = std::clamp(options_.count + (steps > 0 ? 1 : -1), 1, 100);
    sliding_ ? show(context) : find_cuts(context);
    return true;
  }

  void begin(ToolContext& context, const PointerEvent& press) override {
    lines_.on_surface = context.editor.settings.refine_on_surface;
    PointingTool::begin(context, press);
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!sliding_) draw_cuts(context, overlay);
    const std::string value = value_text(context.editor.language);
    draw_value_label(overlay, pointer_, error_.empty() ? value : value + "   " + error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    return value_text(tr) + "   |   " +
           (sliding_ ? tr("Click places the cut   digits type %   Shift fine   Esc cancels")
                     : tr("Click an edge   wheel or digits: number of cuts   Esc cancels")) +
           "   " + position_hint(tr, lines_.on_surface);
  }

 private:
  static Vector3 world(const Object& object, const PolyhedronSource& source, Index v) {
    return object.transform.apply(source.origin + source.polyhedron.position(v));
  }

  /// Finds the edge under the pointer, and why it cannot be cut.
  void look(const ToolContext& context) override {
    edge_.reset();
    cuts_.clear();
    error_.clear();
    PickOptions options;
    options.vertices = options.faces = false;
    options.edge_radius = 14;
    options.visible_only = !context.editor.view.x_ray;
    options.use_surface = false;
    const auto hit = pick(context.scene.scene(), context.projector(), pointer_, options);
    if (!hit || hit->kind != Element::Kind::edge) return;
    const ObjectId id = context.scene.object_id(hit->object);
    const Object* object = context.editor.document().find(id);
    if (!object || !object->polyhedron()) return;
    object_ = id;
    edge_ = EdgeId::from_packed(hit->element.id);
    find_cuts(context);
  }

  bool choose(ToolContext& context) {
    if (!edge_) return false;
    options_.slide = 0;
    lines_.on_surface = context.editor.settings.refine_on_surface;
    show(context);
    sliding_ = error_.empty();
    if (!sliding_) context.editor.cancel_preview();
    input_.clear();
    return sliding_;
  }

  /// Along the chosen edge as it lies on the screen.
  void slide(ToolContext& context, const Vector2& by, const PointerEvent& event) {
    const Object* object = context.editor.history.current().find(object_);
    const PolyhedronSource& source = *object->polyhedron();
    const auto low = context.projector().project(world(*object, source, source.polyhedron.find(edge_->low)));
    const auto high =
        context.projector().project(world(*object, source, source.polyhedron.find(edge_->high)));
    if (!low || !high) return;
    const Vector2 along = high->head<2>() - low->head<2>();
    const double length = std::max(along.norm(), 20 * context.editor.pixel_scale);
    const double part = along.norm() > 1e-9 ? by.dot(along) / along.norm() : by.x();
    raw_ += (event.shift ? fine_share : 1) * part / length * (options_.count + 1);
    options_.slide = std::clamp(event.control ? std::round(raw_ * 10) / 10 : raw_, -most_slide, most_slide);
    show(context);
  }

  void show(ToolContext& context) {
    Editor& editor = context.editor;
    const Object* object = editor.history.current().find(object_);
    const SurfaceForm* form = object ? lines_.form_of(editor, *object) : nullptr;
    const auto done = edit_polyhedron(editor.history.current(), object_, [&](const PolyhedronSource& source) {
      return loop_cut(source, *edge_, options_, form);
    });
    error_ = done ? std::string() : editor.language.text_of(done.error());
    if (!done) return editor.cancel_preview();
    result_ = done->selection;
    editor.preview(done->document);
  }

  /// Writes the cut for scripts, which cut the ring of the selected edge.
  void tell(Editor& editor) const {
    const std::string edge = std::to_string(edge_->low.value) + "-" + std::to_string(edge_->high.value);
    editor.tell_script(
        {{"select.edges",
          {written("object", editor.history.current().find(object_)->name),
           written("ids", std::vector<std::string>{edge})}},
         {"mesh.loop_cut", {written("cuts", double(options_.count)), written("slide", options_.slide)}}});
  }

  ToolState confirm(ToolContext& context) {
    if (!error_.empty()) return ToolState::stay;
    if (!context.editor.commit_preview(
            Phrase::counted(options_.count, translatable("Loop cut"), translatable("{0} loop cuts"))))
      return ToolState::cancel;
    tell(context.editor);
    select_result(context.editor, object_, result_);
    say_form_lost(context.editor, lines_.lost_form());
    return ToolState::commit;
  }

  /// Finds the lines along which the ring would be cut, as they will lie.
  void find_cuts(const ToolContext& context) {
    cuts_.clear();
    const Object* object = edge_ ? context.editor.document().find(object_) : nullptr;
    const PolyhedronSource* source = object ? object->polyhedron() : nullptr;
    const Index e = source ? source->polyhedron.find(*edge_) : no_index;
    if (e == no_index) return;
    const Polyhedron& polyhedron = source->polyhedron;
    const EdgeRing ring = find_edge_ring(polyhedron, e);
    for (const double share : cut_shares({std::min(options_.count, most_shown), 0})) {
      std::vector<EdgePoint> points;
      for (std::size_t i = 0; i < ring.edges.size(); ++i) {
        const EdgeId id = polyhedron.edge_id(ring.edges[i]);
        points.push_back({id, polyhedron.vertex_id(ring.starts[i]) == id.low ? share : 1 - share});
      }
      const std::size_t count = points.size();
      for (std::size_t i = 0; i + (ring.closed ? 0 : 1) < count && count > 1; ++i)
        cuts_.push_back(lines_.line(context.editor, *object, points[i], points[(i + 1) % count]));
    }
  }

  void draw_cuts(const ToolContext& context, const ToolOverlay& overlay) const {
    const Projector projector = context.projector();
    for (const std::vector<Vector3>& line : cuts_) draw_polyline(overlay, projector, line, palette().hot, 2);
  }

  std::string value_text(const Language& tr) const {
    std::string text =
        options_.count == 1 ? tr("Loop cut") : fill(tr("{0} loop cuts"), {std::to_string(options_.count)});
    if (!sliding_) return text;
    const std::string value = input_.active() ? input_.text(0) : fixed_text(100 * options_.slide, 1);
    return text + "  " + value + " %";
  }

  ObjectId object_;
  std::optional<EdgeId> edge_;
  LoopCutOptions options_;
  NumericInput input_;
  double raw_ = 0;  ///< the slide before it is limited
  RefinedLines lines_;
  std::vector<std::vector<Vector3>> cuts_;  ///< lines in space, before the click
  bool sliding_ = false;
  ElementSet result_;
};

}  // namespace

std::unique_ptr<Tool> make_loop_cut_tool() {
  return std::make_unique<LoopCutTool>();
}

}  // namespace hariko
