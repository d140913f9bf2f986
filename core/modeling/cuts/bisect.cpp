#include "core/modeling/cuts/bisect.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"

namespace hariko {
namespace {

/// Corners from the one before the first on the positive side to the one after the last. Empty where no
/// corner is on the positive side; nothing where they are not all in one run.
std::optional<std::vector<VertexId>> positive_part(std::span<const VertexId> corners,
                                                   const std::map<VertexId, int>& side) {
  const std::size_t n = corners.size();
  const auto is_positive = [&](std::size_t i) { return side.at(corners[i % n]) > 0; };
  std::size_t starts = 0, start = 0, positive = 0;
  for (std::size_t i = 0; i < n; ++i) {
    positive += is_positive(i);
    if (!is_positive(i) && is_positive(i + 1)) {
      ++starts;
      start = i;
    }
  }
  if (positive == n) return std::vector<VertexId>(corners.begin(), corners.end());
  if (positive == 0) return std::vector<VertexId>{};
  bool any_negative = false;
  for (const VertexId v : corners) any_negative = any_negative || side.at(v) < 0;
  // A face that only touches the plane stays whole.
  if (!any_negative) return std::vector<VertexId>(corners.begin(), corners.end());
  if (starts != 1) return std::nullopt;
  std::vector<VertexId> out;
  for (std::size_t i = 0; i < positive + 2; ++i) out.push_back(corners[(start + i) % n]);
  return out;
}

/// Fraction of an edge's curve, from its end with the smaller id, at which it crosses the plane through the
/// origin of the object; its ends lie on different sides. `usual` where the surface has no such curve.
double crossing_share(const SurfaceForm& form, EdgeId edge, Axis axis, double usual) {
  const auto curve = form.curve(edge);
  if (!curve) return usual;
  const auto height = [&](double t) {
    const double s = 1 - t;
    return form.source().origin[index_of(axis)] + s * s * s * (*curve)[0][index_of(axis)] +
           3 * s * s * t * (*curve)[1][index_of(axis)] + 3 * s * t * t * (*curve)[2][index_of(axis)] +
           t * t * t * (*curve)[3][index_of(axis)];
  };
  double low = 0, high = 1;
  const bool rises = height(0) < 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((height(middle) < 0) == rises ? low : high) = middle;
  }
  return std::clamp((low + high) / 2, 1e-9, 1 - 1e-9);
}

}  // namespace

Result<EditResult> halved(const PolyhedronSource& source, const Mirror& mirror, const SurfaceForm* on) {
  if (const auto checked = check_mirror(mirror); !checked) return checked.error();
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Eigen::Index axis = index_of(mirror.axis);
  const auto height = [&](Index v) { return source.origin[axis] + polyhedron.position(v)[axis]; };
  std::map<VertexId, int> side;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    side[polyhedron.vertex_id(v)] = std::abs(height(v)) <= mirror.weld_distance ? 0 : height(v) > 0 ? 1 : -1;

  MeshEditor draft(source);
  for (Index e = 0; e < polyhedron.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    const Index a = mesh.origin(h), b = mesh.target(h);
    if (side.at(polyhedron.vertex_id(a)) * side.at(polyhedron.vertex_id(b)) >= 0) continue;
    const double share = height(a) / (height(a) - height(b));
    Vector3 p = polyhedron.position(a) + share * (polyhedron.position(b) - polyhedron.position(a));
    p[axis] = 0 - source.origin[axis];
    const EdgeId edge = polyhedron.edge_id(e);
    const double from_low = polyhedron.vertex_id(a) == edge.low ? share : 1 - share;
    const double crossing = on ? crossing_share(*on, edge, mirror.axis, from_low) : from_low;
    const VertexId middle = draft.add_vertex(p, EdgePoint{edge, crossing});
    side[middle] = 0;
    draft.split_edge(edge, middle);
  }
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const FaceId id = polyhedron.face_id(f);
    auto part = positive_part(draft.face(id), side);
    if (!part)
      return make_error(e_wrong_selection, "The face crosses the plane of the mirror more than once.",
                        "Decompose the face into convex parts first.", element_of(id));
    if (part->empty())
      draft.remove_face(id);
    else
      draft.set_face(id, *std::move(part));
  }
  if (!on) return std::move(draft).finish({});
  // Kept forms are computed for the mirrored whole.
  const RefinedPoints places = draft.places();
  auto half = std::move(draft).finish();
  if (!half) return half.error();
  const auto own = half->mirror;
  half.value().mirror = mirror;
  auto kept = on->keep(std::move(half).value(), places);
  if (!kept) return kept.error();
  kept.value().mirror = own;
  return EditResult{std::move(kept).value(), {}};
}

}  // namespace hariko
