#include "core/document/edits/edit_copies.hpp"

#include <set>
#include <utility>

#include "core/document/edits/edit_support.hpp"
#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

Result<Done> change_copies(Object& object, LiveCopies copies) {
  if (!copies.empty() && !can_have_copies(object))
    return make_error(e_no_live_copies, "The object \"" + object.name + "\" cannot have live copies.",
                      "Leave it out of the selection, or make copies that are objects.",
                      element_of(object.id));
  if (const auto checked = check_copies(copies); !checked) {
    Message error = checked.error();
    error.element = element_of(object.id);
    return error;
  }
  object.copies = std::move(copies);
  return Done{};
}

}  // namespace

bool can_have_copies(const Object& object) {
  return has_shape(object);
}

Result<Document> set_copies(const Document& document, ObjectId id, LiveCopies copies) {
  return detail::change_object(document, id, true,
                               [&](Object& object) { return change_copies(object, std::move(copies)); });
}

Result<Document> add_live_copies(const Document& document, std::span<const ObjectId> objects,
                                 const CopyArray& array) {
  std::set<ObjectId> left(objects.begin(), objects.end());
  Document out = document;
  for (auto& object : out.objects) {
    if (left.erase(object->id) == 0) continue;
    if (object->locked) return detail::locked_object(*object);
    Object changed = *object;
    LiveCopies copies = *object->copies;
    copies.push_back(in_space_of(array, object->transform));
    if (const auto set = change_copies(changed, std::move(copies)); !set) return set.error();
    object = std::make_shared<const Object>(std::move(changed));
  }
  if (!left.empty()) return detail::unknown_object(*left.begin());
  return out;
}

}  // namespace hariko
