#include "core/approximation/mesh_report.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/approximation/facet_geometry.hpp"
#include "core/approximation/fold_error.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr double same_normal = 1e-3;
constexpr std::size_t facets_per_task = 256;
constexpr std::size_t most_careful = 512;  ///< facets that are measured once more

template <class Measure>
CriterionErrors measure_facets(std::size_t count, const Measure& measure) {
  CriterionErrors out;
  out.measured = true;
  out.facets.resize(count);
  parallel_for(count, facets_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) out.facets[f] = static_cast<float>(measure(Index(f)));
  });
  double sum = 0;
  for (std::size_t f = 0; f < count; ++f) {
    sum += double(out.facets[f]);
    if (out.facet != no_index && !(double(out.facets[f]) > out.largest)) continue;
    out.largest = double(out.facets[f]);
    out.facet = Index(f);
  }
  if (count > 0) out.mean = sum / double(count);
  out.bound = out.largest;
  return out;
}

/// Facets with area only, with vertices numbered anew.
ParameterMesh without_degenerate(const ParameterMesh& mesh) {
  ParameterMesh out;
  std::vector<Index> number(mesh.positions.size(), no_index), kept(mesh.facets.size(), no_index);
  for (Index f = 0; f < mesh.facets.size(); ++f) {
    if (mesh.facets[f].degenerate()) continue;
    kept[f] = static_cast<Index>(out.facets.size());
    ParameterFacet facet = mesh.facets[f];
    for (Index& v : facet.vertex) {
      if (number[v] == no_index) {
        number[v] = static_cast<Index>(out.positions.size());
        out.positions.push_back(mesh.positions[v]);
      }
      v = number[v];
    }
    out.facets.push_back(facet);
  }
  out.twin.assign(3 * out.facets.size(), no_index);
  for (Index f = 0; f < mesh.facets.size(); ++f) {
    if (kept[f] == no_index) continue;
    for (Index c = 0; c < 3; ++c) {
      // A dropped facet closes like a zipper: the facets on its two long sides are neighbours.
      Index other = mesh.twin[3 * f + c];
      for (int step = 0; step < 64 && other != no_index && kept[facet_of(other)] == no_index; ++step) {
        Index across = no_index;
        for (const Index h : {next_of(other), previous_of(other)})
          if (mesh.from(h) != mesh.to(h)) across = h;
        other = across == no_index ? no_index : mesh.twin[across];
      }
      if (other != no_index && kept[facet_of(other)] != no_index)
        out.twin[3 * kept[f] + c] = 3 * kept[facet_of(other)] + other % 3;
    }
  }
  return out;
}

/// Normals at corners, shared where they agree.
void add_normals(const SurfaceSampler& sampler, const ParameterMesh& mesh, TriangleMesh& out) {
  std::vector<Vector3> corner(3 * mesh.facets.size());
  parallel_for(mesh.facets.size(), facets_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const ParameterFacet& facet = mesh.facets[f];
      std::array<Vector2, 3> at = facet.parameter;
      if (facet.pole >= 0) {
        Vector2& pole = at[std::size_t(facet.pole)];
        pole = 0.5 * (pole + facet.pole_parameter);
      }
      sampler.normals(facet.patch, at, {corner.data() + 3 * f, 3});
    }
  });
  std::vector<Index> first(mesh.positions.size(), no_index), following;
  out.normal_triangles.resize(mesh.facets.size());
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector3& normal = corner[3 * f + c];
      Index* link = &first[mesh.facets[f].vertex[c]];
      while (*link != no_index && (out.normals[*link] - normal).norm() > same_normal)
        link = &following[*link];
      if (*link == no_index) {
        *link = static_cast<Index>(out.normals.size());
        out.normal_triangles[f][c] = *link;
        out.normals.push_back(normal);
        following.push_back(no_index);
      } else {
        out.normal_triangles[f][c] = *link;
      }
    }
}

}  // namespace

CriterionErrors measure_distance(const FacetErrors& errors, const ParameterMesh& mesh, double tolerance) {
  std::vector<float> bound(mesh.facets.size());
  std::vector<char> certified(mesh.facets.size());
  CriterionErrors out = measure_facets(mesh.facets.size(), [&](Index f) {
    const DistanceError error = errors.distance(mesh, f, tolerance);
    // Up, so that the bound stays one.
    bound[f] = std::nextafter(static_cast<float>(error.bound), std::numeric_limits<float>::infinity());
    certified[f] = error.certified;
    return error.sampled;
  });
  if (mesh.facets.empty()) return out;
  out.certified = std::all_of(certified.begin(), certified.end(), [](char c) { return c != 0; });
  std::vector<Index> order(mesh.facets.size());
  std::iota(order.begin(), order.end(), Index{0});
  const std::size_t careful = std::min(order.size(), most_careful);
  std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(careful), order.end(),
                    [&](Index a, Index b) { return bound[a] > bound[b] || (bound[a] == bound[b] && a < b); });
  // The largest is among the facets with the largest bounds.
  double largest_bound = careful < order.size() ? double(bound[order[careful]]) : 0;
  for (std::size_t k = 0; k < careful; ++k) {
    const Index f = order[k];
    if (double(bound[f]) <= out.largest) {
      largest_bound = std::max(largest_bound, double(bound[f]));
      break;
    }
    const DistanceError error = errors.measured_distance(mesh, f);
    largest_bound = std::max(largest_bound, std::min(error.bound, std::max(double(bound[f]), error.sampled)));
    out.facets[f] = static_cast<float>(error.sampled);
    if (error.sampled <= out.largest) continue;
    out.largest = error.sampled;
    out.facet = f;
  }
  out.bound = std::max(out.largest, largest_bound);
  return out;
}

MeshApproximation mesh_report(const SurfaceSampler& sampler, const FacetErrors& errors,
                              const MeshOptions& options, const ParameterMesh& given,
                              const CancelToken& cancel, const Progress& progress) {
  MeshApproximation out;
  const ParameterMesh mesh = without_degenerate(given);
  const std::size_t count = mesh.facets.size();
  const MeshCriteria& criteria = options.criteria;
  out.mesh.origin = sampler.surface().origin();
  out.mesh.positions = mesh.positions;
  out.mesh.triangles.reserve(count);
  for (const ParameterFacet& facet : mesh.facets) out.mesh.triangles.push_back(facet.vertex);
  out.parts = mesh.facets;
  add_normals(sampler, mesh, out.mesh);
  progress.report(0.3);
  if (cancel.cancelled()) return {};
  if (criteria.distance || options.measure_all)
    out.distance = measure_distance(
        errors, mesh, criteria.distance ? *criteria.distance : std::numeric_limits<double>::infinity());
  progress.report(0.6);
  if (cancel.cancelled()) return {};
  if (criteria.normal_angle || options.measure_all)
    out.normal_angle = measure_facets(count, [&](Index f) { return errors.normal_angle(mesh, f); });
  if (criteria.luminance)
    out.luminance = measure_facets(count, [&](Index f) { return errors.luminance(mesh, f); });
  const double crease =
      criteria.fold_angle ? std::min(crease_angle, 0.5 * *criteria.fold_angle) : crease_angle;
  out.fold_angle = measure_facets(count, [&](Index f) { return facet_fold(sampler, mesh, f, crease); });
  out.smallest_angle = count > 0 ? 4 : 0;
  for (std::size_t f = 0; f < count; ++f) {
    const auto p = mesh.corners(Index(f));
    for (std::size_t c = 0; c < 3; ++c)
      out.longest_edge = std::max(out.longest_edge, (p[(c + 1) % 3] - p[c]).norm());
    out.smallest_angle = std::min(out.smallest_angle, smallest_angle(p));
  }
  progress.report(1);
  return out;
}

}  // namespace hariko
