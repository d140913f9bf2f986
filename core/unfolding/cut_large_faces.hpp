#pragma once

// Faces that are larger than the page, cut into parts that are not.

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/document/paper_settings.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

inline constexpr Code w_facet_cut{"W_FACET_CUT"};

struct CutFaces {
  PolygonMesh mesh;     ///< the mesh itself where nothing is cut; new vertices come behind the old ones
  std::size_t cut = 0;  ///< faces of the mesh that became several
};

/// Faces that no turn puts on a page of these settings are cut by straight lines into as few parts of even
/// size as can be; faces beside them get the new corners on their sides, where they stay straight. Faces that
/// are not flat, or concave, are cut into triangles first. The mesh must have no `unfolding_errors`. Errors:
/// those of `check_settings`; E_PAPER_SETTING where the model would take more than `most_pages` pages.
Result<CutFaces> cut_large_faces(const PolygonMesh& mesh, const PaperSettings& settings);
inline constexpr double most_pages = 2000;

/// W_FACET_CUT: that so many faces were cut.
Message cut_faces_message(std::size_t count);

/// The largest scale (mm for one unit) at which no face is larger than the page. The mesh as above.
double largest_uncut_scale(const PolygonMesh& mesh, const PaperSettings& settings);

}  // namespace hariko
