#include "core/approximation/refinement/facet_control_nets.hpp"

#include <algorithm>

namespace hariko {

namespace {

/// Rounding error of one cut, relative to the coordinates; a generous bound.
constexpr double cut_rounding = 1e-15;

}  // namespace

FacetNets::FacetNets(const SurfaceSampler& sampler) : sampler_(sampler) {
  const PatchSet& patches = sampler.patches();
  shapes_.assign(patches.patch_count(), nullptr);
  for (Index p = 0; p < patches.patch_count(); ++p) {
    const int degree = polynomial_degree(patches, p);
    if (degree == 0) continue;
    shapes_[p] = &triangle_net(degree);
    stride_ = std::max(stride_, shapes_[p]->count());
  }
}

FacetNet FacetNets::of(Index patch, Index facet) const {
  if (!has(facet)) return {};
  return {shapes_[patch], points(slots_[facet].number), slots_[facet].radius};
}

Index FacetNets::take() {
  if (!free_.empty()) {
    const Index number = free_.back();
    free_.pop_back();
    return number;
  }
  if (taken_ % slots_per_block == 0) blocks_.emplace_back(slots_per_block * stride_);
  return taken_++;
}

FacetNet FacetNets::made(const ParameterFacet& facet, std::span<Vector3, TriangleNet::max_count> room) const {
  const TriangleNet& shape = *shapes_[facet.patch];
  std::array<Vector2, TriangleNet::max_count> parameters;
  std::array<Vector3, TriangleNet::max_count> samples;
  std::array<HullBall, TriangleNet::max_count> balls;
  const std::vector<Vector2>& grid = barycentric_grid(shape.degree()).points;
  const std::size_t count = shape.count();
  for (std::size_t k = 0; k < count; ++k)
    parameters[k] = at_barycentric(facet.parameter, grid[k].x(), grid[k].y());
  sampler_.positions(facet.patch, {parameters.data(), count}, {samples.data(), count});
  sampler_.patches().hull(facet.patch, facet.parameter, {samples.data(), count}, {balls.data(), count});
  FacetNet out{&shape, room.data(), 0};
  for (std::size_t k = 0; k < count; ++k) {
    room[k] = balls[k].centre;
    out.radius = std::max(out.radius, balls[k].radius);
  }
  return out;
}

void FacetNets::make(const ParameterMesh& mesh, Index facet) {
  const ParameterFacet& at = mesh.facets[facet];
  if (!possible(at) || has(facet)) return;
  if (slots_.size() <= facet) slots_.resize(mesh.facets.size());
  std::array<Vector3, TriangleNet::max_count> room;
  const FacetNet net = made(at, room);
  slots_[facet] = {take(), net.radius};
  std::copy_n(room.begin(), net.shape->count(), points(slots_[facet].number));
}

void FacetNets::split(const ParameterMesh& mesh, Index first, Index second, int side, double t) {
  if (!has(first)) return;
  if (slots_.size() <= second) slots_.resize(mesh.facets.size());
  const Index number = take();
  const TriangleNet& shape = *shapes_[mesh.facets[first].patch];
  Vector3* net = points(slots_[first].number);
  shape.split(side, t, net, net, points(number));
  slots_[first].radius += cut_rounding * shape.degree() * net[0].lpNorm<Eigen::Infinity>();
  slots_[second] = {number, slots_[first].radius};
}

void FacetNets::release(Index facet) {
  if (!has(facet)) return;
  free_.push_back(slots_[facet].number);
  slots_[facet].number = no_index;
}

}  // namespace hariko
