#include "core/polyhedron/face_check.hpp"

namespace hariko {

FaceFault FaceCheck::operator()(std::span<const Index> face) {
  for (Index v : face)
    if (v >= vertex_count_) return FaceFault::index_range;
  if (face.size() < 3) return FaceFault::too_small;
  return repeats(face) ? FaceFault::repeated_vertex : FaceFault::none;
}

bool FaceCheck::repeats(std::span<const Index> face) {
  if (face.size() <= 8) {
    for (std::size_t i = 0; i + 1 < face.size(); ++i)
      for (std::size_t j = i + 1; j < face.size(); ++j)
        if (face[i] == face[j]) return true;
    return false;
  }
  if (last_seen_.empty()) last_seen_.assign(vertex_count_, 0);
  ++large_faces_;
  for (Index v : face) {
    if (last_seen_[v] == large_faces_) return true;
    last_seen_[v] = large_faces_;
  }
  return false;
}

std::vector<char> sound_faces(const PolygonMesh& mesh) {
  FaceCheck check(mesh.positions.size());
  std::vector<char> sound(mesh.face_count());
  for (std::size_t f = 0; f < sound.size(); ++f) sound[f] = check(mesh.face(f)) == FaceFault::none;
  return sound;
}

}  // namespace hariko
