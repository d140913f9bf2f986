// Properties: what can be set on the document, on the chosen objects and on the selected elements.

#include <imgui.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/document/angles.hpp"
#include "core/document/convert_unit.hpp"
#include "ui/analysis/display_panel.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/measure/dimension_layer.hpp"
#include "ui/outline/outline_rows.hpp"
#include "ui/paper/paper_panel.hpp"
#include "ui/pictures/picture_rows.hpp"
#include "ui/polyhedron/element_rows.hpp"
#include "ui/polyhedron/polyhedron_rows.hpp"
#include "ui/shell/copies_rows.hpp"
#include "ui/shell/message_list.hpp"
#include "ui/skin/skin_properties.hpp"
#include "ui/solids/solids_properties.hpp"
#include "ui/widgets/binding.hpp"
#include "ui/widgets/choice.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

// The document.

void document_section(PanelContext& context) {
  Editor& editor = context.editor;
  heading(context, "Document");
  const Unit current = editor.document().unit;
  row_label(context, "Unit", "The unit of all lengths of the document");
  const OpenScope list = list_scope(context.marks, "combo.unit", context.tr(enum_choice(current).label), -1);
  point_out(context, "unit");
  if (!list) return;
  const auto offers = [&](const char* title, const char* id, const char* step, bool converts) {
    heading(context, title);
    for (const Unit unit : enum_values<Unit>()) {
      const std::string mark = std::string("unit.") + id + "." + std::string(to_string(unit));
      if (unit == current || !selectable_row(context.marks, mark, context.tr(enum_choice(unit).label), false))
        continue;
      const Document& document = editor.history.current();
      editor.commit(converts ? convert_unit(document, unit) : Result<Document>(set_unit(document, unit)),
                    step);
    }
  };
  offers("Convert the numbers, keep the size", "convert", "Convert unit", true);
  offers("Keep the numbers, change the size", "keep", "Change unit", false);
}

// Objects.

void object_name(PanelContext& context, const Object& object) {
  row_label(context, "Name", "");
  std::string name = object.name;
  if (text_field(context.marks, "field.name", name, -1)) context.state.typed_text = name;
  if (ImGui::IsItemDeactivatedAfterEdit())
    context.editor.commit(
        rename_object(context.editor.history.current(), object.id, context.state.typed_text),
        "Rename object");
}

const Similarity* transform_of_object(const Object& object) {
  return &object.transform;
}

void transform_rows(PanelContext& context, const Objects& objects) {
  constexpr auto part = whole_part<Similarity, &transform_of_object, &set_transform>();
  const Binding<Similarity> rows = bind_part(context, objects, part);
  Quantity length = length_quantity(context.editor.document().unit, model_size(context.editor));
  length.standard = 0;
  const VectorSpec location{{"location.x", "location.y", "location.z"},
                            "Location",
                            "Where the object's own zero stands in the document",
                            "Place object",
                            length};
  rows.vector(location, &Similarity::translation);
  const VectorSpec rotation{{"rotation.x", "rotation.y", "rotation.z"},
                            "Rotation",
                            "About the x axis first, then y, then z",
                            "Rotate object",
                            angle_quantity()};
  rows.vector(
      rotation, [](const Similarity& transform) { return angles_of(transform.rotation); },
      [](Similarity& transform, int axis, double angle) {
        Vector3 angles = angles_of(transform.rotation);
        angles[axis] = angle;
        transform.rotation = rotation_of(angles);
      });
  constexpr PropertyRange factors{.low = Similarity::min_scale,
                                  .high = Similarity::max_scale,
                                  .standard = 1,
                                  .multiplies = true,
                                  .decimals = 4};
  rows.row(member_property<&Similarity::scale>(
      {"scale", "Scale", "The same along all axes: surfaces keep their shape", "Scale object", factors}));
}

/// Sizes of the surfaces along the objects' own axes.
void size_rows(PanelContext& context, const Objects& objects) {
  Editor& editor = context.editor;
  const Quantity length = length_quantity(editor.document().unit, model_size(editor));
  const auto sizes = common_axes(objects, [&](const auto& object) -> Vector3 {
    const Box3 box = own_box(editor, *object);
    return box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(box.sizes() * object->transform.scale);
  });
  const VectorSpec spec{{"size.x", "size.y", "size.z"},
                        "Size",
                        "Of the surface, along the object's own axes",
                        "Size of object",
                        length};
  vector_row(context, spec, sizes,
             [&editor, objects, length](const Document& document, int axis, const ValueChange& change) {
               Result<Document> result = document;
               for (const auto& object : objects) {
                 const Box3 box = own_box(editor, *object);
                 const double now = box.isEmpty() ? 0 : box.sizes()[axis] * object->transform.scale;
                 if (result)
                   result = with_size(*result, object->id, box, shown_density(editor, *object), axis,
                                      change.apply(length, now), editor.transform.proportional_size);
               }
               return result;
             });
  if (std::ranges::none_of(objects, [](const auto& object) { return stretches(*object); })) return;
  if (const auto on =
          check_row(context, "proportional", "Proportional",
                    "A typed size scales the object along all its axes", editor.transform.proportional_size))
    editor.transform.proportional_size = *on;
}

void frames_row(PanelContext& context, const Objects& objects) {
  const Objects shaped =
      objects_where(objects, [](const Object& object) { return surface_frames(object.source).has_value(); });
  if (shaped.empty()) return;
  const auto metric = common<bool>(
      shaped, [](const auto& object) { return surface_frames(object->source) == Frames::metric; });
  const auto on =
      check_row(context, "frames", "By measure",
                "Angles and lengths of the polyhedron count: uneven cages give even surfaces", metric);
  if (!on) return;
  Result<Document> result = context.editor.history.current();
  for (const auto& object : shaped)
    if (result.ok()) result = set_frames(*result, object->id, *on ? Frames::metric : Frames::equal);
  context.editor.commit(result, *on ? "Surface by measure" : "Surface by equal angles");
}

bool is_of_placement(std::string_view row) {
  return row.starts_with("location.") || row.starts_with("rotation.") || row == "scale";
}

void object_section(PanelContext& context, const Objects& objects) {
  counted_heading(context, "Object", "{0} objects", objects.size());
  if (objects.size() == 1) object_name(context, *objects.front());
  size_rows(context, objects);
  if (std::ranges::any_of(objects, [](const auto& object) { return object->locked; }))
    hint_text(context, "Locked: unlock it in the list above to change it.");
  copies_rows(context, objects);
  polyhedron_mode_row(context, objects);
  frames_row(context, objects);
  live_mirror_row(context, objects);
  const auto preparation = preparation_properties();
  bind_part(context, objects, preparation.part).rows(preparation.all);
  if (objects.size() == 1) patch_section(context, *objects.front());
  if (is_of_placement(context.state.wanted_row)) ImGui::SetNextItemOpen(true);
  if (folding_heading(context, "placement", translatable("Placement"),
                      objects.size() > 1 ? ImGuiTreeNodeFlags_DefaultOpen : 0))
    transform_rows(context, objects);
  // Nothing of how surfaces show is about pictures.
  if (!std::ranges::all_of(objects, [](const auto& object) { return object_kind(*object).is_backdrop(); }))
    draw_display(context, objects);
}

/// A row that was asked for and does not come: later it would take the keyboard when nobody expects it.
void give_up_wanted_row(PanelContext& context) {
  PanelState& state = context.state;
  // A field that shows may wait for the keyboard over several frames, however long they take.
  if (state.wanted_row.empty() || state.field_opening || context.editor.now < state.wanted_until) return;
  state.wanted_row.clear();
  context.editor.inform("That does not show now: it depends on what else is chosen here.");
}

}  // namespace

void draw_properties(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  if (begin_panel("Properties", rect, palette().panel, {m.px(12), m.px(8)})) {
    PanelState& state = context.state;
    state.typing_row.clear();
    state.steady.begin();
    // Edits replace the document under the panel: what is drawn is this frame's value.
    draw_last_operation(context);
    if (context.editor.paper.shown) draw_paper_properties(context);
    const auto objects = chosen_objects(context.editor);
    if (objects.empty()) {
      hint_text(context,
                context.editor.document().objects.empty()
                    ? translatable("The document is empty. Add a shape, or drop a mesh on the window.")
                    : translatable("Nothing is selected. Click an object here or in the view."));
    } else {
      // Elements first: they are what the hand is on.
      const bool elements = draw_elements(context);
      draw_skin_properties(context);
      draw_solids(context, *objects.front());
      outline_point_section(context);
      if (objects.size() == 1) outline_section(context, *objects.front());
      picture_section(context, objects);
      object_section(context, objects);
      if (!elements) tension_hint(context, *objects.front());
      draw_message_list(context, *objects.front());
    }
    dimension_section(context);
    document_section(context);
    give_up_wanted_row(context);
    state.left = {};  // its field is gone
    state.steady.end(context.marks, state.typing_row);
  }
  ImGui::End();
}

// The section of the properties that adjusts the step just made.

namespace {

/// The step is made again with the new number instead of a further step, when all rows are drawn.
void adjust_later(PanelContext& context, std::size_t number, double value) {
  Editor& editor = context.editor;
  context.state.steps.push_back(
      [&editor, number, value] { editor.last_operation.adjust(editor, number, value); });
}

Quantity quantity_of_operation(const OperationNumber& number, Unit unit) {
  if (!number.whole && !number.angle) return length_quantity(unit, number.value);
  Quantity quantity = number.whole ? plain_quantity(0, 1) : angle_quantity();
  quantity.whole = number.whole;
  quantity.standard.reset();
  return quantity;
}

void choice_of_operation(PanelContext& context, std::size_t index, const OperationNumber& number) {
  std::vector<Choice> choices;
  for (const char* label : number.choices) choices.push_back({label, ""});
  const auto chosen = choose(context, number.id, number.label, "", choices, static_cast<int>(number.value));
  if (chosen) adjust_later(context, index, *chosen);
}

void number_of_operation(PanelContext& context, std::size_t index, const OperationNumber& number) {
  const Quantity quantity = quantity_of_operation(number, context.editor.document().unit);
  row_label(context, number.label, "");
  const std::string& step = context.editor.last_operation.label().english();
  number_field(context, {number.id, number.label, "", step, quantity}, number.value,
               ImGui::GetContentRegionAvail().x,
               [&](const Document& document, const ValueChange& change) -> Result<Document> {
                 adjust_later(context, index, change.apply(quantity, number.value));
                 return document;
               });
}

}  // namespace

void draw_last_operation(PanelContext& context) {
  Editor& editor = context.editor;
  LastOperation& last = editor.last_operation;
  if (!last.can_adjust(editor) || last.numbers().empty()) return;
  heading(context, context.tr(last.label()).c_str());
  const std::vector<OperationNumber>& numbers = last.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].choices.empty())
      number_of_operation(context, i, numbers[i]);
    else
      choice_of_operation(context, i, numbers[i]);
}

}  // namespace hariko
