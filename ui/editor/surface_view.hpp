#pragma once

// SurfaceView: what is known of an object's surface right now. Made by workers, read by the panels and the
// viewport.

#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/continuity.hpp"
#include "core/base/message.hpp"
#include "core/document/document.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "render/color_map.hpp"
#include "render/display_mesh.hpp"
#include "render/surface_lines.hpp"

namespace hariko {

inline constexpr Code e_surface_pending{"E_SURFACE_PENDING"};

struct SurfaceView {
  /// The object this was made from, or failed for.
  std::shared_ptr<const Object> object;
  Quality quality = Quality::final;
  /// Whether the final surface of the same object differs by more than rounding, because something stays
  /// fixed during gestures.
  bool provisional = false;

  Surface surface;                          ///< surface of the last good rebuild
  std::shared_ptr<const DisplayMesh> mesh;  ///< mesh of the last good rebuild; null before the first
  ValueRange range;                         ///< range of the map's values
  std::vector<float> histogram;             ///< the map's values within the range; empty without a map
  std::shared_ptr<const CombLines> combs;   ///< null unless they are shown
  double milliseconds = 0;                  ///< time that the rebuild took, display mesh included
  std::vector<Message> warnings;
  std::optional<double> sticks_out;  ///< protrusion of solids from a surface on their faces; object's lengths
  std::optional<Message> map_error;  ///< reason why the object cannot have the values of its map
  std::optional<Message> error;      ///< reason why there is no newer surface than the one shown

  /// Largest angle between normals on both sides of inner edges that are no creases, radians. Measured when
  /// idle.
  std::optional<double> largest_normal_jump;
  /// From the same measurement; during a gesture the last one of a surface with the same seams.
  std::shared_ptr<const ContinuityReport> continuity;
};

/// A point of a surface by its patch: it stays on the surface when that moves.
struct SurfacePoint {
  ObjectId object;
  Index patch = no_index;
  Vector2 parameter = Vector2::Zero();
  double value = 0;  ///< value of the map at the display mesh; NaN when undefined or without a map
};

}  // namespace hariko
