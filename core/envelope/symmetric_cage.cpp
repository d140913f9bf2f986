#include <algorithm>
#include <map>

#include "core/envelope/network_cage.hpp"

namespace hariko {

namespace {

/// Valleys are found from either side: their vertices are images of each other only so far, over the
/// diagonal (spec 13b: up to 8e-4).
constexpr double symmetry_tolerance = 5e-3;

void even_frames(NetworkCage& cage, const SceneSymmetry& symmetry, std::span<const PlacedSolid> solids) {
  const CageMirror& mirror = *cage.mirror;
  const auto even_unit = [&](Vector3& a, Vector3& b) {
    a = mirror.evened(a, b).stableNormalized();
    b = mirror.reflected(a);
  };
  for (Index v = 0; v < mirror.image.size(); ++v) {
    const Index w = mirror.image[v];
    if (w < v) continue;
    CageVertex &a = cage.vertices[v], &b = cage.vertices[w];
    a.position = mirror.evened(a.position, b.position);
    b.position = mirror.reflected(a.position);
    even_unit(a.normal, b.normal);
    even_unit(a.radial, b.radial);
    if (a.solid == no_index) even_unit(a.outward, b.outward);
    // A vertex in the plane of a solid that is not its own image belongs to two of them.
    const bool shared = v == w && a.solid != no_index && symmetry.solid[a.solid] != a.solid;
    a.guarded = b.guarded = a.guarded || b.guarded || shared;
    for (CageVertex* vertex : {&a, &b})
      if (vertex->solid != no_index)
        vertex->unit = solids[vertex->solid].to_unit * (vertex->position - solids[vertex->solid].centre);
  }
}

/// A face is of a solid where its image is.
void even_owners(NetworkCage& cage) {
  std::map<std::vector<Index>, Index> face_of;
  const auto sorted = [](std::vector<Index> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (Index f = 0; f < cage.faces.size(); ++f) face_of[sorted(cage.faces[f].loop)] = f;
  for (CageFace& face : cage.faces) {
    std::vector<Index> image;
    for (const Index v : face.loop) image.push_back(cage.mirror->image[v]);
    if (cage.faces[face_of.at(sorted(std::move(image)))].solid == no_index) face.solid = no_index;
  }
}

}  // namespace

void make_symmetric(NetworkCage& cage, const SceneSymmetry& symmetry, std::span<const PlacedSolid> solids,
                    double diagonal) {
  std::vector<Vector3> positions;
  std::vector<std::vector<Index>> loops;
  for (const CageVertex& vertex : cage.vertices) positions.push_back(vertex.position);
  for (const CageFace& face : cage.faces) loops.push_back(face.loop);
  cage.mirror = find_mirror(positions, loops, symmetry.axis, symmetry_tolerance * diagonal);
  if (!cage.mirror) return;
  even_frames(cage, symmetry, solids);
  even_owners(cage);
}

}  // namespace hariko
