#include "ui/files/join_request.hpp"

#include <imgui.h>

#include <memory>
#include <utility>

#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

/// The tolerance as it stands in the field.
struct JoinField {
  double tolerance = 0;
  std::string text = {};
};

/// Lengths near the tolerance, with three digits.
Quantity tolerance_quantity(Unit unit, double tolerance) {
  Quantity quantity = length_quantity(unit, tolerance);
  quantity.low = 0;
  return quantity;
}

}  // namespace

Prompt::Request join_request(const Language& tr, const std::string& file, const CleanReport& report,
                             Unit unit, std::function<void(const JoinChoice&)> join,
                             std::function<void()> keep) {
  const auto field = std::make_shared<JoinField>(JoinField{report.tolerance});
  const Quantity quantity = tolerance_quantity(unit, report.tolerance);
  Prompt::Request request;
  request.title = tr("Nearly the same corners");
  request.text =
      fill(tr("In {0} some corners lie nearly at the same place as others: {1}, up to {2} apart. The surface "
              "is open between them unless they are joined."),
           {file, std::to_string(report.near), format_quantity(quantity, report.near_farthest)});
  request.fields = [field, quantity, &tr](PanelContext& context) {
    ImGui::Dummy({0, context.metrics.px(8)});
    option_label(tr, context.metrics, "Tolerance");
    option_field("export.join_tolerance", tr("Corners up to this far apart become one"), context.marks,
                 context.metrics.px(140), quantity, field->text, field->tolerance);
  };
  request.answers = {{tr("Join"), "join",
                      [field, join = std::move(join)] {
                        join(JoinChoice{true, field->tolerance});
                      }},
                     {tr("Keep apart"), "keep", std::move(keep)},
                     {tr("Cancel"), "cancel", {}}};
  return request;
}

}  // namespace hariko
