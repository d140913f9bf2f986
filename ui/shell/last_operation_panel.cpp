// The section of the properties that adjusts the step just made.

#include "ui/widgets/choice.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

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
  number_field(context, {number.id, number.label, "", context.editor.last_operation.label(), quantity},
               number.value, ImGui::GetContentRegionAvail().x,
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
  heading(context, context.tr.phrase(last.label()).c_str());
  const std::vector<OperationNumber>& numbers = last.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].choices.empty())
      number_of_operation(context, i, numbers[i]);
    else
      choice_of_operation(context, i, numbers[i]);
}

}  // namespace hariko
