#pragma once

// The size of an object as it is seen: of its surface, along its own axes, in the document's unit.

#include "ui/editor/editor.hpp"

namespace hariko {

/// The box of the surface that is shown, or before there is one of what the object is made from, in the
/// object's own space; empty where nothing is known.
Box3 own_box(const Editor& editor, const Object& object);

/// The box of the same in the world. O(vertices of the shown mesh).
Box3 shown_box(const Editor& editor, const Object& object);

/// The box in the world of what the visible objects are made from.
Box3 box_of_visible(const Document& document);

/// Whether a size can change along one axis alone. Solids, skins and outlines are scaled as a whole.
bool stretches(const Object& object);

/// The object with another size along an axis (0, 1, 2) of its own; the centre of `box`, its `own_box`,
/// stays. With `proportional`, and where it does not stretch, the object is scaled; else its source is
/// stretched, and the surface of a polyhedron made anew, measured on `density` intervals a patch side, until
/// it has the size (to 1e-6). Errors: E_SIZE (no extent along the axis, or a size that is not above zero),
/// those of `transform_object` and `object_surface`.
Result<Document> with_size(const Document& document, ObjectId object, const Box3& box, int density, int axis,
                           double size, bool proportional);

/// Intervals a patch side of what is shown of an object's surface.
int shown_density(const Editor& editor, const Object& object);

inline constexpr Code e_size{"E_SIZE"};

}  // namespace hariko
