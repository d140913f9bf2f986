#include "ui/editor/selected_items.hpp"

#include "core/document/group_tree.hpp"

namespace hariko {

namespace {

template <class Id>
SelectedIds<Id> ids_of_active(const Editor& editor, std::set<Id> ElementSelection::*member) {
  if (editor.mode == ElementMode::object) return {};
  const auto object = editor.document().find_shared(editor.selection.active);
  if (!object || !object->polyhedron()) return {};
  // What a gesture shows may lack elements that are selected in the document it began with.
  const Polyhedron& polyhedron = object->polyhedron()->polyhedron;
  SelectedIds<Id> selected;
  for (const Id id : editor.selection.of(object->id).*member)
    if (polyhedron.find(id) != no_index) selected.ids.push_back(id);
  if (!selected.ids.empty()) selected.object = object;
  return selected;
}

}  // namespace

Objects chosen_objects(const Editor& editor) {
  Objects objects;
  if (auto active = editor.document().find_shared(editor.selection.active))
    objects.push_back(std::move(active));
  for (const ObjectId id : editor.selection.objects()) {
    if (id == editor.selection.active) continue;
    if (auto object = editor.document().find_shared(id)) objects.push_back(std::move(object));
  }
  const GroupId group = editor.chosen_group.chosen(editor);
  if (group == GroupId{}) return objects;
  // Hidden and locked objects of a group are chosen with it, although they are not selected.
  const std::set<std::shared_ptr<const Object>> known(objects.begin(), objects.end());
  for (const ObjectId id : GroupTree(editor.document()).objects_in(group))
    if (auto object = editor.document().find_shared(id); !known.contains(object))
      objects.push_back(std::move(object));
  return objects;
}

std::vector<ObjectId> chosen_ids(const Editor& editor) {
  std::vector<ObjectId> ids;
  for (const auto& object : chosen_objects(editor)) ids.push_back(object->id);
  return ids;
}

void choose_objects(Editor& editor, std::span<const ObjectId> objects) {
  editor.selection.clear_elements();
  editor.selection.clear_objects();
  for (const ObjectId id : objects)
    if (const Object* object = editor.document().find(id); object && object->visible && !object->locked)
      editor.selection.select({id, element_of(id)}, Selection::How::add);
  editor.selection.active = objects.front();
}

SelectedIds<VertexId> selected_vertices(const Editor& editor) {
  return ids_of_active(editor, &ElementSelection::vertices);
}

SelectedIds<EdgeId> selected_edges(const Editor& editor) {
  return ids_of_active(editor, &ElementSelection::edges);
}

SelectedIds<FaceId> selected_faces(const Editor& editor) {
  return ids_of_active(editor, &ElementSelection::faces);
}

}  // namespace hariko
