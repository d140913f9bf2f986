#pragma once

// What commands that make objects share.

#include <span>

#include "core/document/edits/edits.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// An empty document where the start page shows.
void begin_document(Editor& editor);
/// Half the extent of a new object: a hand's breadth in an empty document, else in proportion to what is
/// there; 1, 2 or 5 times a power of ten.
double new_object_radius(const Editor& editor);
/// Shows everything when something new reaches out of the active view.
void bring_into_sight(Editor& editor, ObjectId object);
void bring_into_sight(Editor& editor, std::span<const ObjectId> objects);
/// In an empty document: 50 mm, whatever its unit.
double first_object_radius(Unit unit);

}  // namespace hariko
