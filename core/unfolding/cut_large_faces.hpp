#pragma once

// Division of faces that are larger than the page.

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/document/paper_settings.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

inline constexpr Code w_facet_cut{"W_FACET_CUT"};

/// Mesh whose faces fit the page.
struct CutFaces {
  PolygonMesh mesh;     ///< unchanged where nothing is cut; new vertices follow the old ones
  std::size_t cut = 0;  ///< number of original faces that were divided
};

/// Divides faces that fit a page of these settings in no rotation by straight lines into as few parts of
/// about equal size as possible; adjacent faces get the new corners on their sides, which stay straight.
/// Faces that are not flat, or concave, are triangulated first. The mesh must have no `unfolding_errors`.
/// Errors: those of `check_settings`; E_PAPER_SETTING where the model would need more than `most_pages`
/// pages.
Result<CutFaces> cut_large_faces(const PolygonMesh& mesh, const PaperSettings& settings);
/// Largest number of pages of a model.
inline constexpr double most_pages = 2000;

/// W_FACET_CUT for a number of divided faces.
Message cut_faces_message(std::size_t count);

/// Largest scale (mm per unit) at which no face is larger than the page. Requirements on the mesh as above.
double largest_uncut_scale(const PolygonMesh& mesh, const PaperSettings& settings);

}  // namespace hariko
