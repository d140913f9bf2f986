#include "core/modeling/operations/inset.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/amount.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/operations/short_edges.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

/// A region and how its rim moves per unit of width.
struct InsetRegion {
  Region region;
  std::vector<Vector3> rates;  ///< per rim point
  double limit;
};

/// Displacement of the origin of each half-edge of the region, per unit of width.
std::map<Index, Vector3> corner_rates(const HalfEdgeMesh& mesh, const Region& region,
                                      const std::vector<Vector3>& rates) {
  std::map<Index, Vector3> at;
  for (std::size_t i = 0; i < region.rim.size(); ++i)
    for (Index corner = region.rim[i].out;; corner = mesh.rotate(corner)) {
      at[corner] = rates[i];
      if (mesh.previous(corner) == region.rim[i].in) break;
    }
  return at;
}

double limit_of(const Polyhedron& polyhedron, const Region& region, const std::vector<Vector3>& rates) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const std::map<Index, Vector3> moving = corner_rates(mesh, region, rates);
  const auto slide = [&](Index corner) {
    const auto found = moving.find(corner);
    return Slide{polyhedron.position(mesh.origin(corner)),
                 found == moving.end() ? Vector3(Vector3::Zero()) : found->second};
  };
  double limit = std::numeric_limits<double>::infinity();
  for (const Index f : region.faces)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h)
      limit = std::min(limit, collapse_amount(slide(h), slide(mesh.next(h))));
  return limit;
}

Result<std::vector<InsetRegion>> prepare(const PolyhedronSource& source, std::span<const FaceId> faces,
                                         Grouping as) {
  const Polyhedron& polyhedron = source.polyhedron;
  const auto chosen = selected(polyhedron, faces, "Select the faces to inset.");
  if (!chosen) return chosen.error();
  std::vector<InsetRegion> out;
  for (Region& region : find_regions(polyhedron, *chosen, as)) {
    if (region.rim.empty())
      return make_error(e_wrong_selection, "The faces form a closed surface, which has no rim to inset.",
                        "Leave at least one face out, or inset each face by itself.",
                        element_of(polyhedron.face_id(region.faces[0])));
    std::vector<Vector3> rates;
    for (const RimPoint& point : region.rim)
      rates.push_back(miter(inward_direction(polyhedron, point.in), inward_direction(polyhedron, point.out)));
    const double limit = limit_of(polyhedron, region, rates);
    out.push_back({std::move(region), std::move(rates), limit});
  }
  return out;
}

Message too_wide(Element element) {
  return make_error(e_bad_amount, "The inset is too wide: a face would shrink to nothing or turn over.",
                    "Use a smaller amount.", element);
}

/// Continues the inner edges of the region that end at the rim across the band.
void carry_across(MeshEditor& draft, const Polyhedron& polyhedron, const Shaping& before,
                  const Region& region) {
  for (const RimPoint& point : region.rim) {
    const EdgeId across = EdgeId::of(point.base, point.top);
    for (const Index e : point.inner_edges) {
      const EdgeId inner = polyhedron.edge_id(e);
      if (before.crease.contains(inner)) draft.shaping().crease.set(across, true);
      if (point.inner_edges.size() == 1 && before.beta.contains(inner))
        draft.shaping().beta.set(across, before.beta.get_or(inner, 1));
    }
  }
}

}  // namespace

Result<double> largest_inset(const PolyhedronSource& source, std::span<const FaceId> faces, Grouping as) {
  const auto regions = prepare(source, faces, as);
  if (!regions) return regions.error();
  double limit = std::numeric_limits<double>::infinity();
  for (const InsetRegion& inset : *regions) limit = std::min(limit, inset.limit);
  return limit;
}

Result<EditResult> inset_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                               const InsetOptions& options) {
  if (const auto positive = detail::check_positive(options.amount); !positive) return positive.error();
  const bool share = options.measure == InsetOptions::Measure::share;
  const auto prepared = prepare(source, faces, options.as);
  if (!prepared) return prepared.error();
  const Polyhedron& polyhedron = source.polyhedron;
  std::vector<Region> regions;
  for (const InsetRegion& inset : *prepared) {
    const double width = share ? options.amount * inset.limit : options.amount;
    const Element element = element_of(polyhedron.face_id(inset.region.faces[0]));
    if (!(width < inset.limit) || !(width < std::numeric_limits<double>::infinity()))
      return too_wide(element);
    regions.push_back(inset.region);
  }

  MeshEditor draft(source);
  raise_regions(draft, polyhedron, regions);
  ElementSet selection;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const InsetRegion& inset = (*prepared)[r];
    const double width = share ? options.amount * inset.limit : options.amount;
    carry_across(draft, polyhedron, *source.shaping, regions[r]);
    for (std::size_t i = 0; i < inset.rates.size(); ++i)
      draft.move_vertex(regions[r].rim[i].top,
                        polyhedron.position(regions[r].rim[i].vertex) + width * inset.rates[i]);
    for (const Index f : regions[r].faces) selection.faces.insert(polyhedron.face_id(f));
  }
  Result<PolyhedronSource> result = std::move(draft).finish();
  if (!result) return result.error();
  tighten_short_edges(result.value(), source);
  // In concave faces edges can pass through each other before one of them shrinks to nothing.
  if (const FaceId face = first_turned_face(polyhedron, result->polyhedron); face != FaceId{})
    return too_wide(element_of(face));
  return EditResult{std::move(result).value(), std::move(selection)};
}

}  // namespace hariko
