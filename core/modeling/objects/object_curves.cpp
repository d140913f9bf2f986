#include "core/modeling/objects/object_curves.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/base/index_list.hpp"
#include "core/geometry/curve_places.hpp"
#include "core/modeling/measuring/surface_curves.hpp"

namespace hariko {

namespace {

Message no_chain(const Object& object) {
  return make_error(e_edge_chain, "The selected edges do not form one chain.",
                    "Select edges that follow each other without branches.", element_of(object.id));
}

/// Vertices of the edges in the order of the chain; a closed one repeats the first at the end. Nothing where
/// there is no single chain.
std::optional<std::vector<VertexId>> chain_of_edges(std::span<const EdgeId> edges) {
  const std::set<EdgeId> all(edges.begin(), edges.end());
  if (all.empty()) return {};
  std::map<VertexId, std::vector<VertexId>> neighbours;
  for (const EdgeId& edge : all) {
    neighbours[edge.low].push_back(edge.high);
    neighbours[edge.high].push_back(edge.low);
  }
  VertexId start = neighbours.begin()->first;
  bool open = false;
  for (auto& [vertex, others] : neighbours) {
    if (others.size() > 2) return {};
    std::sort(others.begin(), others.end());
    if (others.size() == 1 && !open) start = vertex, open = true;
  }
  std::vector<VertexId> chain{start, neighbours[start].front()};
  while (chain.size() <= all.size()) {
    const VertexId here = chain.back(), before = chain[chain.size() - 2];
    const std::vector<VertexId>& others = neighbours[here];
    if (others.size() < 2) break;
    if (here == start) break;
    chain.push_back(others[0] == before ? others[1] : others[0]);
  }
  if (chain.size() != all.size() + 1) return {};
  return chain;
}

CurvePiece placed_piece(CurvePiece piece, const Similarity& place) {
  return [piece = std::move(piece), place](double x) -> CurveSample {
    const CurveSample own = piece(x);
    return {place.apply(own.position), place.apply_to_vector(own.along)};
  };
}

/// Curve of a surface in the object's space.
CurvePiece piece_of_side(const Surface& surface, const SideCurve& curve) {
  const Vector2 from = curve_parameter(surface, curve, 0), to = curve_parameter(surface, curve, 1);
  return [surface, patch = curve.side.patch, from, along = Vector2(to - from)](double x) -> CurveSample {
    const PatchPoint at = surface.patches().evaluate(patch, from + x * along, Order::first);
    return {surface.origin() + at.position, at.ds * along.x() + at.dt * along.y()};
  };
}

/// Curves of a surface over one edge from `a` to `b`, which are its vertices' places. A live mirror has a
/// second one over the image of the edge, which comes after the edge's own.
std::optional<CurvePiece> piece_over_edge(const Surface& surface, const SurfaceElements& elements,
                                          const EdgeId& edge, const Vector3& a, const Vector3& b) {
  const std::vector<SideCurve> curves = elements.curves_over(edge);
  if (curves.empty()) return {};
  CurvePiece piece = piece_of_side(surface, curves.front());
  const Vector3 begin = piece(0).position, end = piece(1).position;
  const bool backward = (begin - b).norm() + (end - a).norm() < (begin - a).norm() + (end - b).norm();
  return backward ? run_backward({std::move(piece)}).front() : piece;
}

}  // namespace

Result<ObjectCurve> curve_of_edges(const Object& object, std::span<const EdgeId> edges,
                                   const Surface* surface) {
  HARIKO_ASSERT(object.cage(), "edges are those of a cage");
  const Polyhedron& cage = *object.cage();
  for (const EdgeId& edge : edges)
    if (cage.find(edge) == no_index) return no_chain(object);
  const auto chain = chain_of_edges(edges);
  if (!chain) return no_chain(object);
  ObjectCurve out;
  out.closed = chain->front() == chain->back();
  const SurfaceElements elements = surface ? SurfaceElements(*surface) : SurfaceElements();
  for (std::size_t i = 0; i + 1 < chain->size(); ++i) {
    const VertexId from = (*chain)[i], to = (*chain)[i + 1];
    const Vector3 a = object.cage_origin() + cage.position(cage.find(from)),
                  b = object.cage_origin() + cage.position(cage.find(to));
    auto curve = surface ? piece_over_edge(*surface, elements, EdgeId::of(from, to), a, b) : std::nullopt;
    out.pieces.push_back(placed_piece(curve ? std::move(*curve) : straight_piece(a, b), object.transform));
  }
  return out;
}

Result<ObjectCurve> curve_of_path(const Object& object) {
  HARIKO_ASSERT(object.skin(), "a path is that of a skin");
  const SubdivisionCurve& path = object.skin()->skin->path;
  if (path.size() < (path.closed ? 3 : 2))
    return make_error(e_unfinished_curve, "The curve has too few points.", "Draw more points of it.",
                      element_of(object.id));
  ObjectCurve out{{}, path.closed};
  for (int span = 0; span < path.spans(); ++span) {
    // The derivative at a corner is that of the next span.
    const double last = path.is_sharp((span + 1) % path.size()) ? 1 - 1e-9 : 1;
    CurvePiece piece = [path, span, last](double x) -> CurveSample {
      const double spans = path.spans();
      return {evaluate(path, (span + x) / spans).position,
              evaluate(path, (span + std::min(x, last)) / spans).first / spans};
    };
    out.pieces.push_back(placed_piece(std::move(piece), object.transform));
  }
  return out;
}

Result<ObjectCurve> curve_of_loop(const Object& object, std::size_t loop) {
  HARIKO_ASSERT(object.outline() && loop < object.outline()->outline->loops.size(), "a loop of an outline");
  SampledCurve curve{object.outline()->outline->loops[loop].points, true};
  std::vector<Vector3>& points = curve.points;
  remove_repeats(points);
  if (points.size() < 3)
    return make_error(e_unfinished_curve, "The curve has too few points.", "Draw more points of it.",
                      element_of(object.id));
  ObjectCurve out{{}, true};
  const auto shared = std::make_shared<const SampledCurve>(std::move(curve));
  for (std::size_t span = 0; span < shared->points.size(); ++span) {
    CurvePiece piece = [shared, span](double x) -> CurveSample {
      return {point_of(*shared, span, x), derivative_of(*shared, span, x)};
    };
    out.pieces.push_back(placed_piece(std::move(piece), object.transform));
  }
  return out;
}

std::optional<std::size_t> drawn_curve_count(const Object& object) {
  if (object.skin()) return std::size_t(1);
  if (const OutlineSource* source = object.outline()) return source->outline->loops.size();
  return std::nullopt;
}

std::optional<std::size_t> drawn_curve_at(const Object& object, VertexId point) {
  if (object.skin()) return std::size_t(0);
  const OutlineSource* source = object.outline();
  if (!source || point.value >= source->outline->point_count()) return std::nullopt;
  return outline_point(*source->outline, point.value).loop;
}

Result<ObjectCurve> drawn_curve_of(const Object& object, std::size_t number) {
  return object.skin() ? curve_of_path(object) : curve_of_loop(object, number);
}

}  // namespace hariko
