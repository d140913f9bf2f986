#include "core/envelope/pulled_vertices.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/envelope/cage_frames.hpp"

namespace hariko {

namespace {

Index mirror_image(const NetworkCage& cage, Index vertex) {
  return cage.mirror ? cage.mirror->image[vertex] : vertex;
}

NetworkVertexKey own_name(const NetworkCage& cage, Index vertex, std::span<const PlacedSolid> solids) {
  return settings_key(key_of(cage.vertices[vertex], solids));
}

}  // namespace

NetworkVertexKey settings_name(const NetworkCage& cage, Index vertex, std::span<const PlacedSolid> solids) {
  const NetworkVertexKey own = own_name(cage, vertex, solids);
  return own.in_valley() ? std::min(own, own_name(cage, mirror_image(cage, vertex), solids)) : own;
}

Index offset_owner(const NetworkCage& cage, Index vertex, std::span<const PlacedSolid> solids,
                   const FlatMap<NetworkVertexKey, Vector3>& offsets) {
  const Index image = mirror_image(cage, vertex);
  if (image == vertex) return vertex;
  const auto place = [&](Index of) { return std::pair(cage.vertices[of].solid, cage.vertices[of].vertex); };
  const auto [first, second] =
      place(vertex) < place(image) ? std::pair(vertex, image) : std::pair(image, vertex);
  // The first one's counts, unless only the second has one.
  const auto has = [&](Index of) { return offsets.find(settings_name(cage, of, solids)) != nullptr; };
  return !has(first) && has(second) ? second : first;
}

Matrix3 offset_axes(const CageVertex& vertex, std::span<const PlacedSolid> solids) {
  return vertex.solid == no_index ? Matrix3(Matrix3::Identity()) : solids[vertex.solid].rotation;
}

bool pull_vertices(NetworkCage& cage, Index first, std::span<const PlacedSolid> solids,
                   const FlatMap<NetworkVertexKey, Vector3>& offsets) {
  if (offsets.empty()) return false;
  bool any = false;
  for (Index v = first; v < cage.vertices.size(); ++v) {
    const Index owner = offset_owner(cage, v, solids, offsets);
    const Vector3* offset = offsets.find(settings_name(cage, owner, solids));
    if (!offset) continue;
    any = true;
    const Vector3 step = offset_axes(cage.vertices[owner], solids) * *offset;
    CageVertex& vertex = cage.vertices[v];
    vertex.position += owner == v ? step : cage.mirror->reflected(step);
    if (vertex.solid != no_index) put_on_solid(vertex, solids[vertex.solid]);
  }
  if (any) set_valley_frames(cage);
  return any;
}

}  // namespace hariko
