#pragma once

// Separating and welding objects that consist of patches.

#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Whether the patch has degree 3 by 3 and no weights, so that its control points can be edited as those of a
/// `PatchSource`.
bool is_editable(const BezierPatch& patch);

/// Document after `separate_patches`, and the new objects.
struct SeparatedPatches {
  Document document;
  std::vector<ObjectId> objects;
};
/// Makes each patch of a `BezierSource` an object of its own, called "<name> 1", "<name> 2" ..., in the
/// object's place in the list, with its placement and display. All are oriented like the old object. Editable
/// ones become `PatchSource`s. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND (no Bezier patches, or only
/// one), E_TOO_MANY_OBJECTS. O(patches + objects), and welding.
Result<SeparatedPatches> separate_patches(const Document& document, ObjectId object);

/// Document after `weld_patch_objects`, and the new object.
struct WeldedPatches {
  Document document;
  ObjectId object;
};
/// Welds all patches of the objects, which may be `PatchSource`s and `BezierSource`s, into one
/// `BezierSource`. They stay where they are in the document's space. The new object takes the first one's
/// place in the list and its name, transform and display; the old objects are removed. Edges that were
/// attached to them keep copies of their sides. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND,
/// E_WRONG_SELECTION (fewer than two objects), E_PATCH_POINTS (too many patches, or points too far away),
/// E_TOO_MANY_OBJECTS.
Result<WeldedPatches> weld_patch_objects(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
