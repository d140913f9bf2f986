#include "core/approximation/mesh_report.hpp"

#include <algorithm>
#include <limits>

#include "core/approximation/refinement/fold_error.hpp"
#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr double same_normal = 1e-3;
constexpr std::size_t facets_per_task = 256;
constexpr std::size_t most_careful = 512;  ///< number of facets that are measured again with care

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

/// Mesh of the facets with area, with vertices renumbered. `original`: the former number of each facet.
ParameterMesh without_degenerate(const ParameterMesh& mesh, std::vector<Index>& original) {
  ParameterMesh out;
  out.positions.reserve(mesh.positions.size());
  out.facets.reserve(mesh.facets.size());
  original.reserve(mesh.facets.size());
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
    original.push_back(f);
  }
  out.twin.assign(3 * out.facets.size(), no_index);
  for (Index f = 0; f < mesh.facets.size(); ++f) {
    if (kept[f] == no_index) continue;
    for (Index c = 0; c < 3; ++c) {
      // A dropped facet closes like a zipper: the facets on its two long sides become neighbours.
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

/// Normal of a corner, identified by patch and parameter.
struct CornerNormal {
  Index patch = 0, normal = no_index;
  Vector2 parameter = Vector2::Zero();
  Index following = no_index;  ///< next one at the same vertex
};

/// Computes normals at corners, shared where they agree.
void add_normals(const SurfaceSampler& sampler, const ParameterMesh& mesh, TriangleMesh& out) {
  const auto place = [&](std::size_t corner) {
    const ParameterFacet& facet = mesh.facets[corner / 3];
    const Vector2& own = facet.parameter[corner % 3];
    return facet.pole == int(corner % 3) ? Vector2(0.5 * (own + facet.pole_parameter)) : own;
  };
  // Within a patch, the facets around a vertex take their normal at one parameter.
  std::vector<Index> first(mesh.positions.size(), no_index), taken(3 * mesh.facets.size());
  std::vector<CornerNormal> places;
  std::vector<std::size_t> corner_of;
  places.reserve(mesh.positions.size());
  corner_of.reserve(mesh.positions.size());
  for (std::size_t c = 0; c < taken.size(); ++c) {
    const Index patch = mesh.facets[c / 3].patch;
    const Vector2 at = place(c);
    Index* link = &first[mesh.facets[c / 3].vertex[c % 3]];
    while (*link != no_index && !(places[*link].patch == patch && places[*link].parameter == at))
      link = &places[*link].following;
    if (*link == no_index) {
      *link = static_cast<Index>(places.size());
      places.push_back({patch, no_index, at, no_index});
      corner_of.push_back(c);
    }
    // `link` may be invalid from here on.
    taken[c] = first[mesh.facets[c / 3].vertex[c % 3]];
    while (!(places[taken[c]].patch == patch && places[taken[c]].parameter == at))
      taken[c] = places[taken[c]].following;
  }
  std::vector<Vector3> normals(places.size());
  parallel_for(places.size(), facets_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      normals[k] = sampler.normal(places[k].patch, places[k].parameter);
  });
  // In the order of the corners, so that the first normal represents those that agree with it.
  std::vector<Index> of_vertex(mesh.positions.size(), no_index), following;
  for (std::size_t k = 0; k < places.size(); ++k) {
    Index at = of_vertex[mesh.facets[corner_of[k] / 3].vertex[corner_of[k] % 3]], last = no_index;
    while (at != no_index && (out.normals[at] - normals[k]).norm() > same_normal)
      last = at, at = following[at];
    if (at == no_index) {
      at = static_cast<Index>(out.normals.size());
      out.normals.push_back(normals[k]);
      following.push_back(no_index);
      (last == no_index ? of_vertex[mesh.facets[corner_of[k] / 3].vertex[corner_of[k] % 3]]
                        : following[last]) = at;
    }
    places[k].normal = at;
  }
  out.normal_triangles.resize(mesh.facets.size());
  for (std::size_t c = 0; c < taken.size(); ++c) out.normal_triangles[c / 3][c % 3] = places[taken[c]].normal;
}

/// Results of the refinement for renumbered facets.
struct Known {
  const BisectionResult& refined;
  std::vector<Index> original;

  /// Net of a facet; computed into `room` where it was released.
  FacetNet of(const ParameterMesh& mesh, Index f, std::span<Vector3, TriangleNet::max_count> room) const {
    const FacetNets* nets = refined.nets.get();
    if (!nets) return {};
    const FacetNet kept = nets->of(mesh.facets[f].patch, original[f]);
    return kept.shape || !nets->possible(mesh.facets[f]) ? kept : nets->made(mesh.facets[f], room);
  }
  /// Distance as in a first pass.
  DistanceError distance(const FacetErrors& errors, const ParameterMesh& mesh, Index f,
                         double tolerance) const {
    const Index number = original[f];
    if (!refined.sampled_distances.empty() && refined.sampled_distances[number] >= 0)
      return {double(refined.sampled_distances[number]), refined.distance_bounds[number], true};
    std::array<Vector3, TriangleNet::max_count> room;
    const FacetNet net = of(mesh, f, room);
    if (!net.shape) return errors.distance(mesh, f, tolerance);
    return {errors.net_sampled(mesh, f, net), refined.distance_bounds[number], true};
  }
};

/// Measures the largest distance, with care where it matters; values per facet come from a first pass.
CriterionErrors measure_distance(const FacetErrors& errors, const ParameterMesh& mesh, const Known& known,
                                 double tolerance) {
  std::vector<float> bound(mesh.facets.size());
  std::vector<char> certified(mesh.facets.size());
  CriterionErrors out = measure_facets(mesh.facets.size(), [&](Index f) {
    const DistanceError error = known.distance(errors, mesh, f, tolerance);
    // Rounded up, so that it remains a bound.
    bound[f] = std::nextafter(static_cast<float>(error.bound), std::numeric_limits<float>::infinity());
    certified[f] = error.certified;
    return error.sampled;
  });
  if (mesh.facets.empty()) return out;
  out.certified = std::all_of(certified.begin(), certified.end(), [](char c) { return c != 0; });
  // The largest distance is among the facets with the largest bounds.
  std::vector<Index> order = ascending_indices(mesh.facets.size());
  const auto later = [&](Index a, Index b) { return bound[a] < bound[b] || (bound[a] == bound[b] && a > b); };
  std::make_heap(order.begin(), order.end(), later);
  double largest_bound = 0;
  for (std::size_t k = 0; !order.empty(); ++k) {
    const Index f = order.front();
    if (k == most_careful || double(bound[f]) <= out.largest) {
      largest_bound = std::max(largest_bound, double(bound[f]));
      break;
    }
    std::pop_heap(order.begin(), order.end(), later);
    order.pop_back();
    std::array<Vector3, TriangleNet::max_count> room;
    const FacetNet net = known.of(mesh, f, room);
    const DistanceError error =
        net.shape ? errors.net_measured(mesh, f, net) : errors.measured_distance(mesh, f);
    largest_bound = std::max(largest_bound, std::min(error.bound, std::max(double(bound[f]), error.sampled)));
    out.facets[f] = static_cast<float>(error.sampled);
    if (error.sampled <= out.largest) continue;
    out.largest = error.sampled;
    out.facet = f;
  }
  out.bound = std::max(out.largest, largest_bound);
  return out;
}

/// Measures folds across the edges of each facet, except creases.
CriterionErrors measure_folds(const SurfaceSampler& sampler, const ParameterMesh& mesh, double crease) {
  std::vector<Vector3> normals(mesh.facets.size());
  parallel_for(mesh.facets.size(), facets_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto p = mesh.corners(Index(f));
      normals[f] = facet_normal(p[0], p[1], p[2]);
    }
  });
  return measure_facets(mesh.facets.size(), [&](Index f) {
    // The angle grows with the distance between the normals.
    double farthest = 0;
    Vector3 across = normals[f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.twin[h] == no_index) continue;
      const Vector3 &a = normals[f], &b = normals[facet_of(mesh.twin[h])];
      if (a.isZero(0) || b.isZero(0)) continue;
      const double distance = (b - a).squaredNorm();
      if (!(distance > farthest) || is_crease(sampler, mesh, h, crease)) continue;
      farthest = distance;
      across = b;
    }
    return farthest > 0 ? angle_between(normals[f], across) : 0;
  });
}

/// Measures the longest edge and the smallest angle.
void measure_shapes(const ParameterMesh& mesh, MeshApproximation& out) {
  double longest = 0, sharpest = 0;  // squared length; cotangent
  bool any = false;
  for (Index f = 0; f < mesh.facets.size(); ++f) {
    const auto p = mesh.corners(f);
    const Vector3 side[3] = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
    const double area = side[0].cross(side[1]).norm();
    for (std::size_t c = 0; c < 3; ++c) {
      longest = std::max(longest, side[c].squaredNorm());
      const double cotangent = -side[c].dot(side[(c + 2) % 3]) / std::max(area, 1e-300);
      if (!any || cotangent > sharpest) sharpest = cotangent;
      any = true;
    }
  }
  out.longest_edge = std::sqrt(longest);
  out.smallest_angle = any ? std::atan2(1.0, sharpest) : 0;
}

}  // namespace

MeshApproximation mesh_report(const SurfaceSampler& sampler, const FacetErrors& errors,
                              const MeshOptions& options, const ParameterMesh& given,
                              const BisectionResult& refined, const CancelToken& cancel,
                              const Progress& progress) {
  MeshApproximation out;
  Known known{refined, {}};
  ParameterMesh mesh = without_degenerate(given, known.original);
  const std::size_t count = mesh.facets.size();
  const MeshCriteria& criteria = options.criteria;
  out.mesh.origin = sampler.surface().origin();
  out.mesh.positions = mesh.positions;
  out.mesh.triangles.reserve(count);
  for (const ParameterFacet& facet : mesh.facets) out.mesh.triangles.push_back(facet.vertex);
  measure_shapes(mesh, out);
  if (options.report == MeshReport::none) {
    out.parts = std::move(mesh.facets);
    return out;
  }
  add_normals(sampler, mesh, out.mesh);
  progress.report(0.3);
  if (cancel.cancelled()) return {};
  const bool all = options.report == MeshReport::all;
  if (criteria.distance || all)
    out.distance =
        measure_distance(errors, mesh, known,
                         criteria.distance ? *criteria.distance : std::numeric_limits<double>::infinity());
  progress.report(0.6);
  if (cancel.cancelled()) return {};
  if (criteria.normal_angle || all)
    out.normal_angle = measure_facets(count, [&](Index f) { return errors.normal_angle(mesh, f); });
  if (criteria.luminance)
    out.luminance = measure_facets(count, [&](Index f) { return errors.luminance(mesh, f); });
  const double crease =
      criteria.fold_angle ? std::min(crease_angle, 0.5 * *criteria.fold_angle) : crease_angle;
  out.fold_angle = measure_folds(sampler, mesh, crease);
  out.parts = std::move(mesh.facets);
  progress.report(1);
  return out;
}

}  // namespace hariko
