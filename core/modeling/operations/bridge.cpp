#include "core/modeling/operations/bridge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/border_loops.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

/// Cross edges of a strip: pairs (i, j) of places in the two ends, each one step on from the last in i, j or
/// both.
using Rungs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Two ends of a strip side by side: the new faces pass `a` forwards and `b` backwards. Closed ends repeat
/// their first entry at the end.
struct Ends {
  std::vector<VertexId> a, b;
};

/// Shortest rungs from (0, 0) to the far ends with as few triangles as possible. O(p q) for p >= q edges.
struct Strip {
  double length = std::numeric_limits<double>::infinity();
  Rungs rungs;
};
Strip shortest_strip(std::span<const Vector3> a, std::span<const Vector3> b) {
  const bool swapped = a.size() < b.size();
  const auto longer = swapped ? b : a, shorter = swapped ? a : b;
  const std::size_t p = longer.size() - 1, q = shorter.size() - 1, spare = p - q;
  // After i steps along the longer end, t of which made triangles, the shorter end is at i - t.
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> best(spare + 1, infinity), before;
  std::vector<std::vector<char>> by_triangle(p + 1, std::vector<char>(spare + 1, 0));
  best[0] = 0;
  for (std::size_t i = 1; i <= p; ++i) {
    before = best;
    for (std::size_t t = 0; t <= spare; ++t) {
      best[t] = infinity;
      if (t > i || i - t > q) continue;
      const double quad = i - t >= 1 ? before[t] : infinity;
      const double triangle = t >= 1 ? before[t - 1] : infinity;
      by_triangle[i][t] = triangle < quad;
      best[t] = std::min(quad, triangle) + (longer[i] - shorter[i - t]).norm();
    }
  }
  Strip strip;
  strip.length = best[spare];
  for (std::size_t i = p, t = spare;; --i) {
    swapped ? strip.rungs.emplace_back(i - t, i) : strip.rungs.emplace_back(i, i - t);
    if (i == 0) break;
    if (by_triangle[i][t]) --t;
  }
  std::reverse(strip.rungs.begin(), strip.rungs.end());
  return strip;
}

std::vector<Vector3> places(const MeshEditor& draft, std::span<const VertexId> vertices) {
  std::vector<Vector3> out;
  for (const VertexId v : vertices) out.push_back(draft.position(v));
  return out;
}

template <class T>
std::vector<T> closed_from(const std::vector<T>& loop, std::size_t start) {
  std::vector<T> out;
  for (std::size_t i = 0; i <= loop.size(); ++i) out.push_back(loop[(start + i) % loop.size()]);
  return out;
}

/// Aligns two closed ends: the second end starts where the strip is shortest, then is rotated by `twist`.
Ends aligned(const MeshEditor& draft, const std::vector<VertexId>& a, const std::vector<VertexId>& b,
             int twist) {
  const std::vector<Vector3> at_a = places(draft, closed_from(a, 0)), at_b = places(draft, b);
  const std::size_t n = a.size(), m = b.size();
  std::vector<std::size_t> starts(m);
  for (std::size_t s = 0; s < m; ++s) starts[s] = s;
  // Trying every start takes n m (|n - m| + 1) steps; with very long ends only starts near the first vertex
  // of the first end are tried.
  const std::size_t work = n * m * (n > m ? n - m + 1 : m - n + 1);
  if (work > 50'000'000) {
    std::stable_sort(starts.begin(), starts.end(), [&](std::size_t s, std::size_t t) {
      return (at_b[s] - at_a[0]).squaredNorm() < (at_b[t] - at_a[0]).squaredNorm();
    });
    starts.resize(std::max<std::size_t>(1, m * 50'000'000 / work));
  }
  double shortest = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (const std::size_t s : starts) {
    const double length = shortest_strip(at_a, closed_from(at_b, s)).length;
    if (length < shortest * (1 - 1e-12)) {  // among equally good starts, the first
      shortest = length;
      best = s;
    }
  }
  const auto count = static_cast<long long>(m);
  const long long turned = (static_cast<long long>(best) + twist % count + count) % count;
  return {closed_from(a, 0), closed_from(b, static_cast<std::size_t>(turned))};
}

/// Adds the faces of the strip.
ElementSet add_strip(MeshEditor& draft, const Ends& ends) {
  const Rungs rungs = shortest_strip(places(draft, ends.a), places(draft, ends.b)).rungs;
  ElementSet selection;
  for (std::size_t k = 0; k + 1 < rungs.size(); ++k) {
    const auto [i, j] = rungs[k];
    const auto [i_next, j_next] = rungs[k + 1];
    std::vector<VertexId> corners{ends.a[i]};
    if (i_next != i) corners.push_back(ends.a[i_next]);
    corners.push_back(ends.b[j_next]);
    if (j_next != j) corners.push_back(ends.b[j]);
    selection.faces.insert(draft.add_face(std::move(corners)));
  }
  return selection;
}

std::optional<Message> check_ends(std::vector<VertexId> a, std::vector<VertexId> b) {
  if (a.size() > largest_bridge_end || b.size() > largest_bridge_end)
    return make_error(e_too_many_elements, "The ends of the bridge have too many vertices.",
                      "Bridge shorter stretches.");
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::vector<VertexId> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  if (common.empty()) return std::nullopt;
  return make_error(e_wrong_selection, "The two ends of the bridge touch at a vertex.",
                    "Choose ends that have no vertex in common.", element_of(common[0]));
}

Result<EditResult> finished(MeshEditor draft, const Ends& ends) {
  // A cross edge that exists already would get more than two faces.
  ElementSet selection = add_strip(draft, ends);
  return std::move(draft).finish(std::move(selection));
}

std::vector<VertexId> reversed(std::span<const VertexId> loop) {
  return {loop.rbegin(), loop.rend()};
}

}  // namespace

Result<EditResult> bridge_faces(const PolyhedronSource& source, FaceId first, FaceId second,
                                const BridgeOptions& options) {
  const std::array<FaceId, 2> both{first, second};
  const auto chosen = selected(source.polyhedron, both, "Select two faces.");
  if (!chosen) return chosen.error();
  if (first == second)
    return make_error(e_wrong_selection, "A bridge needs two faces.", "Select two faces.", element_of(first));
  MeshEditor draft(source);
  const auto a_span = draft.face(first), b_span = draft.face(second);
  const std::vector<VertexId> a(a_span.begin(), a_span.end()), b = reversed(b_span);
  if (auto failed = check_ends(a, b)) return *std::move(failed);
  const Ends ends = aligned(draft, a, b, options.twist);
  draft.remove_face(first);
  draft.remove_face(second);
  return finished(std::move(draft), ends);
}

Result<EditResult> bridge_borders(const PolyhedronSource& source, std::span<const EdgeId> edges,
                                  const BridgeOptions& options) {
  const Polyhedron& polyhedron = source.polyhedron;
  const auto chosen = selected(polyhedron, edges, "Select the edges of two borders.");
  if (!chosen) return chosen.error();
  for (const Index e : *chosen)
    if (!polyhedron.topology().is_border_edge(e))
      return make_error(e_wrong_selection, "The edge is not at a border: it has faces on both sides.",
                        "Select border edges, or bridge two faces.", element_of(polyhedron.edge_id(e)));
  const auto chains = border_chains(polyhedron.topology(), *chosen);
  if (chains.size() != 2 || chains[0].closed != chains[1].closed)
    return make_error(e_wrong_selection, "The edges do not form two closed borders or two stretches.",
                      "Select all edges of two holes, or one stretch of edges on each side.");
  std::array<std::vector<VertexId>, 2> ends;
  for (std::size_t k = 0; k < 2; ++k)
    for (const Index v : chains[k].vertices) ends[k].push_back(polyhedron.vertex_id(v));
  if (auto failed = check_ends(ends[0], ends[1])) return *std::move(failed);
  MeshEditor draft(source);
  const std::vector<VertexId> b = reversed(ends[1]);
  if (!chains[0].closed) return finished(std::move(draft), {ends[0], b});
  const Ends placed = aligned(draft, ends[0], b, options.twist);
  return finished(std::move(draft), placed);
}

}  // namespace hariko
