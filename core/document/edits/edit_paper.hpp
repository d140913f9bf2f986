#pragma once

// Edits of the document's paper model.

#include <span>

#include "core/document/document.hpp"

namespace hariko {

/// Returns the document with this paper model; an equal one changes nothing.
Document set_paper(const Document& document, PaperModel paper);
/// Returns the document without a paper model.
Document remove_paper(const Document& document);

/// Objects that can be unfolded: visible, with a surface or facets. Ascending.
std::vector<ObjectId> unfoldable_objects(const Document& document);

/// Suitable distance between surface and facets for paper: 1 % of the diagonal of the bounding box of the
/// objects' polyhedra, nets and meshes, rounded to one digit. A length in the document's unit, positive;
/// half a millimetre where the box is empty or a point.
double proposed_distance(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
