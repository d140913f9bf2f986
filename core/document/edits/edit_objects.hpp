#pragma once

// Edits of whole objects: add, delete, duplicate, rename, show, place.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_locked{"E_LOCKED"};
inline constexpr Code e_transform_invalid{"E_TRANSFORM_INVALID"};
inline constexpr Code e_display_invalid{"E_DISPLAY_INVALID"};

/// A document and the object that the edit made.
struct Added {
  Document document;
  ObjectId id;
};

/// Appends an object with the next free id. Errors: E_NAME_EMPTY, E_NAME_INVALID, E_TRANSFORM_INVALID,
/// E_DISPLAY_INVALID, E_TOO_MANY_OBJECTS.
Result<Added> add_object(Document document, std::string name, Source source, const Similarity& transform = {},
                         const DisplaySettings& display = {});

/// Appends every object of `other` under new ids (opening a file into the scene), its dimensions and its
/// saved views. Coordinates stay as numbers; units are not converted. Edges that are attached to an object
/// that `other` does not have are free. Errors: E_TOO_MANY_OBJECTS, E_TOO_MANY_DIMENSIONS, E_TOO_MANY_VIEWS,
/// E_PICTURES_TOO_LARGE.
Result<Document> append_document(const Document& document, const Document& other);

/// Deletes objects, and the dimensions that name them. Edges of others that are attached to them keep copies
/// of their sides. Errors: E_UNKNOWN_OBJECT, E_LOCKED.
Result<Document> delete_objects(const Document& document, std::span<const ObjectId> objects);

/// Duplicates an object. The copy follows its original in the list, its attached edges keep copies of their
/// sides, it gets a free name (`free_name`) and is not locked; it lies in the group of the original, or in
/// the next one round it that is not locked. Errors: E_UNKNOWN_OBJECT, E_TOO_MANY_OBJECTS,
/// E_PICTURES_TOO_LARGE.
Result<Added> duplicate_object(const Document& document, ObjectId object);

/// A document and the objects that the edit made.
struct AddedObjects {
  Document document;
  std::vector<ObjectId> ids;
};
/// Changes copy number 1, 2, ... of an object before it joins the document. Its id and name must stay.
using ChangeCopy = std::function<Result<Object>(const Object& copy, std::size_t number)>;
/// Duplicates each of the objects `copies` times, as `duplicate_object` does; the copies of an object follow
/// it in their order. The ids are those of the copies of the first object that is given, then of the second,
/// and so on; an object that is given twice counts once. Errors: as above, and those of `change`, which then
/// name the original. O(n log n) in the objects and copies together.
Result<AddedObjects> duplicate_objects(const Document& document, std::span<const ObjectId> objects,
                                       std::size_t copies = 1, const ChangeCopy& change = {});

/// Returns the name itself where no object has it, else with the lowest free number: "Box", "Box 2", "Box 3".
/// A number at the end of the name is counted on from: after "Box 2" comes "Box 3". Not longer than
/// Object::max_name_length. O(objects).
std::string free_name(const Document& document, const std::string& name);

/// Renames an object. Errors: E_UNKNOWN_OBJECT, E_NAME_EMPTY, E_NAME_INVALID.
Result<Document> rename_object(const Document& document, ObjectId object, std::string name);

/// Shows or hides an object by its own switch; in a hidden group it stays hidden. Errors: E_UNKNOWN_OBJECT.
Result<Document> set_visible(const Document& document, ObjectId object, bool visible);
/// Hides all of these objects. Errors: E_UNKNOWN_OBJECT. O(n log n).
Result<Document> hide_objects(const Document& document, std::span<const ObjectId> objects);

/// Returns the document with these objects visible, with the groups round them, and no others. Unchanged
/// objects are shared. O(n log n).
Result<Document> showing_only(const Document& document, std::span<const ObjectId> objects);
/// Locks or unlocks an object by its own switch; in a locked group it stays locked. Errors: E_UNKNOWN_OBJECT.
Result<Document> set_locked(const Document& document, ObjectId object, bool locked);
/// The same of all of these objects. O(n log n).
Result<Document> lock_objects(const Document& document, std::span<const ObjectId> objects, bool locked);

/// Places an object. Normalises the rotation unless it is a unit quaternion already. Errors:
/// E_UNKNOWN_OBJECT, E_LOCKED, E_TRANSFORM_INVALID (not finite, zero rotation, scale outside 1e-9 .. 1e9).
Result<Document> set_transform(const Document& document, ObjectId object, const Similarity& transform);

/// Sets the display of an object. Errors: E_UNKNOWN_OBJECT, E_DISPLAY_INVALID (density out of range).
Result<Document> set_display(const Document& document, ObjectId object, const DisplaySettings& display);

/// Changes the unit without converting the numbers, so that real sizes change.
Document set_unit(const Document& document, Unit unit);

/// Replaces the source (after a repair, a re-import, an edit of connectivity). Errors: E_UNKNOWN_OBJECT,
/// E_LOCKED.
Result<Document> set_source(const Document& document, ObjectId object, Source source);

}  // namespace hariko
