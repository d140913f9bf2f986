#include "core/gaussmap/sphere/delaunay_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/solvers/small_solver.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/edge_key.hpp"
#include "core/geometry/orientation.hpp"

namespace hariko {
namespace {

/// Auxiliary point for sites on one circle, whose hull is flat: the pole of the circle away from the image
/// makes it solid. Nothing when the sites span space (gaussmap.md 3).
std::optional<Vector3> guard_for(const std::vector<std::vector<Vector3>>& loops,
                                 const std::vector<Vector3>& sites) {
  Vector3 mean = Vector3::Zero(), axis = Vector3::Zero();
  for (const Vector3& site : sites) mean += site / double(sites.size());
  Matrix3 spread = Matrix3::Zero();
  for (const Vector3& site : sites) spread += (site - mean) * (site - mean).transpose();
  const SymmetricAxes axes = symmetric_axes(spread);
  // Eigenvalues are squares of the singular values of the sites about their mean.
  if (axes.values[0] >= 1e-12 * axes.values[2]) return {};
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) axis += loop[i].cross(loop[(i + 1) % loop.size()]);
  const Vector3 normal = axes.vectors.col(0);
  return axis.dot(normal) > 0 ? Vector3(-normal) : normal;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Message flat_image() {
  return make_error(e_boundary_edge, "The normals along the outline do not enclose a part of the sphere.",
                    "Sample the outline more densely, or give normals that turn along it.",
                    element_of(VertexId{0}));
}

}  // namespace

SiteInsertion::SiteInsertion(ConvexHull hull, std::vector<Index> next, Index guard_count)
    : hull_(std::move(hull)), next_(std::move(next)), guard_count_(guard_count) {
  std::vector<double> angles;
  for (Index i = 0; i < next_.size(); ++i) {
    const Vector3 &a = hull_.points()[i], &b = hull_.points()[next_[i]];
    angles.push_back(angle_between(a, b));
    arcs_.push_back({(a + b).normalized(), std::cos(angles.back() / 2)});
  }
  boundary_spacing_ = median_of(std::move(angles));
}

Result<SiteInsertion> SiteInsertion::begin(const std::vector<std::vector<Vector3>>& loops, bool reversed) {
  std::vector<Vector3> points;
  std::vector<Index> next;
  for (const auto& loop : loops) {
    const Index first = static_cast<Index>(points.size()), count = static_cast<Index>(loop.size());
    for (Index i = 0; i < count; ++i) next.push_back(first + (i + 1) % count);
    points.insert(points.end(), loop.begin(), loop.end());
  }
  const auto guard = guard_for(loops, points);
  if (guard) points.push_back(*guard);
  auto hull = ConvexHull::build(std::move(points));
  if (!hull) return flat_image();
  SiteInsertion out(*std::move(hull), std::move(next), guard ? 1 : 0);
  const Result<Done> filled = out.fill_inside(loops, reversed);
  if (!filled) return filled.error();
  return out;
}

bool SiteInsertion::is_loop_edge(Index a, Index b) const {
  return a < next_.size() && b < next_.size() && (next_[a] == b || next_[b] == a);
}

Result<Done> SiteInsertion::fill_inside(const std::vector<std::vector<Vector3>>& loops, bool reversed) {
  const auto& faces = hull_.faces();
  std::unordered_map<std::uint64_t, Index> face_of;
  for (Index f = 0; f < faces.size(); ++f)
    if (faces[f].alive)
      for (std::size_t k = 0; k < 3; ++k)
        face_of[half_edge_key(faces[f].corner[k], faces[f].corner[(k + 1) % 3])] = f;
  // Name of the arc from a site to the next one, by its start in the outline.
  struct Place {
    Element element;
    std::string text;
  };
  const auto place = [&](Index site) {
    std::size_t loop = 0;
    Index first = 0;
    while (site - first >= loops[loop].size()) first += static_cast<Index>(loops[loop++].size());
    const Index at =
        reversed ? static_cast<Index>(loops[loop].size()) - 1 - (next_[site] - first) : site - first;
    std::string text = "point " + std::to_string(at);
    if (loops.size() > 1) text += " of loop " + std::to_string(loop);
    return Place{element_of(VertexId{first + at}), std::move(text)};
  };
  inside_.assign(faces.size(), 0);
  std::vector<Index> stack;
  for (Index i = 0; i < next_.size(); ++i) {
    const auto found = face_of.find(half_edge_key(i, next_[i]));
    if (found == face_of.end())
      return make_error(
          e_boundary_edge,
          "The Gauss image between " + place(i).text + " and the next is coarser than its surroundings.",
          "Sample the outline more densely there.", place(i).element);
    if (!inside_[found->second]) stack.push_back(found->second);
    inside_[found->second] = 1;
  }
  while (!stack.empty()) {
    const ConvexHull::Face& face = faces[stack.back()];
    stack.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face.corner[k], b = face.corner[(k + 1) % 3];
      if (a < next_.size() && b < next_.size() && next_[b] == a)
        return make_error(e_image_leak,
                          "The Gauss image leaks out between " + place(b).text + " and the next.",
                          "Sample the outline more densely there, or reverse a loop.", place(b).element);
      if (a >= next_.size())
        return make_error(e_image_leak, "The Gauss image is not enclosed by the outline.",
                          "Reverse the loop, so that the surface lies on its left.", element_of(VertexId{0}));
      if (is_loop_edge(a, b) || inside_[face.neighbour[k]]) continue;
      inside_[face.neighbour[k]] = 1;
      stack.push_back(face.neighbour[k]);
    }
  }
  for (Index f = 0; f < faces.size(); ++f)
    if (faces[f].alive && inside_[f]) offer(f);
  return Done{};
}

void SiteInsertion::offer(Index face) {
  const auto& v = hull_.faces()[face].corner;
  const Vector3& a = hull_.points()[v[0]];
  const double radius = angle_between(a, sphere_circumcentre(a, hull_.points()[v[1]], hull_.points()[v[2]]));
  candidates_.push({radius, face});
}

bool SiteInsertion::near_loop(const Vector3& centre) const {
  return std::any_of(arcs_.begin(), arcs_.end(),
                     [&](const Arc& arc) { return centre.dot(arc.middle) > arc.cosine; });
}

ConvexHull::Horizon SiteInsertion::admissible_horizon(Index face, const Vector3& centre) const {
  // Also skips circles for which rounding puts the centre behind its own face: very small ones, and ones
  // round a pole.
  if (near_loop(centre) || !hull_.sees(centre, face)) return {};
  ConvexHull::Horizon horizon = hull_.horizon(centre, face);
  const bool inner =
      std::all_of(horizon.faces.begin(), horizon.faces.end(), [&](Index f) { return inside_[f]; });
  if (!inner) return {};
  for (const auto& edge : horizon.edges)
    if (side_of_plane(Vector3::Zero(), hull_.points()[edge.from], hull_.points()[edge.to], centre) <= 0)
      return {};
  return horizon;
}

bool SiteInsertion::find_top() {
  while (!candidates_.empty() && !hull_.faces()[candidates_.top().face].alive) candidates_.pop();
  return !candidates_.empty();
}

double SiteInsertion::largest_radius() {
  while (find_top()) {
    const Candidate top = candidates_.top();
    const auto& v = hull_.faces()[top.face].corner;
    const Vector3 centre =
        sphere_circumcentre(hull_.points()[v[0]], hull_.points()[v[1]], hull_.points()[v[2]]);
    if (!admissible_horizon(top.face, centre).edges.empty()) return top.radius;
    candidates_.pop();
  }
  return 0;
}

std::optional<Index> SiteInsertion::insert_next(double smallest_radius) {
  while (find_top()) {
    const Candidate top = candidates_.top();
    if (top.radius < smallest_radius) return {};
    candidates_.pop();
    const auto v = hull_.faces()[top.face].corner;
    const Vector3 centre =
        sphere_circumcentre(hull_.points()[v[0]], hull_.points()[v[1]], hull_.points()[v[2]]);
    const ConvexHull::Horizon horizon = admissible_horizon(top.face, centre);
    if (horizon.edges.empty()) continue;
    const Index number = hull_.insert(centre, horizon);
    inside_.resize(hull_.faces().size(), 1);
    for (Index f = static_cast<Index>(hull_.faces().size() - horizon.edges.size()); f < hull_.faces().size();
         ++f)
      offer(f);
    return number - guard_count_;
  }
  return {};
}

SphereMesh SiteInsertion::mesh() const {
  const Index boundary = static_cast<Index>(next_.size());
  std::vector<Vector3> sites = hull_.points();
  sites.erase(sites.begin() + boundary, sites.begin() + boundary + guard_count_);
  std::vector<SphereMesh::Triangle> triangles;
  for (Index f = 0; f < hull_.faces().size(); ++f) {
    if (!hull_.faces()[f].alive || !inside_[f]) continue;
    SphereMesh::Triangle triangle = hull_.faces()[f].corner;
    for (Index& v : triangle)
      if (v >= boundary) v -= guard_count_;
    triangles.push_back(triangle);
  }
  return {std::move(sites), next_, std::move(triangles)};
}

}  // namespace hariko
