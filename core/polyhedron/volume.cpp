#include "core/polyhedron/volume.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hariko {

std::vector<double> closed_component_volumes(const HalfEdgeMesh& topology,
                                             std::span<const Vector3> positions) {
  const std::vector<Index> component = topology.face_components();
  const Index count = component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
  std::vector<double> volume(count, 0), span(count, 0);
  std::vector<char> open(count, 0);
  std::vector<Vector3> reference(count);
  std::vector<char> seen(count, 0);
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index c = component[f];
    const std::span<const Index> corners = topology.face_vertices(f);
    // The reference point lies in the component, so that far objects are as precise as near ones.
    if (!seen[c]) reference[c] = positions[corners[0]];
    seen[c] = 1;
    const Vector3 p = positions[corners[0]] - reference[c];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Vector3 q = positions[corners[i]] - reference[c], r = positions[corners[i + 1]] - reference[c];
      const double tetrahedron = p.dot(q.cross(r)) / 6;
      volume[c] += tetrahedron;
      span[c] += std::abs(tetrahedron);
    }
    for (Index h = topology.face_begin(f); h < topology.face_end(f); ++h)
      if (topology.twin(h) == no_index) open[c] = 1;
  }
  for (Index c = 0; c < count; ++c)
    if (open[c] || !(std::abs(volume[c]) > 1e-12 * span[c])) volume[c] = 0;
  return volume;
}

}  // namespace hariko
