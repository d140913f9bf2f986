#include "ui/widgets/binding.hpp"

namespace hariko {

std::optional<double> draw_property(PanelContext& context, const PropertyRow& row, const Quantity& quantity,
                                    std::optional<double> value, const EditValues& edit) {
  switch (row.kind) {
    case PropertyKind::number:
      value_row(context, {row.id, row.label, row.help, row.step, quantity, row.range.slider}, value, edit);
      return {};
    case PropertyKind::check: {
      const auto on =
          check_row(context, row.id, row.label, row.help, value ? std::optional(*value != 0) : std::nullopt);
      return on ? std::optional(*on ? 1.0 : 0.0) : std::nullopt;
    }
    case PropertyKind::list: {
      const auto chosen =
          choose(context, row.id, row.label, row.help, row.choices, value ? static_cast<int>(*value) : -1);
      return chosen ? std::optional(static_cast<double>(*chosen)) : std::nullopt;
    }
  }
  return {};
}

}  // namespace hariko
