#pragma once

// Edits of the document's paper model.

#include <span>

#include "core/document/document.hpp"

namespace hariko {

/// The document with this paper model; an equal one changes nothing.
Document set_paper(const Document& document, PaperModel paper);
/// The document without one.
Document remove_paper(const Document& document);

/// The objects that can be unfolded: visible, with a surface or facets. Ascending.
std::vector<ObjectId> unfoldable_objects(const Document& document);

/// A distance between surface and facets that suits paper: 1 % of the diagonal of the box of the objects'
/// polyhedra, nets and meshes, rounded to one digit. Positive.
double proposed_distance(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
