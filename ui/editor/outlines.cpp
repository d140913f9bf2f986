#include "ui/editor/outlines.hpp"

#include "core/gaussmap/outlines/interpolate_normals.hpp"

namespace hariko {

const Object* active_outline(const Editor& editor) {
  const Object* object = editor.active_object();
  return object && object->outline() ? object : nullptr;
}

std::set<Index> selected_points(const Editor& editor, const Object& object) {
  std::set<Index> out;
  if (editor.mode != ElementMode::vertex) return out;
  const std::size_t count = object.outline()->outline->point_count();
  for (const VertexId id : editor.selection.of(object.id).vertices)
    if (id.value < count) out.insert(id.value);
  return out;
}

bool change_outline(Editor& editor, const std::function<Result<Outline>(const Outline&)>& change,
                    const std::string& label) {
  return editor.commit(edit_outline(editor.history.current(), editor.selection.active, change), label);
}

OutlinePlace place_of_point(const Object& object, Index number) {
  const Outline& outline = *object.outline()->outline;
  const OutlinePoint at = outline_point(outline, number);
  const OutlineLoop& loop = outline.loops[at.loop];
  const std::size_t count = loop.points.size();
  const Vector3 chord = loop.points[(at.place + 1) % count] - loop.points[(at.place + count - 1) % count];
  OutlinePlace out;
  out.point = object.transform.apply(loop.points[at.place]);
  out.normal = object.transform.rotation * loop.normals[at.place].stableNormalized();
  out.tangent = object.transform.rotation * chord.stableNormalized();
  return out;
}

Index inserted_points(const Editor& editor, const Object& object) {
  const SurfaceView* view = editor.view_of(object.id);
  if (!view || !view->mesh || !view->object || !view->object->outline()) return 0;
  const Outline& outline = *view->object->outline()->outline;
  // Three patches a face. Vertices - edges + faces = 2 - loops, and 3 faces = 2 edges - border edges.
  const auto faces = std::ptrdiff_t(view->surface.patch_count() / 3),
             border = std::ptrdiff_t(outline.point_count()), loops = std::ptrdiff_t(outline.loops.size());
  return Index(std::max<std::ptrdiff_t>(0, 2 - loops + (faces - border) / 2));
}

}  // namespace hariko
