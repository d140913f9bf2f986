#include "core/exchange/read_bpt.hpp"

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/read_patches.hpp"

namespace hariko {

Result<std::vector<BicubicNet>> bicubic_nets(const std::vector<BezierPatch>& patches) {
  std::vector<BicubicNet> nets;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const BezierPatch& patch = patches[k];
    if (patch.degree_s != 3 || patch.degree_t != 3 || patch.rational())
      return make_error(
          e_format_unknown,
          "Patch " + std::to_string(k + 1) + " has degree " + std::to_string(patch.degree_s) + " by " +
              std::to_string(patch.degree_t) + (patch.rational() ? " and weights." : "."),
          "Only patches of degree 3 by 3 without weights can be edited; `hariko mesh` takes all.");
    nets.push_back({1, 1, patch.points});
  }
  return nets;
}

Result<std::vector<BicubicNet>> read_bpt(std::string_view text) {
  const auto patches = read_bezier_text(text);
  if (!patches.ok()) return patches.error();
  return bicubic_nets(*patches);
}

}  // namespace hariko
