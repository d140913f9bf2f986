#pragma once

// ViewMap: a map that a view shows on all surfaces at once, without an edit; and what is shown of an object
// then.

#include <optional>

#include "core/document/document.hpp"

namespace hariko {

/// A map of an object's own, any but `shaded`, goes before that of the view.
struct ViewMap {
  std::optional<SurfaceMap> map;
  /// As `DisplaySettings::ranges`: of the maps with values, common to all objects that show the view's.
  MapRanges ranges{};
  friend bool operator==(const ViewMap&, const ViewMap&) = default;
};

/// Whether an object has a map: reference facets have no curvature, nor edges that could be continuous. Walls
/// and deviations may still have no values (`SurfaceView::map_error`).
bool can_show(const Object& object, SurfaceMap map);
/// Whether the view's map colours an object.
bool follows_view(const ViewMap& view, const Object& object);
/// The map that colours an object: its own, else the view's where it has it.
SurfaceMap shown_map(const ViewMap& view, const Object& object);
/// The display settings with the map and its range as they are shown.
DisplaySettings shown_display(const ViewMap& view, const Object& object);

/// Power of the object's scale by which a map's values are divided in the world: 0 for those of making, which
/// are lengths in the world already.
int scale_power(SurfaceMap map);

}  // namespace hariko
