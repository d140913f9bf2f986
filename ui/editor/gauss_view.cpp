#include "ui/editor/gauss_view.hpp"

#include "core/gaussmap/sphere/gauss_sphere.hpp"

namespace hariko {

std::optional<Index> GaussView::newest() const {
  if (!made_step || *made_step == 0 || !sphere || !sphere->mesh) return {};
  return sphere->mesh->site_count() - 1;
}

bool GaussView::has(std::optional<Index> site) const {
  return site && sphere && sphere->mesh && *site < sphere->mesh->site_count();
}

}  // namespace hariko
