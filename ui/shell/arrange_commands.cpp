// Commands that arrange whole objects: rows, rings, mirror images, common sides, equal gaps, and copies that
// are moved at once. They act on all that are chosen; the numbers of copies can be adjusted right afterwards.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/modeling/objects/primitives.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/shell/arrange_operations.hpp"
#include "ui/view/transform_tool.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

constexpr Code e_no_ring_centre{"E_NO_RING_CENTRE"};

constexpr const char* row_step = translatable("Array in a row");
constexpr const char* ring_step = translatable("Array around an axis");
constexpr const char* image_step = translatable("Mirrored copy");
constexpr const char* copies_step = translatable("Duplicate and move");

Box3 box_of_objects(const Editor& editor, std::span<const ObjectId> ids) {
  Box3 box;
  for (const ObjectId id : ids)
    if (const Object* object = editor.document().find(id)) box.extend(shown_box(editor, *object));
  return box;
}

/// A step along x that leaves a gap of about a quarter of the objects' width, with two digits.
double usual_step(const Editor& editor, std::span<const ObjectId> ids) {
  const Box3 box = box_of_objects(editor, ids);
  double width = box.isEmpty() ? 0 : box.sizes().x();
  if (!(width > 0)) width = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  if (!(width > 0) || !std::isfinite(width)) width = 2 * new_object_radius(editor);
  const double digit = std::pow(10, std::floor(std::log10(width)) - 1);
  return std::ceil(1.25 * width / digit) * digit;
}

Result<Document> live_row(const Document& document, std::span<const ObjectId> ids, int count,
                          const Vector3& step) {
  const auto row = row_of_copies(count, step);
  if (!row) return row.error();
  return add_live_copies(document, ids, *row);
}

Result<MakeOperation> row_of_objects(const Editor&, std::vector<ObjectId> ids) {
  return MakeOperation([ids = std::move(ids)](const Document& document, std::span<const OperationNumber> n) {
    const Vector3 step(n[1].value, n[2].value, n[3].value);
    if (wants_live_copies(n))
      return chosen_with_live_copies(live_row(document, ids, int(n[0].value), step), ids);
    return all_chosen(array_in_row(document, ids, int(n[0].value), step), ids);
  });
}

WriteOperation written_row(const Editor&) {
  return [](std::span<const OperationNumber> n) {
    return std::vector{WrittenCommand{
        "object.array_row",
        {written("count", n[0].value), written("step", Vector3(n[1].value, n[2].value, n[3].value)),
         written_switch("live", wants_live_copies(n))}}};
  };
}

void make_row_of_objects(Editor& editor) {
  constexpr int usual_count = 3;
  run_on_chosen(editor, row_step,
                {count_of_places(usual_count),
                 distance_number("array_x", translatable("Step X"), usual_step(editor, chosen_ids(editor))),
                 distance_number("array_y", translatable("Step Y"), 0),
                 distance_number("array_z", translatable("Step Z"), 0), kind_of_copies()},
                row_of_objects, written_row);
}

/// Centres that a ring can have, in the order of the choices; nothing where there is no such place.
using Centres = std::array<std::optional<Vector3>, 3>;

Centres centres_of(const Editor& editor, std::span<const ObjectId> ids) {
  Centres centres;
  centres[0] = Vector3::Zero();
  if (const Box3 box = box_of_objects(editor, ids); !box.isEmpty()) centres[1] = box.center();
  if (const TransformTarget target = TransformTarget::of(editor); !target.empty())
    centres[2] = target.pivot();
  return centres;
}

Result<Document> live_ring(const Document& document, std::span<const ObjectId> ids, int count,
                           const RingAxis& axis, double degrees) {
  const auto ring = ring_of_copies(count, axis, degrees);
  if (!ring) return ring.error();
  return add_live_copies(document, ids, *ring);
}

Result<MakeOperation> ring_of_objects(const Editor& editor, std::vector<ObjectId> ids) {
  const Centres centres = centres_of(editor, ids);
  return MakeOperation(
      [ids = std::move(ids), centres](const Document& document,
                                      std::span<const OperationNumber> n) -> Result<OperationResult> {
        const auto& centre = centres[static_cast<std::size_t>(n[2].value)];
        if (!centre)
          return make_error(e_no_ring_centre, "What is selected has no such centre.",
                            "Choose the world's zero, or select something.");
        const RingAxis axis{*centre, Vector3::Unit(static_cast<Eigen::Index>(n[1].value))};
        if (wants_live_copies(n))
          return chosen_with_live_copies(live_ring(document, ids, int(n[0].value), axis, n[3].value), ids);
        return all_chosen(array_around_axis(document, ids, int(n[0].value), axis, n[3].value), ids);
      });
}

WriteOperation written_ring(const Editor& editor) {
  return [centres = centres_of(editor, chosen_ids(editor))](std::span<const OperationNumber> n) {
    const auto& centre = centres[static_cast<std::size_t>(n[2].value)];
    if (!centre) return std::vector<WrittenCommand>();
    return std::vector{
        WrittenCommand{"object.array_ring",
                       {written("count", n[0].value),
                        written("axis", std::string(1, static_cast<char>('x' + int(n[1].value)))),
                        written("centre", *centre), written("angle", n[3].value),
                        written_switch("live", wants_live_copies(n))}}};
  };
}

void make_ring_of_objects(Editor& editor) {
  constexpr int usual_count = 6;
  constexpr double full_turn = 360;
  run_on_chosen(
      editor, ring_step,
      {count_of_places(usual_count), choice_number("array_axis", translatable("Axis"), {"X", "Y", "Z"}, 2),
       choice_number("array_centre", translatable("Centre"),
                     {translatable("World zero"), translatable("Selection"), translatable("Pivot")}),
       OperationNumber{
           "array_angle", translatable("Angle"), full_turn, -full_turn, full_turn, false, true, {}},
       kind_of_copies()},
      ring_of_objects, written_ring);
}

MirrorPlane plane_of_images(Axis axis, double position) {
  return {static_cast<int>(axis), position};
}

/// Makes images, which are then chosen, as copies are; live ones are chosen with their originals.
MakeOfObjects images_across(Axis axis) {
  return [axis](const Editor&, std::vector<ObjectId> ids) -> Result<MakeOperation> {
    return MakeOperation(
        [axis, ids = std::move(ids)](const Document& document,
                                     std::span<const OperationNumber> n) -> Result<OperationResult> {
          const MirrorPlane plane = plane_of_images(axis, n[0].value);
          if (wants_live_copies(n))
            return chosen_with_live_copies(add_live_copies(document, ids, mirror_of_copies(plane)), ids);
          const auto added = mirrored_copies(document, ids, plane);
          if (!added) return added.error();
          OperationResult result{added->document, added->ids.front()};
          result.objects = added->ids;
          return result;
        });
  };
}

/// Writes the command of an image.
WriteOfObjects written_images(const char* id) {
  return [id](const Editor&) -> WriteOperation {
    return [id](std::span<const OperationNumber> n) {
      return std::vector{WrittenCommand{
          id, {written("position", n[0].value), written_switch("live", wants_live_copies(n))}}};
    };
  };
}

ScriptUse images_in_scripts(Editor& editor, Axis axis) {
  ScriptUse use;
  use.arguments = {length_argument("position", translatable("Position"), 0), live_copies_argument()};
  use.run = [&editor, axis](const Arguments& given) {
    const MirrorPlane plane = plane_of_images(axis, given.number("position"));
    const Document& document = editor.history.current();
    const std::vector<ObjectId> chosen = chosen_ids(editor);
    if (given.on("live"))
      return make_live_copies(editor, add_live_copies(document, chosen, mirror_of_copies(plane)), image_step);
    make_copies(editor, mirrored_copies(document, chosen, plane), {}, image_step);
  };
  return use;
}

/// Copies and moves them as the tool did, by other lengths where there are numbers.
MakeOperation moved_copies(AddedObjects copies, TransformTarget target, const Transformation& done) {
  return [copies = std::move(copies), target = std::move(target), done](
             const Document&, std::span<const OperationNumber> n) -> Result<OperationResult> {
    Transformation again = done;
    if (n.size() == 3) again.translation = Vector3(n[0].value, n[1].value, n[2].value);
    Result<Document> moved = target.apply(copies.document, again);
    if (!moved) return moved.error();
    OperationResult result{std::move(moved).value(), copies.ids.front()};
    result.objects = copies.ids;
    return result;
  };
}

/// Writes copies and their move as two steps of a script.
WriteOperation written_copies(const Transformation& done) {
  return [done](std::span<const OperationNumber> n) {
    const Vector3 by = n.size() == 3 ? Vector3(n[0].value, n[1].value, n[2].value) : done.translation;
    if (!done.only_translates()) return std::vector<WrittenCommand>();
    return std::vector{WrittenCommand{"object.duplicate"}, WrittenCommand{"select.objects"},
                       WrittenCommand{"transform.move", {written("by", by)}}};
  };
}

MakeOfObjects copies_moved_again(const Transformation& done) {
  return [done](const Editor& editor, std::vector<ObjectId> ids) -> Result<MakeOperation> {
    auto copies = duplicate_objects(editor.history.current(), ids);
    if (!copies) return copies.error();
    TransformTarget target = TransformTarget::of_objects(editor, copies->document, copies->ids);
    return moved_copies(std::move(copies).value(), std::move(target), done);
  };
}

void duplicate_and_move(CommandHost& host) {
  auto copies = duplicate_objects(host.editor.history.current(), chosen_ids(host.editor));
  if (!copies) return host.editor.notify(copies.error());
  NewObjects made{copies->document, copies->ids, copies_step, {}};
  made.moved = [copies = *copies](Editor& editor, const Document& before, const TransformTarget& target,
                                  const Transformation& done) {
    choose_objects(editor, copies.ids);
    const WriteOfObjects write = [done](const Editor&) { return written_copies(done); };
    OperationStep step{copies_step,
                       {},
                       moved_copies(copies, target, done),
                       begin_on_chosen(copies_moved_again(done), write),
                       written_copies(done)};
    if (done.only_translates())
      step.numbers = {distance_number("copies_x", "X", done.translation.x()),
                      distance_number("copies_y", "Y", done.translation.y()),
                      distance_number("copies_z", "Z", done.translation.z())};
    editor.tell_script(step.written(step.numbers));
    editor.last_operation.take_up(editor, before, std::move(step));
  };
  host.viewport.start_modal(make_transform_tool(std::move(made)));
}

std::vector<SizedObject> chosen_with_boxes(const Editor& editor) {
  std::vector<SizedObject> out;
  for (const auto& object : chosen_objects(editor)) out.push_back({object->id, shown_box(editor, *object)});
  return out;
}

void make_arrangement(Editor& editor, const Result<Document>& result, const char* step) {
  if (!editor.commit(result, step) && result) editor.inform("The objects lie like this already.");
}

void align_chosen(Editor& editor, Axis axis, BoxSide side) {
  const auto objects = chosen_with_boxes(editor);
  make_arrangement(editor,
                   align_objects(editor.history.current(), objects, editor.selection.active, axis, side),
                   translatable("Align objects"));
}

void distribute_chosen(Editor& editor, Axis axis) {
  const auto objects = chosen_with_boxes(editor);
  make_arrangement(editor, distribute_objects(editor.history.current(), objects, axis),
                   translatable("Distribute objects"));
}

ScriptUse row_in_scripts(Editor& editor) {
  ScriptUse use;
  use.arguments = {whole_argument("count", translatable("Total count"), 3, least_places, most_places),
                   point_argument("step", translatable("Step"), ArgumentUnit::length, std::nullopt),
                   live_copies_argument()};
  use.run = [&editor](const Arguments& given) {
    if (given.on("live"))
      return make_live_copies(
          editor,
          live_row(editor.history.current(), chosen_ids(editor), given.whole("count"), given.point("step")),
          row_step);
    make_copies(
        editor,
        array_in_row(editor.history.current(), chosen_ids(editor), given.whole("count"), given.point("step")),
        chosen_ids(editor), row_step);
  };
  return use;
}

ScriptUse ring_in_scripts(Editor& editor) {
  ScriptUse use;
  use.arguments = {whole_argument("count", translatable("Total count"), 6, least_places, most_places),
                   word_argument("axis", translatable("Axis"), {"x", "y", "z"}, "z"),
                   point_argument("centre", translatable("Centre"), ArgumentUnit::length, Vector3(0, 0, 0)),
                   angle_argument("angle", translatable("Angle"), 360), live_copies_argument()};
  use.run = [&editor](const Arguments& given) {
    const RingAxis axis{given.point("centre"), Vector3::Unit(given.text("axis").front() - 'x')};
    if (given.on("live"))
      return make_live_copies(editor,
                              live_ring(editor.history.current(), chosen_ids(editor), given.whole("count"),
                                        axis, given.number("angle")),
                              ring_step);
    make_copies(editor,
                array_around_axis(editor.history.current(), chosen_ids(editor), given.whole("count"), axis,
                                  given.number("angle")),
                chosen_ids(editor), ring_step);
  };
  return use;
}

WhyNot needs_several(const Editor& editor, std::size_t least, const char* otherwise) {
  return only_if(
      needs_object(editor), [&editor, least] { return chosen_ids(editor).size() >= least; }, otherwise);
}

WhyNot needs_shown_object(const Editor& editor) {
  return only_if(
      needs_object(editor),
      [&editor] {
        return std::ranges::any_of(chosen_objects(editor),
                                   [](const auto& object) { return object->visible; });
      },
      translatable("What is selected is hidden."));
}

void add_copying(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot object = needs_object(editor);
  MenuRows(table, "Edit")
      .add_edit(
          "object.duplicate_move", "Duplicate and move",
          "Copy the chosen objects and move the copies with the pointer or by typed lengths; Esc takes them "
          "away again.",
          [&host] { duplicate_and_move(host); }, needs_shown_object(editor),
          {.keys = "Shift+D", .separator_before = true, .needs_window = true, .contexts = Context::object});
  MenuRows rows(host.table, arrange_menu());
  rows.add_edit("object.array_row", "Array in a row\u2026",
                "A row of copies of the chosen objects; count and steps can be changed right afterwards.",
                [&editor] { make_row_of_objects(editor); }, object,
                {.contexts = Context::object, .script = row_in_scripts(editor)});
  rows.add_edit(
      "object.array_ring", "Array around an axis\u2026",
      "A ring or an arc of copies of the chosen objects; count, axis, centre and angle can be changed right "
      "afterwards.",
      [&editor] { make_ring_of_objects(editor); }, object,
      {.contexts = Context::object, .script = ring_in_scripts(editor)});
  add_curve_array_command(host);
  add_live_copy_commands(host);
}

void add_mirrored_copies(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot object = needs_object(editor);
  MenuRows rows(host.table, arrange_menu());
  rows.next_group();
  const auto mirror = [&](const char* id, const char* label, Axis axis) {
    rows.add_edit(
        id, label,
        "A mirror image of each chosen object, on the other side of the plane through zero; the plane can "
        "be moved right afterwards, and the image can be a live copy.",
        [&editor, axis, id] {
          run_on_chosen(editor, image_step,
                        {distance_number("mirror_position", translatable("Position"), 0), kind_of_copies()},
                        images_across(axis), written_images(id));
        },
        object, {.contexts = Context::object, .script = images_in_scripts(editor, axis)});
  };
  mirror("object.mirror_copy_x", "Mirrored copy across X", Axis::x);
  mirror("object.mirror_copy_y", "Mirrored copy across Y", Axis::y);
  mirror("object.mirror_copy_z", "Mirrored copy across Z", Axis::z);
}

void add_aligning(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot two = needs_several(
      editor, 2, translatable("Choose two or more objects. Press 4 and click them with Shift."));
  MenuRows rows(host.table, arrange_menu());
  rows.next_group();
  const auto align = [&](const char* id, const char* label, const char* help, Axis axis, BoxSide side) {
    rows.add_edit(id, label, help, [&editor, axis, side] { align_chosen(editor, axis, side); }, two,
                  {.contexts = Context::object});
  };
  const char* low = "The sides with the least coordinate come to lie where that of the active object lies.";
  const char* middle = "The centres of the objects' boxes come to lie where that of the active object lies.";
  const char* high =
      "The sides with the greatest coordinate come to lie where that of the active object lies.";
  align("object.align_x_low", "Align X minimum", low, Axis::x, BoxSide::minimum);
  align("object.align_x_centre", "Align X centre", middle, Axis::x, BoxSide::centre);
  align("object.align_x_high", "Align X maximum", high, Axis::x, BoxSide::maximum);
  align("object.align_y_low", "Align Y minimum", low, Axis::y, BoxSide::minimum);
  align("object.align_y_centre", "Align Y centre", middle, Axis::y, BoxSide::centre);
  align("object.align_y_high", "Align Y maximum", high, Axis::y, BoxSide::maximum);
  align("object.align_z_low", "Align Z minimum", low, Axis::z, BoxSide::minimum);
  align("object.align_z_centre", "Align Z centre", middle, Axis::z, BoxSide::centre);
  align("object.align_z_high", "Align Z maximum", high, Axis::z, BoxSide::maximum);
}

void add_distributing(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot three = needs_several(
      editor, 3, translatable("Choose three or more objects. Press 4 and click them with Shift."));
  MenuRows rows(host.table, arrange_menu());
  rows.next_group();
  const auto distribute = [&](const char* id, const char* label, Axis axis) {
    rows.add_edit(id, label, "Equal gaps between the chosen objects; the first and the last stay.",
                  [&editor, axis] { distribute_chosen(editor, axis); }, three, {.contexts = Context::object});
  };
  distribute("object.distribute_x", "Distribute along X", Axis::x);
  distribute("object.distribute_y", "Distribute along Y", Axis::y);
  distribute("object.distribute_z", "Distribute along Z", Axis::z);
}

}  // namespace

void add_arrange_commands(CommandHost& host) {
  add_copying(host);
  add_mirrored_copies(host);
  add_aligning(host);
  add_distributing(host);
}

}  // namespace hariko
