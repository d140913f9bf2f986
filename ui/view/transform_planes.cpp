// The planes of sections that are transformed.

#include <algorithm>

#include "core/skinning/sections/section_frame.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/transform_target.hpp"

namespace hariko {

void TransformTarget::choose_planes() {
  const auto of_sections = [](const Part& part) {
    return part.skin && std::none_of(part.vertices.begin(), part.vertices.end(),
                                     [](VertexId id) { return is_path_point(id.value); });
  };
  if (!std::all_of(parts_.begin(), parts_.end(), of_sections)) return;
  std::optional<Matrix3> first, axes;  // in the document's space
  int count = 0;
  for (Part& part : parts_) {
    const Matrix3 place = part.transform.rotation.toRotationMatrix();
    part.turns.assign(part.vertices.size(), Matrix3::Identity());
    std::vector<Vector3> middles = part.pivots;
    for (const SkinSection& section : part.skin->sections) {
      std::vector<std::size_t> chosen;
      std::vector<Vector3> points;
      for (std::size_t i = 0; i < part.vertices.size(); ++i)
        if (find_point(section, part.vertices[i].value) >= 0) {
          chosen.push_back(i);
          points.push_back(part.start[i]);
        }
      if (chosen.empty()) continue;
      const Vector3 direction = place * section_direction_of_view(*part.skin, section);
      axes = axes ? carried_axes(*axes, direction) : upright_axes(direction);
      if (!first) first = axes;
      ++count;
      Vector3 middle = Vector3::Zero();
      for (const Vector3& point : points) middle += point / double(points.size());
      for (const std::size_t i : chosen) {
        part.turns[i] = place.transpose() * *axes * first->transpose() * place;
        middles[i] = middle;
      }
    }
    // One section has the pivot that was chosen.
    if (count > 1 || parts_.size() > 1) part.pivots = std::move(middles);
  }
  if (!first) return;
  local_frame_ = *first;
  in_planes_ = true;
}

}  // namespace hariko
