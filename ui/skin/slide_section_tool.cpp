#include "ui/skin/skin_tools.hpp"

#include <cmath>

#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/sections/skin_places.hpp"
#include "ui/editor/numeric_input.hpp"
#include "ui/editor/probe.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

namespace {

constexpr double slide_reach = 8;  // design pixels

class SlideSectionTool final : public SpeakingTool {
 public:
  SlideSectionTool(std::uint32_t section, bool modal) : section_(section), modal_(modal) {}
  bool modal() const override { return modal_; }

  void begin(ToolContext& context, const PointerEvent& press) override {
    press_ = press;
    pointer_ = press.pixel;
    const Object* object = shown_skin(context.editor);
    if (!object) return;
    object_ = object->id;
    skin_ = *object->skin()->skin;
    view_ = view_of(skin_, nullptr);
    const int k = skin_.find_section(section_);
    from_ = v_ = k >= 0 ? skin_.sections[std::size_t(k)].v : 0;
    grip_ = path_place(view_, *object, context.projector(), pointer_).value_or(from_);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    if (modal_ && event.kind == PointerEvent::Kind::press) return confirm(context);
    if (event.kind == PointerEvent::Kind::release) {
      if (modal_) return ToolState::stay;
      if (dragging_) return confirm(context);
      select(context.editor);
      return ToolState::commit;
    }
    const double moved = (event.pixel - press_.pixel).norm();
    if (!dragging_ && moved <= drag_threshold * context.editor.pixel_scale) return ToolState::stay;
    dragging_ = true;
    if (!input_.active()) show(context, event.alt);
    return ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    if (press.chord.key == Key::enter) return confirm(context);
    if (!input_.key(press)) return unused_key(press);
    show(context, false);
    return ToolState::stay;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!dragging_ && !modal_) return;
    const std::string value = value_text(context.editor.language);
    draw_value_label(overlay, pointer_, error_.empty() ? value : value + "   " + error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    return value_text(tr) + "   |   " +
           tr("Move along the path   Alt freely   digits type %   Enter confirms   Esc cancels");
  }

 private:
  void select(Editor& editor) const {
    const int k = skin_.find_section(section_);
    if (k < 0) return;
    ElementSelection elements;
    for (const SectionPoint& p : skin_.sections[std::size_t(k)].points)
      elements.vertices.insert(VertexId{p.id});
    editor.mode = ElementMode::vertex;
    editor.selection.select(object_, elements, press_.shift ? Selection::How::add : Selection::How::replace);
    editor.selection.active = object_;
  }

  double wanted(const ToolContext& context, const Object& object, bool free) const {
    if (input_.active()) return input_.value().value_or(100 * from_) / 100;
    const Projector projector = context.projector();
    const auto place = path_place(view_, object, projector, pointer_);
    if (!place) return v_;
    double v = from_ + *place - grip_;
    if (skin_.path.closed) v -= std::floor(v);
    double least = slide_reach * context.editor.pixel_scale;
    const auto here = pixel_of(object, projector, evaluate(skin_.path, v).position);
    for (int i = 0; i < skin_.path.size() && !free && here; ++i) {
      const double u = skin_.path.parameter(i);
      const auto there = pixel_of(object, projector, evaluate(skin_.path, u).position);
      if (!there || (*there - *here).norm() >= least) continue;
      least = (*there - *here).norm();
      v = u;
    }
    return v;
  }

  void show(ToolContext& context, bool free) {
    Editor& editor = context.editor;
    const Object* object = editor.history.current().find(object_);
    if (!object || !object->skin()) return;
    v_ = wanted(context, *object, free);
    const auto next = with_skin(editor.history.current(), object_, slide_section(skin_, section_, v_));
    error_ = next ? std::string() : editor.language.text_of(next.error());
    if (next) editor.preview(next);
  }

  ToolState confirm(ToolContext& context) {
    if (!error_.empty() && modal_) return ToolState::stay;
    if (!context.editor.history.in_gesture()) return ToolState::cancel;
    context.editor.commit_preview(translatable("Slide section"));
    return ToolState::commit;
  }

  std::string value_text(const Language& tr) const {
    const std::string value = input_.active() ? input_.text(0) : fixed_text(100 * v_, 1);
    return std::string(tr("Slide section")) + "  " + value + " %";
  }

  std::uint32_t section_;
  bool modal_;
  ObjectId object_;
  Skin skin_;      ///< at the beginning
  SkinView view_;  ///< likewise
  PointerEvent press_;
  double from_ = 0, grip_ = 0, v_ = 0;  ///< places on the path: of the section, of the pointer, now
  bool dragging_ = false;
  NumericInput input_;
};

}  // namespace

std::unique_ptr<Tool> make_slide_section_tool(std::uint32_t section, bool modal) {
  return std::make_unique<SlideSectionTool>(section, modal);
}

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
    if (press.chord.key == Key::enter) return ToolState::commit;
    return unused_key(press);
  }

  void cancel(ToolContext&) override {}

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    const Object* object = shown_skin(context.editor);
    if (object && place_) {
      std::vector<Vector3> line = sketch_;
      for (Vector3& point : line) point = object->transform.apply(point);
      draw_polyline(overlay, context.projector(), line, palette().hot, 2.5F);
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
      refuse(context, "Click the surface of the skin.");
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
};

}  // namespace

std::unique_ptr<Tool> make_add_section_tool(AddSection add) {
  return std::make_unique<AddSectionTool>(std::move(add));
}

}  // namespace hariko
