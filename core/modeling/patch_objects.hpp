#pragma once

// Objects of patches are taken apart and put together.

#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Of degree 3 by 3 without weights: the control points can be edited, as those of a `PatchSource`.
bool is_editable(const BezierPatch& patch);

struct SeparatedPatches {
  Document document;
  std::vector<ObjectId> objects;
};
/// Each patch of a `BezierSource` becomes an object of its own, called "<name> 1", "<name> 2" ..., in the
/// place of the object, and placed and shown as it was. All look to the side that was outside. Those that are
/// editable become `PatchSource`s. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND (no Bezier patches, or
/// one only), E_TOO_MANY_OBJECTS. O(patches + objects), and welding.
Result<SeparatedPatches> separate_patches(const Document& document, ObjectId object);

struct WeldedPatches {
  Document document;
  ObjectId object;
};
/// One `BezierSource` of all patches of the objects, which may be `PatchSource`s and `BezierSource`s. They
/// stay where they are in the document's space. The new object stands in the first one's place and has its
/// name, transform and display; all others go. Edges that were attached to them keep copies of their sides.
/// Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND, E_WRONG_SELECTION (fewer than two objects),
/// E_PATCH_POINTS (too many patches, or points too far away), E_TOO_MANY_OBJECTS.
Result<WeldedPatches> weld_patch_objects(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
