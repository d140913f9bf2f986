#include "core/skinning/columns/quad_fans.hpp"

#include <cmath>

namespace hariko {

std::vector<std::vector<Index>> fan_faces(const TriangleFan& fan, const std::function<bool(Index)>& may_go,
                                          const std::function<double(Index)>& parameter) {
  const std::size_t triangles = fan.outer.size() - 1;
  std::size_t alone = triangles;
  if (triangles % 2 == 1) {
    const std::size_t half = (triangles - 1) / 2;
    const auto from_middle = [&](std::size_t i) {
      return std::abs(0.5 * (parameter(fan.outer[i]) + parameter(fan.outer[i + 1])) - 0.5);
    };
    alone = half % 2 == 0 ? half : from_middle(0) > from_middle(triangles - 1) ? 0 : triangles - 1;
  }
  std::vector<std::vector<Index>> out;
  const auto add = [&](std::size_t i, std::size_t count) {
    std::vector<Index> face{fan.apex};
    for (std::size_t k = 0; k <= count; ++k)
      face.push_back(fan.outer[fan.apex_on_first_row ? i + k : i + count - k]);
    out.push_back(std::move(face));
  };
  for (std::size_t i = 0; i < triangles;) {
    const bool pair = i != alone && i + 1 < triangles && i + 1 != alone && may_go(fan.outer[i + 1]);
    add(i, pair ? 2 : 1);
    i += pair ? 2 : 1;
  }
  return out;
}

}  // namespace hariko
