#pragma once

// Commands that make objects: what they share, and where new objects are put, in the window and in scripts.

#include <span>
#include <vector>

#include "core/document/edits/edits.hpp"
#include "core/document/similarity.hpp"
#include "ui/editor/command_arguments.hpp"
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

/// On the ground the first object at zero and others in the middle of the view; on another working plane
/// along its axes, the first at its zero and others below the middle of the view.
Similarity place_for_new(const Editor& editor);

/// The arguments `at` (in the document's space) and `turned` (degrees about x, y and z, one after the other)
/// of commands that make objects.
void add_place_arguments(std::vector<ArgumentSpec>& arguments);
/// The place that these arguments give.
Similarity given_place(const Arguments& arguments);
/// A place as a script writes it; `turned` only where it is turned. The scale is left out.
std::vector<WrittenArgument> written_place(const Similarity& place);

}  // namespace hariko
