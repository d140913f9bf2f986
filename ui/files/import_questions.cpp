#include "ui/files/import_questions.hpp"

#include <imgui.h>

#include <memory>
#include <optional>
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
  request.fields = [field, quantity](PanelContext& context) {
    option_label(context, "Tolerance");
    option_field(context, "export.join_tolerance", "Corners up to this far apart become one", 140, quantity,
                 field->text, field->tolerance);
  };
  // As it is proposed the tolerance is each mesh's own: that of a large one would ruin small ones beside it.
  const std::optional<double> proposed = report.loose ? std::nullopt : std::optional(report.tolerance);
  request.answers = {{tr("Join"), "join",
                      [field, proposed, join = std::move(join)] {
                        JoinChoice choice{true, field->tolerance};
                        if (proposed == field->tolerance) choice.distance.reset();
                        join(choice);
                      }},
                     {tr("Keep apart"), "keep", std::move(keep)},
                     {tr("Cancel"), "cancel", {}}};
  return request;
}

namespace {

/// Lines about the faults: what they are, how many there are, and what repairs them.
std::string lines_about_faults(const Language& tr, const RepairableFaults& faults) {
  std::string out;
  if (faults.on_edges > 0)
    out += "\n\u2022 " + fill(tr("Corners on edges of other faces: {0}. The surface is open there until the "
                                 "edges are split."),
                              {std::to_string(faults.on_edges)});
  if (faults.inside_out > 0)
    out +=
        "\n\u2022 " + fill(tr("Closed parts that are inside out: {0}. Their faces can be turned outwards."),
                           {std::to_string(faults.inside_out)});
  return out;
}

}  // namespace

Prompt::Request repair_request(const Language& tr, const std::string& file, const RepairableFaults& faults,
                               std::function<void(const RepairChoice&)> repair, std::function<void()> keep) {
  const auto choice =
      std::make_shared<RepairChoice>(RepairChoice{faults.on_edges > 0, faults.inside_out > 0});
  Prompt::Request request;
  request.title = tr("The mesh has faults");
  request.text = fill(tr("{0} opens as it is, or repaired:"), {file}) + lines_about_faults(tr, faults);
  if (faults.on_edges > 0 && faults.inside_out > 0)
    request.fields = [choice](PanelContext& context) {
      option_check(context, "import.split_edges", "Split the edges", "", choice->split_edges);
      option_check(context, "import.turn_parts", "Turn the parts", "", choice->turn_parts);
    };
  request.answers = {{tr("Repair and open"), "repair",
                      [choice, repair = std::move(repair), keep] {
                        if (choice->split_edges || choice->turn_parts) return repair(*choice);
                        keep();
                      }},
                     {tr("Open as it is"), "keep", keep},
                     {tr("Cancel"), "cancel", {}}};
  return request;
}

}  // namespace hariko
