// Commands of the Solids menu: solids round which a surface goes. They are added to the active object where
// it is made of solids, else they begin a new one. Their numbers can be adjusted right afterwards.

#include <algorithm>
#include <array>
#include <utility>

#include "core/document/edits/edit_solids.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/solid.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/last_operation.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/solids/new_solids.hpp"
#include "ui/view/viewport.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

namespace {

/// Beside the solids that are there: half of it stands out on the right.
Vector3 beside(const EnvelopeInput& input) {
  Eigen::AlignedBox3d box;
  for (const Solid& solid : input.solids) box.extend(box_of(solid));
  const Vector3 centre = box.center();
  return {box.max().x(), centre.y(), centre.z()};
}

void add(Editor& editor, const NewSolid& shape) {
  begin_document(editor);
  double radius = new_object_radius(editor);
  Vector3 at = Vector3::Zero();
  if (const Object* object = active_solids(editor)) {
    radius /= object->transform.scale;
    at = beside(*object->solids()->input);
  }
  const Similarity place = place_for_new(editor);
  const auto put = [at](Solid solid) {
    solid.position = at;
    return solid;
  };
  const bool begins = !active_solids(editor);
  const std::vector<OperationNumber> numbers = shape.numbers(radius);
  if (!add_new_solid(editor, shape, numbers, put, place)) return;
  const Object& object = *editor.active_object();
  WrittenCommand step{std::string("solid.") + shape.name, written_numbers(numbers)};
  Similarity there;
  there.translation = object.transform.apply(at);
  if (begins) there.rotation = object.transform.rotation;
  for (WrittenArgument& argument : written_place(there)) step.arguments.push_back(std::move(argument));
  std::vector<WrittenCommand> steps{std::move(step)};
  // The name that a script gives is English.
  if (begins) steps.push_back({"object.rename", {written("name", object.name)}});
  editor.tell_script(std::move(steps));
}

/// Use in scripts: sizes and places do not depend on what is there; `at` is in the document's space.
ScriptUse solid_in_scripts(Editor& editor, const NewSolid& shape) {
  const std::vector<OperationNumber> usual = shape.numbers(first_object_radius(Unit::millimetre));
  ScriptUse use;
  use.arguments = arguments_of(usual);
  add_place_arguments(use.arguments);
  use.arguments.push_back(on_off_argument("new_object", translatable("Begins a new object"), false));
  use.run = [&editor, shape, usual](const Arguments& given) {
    begin_document(editor);
    // Without an active object of solids a new one begins.
    if (given.on("new_object")) editor.selection.active = {};
    const Object* object = active_solids(editor);
    const Similarity place = given_place(given);
    Vector3 at = Vector3::Zero();
    Vector3 turned = Vector3::Zero();
    if (object) {
      at = object->transform.inverse().apply(place.translation);
      turned = given.point("turned");
    }
    const auto put = [at, turned](Solid solid) {
      solid.position = at;
      solid.rotation = turned;
      return solid;
    };
    add_new_solid(editor, shape, with_values(usual, given), put, place);
  };
  return use;
}

std::vector<std::uint32_t> selected_solids(const Editor& editor) {
  std::vector<std::uint32_t> out;
  for (const VertexId id : editor.selection.of(editor.selection.active).vertices) out.push_back(id.value);
  return out;
}

double width_of(const Object& object, std::span<const std::uint32_t> ids) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t id : ids)
    if (const Solid* solid = find_solid(object, id)) box.extend(box_of(*solid));
  return box.isEmpty() ? 1 : box.sizes().x();
}

/// Copies of the selected solids, moved to the right by their width and selected.
void duplicate_solids(Editor& editor) {
  const ObjectId object = editor.selection.active;
  const std::vector<std::uint32_t> ids = selected_solids(editor);
  std::vector<std::uint32_t> copies;
  const auto result = array_solids(editor.history.current(), object, ids, 1,
                                   {width_of(*editor.active_object(), ids), 0, 0}, copies);
  if (editor.commit(result, Phrase::counted(copies.size(), translatable("Duplicate solid"),
                                            translatable("Duplicate {0} solids"))))
    select_solids(editor, object, copies);
}

/// A bar between the two selected solids; its radius is that of a selected solid.
void bridge(Editor& editor) {
  const Object& object = *editor.active_object();
  const std::vector<std::uint32_t> ids = selected_solids(editor);
  const Solid &a = *find_solid(object, ids[0]), &b = *find_solid(object, ids[1]);
  constexpr double share = 0.25;
  const double radius = share * std::min(box_of(a).sizes().minCoeff(), box_of(b).sizes().minCoeff());
  const std::uint32_t bar = next_solid_id(*object.solids()->input);
  if (editor.commit(add_solid(editor.history.current(), object.id, bridge_between(a, b, radius)),
                    translatable("Bridge solids")))
    select_solids(editor, editor.selection.active, std::array{bar});
}

/// Makes one part of a surface that has several.
void join(Editor& editor) {
  bool joined = false;
  const auto result = change_envelope(editor.history.current(), editor.selection.active,
                                      [&](EnvelopeInput& input) { joined = join_parts(input); });
  if (result.ok() && !joined) return editor.inform("The surface is one part already.");
  editor.commit(result, translatable("Join parts"));
}

WhyNot needs_solids(const Editor& editor) {
  return only_if(
      needs_object(editor), [&editor] { return editor.active_object()->solids() != nullptr; },
      translatable("The active object is not made of solids."));
}

WhyNot needs_chosen_solids(const Editor& editor) {
  return only_if(
      needs_solids(editor),
      [&editor] { return editor.mode != ElementMode::object && !editor.selection.of_active().empty(); },
      translatable("No solid is selected. Click one."));
}

MakeOperation row_of(ObjectId object, std::vector<std::uint32_t> ids) {
  return [object, ids = std::move(ids)](const Document& document,
                                        std::span<const OperationNumber> n) -> Result<OperationResult> {
    std::vector<std::uint32_t> copies;
    auto made =
        array_solids(document, object, ids, int(n[0].value), {n[1].value, n[2].value, n[3].value}, copies);
    if (!made) return made.error();
    OperationResult result{std::move(made).value(), object};
    for (const std::uint32_t id : copies) result.selected.vertices.insert(VertexId{id});
    return result;
  };
}

std::vector<WrittenCommand> written_row_of_solids(std::span<const OperationNumber> numbers) {
  return {WrittenCommand{"solid.row", written_numbers(numbers)}};
}

Result<BegunOperation> begin_row(const Editor& editor) {
  if (const Reason reason = needs_chosen_solids(editor)()) return make_error(e_wrong_selection, *reason);
  return BegunOperation{row_of(editor.selection.active, selected_solids(editor)), {}, written_row_of_solids};
}

/// A row of copies of the selected solids, whose number and distance can be adjusted afterwards.
void make_row(Editor& editor, std::vector<OperationNumber> numbers) {
  OperationStep step;
  step.label = translatable("Row of solids");
  step.numbers = std::move(numbers);
  step.make = row_of(editor.selection.active, selected_solids(editor));
  step.begin = begin_row;
  step.written = written_row_of_solids;
  editor.last_operation.run(editor, std::move(step));
}

/// Numbers of a row to begin with.
std::vector<OperationNumber> row_numbers(double width) {
  constexpr double usual_copies = 3, most_copies = max_solids - 1;
  return {{"copies", translatable("Copies"), usual_copies, 1, most_copies, true},
          distance_number("row_x", "X", width),
          distance_number("row_y", "Y", 0),
          distance_number("row_z", "Z", 0)};
}

ScriptUse row_in_scripts(Editor& editor) {
  const std::vector<OperationNumber> usual = row_numbers(2 * first_object_radius(Unit::millimetre));
  return {.arguments = arguments_of(usual),
          .run = [&editor, usual](const Arguments& given) { make_row(editor, with_values(usual, given)); }};
}

WhyNot needs_two_solids(const Editor& editor) {
  const auto two = [&editor] {
    const std::vector<std::uint32_t> ids = selected_solids(editor);
    return editor.mode != ElementMode::object && ids.size() == 2 &&
           std::ranges::all_of(ids, [&](auto id) { return find_solid(*editor.active_object(), id); });
  };
  return only_if(needs_solids(editor), two, translatable("A bridge needs two selected solids."));
}

WhyNot needs_ball(const Editor& editor) {
  return only_if(
      needs_solids(editor),
      [&editor] { return editor.active_object()->solids()->input->settings.method == EnvelopeMethod::ball; },
      translatable("The surface is a network of curves."));
}

/// The selected solids, or all where none is selected.
std::vector<std::uint32_t> selected_or_all_solids(const Editor& editor) {
  std::vector<std::uint32_t> ids;
  if (editor.mode != ElementMode::object) ids = selected_solids(editor);
  if (ids.empty())
    for (const Solid& solid : editor.active_object()->solids()->input->solids) ids.push_back(solid.id);
  return ids;
}

WhyNot needs_pulls(const Editor& editor) {
  const auto any_pulled = [&editor] {
    return std::ranges::any_of(editor.active_object()->solids()->input->solids,
                               [](const Solid& solid) { return !solid.pulls.empty(); });
  };
  const auto pulled = [&editor] {
    return std::ranges::any_of(selected_or_all_solids(editor), [&](std::uint32_t id) {
      const Solid* solid = find_solid(*editor.active_object(), id);
      return solid && !solid->pulls.empty();
    });
  };
  return only_if(
      only_if(needs_ball(editor), any_pulled, translatable("The surface is not pulled anywhere.")), pulled,
      translatable(
          "The surface of the selected solids is not pulled. Pull it first: Solids > Pull surface."));
}

void remove_pulls(Editor& editor) {
  const std::vector<std::uint32_t> ids = selected_or_all_solids(editor);
  editor.commit(change_solids(editor.history.current(), editor.selection.active, ids,
                              [](Solid& solid) { solid.pulls.clear(); }),
                translatable("Remove pulls"));
}

void add_pull_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, "Solids");
  rows.add(
      "solid.pull", "Pull surface", "Drag the surface outwards or inwards; the place stays with its solid.",
      [&host] { host.viewport.start_modal(make_pull_tool()); }, needs_ball(editor), {.needs_window = true});
  rows.add_edit(
      "solid.remove_pulls", "Remove pulls",
      "The surface of the selected solids, or of all, is no longer pulled by hand.",
      [&editor] { remove_pulls(editor); }, needs_pulls(editor));
}

void add_new_solids(CommandHost& host) {
  Editor& editor = host.editor;
  for (const NewSolid& shape : new_solids())
    MenuRows(host.table, "Solids")
        .add_edit(std::string("solid.") + shape.name, shape.label, shape.help,
                  [&editor, shape] { add(editor, shape); }, {}, {.script = solid_in_scripts(editor, shape)});
  MenuRows places(host.table, submenu("Solids", translatable("Place")));
  places.next_group();
  for (const NewSolid& shape : new_solids())
    places.add(std::string("solid.place_") + shape.name, shape.label,
               "Click where it is to stand, on the working plane or on another solid; drag for its size.",
               [&host, shape] {
                 begin_document(host.editor);
                 host.viewport.start_modal(make_place_solid_tool(shape));
               },
               {}, {.needs_window = true});
}

}  // namespace

void add_solid_commands(CommandHost& host) {
  Editor& editor = host.editor;
  add_new_solids(host);
  const WhyNot chosen = needs_chosen_solids(editor);
  MenuRows rows(host.table, "Solids");
  rows.add_edit("solid.duplicate", "Duplicate solid", "Copy the selected solids to their right.",
                [&editor] { duplicate_solids(editor); }, chosen, {.separator_before = true});
  rows.add_edit(
      "solid.row", "Row of solids",
      "Copy the selected solids several times, each as far from the last; number and distance can be "
      "changed right afterwards.",
      [&editor] {
        make_row(editor, row_numbers(width_of(*editor.active_object(), selected_solids(editor))));
      },
      chosen, {.script = row_in_scripts(editor)});
  rows.add_edit(
      "solid.bridge", "Bridge solids", "Put a bar between the two selected solids.",
      [&editor] { bridge(editor); }, needs_two_solids(editor));
  rows.add_edit(
      "solid.join_parts", "Join parts",
      "Enlarge the ball to the smallest that makes one part of the surface.", [&editor] { join(editor); },
      needs_ball(editor));
  add_pull_commands(host);
  rows.add_edit(
      "solid.to_polyhedron", "Convert to polyhedron",
      "The corners of the surface become a polyhedron whose vertices and normals can be edited; the solids "
      "are kept, hidden.",
      [&host, &editor] { host.application.convert(editor.selection.active); }, needs_solids(editor),
      {.separator_before = true});
}

}  // namespace hariko
