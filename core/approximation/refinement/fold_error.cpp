#include "core/approximation/refinement/fold_error.hpp"

#include <algorithm>

#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

double fold_between(const Vector3& a, const Vector3& b) {
  return a.isZero(0) || b.isZero(0) ? 0 : angle_between(a, b);
}

Vector3 normal_of(const ParameterMesh& mesh, Index facet) {
  const auto p = mesh.corners(facet);
  return facet_normal(p[0], p[1], p[2]);
}

}  // namespace

bool is_crease(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index half_edge, double angle) {
  const Index other = mesh.twin[half_edge];
  if (other == no_index || mesh.facets[facet_of(half_edge)].patch == mesh.facets[facet_of(other)].patch)
    return false;
  const ParameterLine a = mesh.line(half_edge), b = mesh.line(other);
  return fold_between(sampler.normal(a.patch, a.at(0.5)), sampler.normal(b.patch, b.at(0.5))) > angle;
}

double edge_fold(const ParameterMesh& mesh, Index half_edge) {
  const Index other = mesh.twin[half_edge];
  if (other == no_index) return 0;
  return fold_between(normal_of(mesh, facet_of(half_edge)), normal_of(mesh, facet_of(other)));
}

double facet_fold(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index facet, double crease) {
  double worst = 0;
  for (Index h = 3 * facet; h < 3 * facet + 3; ++h) {
    const double fold = edge_fold(mesh, h);
    if (fold > worst && !is_crease(sampler, mesh, h, crease)) worst = fold;
  }
  return worst;
}

double virtual_fold(const ParameterMesh& mesh, Index half_edge, const Vector3& m) {
  const auto halves = [&](Index h, Vector3& first, Vector3& second) {
    const Vector3 &a = mesh.positions[mesh.from(h)], &b = mesh.positions[mesh.to(h)];
    const Vector3& o = mesh.positions[mesh.from(previous_of(h))];
    first = facet_normal(a, m, o);
    second = facet_normal(m, b, o);
  };
  Vector3 near_a, near_b, far_b, far_a;
  halves(half_edge, near_a, near_b);
  double worst = fold_between(near_a, near_b);
  if (mesh.twin[half_edge] == no_index) return worst;
  halves(mesh.twin[half_edge], far_b, far_a);
  return std::max(
      {worst, fold_between(far_a, far_b), fold_between(near_a, far_a), fold_between(near_b, far_b)});
}

}  // namespace hariko
