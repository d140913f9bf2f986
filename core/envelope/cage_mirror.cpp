#include "core/envelope/cage_mirror.hpp"

#include <algorithm>
#include <set>

namespace hariko {

namespace {

/// The loop with its least corner first.
std::vector<Index> canonical(std::vector<Index> loop) {
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

}  // namespace

std::optional<CageMirror> find_mirror(std::span<const Vector3> positions,
                                      std::span<const std::vector<Index>> loops, Eigen::Index axis,
                                      double tolerance) {
  CageMirror out{axis, {}};
  for (const Vector3& p : positions) {
    const Vector3 wanted = out.reflected(p);
    const auto nearest =
        std::min_element(positions.begin(), positions.end(), [&](const auto& a, const auto& b) {
          return (a - wanted).squaredNorm() < (b - wanted).squaredNorm();
        });
    if (!((*nearest - wanted).norm() <= tolerance)) return std::nullopt;
    out.image.push_back(Index(nearest - positions.begin()));
  }
  for (Index v = 0; v < out.image.size(); ++v)
    if (out.image[out.image[v]] != v) return std::nullopt;
  std::set<std::vector<Index>> known;
  for (const auto& loop : loops) known.insert(canonical(loop));
  for (const auto& loop : loops) {
    std::vector<Index> image;
    for (const Index v : loop) image.push_back(out.image[v]);
    std::reverse(image.begin(), image.end());
    if (!known.contains(canonical(std::move(image)))) return std::nullopt;
  }
  return out;
}

void even(const CageMirror& mirror, std::span<Vector3> positions) {
  for (Index v = 0; v < mirror.image.size(); ++v) {
    const Index w = mirror.image[v];
    if (w < v) continue;
    positions[v] = mirror.evened(positions[v], positions[w]);
    positions[w] = mirror.reflected(positions[v]);
  }
}

}  // namespace hariko
