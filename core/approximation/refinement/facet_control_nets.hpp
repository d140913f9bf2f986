#pragma once

// FacetNets: Bezier nets of polynomial patches over the facets of a mesh, kept while it is refined: the nets
// of a facet's halves follow from its own at a fraction of the cost of points on the surface.

#include <vector>

#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"
#include "core/surface/triangle_net.hpp"

namespace hariko {

/// Control net of the patch over one facet, each point within `radius` of the exact one.
struct FacetNet {
  const TriangleNet* shape = nullptr;  ///< null: no net
  const Vector3* points = nullptr;
  double radius = 0;
};

/// Nets of all facets. Keeps a reference to the sampler. Facets at poles, and of patches that are not
/// polynomial, have no net.
class FacetNets {
 public:
  explicit FacetNets(const SurfaceSampler& sampler);

  /// Net of a facet; its `shape` is null where it has none.
  FacetNet of(Index patch, Index facet) const;
  /// Whether a facet like this one can have a net.
  bool possible(const ParameterFacet& facet) const {
    return shapes_[facet.patch] && facet.pole < 0 && !facet.degenerate();
  }
  /// Net of a facet that can have one, written to `room` and not kept. Thread-safe.
  FacetNet made(const ParameterFacet& facet, std::span<Vector3, TriangleNet::max_count> room) const;
  /// Computes and keeps the net of a facet that has none, where it can have one. O(n^4) in the degree.
  void make(const ParameterMesh& mesh, Index facet);
  /// Splits a net after a cut of the mesh: facets `first` and `second` are the halves of the former `first`,
  /// whose side was cut at fraction t of its length.
  void split(const ParameterMesh& mesh, Index first, Index second, int side, double t);
  /// Releases the memory of a net.
  void release(Index facet);

 private:
  struct Slot {
    Index number = no_index;
    double radius = 0;
  };
  static constexpr Index slots_per_block = 64;
  Vector3* points(Index number) {
    return blocks_[number / slots_per_block].data() + (number % slots_per_block) * stride_;
  }
  const Vector3* points(Index number) const { return const_cast<FacetNets*>(this)->points(number); }
  bool has(Index facet) const { return facet < slots_.size() && slots_[facet].number != no_index; }
  Index take();

  const SurfaceSampler& sampler_;
  std::vector<const TriangleNet*> shapes_;  ///< per patch; null where it is not polynomial
  std::vector<Slot> slots_;                 ///< per facet
  std::vector<std::vector<Vector3>> blocks_;
  std::vector<Index> free_;
  Index taken_ = 0;
  std::size_t stride_ = 0;  ///< points per slot
};

}  // namespace hariko
