#pragma once

// MapSurroundings: what the map of an object depends on beside the object itself.

#include <functional>

#include "core/document/document.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Whether there is a surface to compare with, and if not, why.
enum class ReferenceState {
  unasked,  ///< the map compares nothing
  none,     ///< none is chosen, or it is gone
  itself,   ///< the object is the reference
  hidden,
  waiting,  ///< its surface is not ready
  ready,
};

/// Values that are those of their defaults where the map does not depend on them, so that nothing is computed
/// anew without need.
struct MapSurroundings {
  double limit = 0;                 ///< limit of maps with one: degrees, or a length in the document's unit
  Similarity transform;             ///< the object's, for maps of making
  Vector3 pull = Vector3::UnitZ();  ///< for drafts
  ReferenceState state = ReferenceState::unasked;
  Surface reference;               ///< the object's, where the state is ready
  bool reference_facets = false;   ///< it consists of flat facets
  Similarity reference_transform;  ///< from its space to the document's
};

/// Whether both ask for the same values: all but the limit, which is a matter of colours.
bool same_values(const MapSurroundings& a, const MapSurroundings& b);

/// Surface of an object of the document as it is shown now; null where it is not ready.
using ShownSurface = std::function<const Surface*(ObjectId)>;
/// Finds what an object's map depends on.
MapSurroundings surroundings_of(const Document& document, const Object& object, const ShownSurface& shown);

}  // namespace hariko
