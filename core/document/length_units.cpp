#include "core/document/length_units.hpp"

namespace hariko {

std::array<UnitFactor, 5> length_units(Unit unit) {
  const auto factor = [unit](Unit typed) { return millimetres_per(typed) / millimetres_per(unit); };
  return {UnitFactor{"mm", factor(Unit::millimetre)}, UnitFactor{"cm", factor(Unit::centimetre)},
          UnitFactor{"m", factor(Unit::metre)}, UnitFactor{"in", factor(Unit::inch)},
          UnitFactor{"\"", factor(Unit::inch)}};
}

}  // namespace hariko
