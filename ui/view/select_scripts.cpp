#include "ui/view/command_scripts.hpp"

#include <algorithm>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/edit_result.hpp"
#include "ui/base/text_number.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

/// Slack of a box relative to its size, so that coordinates with rounding errors lie inside.
constexpr double box_tolerance = 1e-9;

const char* word_of(ElementMode mode) {
  return mode == ElementMode::vertex ? "vertex" : mode == ElementMode::edge ? "edge" : "face";
}

/// Adds the element of this name: "12", or "12-13" for an edge. False where it is no name.
bool add_element(ElementSelection& elements, ElementMode mode, std::string_view name) {
  if (mode != ElementMode::edge) {
    const auto id = number_in<std::uint32_t>(name);
    if (!id) return false;
    if (mode == ElementMode::vertex)
      elements.vertices.insert(VertexId{*id});
    else
      elements.faces.insert(FaceId{*id});
    return true;
  }
  const auto ends = numbers_in<std::uint32_t, 2>(name, '-');
  if (!ends || (*ends)[0] == (*ends)[1]) return false;
  elements.edges.insert(EdgeId::of(VertexId{(*ends)[0]}, VertexId{(*ends)[1]}));
  return true;
}

Result<ElementSelection> elements_named(const Object& object, ElementMode mode,
                                        const std::vector<std::string>& names) {
  ElementSelection out;
  for (const std::string& name : names) {
    ElementSelection one;
    if (!add_element(one, mode, name) || object_kind(object).existing(object, one).empty())
      return make_error(
          e_unknown_element,
          "\"" + object.name + "\" has no " + word_of(mode) + " \"" + shortened(name, 40) + "\".",
          "Ids are those of the document; an edge is named by its two vertices, as \"0-1\".");
    add_element(out, mode, name);
  }
  return out;
}

/// Elements that lie in a box of the document's space with all of their corners.
Result<ElementSelection> elements_in_box(const Object& object, ElementMode mode, const Vector3& from,
                                         const Vector3& to) {
  const Vector3 slack = Vector3::Constant(box_tolerance * std::max((to - from).norm(), to.norm()));
  const Box3 box(from.cwiseMin(to) - slack, from.cwiseMax(to) + slack);
  const ObjectKind& kind = object_kind(object);
  ElementSelection inside;
  for (const VertexId id : kind.all(object, ElementMode::vertex).vertices)
    if (const auto place = kind.place(object, element_of(id)))
      if (box.contains(object.transform.apply(*place))) inside.vertices.insert(id);
  ElementSelection out =
      mode == ElementMode::vertex ? inside : kind.converted(object, inside, ElementMode::vertex, mode);
  if (!out.empty()) return out;
  return make_error(e_nothing_selected,
                    std::string("No ") + word_of(mode) + " of \"" + object.name + "\" lies in the box.",
                    "Make the box larger.");
}

void select_objects(Editor& editor, const Arguments& arguments) {
  if (!arguments.has("names")) return;
  const auto ids = objects_named(editor.document(), arguments.list("names"));
  if (!ids) return editor.notify(ids.error());
  if (ids->empty()) return;
  Selection selection = editor.selection;
  if (!arguments.on("add")) selection.clear_objects();
  for (const ObjectId id : *ids) selection.select({id, element_of(id)}, Selection::How::add);
  selection.active = ids->front();
  selection.prune(editor.document());
  // A single object that is hidden or locked becomes the active one, to be shown or unlocked.
  for (const ObjectId id : *ids)
    if (ids->size() > 1 && !selection.contains({id, element_of(id)}))
      return editor.notify(make_error(e_locked,
                                      "\"" + editor.document().find(id)->name + "\" is hidden or locked.",
                                      "Show it by object.show_all, or unlock it by object.lock."));
  editor.selection = std::move(selection);
}

void select_elements(Editor& editor, const Arguments& arguments) {
  if (arguments.has("object")) {
    const auto ids = objects_named(editor.document(), std::vector{arguments.text("object")});
    if (!ids) return editor.notify(ids.error());
    editor.selection.active = ids->front();
  }
  const bool box = arguments.has("from") || arguments.has("to"), named = arguments.has("ids");
  if (!box && !named) return;
  if (box && (named || !arguments.has("from") || !arguments.has("to")))
    return editor.notify(make_error(e_argument, "Elements are chosen by \"ids\", or by \"from\" and \"to\".",
                                    "Leave the others out."));
  const Object* object = editor.active_object();
  if (!object)
    return editor.notify(make_error(e_no_object_named, "There is no object to select elements of.",
                                    "Open a document or add an object first."));
  if (!object->visible || object->locked)
    return editor.notify(make_error(e_locked, "\"" + object->name + "\" is hidden or locked.",
                                    "Show it by object.show_all, or unlock it by object.lock."));
  const auto elements =
      named ? elements_named(*object, editor.mode, arguments.list("ids"))
            : elements_in_box(*object, editor.mode, arguments.point("from"), arguments.point("to"));
  if (!elements) return editor.notify(elements.error());
  editor.selection.select(object->id, *elements,
                          arguments.on("add") ? Selection::How::add : Selection::How::replace);
}

}  // namespace

std::vector<ArgumentSpec> arguments_to_select(ElementMode mode) {
  const ArgumentSpec add = on_off_argument("add", "what was selected stays selected", false);
  if (mode == ElementMode::object)
    return {optional(list_argument("names", "of the objects; without them only the mode changes")), add};
  return {optional(text_argument("object", "name of the object that becomes the active one")),
          optional(list_argument("ids", mode == ElementMode::edge ? "of edges, such as \"0-1\""
                                                                  : "of elements, as in the document")),
          optional(point_argument("from", "corner of a box: what lies in it is selected",
                                  ArgumentUnit::length, {})),
          optional(point_argument("to", "opposite corner of the box", ArgumentUnit::length, {})), add};
}

void select_as_written(Editor& editor, const Arguments& arguments) {
  editor.mode == ElementMode::object ? select_objects(editor, arguments) : select_elements(editor, arguments);
}

}  // namespace hariko
