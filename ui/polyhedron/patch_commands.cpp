#include "ui/polyhedron/patch_commands.hpp"

#include <algorithm>

#include "core/modeling/objects/patch_objects.hpp"
#include "ui/view/transform_target.hpp"

namespace hariko {

namespace {

void select(Editor& editor, std::span<const ObjectId> objects) {
  editor.selection.clear_elements();
  editor.selection.active = objects[0];
  if (editor.mode != ElementMode::object) return;
  editor.selection.clear_objects();
  for (const ObjectId id : objects) editor.selection.select({id, element_of(id)}, Selection::How::add);
  editor.selection.active = objects[0];
}

void separate(Editor& editor) {
  const auto done = separate_patches(editor.history.current(), editor.selection.active);
  if (!done) return editor.notify(done.error());
  if (editor.commit(Result<Document>(done->document), translatable("Separate patches")))
    select(editor, done->objects);
}

/// The active object first: the others go into it.
std::vector<ObjectId> chosen(const Editor& editor) {
  std::vector<ObjectId> objects = selected_objects(editor);
  const auto active = std::find(objects.begin(), objects.end(), editor.selection.active);
  if (active != objects.end()) std::rotate(objects.begin(), active, active + 1);
  return objects;
}

bool has_several_patches(const Editor& editor) {
  const BezierSource* bezier = editor.active_object()->bezier();
  return bezier && bezier->patches->size() > 1;
}

void weld(Editor& editor) {
  const auto done = weld_patch_objects(editor.history.current(), chosen(editor));
  if (!done) return editor.notify(done.error());
  if (editor.commit(Result<Document>(done->document), translatable("Weld patches")))
    select(editor, std::span(&done->object, 1));
}

}  // namespace

void add_patch_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot object = needs_object(editor);
  host.table.add(
      {.id = "shape.weld_patches",
       .menu = "Shape",
       .label = "Weld patches",
       .help = "Make one surface of the chosen objects of patches: sides that are equal are joined.",
       .changes_document = true,
       .separator_before = true,
       .run = [&editor] { weld(editor); },
       .why_not = [&editor, object]() -> Reason {
         if (auto reason = object()) return reason;
         const Object& active = *editor.active_object();
         if (!active.patches() && !active.bezier())
           return translatable("The active object is not made of patches.");
         if (selected_objects(editor).size() > 1) return {};
         return translatable("Choose two or more objects. Press 4 and click them with Shift.");
       }});
  host.table.add({.id = "shape.separate_patches",
                  .menu = "Shape",
                  .label = "Separate patches",
                  .help = "Each patch becomes an object; the control points of those of degree 3 by 3 "
                          "without weights can then be edited, and edges attached to their sides.",
                  .changes_document = true,
                  .run = [&editor] { separate(editor); },
                  .why_not = only_if(
                      object, [&editor] { return has_several_patches(editor); },
                      translatable("The active object does not have several welded patches."))});
}

}  // namespace hariko
