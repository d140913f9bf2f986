#include "core/skinning/sections/skin_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hariko {

std::vector<double> vertex_places(const Skin& skin, const SkinMesh& mesh) {
  std::vector<double> out;
  out.reserve(mesh.vertices.size());
  for (const SkinVertex& vertex : mesh.vertices) {
    double place = std::numeric_limits<double>::quiet_NaN();
    if (vertex.section >= 0)
      place = skin.sections[std::size_t(vertex.section)].v;
    else if (vertex.strip >= 0)
      place = mesh.rows[std::size_t(vertex.strip)][std::size_t(vertex.row)];
    else if (vertex.row >= 0)
      place = mesh.grid_places[std::size_t(vertex.row)];
    out.push_back(place);
  }
  return out;
}

std::optional<double> place_on_path(const SubdivisionTopology& topology, const std::vector<double>& places,
                                    bool closed, Index patch, const Vector2& parameter) {
  const auto face = topology.mesh().mesh.face(topology.face_of(patch));
  std::vector<double> around;
  for (const Index v : face) around.push_back(places[v]);
  // Beyond the seam of a closed path places are one turn further.
  const double most = *std::max_element(around.begin(), around.end());
  for (double& place : around)
    if (closed && place < most - 0.5) place += 1;
  const std::size_t n = around.size();
  std::array<double, 4> corner{};
  if (!topology.cut()) {
    std::copy_n(around.begin(), 4, corner.begin());
  } else {
    double centre = 0;
    for (const double place : around) centre += place / double(n);
    const std::size_t c = std::size_t(topology.corner_of(patch));
    corner = {around[c], (around[c] + around[(c + 1) % n]) / 2, centre,
              (around[c] + around[(c + n - 1) % n]) / 2};
  }
  const double x = parameter.x(), y = parameter.y();
  const double place =
      (1 - y) * ((1 - x) * corner[0] + x * corner[1]) + y * ((1 - x) * corner[3] + x * corner[2]);
  if (!std::isfinite(place)) return {};
  return place > 1 ? place - 1 : place;
}

}  // namespace hariko
