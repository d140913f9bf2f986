#include "core/offset/offset_surface.hpp"

#include <cmath>
#include <memory>
#include <span>
#include <string>

#include "core/offset/wall_builder.hpp"

namespace hariko {

namespace {

Message offset_cancelled() {
  return make_error(e_cancelled, "The offset was cancelled.");
}

/// Warning about the folds of one offset; the lengths are multiplied by `scale` in the text.
Message fold_warning(const Surface& base, const OffsetFolds& folds, double distance, double scale) {
  const bool outside = distance > 0;
  const double radius = outside ? folds.outside : folds.inside;
  return make_warning(
      w_offset_folds,
      "At the distance " + rounded_text(scale * distance, 4) + " the surface folds over itself in " +
          counted(folds.patches, " patch", " patches") + ": it bends with a radius of " +
          rounded_text(scale * radius, 4) + " there.",
      "Choose a distance below " + rounded_text(scale * radius, 4) +
          (outside ? " to the outside" : " to the inside") + ", or make the surface rounder there.",
      base.provenance()[folds.worst].element);
}

void add_warnings(const Surface& base, std::span<const double> layers, double scale, OffsetSurface& out) {
  for (std::size_t layer = 0; layer < layers.size(); ++layer)
    if (out.folds[layer].patches > 0)
      out.warnings.push_back(fold_warning(base, out.folds[layer], layers[layer], scale));
  if (out.crossings > 0)
    out.warnings.push_back(make_warning(
        w_offset_crosses,
        "The offset crosses itself along " + counted(out.crossings, " sharp edge", " sharp edges") +
            ", on the narrow side.",
        "Make these edges smooth, put the distance on their other side, or trim it in another program."));
  if (out.tips > 0)
    out.warnings.push_back(make_warning(w_offset_tips,
                                        "The surface has " + counted(out.tips, " sharp tip", " sharp tips") +
                                            " without a normal, where the offset is torn.",
                                        "Make the tips round."));
  if (out.gaps > 0)
    out.warnings.push_back(
        make_warning(w_offset_gaps,
                     counted(out.gaps, " place stays", " places stay") +
                         " open, where sharp edges or borders meet in the middle of another side.",
                     "Divide the longer side there, so that corners meet corners."));
}

Result<OffsetSurface> layered(const Surface& surface, std::vector<double> layers, double scale,
                              const CancelToken& cancel) {
  for (const double distance : layers)
    if (!std::isfinite(distance))
      return make_error(e_offset_distance, "The distance is not a number.", "Type a length.");
  if (surface.patch_count() == 0)
    return make_error(e_offset_nothing, "There is no surface to keep a distance from.",
                      "Choose an object with a surface.");
  OffsetSurface out;
  for (const double distance : layers) out.folds.push_back(offset_folds(surface, distance, cancel));
  if (cancel.cancelled()) return offset_cancelled();
  WallBuilder builder(std::make_shared<const BaseNormals>(surface), layers);
  auto made = builder.build();
  if (cancel.cancelled()) return offset_cancelled();
  if (!made)
    return make_error(e_offset_edge,
                      "Two patches meet back to back along a sharp edge, and there is no way round it.",
                      "Open the edge, or make it less sharp.");
  out.surface = std::move(*made);
  out.sharp_edges = builder.sharp_edges();
  out.crossings = builder.crossings();
  out.gaps = builder.gaps();
  out.tips = builder.tips();
  add_warnings(surface, layers, scale, out);
  return out;
}

}  // namespace

Result<OffsetSurface> wall_surface(const Surface& surface, const Wall& wall, double scale,
                                   const CancelToken& cancel) {
  if (!std::isfinite(wall.offset) || !std::isfinite(wall.thickness) || wall.thickness < 0)
    return make_error(e_offset_distance,
                      "A wall's thickness is a length of 0 or more, and its offset a length.",
                      "Type lengths.");
  const double middle = wall.offset / scale, thickness = wall.thickness / scale;
  if (thickness == 0) return layered(surface, {middle}, scale, cancel);
  const double outward = wall.side == WallSide::outside  ? thickness
                         : wall.side == WallSide::inside ? 0
                                                         : thickness / 2;
  return layered(surface, {middle + outward, middle + outward - thickness}, scale, cancel);
}

}  // namespace hariko
