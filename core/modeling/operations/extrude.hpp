#pragma once

// Extruding faces, and the open border of a sheet.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/selection/region.hpp"

namespace hariko {

struct ExtrudeOptions {
  /// along the mean normal of each group; negative moves inwards, 0 leaves the copy in place
  double distance = 0;
  Grouping as = Grouping::region;
};

/// Moves faces out and puts walls round them. A group of faces that is a whole open sheet becomes a closed
/// body: the sheet turned over becomes its back, and where the distance is negative all faces of the body are
/// turned so that their normals point outwards.
///
/// The faces keep their ids, as do vertices inside a region; the old rim keeps its place, its shaping and its
/// pins. The new rim has the tensions, creases and tags of the old one. A crease that crossed the old rim
/// into the region continues up the wall; other edges of the walls are plain (`tighten_short_edges`). The
/// Euler number stays, except that a sheet's doubles when it becomes a body.
///
/// Selected afterwards: the moved faces. Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_BAD_AMOUNT,
/// E_WRONG_SELECTION (a group that is closed; a mean normal that vanishes), E_NONFINITE.
Result<EditResult> extrude_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                                 const ExtrudeOptions& options = {});

/// Adds a quad to every given border edge; the quads of consecutive edges share a side. The new border lies
/// `distance` out in the planes of the faces it continues (0: in place, to be dragged). The new border has
/// the tensions, creases and tags of the old one. The Euler number stays. Selected afterwards: the new border
/// edges. Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_BAD_AMOUNT, E_WRONG_SELECTION (an edge that is not
/// open), E_NONFINITE.
Result<EditResult> extrude_borders(const PolyhedronSource& source, std::span<const EdgeId> edges,
                                   double distance = 0);

}  // namespace hariko
