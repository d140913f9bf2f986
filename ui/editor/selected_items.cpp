#include "ui/editor/selected_items.hpp"

#include <map>
#include <string_view>

#include "core/base/text/nearest_word.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/group_tree.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko {

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

Result<std::vector<ObjectId>> objects_named(const Document& document, std::span<const std::string> names) {
  std::map<std::string_view, std::vector<ObjectId>> called;
  for (const auto& object : document.objects) called[object->name].push_back(object->id);
  std::vector<ObjectId> out;
  for (const std::string& name : names) {
    if (const auto found = called.find(name); found != called.end()) {
      out.insert(out.end(), found->second.begin(), found->second.end());
      continue;
    }
    std::vector<std::string> known;
    for (const auto& object : document.objects) known.push_back(object->name);
    constexpr std::size_t shown_bytes = 120;
    const auto near = nearest_word(name, known);
    return make_error(e_no_object_named,
                      "There is no object called \"" + shortened(name, shown_bytes) + "\"." +
                          (near ? " Did you mean \"" + *near + "\"?" : std::string()),
                      "`hariko info` lists the names.");
  }
  return out;
}

std::string describe_in(const Object* object, const ElementSelection& selection, const Language& tr) {
  return object ? object_kind(*object).describe(selection, tr) : describe(selection, tr);
}

std::string left_out_text(const Editor& editor, const std::string& keys) {
  if (!editor.left_out || !(editor.left_out->selection == editor.selection)) return {};
  const std::size_t count = editor.left_out->count;
  const Language& tr = editor.language;
  return tr.counted(count, "1 hidden element left out", "{0} hidden elements left out") +
         (keys.empty() ? std::string() : "   " + fill(tr("{0}: take hidden ones, too"), {keys}));
}

}  // namespace hariko
