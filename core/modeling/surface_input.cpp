#include "core/modeling/surface_input.hpp"

#include <utility>

#include "core/modeling/automatic_tension.hpp"

namespace hariko {
namespace {

/// Names of the whole's elements: images stand for the half's, whose faces may be pieces.
std::shared_ptr<const ElementAliases> joined(const std::shared_ptr<const ElementAliases>& pieces,
                                             const std::shared_ptr<const ElementAliases>& images) {
  if (!pieces || !images) return pieces ? pieces : images;
  auto out = std::make_shared<ElementAliases>(*images);
  out->pieces = pieces->pieces;
  out->inner_edges = pieces->inner_edges;
  return out;
}

Shaping stretched(const PolyhedronSurfaceInput& input, double exponent, Quality quality,
                  SurfaceInputCache& cache) {
  auto& kept = cache.tension;
  const bool frozen = quality == Quality::drag && kept &&
                      kept->topology == input.polyhedron.shared_topology() && kept->exponent == exponent &&
                      kept->before == input.shaping;
  if (!frozen)
    kept = {input.polyhedron.shared_topology(), exponent, input.shaping,
            with_automatic_tension(input.polyhedron, input.shaping, exponent)};
  return kept->after;
}

}  // namespace

Result<PolyhedronSurfaceInput> surface_input(const PolyhedronSource& source, Quality quality,
                                             SurfaceInputCache* cache) {
  SurfaceInputCache own;
  SurfaceInputCache& kept = cache ? *cache : own;
  const PolyhedronSource* prepared = &source;
  std::shared_ptr<const ElementAliases> pieces;
  if (source.preparation.split_concave) {
    auto convex = with_convex_faces(source, kept.convex ? &*kept.convex : nullptr);
    if (!convex) return convex.error();
    kept.convex = std::move(convex).value();
    prepared = &kept.convex->source;
    pieces = kept.convex->aliases;
  } else {
    kept.convex.reset();
  }

  PolyhedronSurfaceInput input{prepared->polyhedron, *prepared->shaping, source.mode, source.origin, pieces};
  input.round = source.round;
  input.frames = source.frames;
  if (prepared->mirror) {
    auto whole = mirrored(*prepared, kept.whole ? &*kept.whole : nullptr);
    if (!whole) return whole.error();
    kept.whole = std::move(whole).value();
    input.polyhedron = kept.whole->polyhedron;
    input.shaping = kept.whole->shaping;
    input.origin = kept.whole->origin;
    input.aliases = joined(pieces, kept.whole->aliases);
  } else {
    kept.whole.reset();
  }

  if (const double exponent = source.preparation.automatic_tension; exponent != 0)
    input.shaping = stretched(input, exponent, quality, kept);
  else
    kept.tension.reset();
  return input;
}

}  // namespace hariko
