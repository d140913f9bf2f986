#pragma once

// Shells of a CAD model, and which of them are voids in the material of others.

#include <vector>

#include "core/cad/cad_model.hpp"

namespace hariko {

/// Faces that are connected over edges.
struct CadShell {
  std::vector<Index> faces;  ///< ascending
  bool closed = false;       ///< no face ends at an edge without a neighbour
  /// Volume that a closed shell encloses, a length cubed; negative where its faces look inward.
  double volume = 0;
  /// Shell whose material a void hollows: the innermost one around it, which looks the other way; no_index
  /// for all others.
  Index hollows = no_index;
};

/// Shells of a model. A closed shell is a void where the innermost shell around it is none and looks the
/// other way; shells that intersect, touch or lie apart are no voids of each other. Nesting is exact: points
/// near a shell are projected onto its faces, the others have winding numbers about its triangles. O(faces),
/// and O(n log n) for n triangles of shells with others in their boxes.
std::vector<CadShell> cad_shells(const CadModel& model);

}  // namespace hariko
