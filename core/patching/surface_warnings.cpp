#include "core/patching/surface_warnings.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

#include "core/base/parallel.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

namespace {

constexpr std::size_t message_limit = 100;
constexpr int sample_density = 4;
/// Cosine of 107 degrees: a patch whose normal turns so far from its mean is folded over itself. Sharply
/// curved patches that do not fold reach 92 degrees (the car's sills), folded ones 129 and more (the concave
/// sample).
constexpr double folded_cosine = -0.3;

/// Designer's name of an element of the polyhedron; nothing for copies, which are reported with their
/// original.
template <class Id>
std::optional<Element> designers_own(Id id, const ElementAliases* aliases) {
  if (!aliases) return element_of(id);
  if (aliases->is_copy(element_of(id))) return std::nullopt;
  return aliases->original(element_of(id));
}

void add_long_tangents(const Polyhedron& polyhedron, const Network& network, const ElementAliases* aliases,
                       std::vector<Message>& out) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::size_t count = 0;
  for (Index e = 0; e < mesh.edge_count() && count < message_limit; ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    const double length = (polyhedron.position(mesh.target(h)) - polyhedron.position(mesh.origin(h))).norm();
    if (std::max(network.start[h].norm(), network.end[h].norm()) <= length) continue;
    const auto element = designers_own(polyhedron.edge_id(e), aliases);
    if (!element) continue;
    ++count;
    const std::string name = element->kind == Element::Kind::edge
                                 ? "edge " + to_string(EdgeId::from_packed(element->id))
                                 : "an edge inside face " + std::to_string(element->id);
    out.push_back(make_warning(
        w_long_tangent, "The tangents of " + name + " are longer than the edge, so its curve may loop.",
        "Raise the tension of this edge or of its long neighbours, or add an edge loop.", *element));
  }
}

bool folds(const Surface& surface, const GridPattern& pattern, Index patch, std::vector<PatchPoint>& points) {
  points.resize(static_cast<std::size_t>(pattern.point_count()));
  surface.patches().evaluate_grid(std::span(&patch, 1), pattern, std::span(points));
  Vector3 mean = Vector3::Zero();
  for (const PatchPoint& point : points) mean += point.ds.cross(point.dt);
  mean.normalize();
  return std::any_of(points.begin(), points.end(),
                     [&](const PatchPoint& point) { return unit_normal(point).dot(mean) < folded_cosine; });
}

}  // namespace

std::vector<Message> surface_warnings(const Polyhedron& polyhedron, const Network& network,
                                      const Surface& surface, const ElementAliases* aliases) {
  std::vector<Message> out;
  add_long_tangents(polyhedron, network, aliases, out);

  const HalfEdgeMesh& mesh = polyhedron.topology();
  const GridPattern pattern{Domain::triangle, sample_density};
  std::vector<std::uint8_t> folded(mesh.face_count(), 0);
  parallel_for(mesh.face_count(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<PatchPoint> points;
    for (Index f = static_cast<Index>(begin); f < end; ++f)
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f) && !folded[f]; ++h)
        folded[f] = folds(surface, pattern, h, points);
  });
  std::set<std::uint64_t> named;  // several pieces of a face may fold
  for (Index f = 0; f < mesh.face_count() && named.size() < message_limit; ++f) {
    if (!folded[f]) continue;
    const auto element = designers_own(polyhedron.face_id(f), aliases);
    if (!element || !named.insert(element->id).second) continue;
    out.push_back(
        make_warning(w_fold, "The surface folds over itself in face " + std::to_string(element->id) + ".",
                     "Split the face into convex parts, or raise the tension of its edges.", *element));
  }
  return out;
}

}  // namespace hariko
