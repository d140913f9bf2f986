// Move: carries the selected vertices along in the plane that faces the viewer.

#include <vector>

#include "ui/tools/tool.hpp"

namespace hariko {

namespace {

class MoveTool final : public Tool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    const Editor& editor = context.editor;
    const Object* object = editor.active_object();
    const PolyhedronSource* source = object ? object->polyhedron() : nullptr;
    if (!source) return;
    object_ = object->id;
    vertices_ = touched_vertices(editor.selection.of(object_), source->polyhedron);
    for (const VertexId id : vertices_)
      start_.push_back(source->polyhedron.position(source->polyhedron.find(id)));
    // The grabbed point stays under the pointer: the plane goes through it.
    const auto hit = pick_element(context, press.pixel);
    anchor_ = hit ? hit->point : editor.camera().target;
    from_ = context.projector().on_facing_plane(press.pixel, anchor_);
    to_object_ = object->transform.inverse();
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    if (vertices_.empty()) return ToolState::cancel;
    const Vector3 to = context.projector().on_facing_plane(event.pixel, anchor_);
    world_ = to - from_;
    const Vector3 moved = to_object_.apply_to_vector(world_);
    std::vector<Vector3> positions = start_;
    for (Vector3& position : positions) position += moved;
    if (!context.editor.preview(
            move_vertices(context.editor.history.current(), object_, vertices_, positions))) {
      cancel(context);
      return ToolState::cancel;
    }
    if (event.kind != PointerEvent::Kind::release) return ToolState::stay;
    context.editor.commit_preview(
        vertices_.size() == 1 ? translatable("Move vertex")
                              : fill(translatable("Move {0} vertices"), {std::to_string(vertices_.size())}));
    return ToolState::commit;
  }

  void cancel(ToolContext& context) override { context.editor.cancel_preview(); }

  std::string hint(const Language& tr) const override {
    return fill(tr("Move by {0}  {1}  {2}   Esc cancels"),
                {format_number(world_.x(), 3), format_number(world_.y(), 3), format_number(world_.z(), 3)});
  }

 private:
  ObjectId object_;
  std::vector<VertexId> vertices_;
  std::vector<Vector3> start_;  ///< relative to the source's origin
  Vector3 anchor_ = Vector3::Zero(), from_ = Vector3::Zero(), world_ = Vector3::Zero();
  Similarity to_object_;
};

}  // namespace

std::unique_ptr<Tool> make_move_tool() {
  return std::make_unique<MoveTool>();
}

}  // namespace hariko
