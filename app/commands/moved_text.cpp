#include "app/commands/moved_text.hpp"

#include "core/exchange/number_text.hpp"

namespace hariko {

std::string moved_text(const Vector3& moved) {
  if (moved.isZero(0)) return {};
  std::string out = "moved to zero by";
  for (int axis = 0; axis < 3; ++axis) {
    out += ' ';
    append_real(out, 0 - moved[axis]);
  }
  return out + '\n';
}

}  // namespace hariko
