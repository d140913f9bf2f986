#include "core/modeling/surfacing/project_to_reference.hpp"

#include "core/base/parallel.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {

namespace {

constexpr std::size_t projections_per_task = 64;

}  // namespace

std::vector<char> vertices_that_stay(const PolyhedronSource& source) {
  std::vector<char> out(source.polyhedron.vertex_count());
  const auto hold = [&](VertexId id) {
    if (const Index v = source.polyhedron.find(id); v != no_index) out[v] = 1;
  };
  for (const auto& entry : source.shaping->pin) hold(entry.first);
  for (const auto& entry : *source.attachments) {
    if (source.polyhedron.find(entry.first) == no_index) continue;
    hold(entry.first.low);
    hold(entry.first.high);
  }
  return out;
}

Result<std::vector<Index>> vertices_to_move(const PolyhedronSource& source,
                                            std::span<const VertexId> vertices) {
  const auto chosen = selected(source.polyhedron, vertices, "Select vertices, edges or faces.");
  if (!chosen) return chosen.error();
  const std::vector<char> stay = vertices_that_stay(source);
  std::vector<Index> moving = *chosen;
  std::erase_if(moving, [&](Index v) { return stay[v] != 0; });
  if (moving.empty())
    return make_error(e_wrong_selection,
                      "All of the vertices are pinned or attached, so none of them may move.",
                      "Release their pins, or select others.");
  return moving;
}

Result<EditResult> project_to_reference(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                        const ReferenceFacets& reference) {
  const auto moving = vertices_to_move(source, vertices);
  if (!moving) return moving.error();
  const Polyhedron& polyhedron = source.polyhedron;
  std::vector<Vector3> places(moving->size());
  parallel_for(places.size(), projections_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      places[i] = reference.foot(polyhedron.position((*moving)[i])).position;
  });
  if (source.mirror) {
    const std::vector<char> seam = mirror_seam(polyhedron, source.origin, *source.mirror);
    const Eigen::Index axis = index_of(source.mirror->axis);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (seam[(*moving)[i]]) places[i][axis] = 0 - source.origin[axis];
  }
  auto moved = polyhedron.with_positions(*moving, places);
  if (!moved) return moved.error();
  EditResult out{source, {}};
  out.source.polyhedron = std::move(moved).value();
  out.selection.vertices.insert(vertices.begin(), vertices.end());
  return out;
}

}  // namespace hariko
