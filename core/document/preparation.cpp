#include "core/document/preparation.hpp"

namespace hariko {

Result<Done> check_preparation(const Preparation& preparation) {
  if (!(preparation.automatic_tension >= 0 && preparation.automatic_tension <= 1))
    return make_error(e_automatic_tension_range, "The automatic tension is out of range.",
                      "Use a number from 0 to 1.");
  return Done{};
}

}  // namespace hariko
