// The section of the properties that adjusts the step just made.

#include "ui/widgets/panels.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

void draw_last_operation(PanelContext& context) {
  Editor& editor = context.editor;
  LastOperation& last = editor.last_operation;
  if (!last.can_adjust(editor) || last.numbers().empty()) return;
  heading(context, context.tr.phrase(last.label()).c_str());
  const std::vector<OperationNumber>& numbers = last.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const OperationNumber& number = numbers[i];
    Quantity quantity =
        number.whole ? plain_quantity(0, 1) : length_quantity(editor.document().unit, number.value);
    quantity.whole = number.whole;
    // The step is made again with the new number instead of a further step, when all rows are drawn.
    row_label(context, number.label, "");
    number_field(context, {number.id, number.label, "", last.label(), quantity}, number.value,
                 ImGui::GetContentRegionAvail().x,
                 [&](const Document& document, const ValueChange& change) -> Result<Document> {
                   context.state.steps.push_back([&editor, i, wanted = change.apply(quantity, number.value)] {
                     editor.last_operation.adjust(editor, i, wanted);
                   });
                   return document;
                 });
  }
}

}  // namespace hariko
