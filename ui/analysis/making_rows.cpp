#include "ui/analysis/making_rows.hpp"

#include <array>

#include "core/document/edits/edits.hpp"
#include "core/document/object_shape.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/editor/legend_source.hpp"
#include "ui/widgets/choice.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array pull_choices{
    Choice{"X", translatable("The part leaves its mould along x")},
    Choice{"Y", translatable("The part leaves its mould along y")},
    Choice{"Z", translatable("The part leaves its mould along z")},
    Choice{"\u2212X", translatable("The part leaves its mould against x")},
    Choice{"\u2212Y", translatable("The part leaves its mould against y")},
    Choice{"\u2212Z", translatable("The part leaves its mould against z")},
    Choice{translatable("From the view"), translatable("Towards the eye, as the view is now")},
};
constexpr int from_view = 6;

Vector3 pull_axis(int choice) {
  return (choice < 3 ? 1.0 : -1.0) * Vector3::Unit(choice % 3);
}

void pull_row(PanelContext& context) {
  Editor& editor = context.editor;
  const Vector3& pull = editor.document().making.pull;
  int current = 0;
  while (current < from_view && pull_axis(current) != pull) ++current;
  const auto chosen =
      choose(context, "pull", "Pull", "Direction in which the part leaves its mould", pull_choices, current);
  if (!chosen) return;
  MakingSettings making = editor.history.current().making;
  making.pull = *chosen == from_view ? editor.camera().towards_eye() : pull_axis(*chosen);
  editor.commit(set_making(editor.history.current(), making), "Pull direction");
}

/// A number of the settings, which fields show in a unit that has so many of what is stored.
EditValues making_values(double MakingSettings::*member, double unit, const Quantity& quantity) {
  return [=](const Document& document, const ValueChange& change) {
    MakingSettings making = document.making;
    making.*member = change.apply(quantity, making.*member / unit) * unit;
    return set_making(document, making);
  };
}

void draft_row(PanelContext& context) {
  Quantity angle = angle_quantity();
  angle.low = 0;
  angle.high = MakingSettings::max_draft;
  angle.standard = MakingSettings().draft;
  value_row(context,
            {"draft_limit", "Least draft", "Walls with less than this angle to the pull are marked",
             "Least draft", angle},
            context.editor.document().making.draft, making_values(&MakingSettings::draft, 1, angle));
}

void length_row(PanelContext& context, const FieldSpec& texts, double MakingSettings::*member) {
  const Document& document = context.editor.document();
  const double unit = millimetres_per(document.unit), value = document.making.*member / unit;
  FieldSpec spec = texts;
  // Two decimals behind the leading digit: tools and walls are seldom finer.
  spec.quantity = length_quantity(document.unit, 10 * value);
  constexpr double least = 1e-6, most = 1e6;  // millimetres: within what the settings allow
  spec.quantity.low = least / unit;
  spec.quantity.high = most / unit;
  spec.quantity.standard = MakingSettings().*member / unit;
  value_row(context, spec, value, making_values(member, unit, spec.quantity));
}

void reference_row(PanelContext& context) {
  Editor& editor = context.editor;
  const Language& tr = context.tr;
  const Document& document = editor.document();
  const Object* now = document.find(document.making.reference);
  row_label(context, "Reference", "The object that the others deviate from");
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##reference", now ? now->name.c_str() : tr("None"));
  context.marks.item("combo.reference");
  point_out(context, "reference");
  if (!open) return;
  const auto offer = [&](ObjectId id, const char* name) {
    ImGui::PushID(static_cast<int>(id.value));
    if (ImGui::Selectable(name, id == document.making.reference)) {
      MakingSettings making = editor.history.current().making;
      making.reference = id;
      later(context, set_making(editor.history.current(), making), "Reference of deviations");
    }
    context.marks.item("reference." + std::to_string(id.value));
    ImGui::PopID();
  };
  offer(ObjectId{}, tr("None"));
  for (const auto& object : document.objects)
    if (object->visible && has_shape(*object)) offer(object->id, object->name.c_str());
  ImGui::EndCombo();
}

}  // namespace

void making_rows(PanelContext& context, SurfaceMap map) {
  if (map == SurfaceMap::draft) {
    pull_row(context);
    draft_row(context);
  }
  if (map == SurfaceMap::radius)
    length_row(context,
               {"radius_limit",
                "Least radius",
                "What is bent more tightly, no tool of this radius can make",
                "Least radius",
                {}},
               &MakingSettings::radius);
  if (map == SurfaceMap::thickness)
    length_row(
        context,
        {"thickness_limit", "Least wall", "Walls that are thinner than this are marked", "Least wall", {}},
        &MakingSettings::thickness);
  if (map == SurfaceMap::deviation) reference_row(context);
}

void missing_map_row(PanelContext& context) {
  const auto missing = missing_map(context.editor);
  if (!missing || !missing->object.empty()) return;
  const TextColour colour(palette().warning);
  text_in_lines(context.tr.text_of(*missing->reason) + " " + context.tr.remedy_of(*missing->reason));
  context.marks.item("map.missing");
}

}  // namespace hariko
