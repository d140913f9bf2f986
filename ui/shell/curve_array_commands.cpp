// The command that places copies of whole objects along a curve: a chain of selected edges, the path of a
// skin or a loop of an outline.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/document/object_box.hpp"
#include "core/modeling/objects/object_curves.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/editor/surface_view.hpp"
#include "ui/shell/arrange_operations.hpp"

namespace hariko {

namespace {

constexpr Code e_no_curve{"E_NO_CURVE"};
constexpr Code e_which_curve{"E_WHICH_CURVE"};
constexpr Code e_curve_pending{"E_CURVE_PENDING"};
constexpr Code e_curve_surface{"E_CURVE_SURFACE"};

constexpr const char* along_step = translatable("Array along a curve");
constexpr const char* no_curve =
    translatable("No curve is selected. Select edges, or choose a skin or an outline last.");
constexpr const char* edges_of_several =
    translatable("Edges of several objects are selected. Select those of one object.");
constexpr const char* several_loops =
    translatable("The outline has several loops. Select a point of one of them.");
constexpr const char* nothing_to_copy =
    translatable("Nothing is chosen to be copied along the curve. Press 4 and choose it, too.");

/// The curve that is selected, and what is chosen beside it.
struct CurveChoice {
  ObjectId object;
  std::vector<EdgeId> edges = {};  ///< none: the path of a skin, or a loop of an outline
  std::size_t loop = 0;
  std::vector<ObjectId> copied = {};
};

/// The skin or outline that is meant: the active object, else the only one among those that are chosen.
std::optional<ObjectId> drawn_curve(const Editor& editor, std::span<const ObjectId> chosen,
                                    bool only_active) {
  const auto drawn = [&](ObjectId id) {
    const Object* object = editor.document().find(id);
    return object && drawn_curve_count(*object).has_value();
  };
  if (chosen.size() < 2) return {};
  if (drawn(chosen.front())) return chosen.front();
  if (only_active || std::ranges::count_if(chosen, drawn) != 1) return {};
  return *std::ranges::find_if(chosen, drawn);
}

/// The drawn curve of the points that are selected, or the only one.
Result<std::size_t> chosen_loop(const Editor& editor, const Object& object) {
  const auto& points = editor.selection.of(object.id).vertices;
  if (const auto at = points.empty() ? std::nullopt : drawn_curve_at(object, *points.begin())) return *at;
  const std::size_t count = drawn_curve_count(object).value_or(0);
  if (count > 1) return make_error(e_which_curve, several_loops);
  if (count == 0) return make_error(e_no_curve, no_curve);
  return std::size_t(0);
}

/// While elements are selected their edges come first; while objects are, the one that was chosen last.
Result<CurveChoice> chosen_curve(const Editor& editor) {
  const std::vector<ObjectId> chosen = chosen_ids(editor);
  std::vector<ObjectId> with_edges;
  for (const auto& [id, elements] : editor.selection.elements()) {
    const Object* object = editor.document().find(id);
    if (object && object->cage() && !elements.edges.empty()) with_edges.push_back(id);
  }
  CurveChoice out;
  const bool elements_first = editor.mode != ElementMode::object && !with_edges.empty();
  auto drawn = elements_first ? std::nullopt : drawn_curve(editor, chosen, !with_edges.empty());
  if (drawn) {
    out.object = *drawn;
    const Object& object = *editor.document().find(*drawn);
    const auto loop = chosen_loop(editor, object);
    if (!loop) return loop.error();
    out.loop = *loop;
  } else {
    if (with_edges.empty()) return make_error(e_no_curve, no_curve);
    if (with_edges.size() > 1) return make_error(e_which_curve, edges_of_several);
    out.object = with_edges.front();
    const auto& edges = editor.selection.of(out.object).edges;
    out.edges.assign(edges.begin(), edges.end());
  }
  std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(out.copied),
               [&](ObjectId id) { return id != out.object; });
  if (out.copied.empty()) return make_error(e_no_objects, nothing_to_copy);
  return out;
}

/// The surface whose curves lie over the edges of an object; null where none is shown.
Result<const Surface*> surface_over_edges(const Editor& editor, const Object& object) {
  if (!object_kind(object).curves_over_edges() || !object.display.surface)
    return static_cast<const Surface*>(nullptr);
  const SurfaceView* view = editor.view_of(object.id);
  if (view && view->error)
    return make_error(e_curve_surface, "The surface over the selected edges cannot be made.",
                      "Hide the surface to use the straight edges.", element_of(object.id));
  if (!view || !view->mesh || view->quality != Quality::final || !view->object ||
      !(view->object->source == object.source))
    return make_error(e_curve_pending, "The surface over the selected edges is still being computed.",
                      "Try again when it is ready.", element_of(object.id));
  return &view->surface;
}

Result<ObjectCurve> curve_of_choice(const Editor& editor, const CurveChoice& choice) {
  const Object* object = editor.document().find(choice.object);
  if (!object) return make_error(e_no_curve, no_curve);
  if (!choice.edges.empty() && object->cage()) {
    const auto surface = surface_over_edges(editor, *object);
    if (!surface) return surface.error();
    return curve_of_edges(*object, choice.edges, *surface);
  }
  if (choice.loop < drawn_curve_count(*object).value_or(0)) return drawn_curve_of(*object, choice.loop);
  return make_error(e_no_curve, no_curve);
}

/// Numbers of the operation by their places in the list.
enum CurveNumber : std::size_t {
  places_number,
  count_number,
  spacing_number,
  turning_number,
  offset_number,
  begin_number,
  direction_number,
  copies_number
};

bool is_set(std::span<const OperationNumber> numbers, CurveNumber number) {
  return numbers[number].value != 0;
}

Vector3 middle_of_objects(const Document& document, std::span<const ObjectId> objects) {
  Box3 box;
  for (const ObjectId id : objects)
    if (const Object* object = document.find(id)) box.extend(world_box(*object));
  return box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(box.center());
}

/// Numbers and choices that the window asks for beside the objects and the curve.
struct AlongCurve {
  CurveLayout layout;
  bool onto_curve = false, backward = false;
};

Result<ArcLengthCurve> curve_to_follow(const ObjectCurve& curve, bool backward) {
  return ArcLengthCurve::make(backward ? run_backward(curve.pieces) : curve.pieces, curve.closed);
}

CurveLayout layout_of(const Document& document, const std::vector<ObjectId>& objects, AlongCurve wanted) {
  if (wanted.onto_curve) wanted.layout.carried = middle_of_objects(document, objects);
  return wanted.layout;
}

Result<AddedObjects> arrayed_along(const Document& document, const std::vector<ObjectId>& objects,
                                   const ObjectCurve& curve, const AlongCurve& wanted) {
  const auto made = curve_to_follow(curve, wanted.backward);
  if (!made) return made.error();
  return array_along_curve(document, objects, *made, layout_of(document, objects, wanted));
}

Result<Document> live_along(const Document& document, const std::vector<ObjectId>& objects,
                            const ObjectCurve& curve, const AlongCurve& wanted) {
  const auto made = curve_to_follow(curve, wanted.backward);
  if (!made) return made.error();
  return live_copies_along_curve(document, objects, *made, layout_of(document, objects, wanted));
}

MakeOperation make_along(std::vector<ObjectId> objects, ObjectCurve found) {
  const auto curve = std::make_shared<const ObjectCurve>(std::move(found));
  return [objects = std::move(objects), curve](const Document& document, std::span<const OperationNumber> n) {
    AlongCurve wanted{{}, is_set(n, begin_number), is_set(n, direction_number)};
    wanted.layout.count = int(n[count_number].value);
    if (is_set(n, places_number)) wanted.layout.spacing = n[spacing_number].value;
    wanted.layout.turning = CurveTurning(int(n[turning_number].value));
    wanted.layout.offset = n[offset_number].value;
    if (is_set(n, copies_number))
      return chosen_with_live_copies(live_along(document, objects, *curve, wanted), objects);
    return all_chosen(arrayed_along(document, objects, *curve, wanted), objects);
  };
}

/// On the curve that is selected then, else on the one that was selected for the first step.
MakeOfObjects along_chosen_curve(const CurveChoice& first) {
  return [first](const Editor& editor, std::vector<ObjectId> ids) -> Result<MakeOperation> {
    auto choice = chosen_curve(editor);
    if (!choice && choice.error().code == e_no_curve) {
      CurveChoice again = first;
      again.copied = std::move(ids);
      choice = std::move(again);
    }
    if (!choice) return choice.error();
    auto curve = curve_of_choice(editor, *choice);
    if (!curve) return curve.error();
    return make_along(choice->copied, std::move(curve).value());
  };
}

constexpr const char* turning_words[] = {"curve", "upright", "none"};

WriteOperation written_along(const Editor&) {
  return [](std::span<const OperationNumber> n) {
    return std::vector{WrittenCommand{
        "object.array_curve",
        {is_set(n, places_number) ? written("spacing", n[spacing_number].value)
                                  : written("count", n[count_number].value),
         written("turning", std::string(turning_words[std::size_t(n[turning_number].value)])),
         written("offset", n[offset_number].value), written_switch("on_curve", is_set(n, begin_number)),
         written_switch("backward", is_set(n, direction_number)),
         written_switch("live", is_set(n, copies_number))}}};
  };
}

/// A fifth of a curve, with two digits.
double usual_spacing(double length) {
  const double digit = std::pow(10, std::floor(std::log10(length / 5)) - 1);
  return std::floor(length / 5 / digit) * digit;
}

std::vector<OperationNumber> numbers_along(const ArcLengthCurve& curve, const Vector3& objects) {
  constexpr int usual_count = 6;
  constexpr double clearly = 1 - 1e-6;  // the beginning counts where distances are equal
  const bool nearer_to_end = !curve.closed() && (curve.at(curve.length()).position - objects).norm() <
                                                    clearly * (curve.at(0).position - objects).norm();
  OperationNumber spacing =
      distance_number("array_spacing", translatable("Spacing"), usual_spacing(curve.length()));
  spacing.low = 0;
  return {
      choice_number("array_places", translatable("Places"),
                    {translatable("By count"), translatable("By spacing")}),
      count_of_places(usual_count),
      spacing,
      choice_number("array_turning", translatable("Turning"),
                    {translatable("With the curve"), translatable("Upright"), translatable("Not turned")}),
      distance_number("array_offset", translatable("Offset"), 0),
      choice_number("array_begin", translatable("First place"),
                    {translatable("As it stands"), translatable("On the curve")}),
      choice_number("array_direction", translatable("Direction"),
                    {translatable("Forward"), translatable("Backward")}, nearer_to_end ? 1 : 0),
      kind_of_copies()};
}

void make_along_curve(Editor& editor) {
  const auto choice = chosen_curve(editor);
  if (!choice) return editor.notify(choice.error());
  const auto found = curve_of_choice(editor, *choice);
  if (!found) return editor.notify(found.error());
  const auto curve = ArcLengthCurve::make(found->pieces, found->closed);
  if (!curve) return editor.notify(curve.error());
  run_on_chosen(editor, along_step,
                numbers_along(*curve, middle_of_objects(editor.document(), choice->copied)),
                along_chosen_curve(*choice), written_along);
}

void make_along_as_written(Editor& editor, const Arguments& given) {
  if (given.has("count") == given.has("spacing"))
    return editor.notify(
        make_error(e_argument, "The places are given by \"count\" or by \"spacing\".", "Write one of them."));
  const auto choice = chosen_curve(editor);
  if (!choice) return editor.notify(choice.error());
  const auto curve = curve_of_choice(editor, *choice);
  if (!curve) return editor.notify(curve.error());
  AlongCurve wanted{{}, given.on("on_curve"), given.on("backward")};
  if (given.has("count")) wanted.layout.count = given.whole("count");
  if (given.has("spacing")) wanted.layout.spacing = given.number("spacing");
  wanted.layout.turning =
      CurveTurning(std::find(std::begin(turning_words), std::end(turning_words), given.text("turning")) -
                   std::begin(turning_words));
  wanted.layout.offset = given.number("offset");
  const Document& document = editor.history.current();
  if (given.on("live"))
    return make_live_copies(editor, live_along(document, choice->copied, *curve, wanted), along_step);
  make_copies(editor, arrayed_along(document, choice->copied, *curve, wanted), choice->copied, along_step);
}

ScriptUse along_in_scripts(Editor& editor) {
  ScriptUse use;
  use.arguments = {
      optional(whole_argument("count", translatable("Total count"), {}, least_places, most_places)),
      optional(length_argument("spacing", translatable("Spacing"), {}, 0)),
      word_argument("turning", translatable("Turning"), {std::begin(turning_words), std::end(turning_words)},
                    turning_words[0]),
      length_argument("offset", translatable("Offset"), 0),
      on_off_argument("on_curve", translatable("On the curve"), false),
      on_off_argument("backward", translatable("Backward"), false),
      live_copies_argument()};
  use.run = [&editor](const Arguments& given) { make_along_as_written(editor, given); };
  use.looks_at_surfaces = true;
  return use;
}

}  // namespace

void add_curve_array_command(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows(host.table, arrange_menu())
      .add_edit(
          "object.array_curve", "Array along a curve\u2026",
          "Copies of the chosen objects along selected edges, the path of a skin or an outline; count, "
          "spacing "
          "and turning can be changed right afterwards.",
          [&editor] { make_along_curve(editor); },
          [&editor, object = needs_object(editor)]() -> Reason {
            if (auto reason = object()) return reason;
            const auto choice = chosen_curve(editor);
            return choice ? Reason() : Reason(choice.error().text);
          },
          {.contexts = Context::object, .script = along_in_scripts(editor)});
}

// Commands that make objects of live copies, and that take live copies away.

namespace {

void make_objects_of_copies(Editor& editor) {
  const std::vector<ObjectId> originals = chosen_ids(editor);
  make_copies(editor, copies_to_objects(editor.history.current(), originals), originals,
              translatable("Make copies objects"));
}

void remove_live_copies(Editor& editor) {
  Result<Document> result = editor.history.current();
  for (const auto& object : chosen_objects(editor))
    if (result && !object->copies->empty()) result = set_copies(*result, object->id, {});
  editor.commit(result, translatable("Remove live copies"));
}

WhyNot needs_live_copies(const Editor& editor) {
  return only_if(
      needs_object(editor),
      [&editor] {
        return std::ranges::any_of(chosen_objects(editor),
                                   [](const auto& object) { return !object->copies->empty(); });
      },
      translatable("What is chosen has no live copies."));
}

}  // namespace

void add_live_copy_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, arrange_menu());
  rows.add_edit(
      "object.copies_to_objects", "Make copies objects",
      "Objects of their own in the place of the live copies of the chosen objects: an array that is taken "
      "apart.",
      [&editor] { make_objects_of_copies(editor); }, needs_live_copies(editor),
      {.separator_before = true, .contexts = Context::object});
  rows.add_edit(
      "object.remove_copies", "Remove live copies",
      "The chosen objects stay at their own places alone, without the other places of their arrays.",
      [&editor] { remove_live_copies(editor); }, needs_live_copies(editor), {.contexts = Context::object});
}

}  // namespace hariko
