#include "core/polyhedron/edge_table.hpp"

#include <algorithm>

namespace hariko {

namespace {

/// Calls visit(corner, a, b) for every directed edge a -> b.
template <class Visit>
void for_each_directed_edge(const PolygonMesh& mesh, std::span<const char> used, Visit&& visit) {
  const Index* vertices = mesh.face_vertices.data();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!used.empty() && !used[f]) continue;
    const Index begin = mesh.face_offsets[f], end = mesh.face_offsets[f + 1];
    if (begin == end) continue;
    for (Index h = begin; h + 1 < end; ++h) visit(h, vertices[h], vertices[h + 1]);
    visit(end - 1, vertices[end - 1], vertices[begin]);
  }
}

}  // namespace

EdgeTable::EdgeTable(const PolygonMesh& mesh, std::span<const char> used)
    : offsets_(mesh.positions.size() + 2, 0) {
  // Counting sort by the lower vertex. Counts are kept two places ahead, so that scattering leaves correct
  // offsets.
  for_each_directed_edge(mesh, used, [&](Index, Index a, Index b) { ++offsets_[std::min(a, b) + 2]; });
  for (std::size_t i = 2; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
  uses_.resize(offsets_.back());
  for_each_directed_edge(mesh, used, [&](Index h, Index a, Index b) {
    uses_[offsets_[std::min(a, b) + 1]++] = {std::max(a, b), h};
  });
  offsets_.pop_back();
  for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) sort_bucket(offsets_[v], offsets_[v + 1]);
}

void EdgeTable::sort_bucket(Index begin, Index end) {
  if (end - begin > 32) {
    std::sort(uses_.begin() + begin, uses_.begin() + end, [](const EdgeUse& a, const EdgeUse& b) {
      return a.high != b.high ? a.high < b.high : a.corner < b.corner;
    });
    return;
  }
  // Insertion sort: a bucket holds about four uses, and the order of the corners is kept.
  for (Index i = begin + 1; i < end; ++i) {
    const EdgeUse use = uses_[i];
    Index j = i;
    for (; j > begin && uses_[j - 1].high > use.high; --j) uses_[j] = uses_[j - 1];
    uses_[j] = use;
  }
}

std::vector<Index> faces_of_corners(const PolygonMesh& mesh) {
  std::vector<Index> out(mesh.face_vertices.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    std::fill(out.begin() + mesh.face_offsets[f], out.begin() + mesh.face_offsets[f + 1],
              static_cast<Index>(f));
  return out;
}

}  // namespace hariko
