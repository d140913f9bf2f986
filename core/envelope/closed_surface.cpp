#include "core/envelope/closed_surface.hpp"

#include <algorithm>
#include <optional>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Sides whose neighbours are not known yet, in lists by the nodes where they begin.
class OpenSides {
 public:
  explicit OpenSides(std::size_t nodes) : first_(nodes, no_index) {}

  bool empty() const { return count_ == 0; }
  void add(Index from, Index to, const PatchSide& side) {
    sides_.push_back({to, first_[from], side});
    first_[from] = Index(sides_.size() - 1);
    ++count_;
  }
  bool has(Index from, Index to) const {
    for (Index at = first_[from]; at != no_index; at = sides_[at].next)
      if (sides_[at].to == to) return true;
    return false;
  }
  /// Removes the side between two nodes; nothing where there is none.
  std::optional<PatchSide> take(Index from, Index to) {
    for (Index* at = &first_[from]; *at != no_index; at = &sides_[*at].next) {
      const Open found = sides_[*at];
      if (found.to != to) continue;
      *at = found.next;
      --count_;
      return found.side;
    }
    return {};
  }

 private:
  struct Open {
    Index to, next;  ///< the node where the side ends; the next side in the list
    PatchSide side;
  };
  std::vector<Open> sides_;
  std::vector<Index> first_;  ///< per node
  std::size_t count_ = 0;
};

}  // namespace

Surface closed_surface(const Vector3& origin, std::shared_ptr<const PatchSet> patches,
                       std::span<const ClosedPatch> places, std::vector<Vector3> normals) {
  auto provenance = std::make_shared<std::vector<Provenance>>();
  auto nodes = std::make_shared<std::vector<Index>>();
  auto seams = std::make_shared<std::vector<Seam>>();
  OpenSides open(normals.size());
  for (Index p = 0; p < places.size(); ++p) {
    const ClosedPatch& place = places[p];
    provenance->push_back(place.provenance);
    for (std::size_t k = 0; k < 4; ++k) {
      const Index a = place.nodes[k], b = place.nodes[(k + 1) % 4];
      HARIKO_ASSERT(std::max(a, b) < normals.size(), "one normal a node");
      nodes->push_back(a);
      const PatchSide here{p, std::uint8_t(k)};
      const std::optional<PatchSide> other = open.take(b, a);
      if (!other) {
        HARIKO_ASSERT(!open.has(a, b), "two sides run the same way");
        open.add(a, b, here);
        continue;
      }
      Seam seam;
      seam.first = *other;
      seam.second = here;
      seam.source = place.sources[k];
      seams->push_back(seam);
    }
  }
  HARIKO_ASSERT(open.empty(), "the surface is closed");
  Surface::Parts parts;
  parts.origin = origin;
  parts.patches = std::move(patches);
  parts.seams = std::move(seams);
  parts.provenance = std::move(provenance);
  parts.corner_nodes = std::move(nodes);
  parts.node_count = Index(normals.size());
  parts.node_normals = std::make_shared<const std::vector<Vector3>>(std::move(normals));
  parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>();
  parts.boundary_sources = std::make_shared<const std::vector<Element>>();
  return Surface(std::move(parts));
}

}  // namespace hariko
