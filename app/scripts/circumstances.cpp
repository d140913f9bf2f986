#include "app/scripts/circumstances.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

namespace hariko {

namespace {

/// Commands in the order of the enumerators.
constexpr std::array pivot_commands{"transform.pivot_median", "transform.pivot_box",
                                    "transform.pivot_individual", "transform.pivot_active"};
constexpr std::array falloff_commands{"transform.falloff_smooth", "transform.falloff_linear",
                                      "transform.falloff_sharp"};
constexpr std::array mode_commands{"select.vertices", "select.edges", "select.faces", "select.objects"};

/// Objects that commands on objects act on, the active one first.
std::vector<ObjectId> acted_on(const Document& document, const Selection& selection) {
  std::vector<ObjectId> out;
  if (document.find(selection.active)) out.push_back(selection.active);
  for (const ObjectId id : selection.objects())
    if (id != selection.active && document.find(id)) out.push_back(id);
  return out;
}

std::vector<std::string> names_of(const Document& document, const std::vector<ObjectId>& ids) {
  std::vector<std::string> out;
  for (const ObjectId id : ids) out.push_back(document.find(id)->name);
  return out;
}

template <class Ids>
std::vector<std::string> script_names(const Ids& ids) {
  std::vector<std::string> out;
  for (const auto id : ids) out.push_back(script_name(id));
  return out;
}

/// Steps that add the elements of an object to what is selected, or replace it.
void add_elements_of(const Object& object, const ElementSelection& elements, bool add,
                     std::vector<WrittenCommand>& out) {
  const auto choose = [&](const char* command, std::vector<std::string> ids) {
    if (ids.empty()) return;
    WrittenCommand step{command, {written("object", object.name), written("ids", ids)}};
    if (std::exchange(add, true)) step.arguments.push_back(written_switch("add", true));
    out.push_back(std::move(step));
  };
  choose(mode_commands[0], script_names(elements.vertices));
  choose(mode_commands[1], script_names(elements.edges));
  choose(mode_commands[2], script_names(elements.faces));
}

std::vector<WrittenCommand> steps_to_select_elements(const Document& document, const Circumstances& from,
                                                     const Circumstances& to) {
  std::vector<WrittenCommand> out;
  const Selection& selection = to.selection;
  if (const auto all = acted_on(document, selection); all.size() > 1)
    out.push_back({"select.objects", {written("names", names_of(document, all))}});
  bool add = false;
  for (const auto& [id, elements] : selection.elements())
    if (const Object* object = document.find(id); object && id != selection.active)
      add_elements_of(*object, elements, std::exchange(add, true), out);
  const Object* active = document.find(selection.active);
  if (!active) return out;
  const char* mode = mode_commands[static_cast<std::size_t>(to.mode)];
  if (const ElementSelection& own = selection.of_active(); !own.empty()) {
    add_elements_of(*active, own, add, out);
    if (out.back().command != mode) out.push_back({mode});
    return out;
  }
  out.push_back({mode, {written("object", active->name)}});
  // The command is refused where nothing is selected.
  if (!add && !from.selection.no_elements()) out.push_back({"select.none"});
  return out;
}

}  // namespace

std::string script_name(VertexId id) {
  return std::to_string(id.value);
}
std::string script_name(EdgeId id) {
  return std::to_string(id.low.value) + "-" + std::to_string(id.high.value);
}
std::string script_name(FaceId id) {
  return std::to_string(id.value);
}

Circumstances circumstances_of(const Editor& editor) {
  return {editor.selection,
          editor.mode,
          editor.transform.pivot,
          editor.transform.soft.falloff,
          editor.transform.local_edit,
          editor.settings.refine_on_surface};
}

void set_circumstances(Editor& editor, const Circumstances& circumstances) {
  editor.selection = circumstances.selection;
  editor.mode = circumstances.mode;
  editor.transform.pivot = circumstances.pivot;
  editor.transform.soft.falloff = circumstances.falloff;
  editor.transform.local_edit = circumstances.local_edit;
  editor.settings.refine_on_surface = circumstances.refine_on_surface;
}

std::vector<WrittenCommand> steps_to_select(const Document& document, const Circumstances& from,
                                            const Circumstances& to) {
  const auto now = acted_on(document, from.selection), wanted = acted_on(document, to.selection);
  const bool same_elements =
      to.mode == ElementMode::object || from.selection.elements() == to.selection.elements();
  // In object mode what is chosen is transformed, too, which an active object alone is not.
  const std::set<ObjectId>&has = from.selection.objects(), &needs = to.selection.objects();
  const bool same_objects =
      now == wanted &&
      (to.mode != ElementMode::object || std::includes(has.begin(), has.end(), needs.begin(), needs.end()));
  if (from.mode == to.mode && same_objects && same_elements) return {};
  if (to.mode != ElementMode::object) return steps_to_select_elements(document, from, to);
  if (wanted.empty()) return {WrittenCommand{"select.objects"}};
  return {WrittenCommand{"select.objects", {written("names", names_of(document, wanted))}}};
}

std::vector<WrittenCommand> steps_to_set(const Circumstances& from, const Circumstances& to) {
  std::vector<WrittenCommand> out;
  if (from.pivot != to.pivot) out.push_back({pivot_commands[static_cast<std::size_t>(to.pivot)]});
  if (from.falloff != to.falloff) out.push_back({falloff_commands[static_cast<std::size_t>(to.falloff)]});
  if (from.local_edit != to.local_edit)
    out.push_back({"transform.local_edit", {written_switch("on", to.local_edit)}});
  if (from.refine_on_surface != to.refine_on_surface)
    out.push_back({"mesh.on_surface", {written_switch("on", to.refine_on_surface)}});
  return out;
}

}  // namespace hariko
