#include "ui/widgets/property.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace hariko {

Quantity quantity_in(const PropertyRange& range, Unit unit, double size) {
  Quantity quantity;
  switch (range.unit) {
    case PropertyUnit::none:
      quantity = range.whole ? plain_quantity(0, std::max(1.0, range.step))
                             : plain_quantity(range.decimals, range.step);
      break;
    case PropertyUnit::length:
      quantity = length_quantity(unit, size);
      break;
    case PropertyUnit::millimetres:
      quantity = length_quantity(Unit::millimetre, size);
      quantity.decimals = 1;
      quantity.step = 1;
      break;
    case PropertyUnit::degrees:
      quantity = angle_quantity();
      break;
  }
  quantity.multiplies = range.multiplies;
  quantity.low = range.low;
  quantity.high = range.high;
  quantity.whole = range.whole;
  quantity.standard = range.standard;
  return quantity;
}

ArgumentSpec property_argument(const PropertyRow& row) {
  if (row.kind == PropertyKind::check) return on_off_argument("on", "", true);
  if (row.kind == PropertyKind::list)
    return word_argument("value", "", std::vector<std::string>(row.words.begin(), row.words.end()), {});
  ArgumentSpec spec = number_argument("value", "", row.range.standard, row.range.low, row.range.high);
  if (row.range.whole) spec.type = ArgumentType::whole;
  if (row.range.unit == PropertyUnit::length) spec.unit = ArgumentUnit::length;
  if (row.range.unit == PropertyUnit::degrees) spec.unit = ArgumentUnit::degrees;
  return spec;
}

double given_property(const PropertyRow& row, const Arguments& given) {
  if (row.kind == PropertyKind::check) return given.on("on") ? 1 : 0;
  if (row.kind == PropertyKind::number) return given.number("value");
  const auto word = std::find(row.words.begin(), row.words.end(), given.text("value"));
  HARIKO_ASSERT(word != row.words.end(), "words of arguments are checked");
  return static_cast<double>(word - row.words.begin());
}

WrittenArgument written_property(const PropertyRow& row, double value) {
  if (row.kind == PropertyKind::check) return written_switch("on", value != 0);
  if (row.kind == PropertyKind::number) return written("value", value);
  return written("value", std::string(row.words[static_cast<std::size_t>(value)]));
}

}  // namespace hariko
