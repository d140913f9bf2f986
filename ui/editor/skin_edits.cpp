#include "ui/editor/skin_edits.hpp"

#include <algorithm>

#include "core/document/edits/edit_skin.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "core/skinning/edit/symmetric_edit.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

Result<Document> with_skin(const Document& document, ObjectId object, const Result<SkinEdit>& edit) {
  if (!edit) return edit.error();
  return set_skin(document, object, edit->skin);
}

bool commit_skin(Editor& editor, ObjectId object, const Result<SkinEdit>& edit, const std::string& label) {
  if (!editor.commit(with_skin(editor.history.current(), object, edit), label)) return false;
  for (const Message& note : edit->notes) editor.notify(note);
  Box3 box;
  if (const Object* changed = editor.document().find(object)) box = box_at_own_place(*changed);
  const double size = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  if (edit->deviation > 1e-6 * size)
    editor.inform({"The curve moved by up to {0}.", {format_number(edit->deviation, 3)}});
  return true;
}

bool commit_skin(Editor& editor, ObjectId object, const Result<CorrespondenceEdit>& edit,
                 const std::string& label) {
  if (!edit) return editor.refuse(edit.error());
  if (!editor.commit(set_skin(editor.history.current(), object, edit->skin), label)) return false;
  if (!edit->removed.empty() && !edit->added.empty())
    editor.inform(edit->removed.size() == 1 ? Phrase("A correspondence that would cross gave way.")
                                            : Phrase("{0} correspondences that would cross gave way.",
                                                     {std::to_string(edit->removed.size())}));
  return true;
}

void select_new_points(Editor& editor, const SkinEdit& edit) {
  if (edit.points.empty()) return;
  ElementSelection elements;
  for (const std::uint32_t id : edit.points) elements.vertices.insert(VertexId{id});
  editor.selection.set(editor.selection.active, elements);
}

std::vector<std::uint32_t> with_mirrored(const Skin& skin, const std::vector<std::uint32_t>& points) {
  return skin.mirror ? with_partners(skin, points, *skin.mirror) : points;
}

void delete_selected_points(Editor& editor) {
  const Object* object = shown_skin(editor);
  if (!object) return;
  const Skin& skin = *object->skin()->skin;
  if (const auto points = selected_section_points(editor); !points.empty())
    commit_skin(editor, object->id, delete_section_points(skin, with_mirrored(skin, points)),
                translatable("Delete section points"));
  else if (const auto path = selected_path_points(editor); !path.empty())
    commit_skin(editor, object->id, delete_path_point(skin, path.front()), translatable("Delete path point"));
}

std::vector<std::uint32_t> selected_section_points(const Editor& editor) {
  std::vector<std::uint32_t> out;
  const Object* object = shown_skin(editor);
  if (!object) return out;
  const auto& chosen = editor.selection.of(object->id).vertices;
  for (const SkinSection& section : object->skin()->skin->sections)
    for (const SectionPoint& p : section.points)
      if (chosen.contains(VertexId{p.id})) out.push_back(p.id);
  return out;
}

std::vector<int> selected_path_points(const Editor& editor) {
  std::vector<int> out;
  const Object* object = shown_skin(editor);
  if (!object) return out;
  for (const VertexId id : editor.selection.of(object->id).vertices)
    if (id.value >= path_point_ids && id.value < rail_point_ids &&
        int(id.value - path_point_ids) < object->skin()->skin->path.size())
      out.push_back(int(id.value - path_point_ids));
  return out;
}

const SkinSection* selected_section(const Editor& editor) {
  const Object* object = shown_skin(editor);
  const auto ids = selected_section_points(editor);
  if (!object || ids.empty()) return nullptr;
  for (const SkinSection& section : object->skin()->skin->sections)
    if (std::ranges::all_of(ids, [&](std::uint32_t id) { return find_point(section, id) >= 0; }))
      return &section;
  return nullptr;
}

}  // namespace hariko
