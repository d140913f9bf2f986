#include "core/modeling/surfacing/surface_input.hpp"

#include <utility>

#include "core/modeling/surfacing/automatic_tension.hpp"

namespace hariko {
namespace {

using Aliases = std::shared_ptr<const ElementAliases>;

/// Aliases of the whole's elements: images stand for elements of the half, whose faces may be pieces of
/// merged ones.
Aliases joined(const Aliases& merged, const Aliases& pieces, const Aliases& images) {
  const int steps = (merged ? 1 : 0) + (pieces ? 1 : 0) + (images ? 1 : 0);
  if (steps < 2) return merged ? merged : pieces ? pieces : images;
  auto out = std::make_shared<ElementAliases>(images ? *images : ElementAliases{});
  if (pieces) {
    out->pieces = pieces->pieces;
    out->inner_edges = pieces->inner_edges;
  }
  if (merged) {
    out->merged = merged->merged;
    out->sides = merged->sides;
  }
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
  Aliases flat, pieces, images;
  if (source.preparation.merge_coplanar) {
    auto merged = with_merged_faces(source, kept.merged ? &*kept.merged : nullptr);
    if (!merged) return merged.error();
    kept.merged = std::move(merged).value();
    prepared = &kept.merged->source;
    flat = kept.merged->aliases;
  } else {
    kept.merged.reset();
  }
  if (source.preparation.split_concave) {
    auto convex = with_convex_faces(*prepared, kept.convex ? &*kept.convex : nullptr);
    if (!convex) return convex.error();
    kept.convex = std::move(convex).value();
    prepared = &kept.convex->source;
    pieces = kept.convex->aliases;
  } else {
    kept.convex.reset();
  }

  PolyhedronSurfaceInput input{prepared->polyhedron, *prepared->shaping, source.mode, source.origin, {}};
  input.frames = source.frames;
  if (prepared->mirror) {
    auto whole = mirrored(*prepared, kept.whole ? &*kept.whole : nullptr);
    if (!whole) return whole.error();
    kept.whole = std::move(whole).value();
    input.polyhedron = kept.whole->polyhedron;
    input.shaping = kept.whole->shaping;
    input.origin = kept.whole->origin;
    images = kept.whole->aliases;
  } else {
    kept.whole.reset();
  }
  input.aliases = joined(flat, pieces, images);

  if (const double exponent = source.preparation.automatic_tension; exponent != 0)
    input.shaping = stretched(input, exponent, quality, kept);
  else
    kept.tension.reset();
  return input;
}

}  // namespace hariko
