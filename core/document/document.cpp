#include "core/document/document.hpp"

#include <algorithm>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/words.hpp"

namespace hariko {

std::string_view to_string(Unit unit) {
  return enum_word(unit);
}

double millimetres_per(Unit unit) {
  switch (unit) {
    case Unit::millimetre:
      return 1;
    case Unit::centimetre:
      return 10;
    case Unit::metre:
      return 1000;
    case Unit::inch:
      return 25.4;
  }
  HARIKO_ASSERT(false, "unit out of range");
  return 1;
}

std::shared_ptr<const Object> Document::find_shared(ObjectId id) const {
  const auto found =
      std::find_if(objects.begin(), objects.end(), [&](const auto& object) { return object->id == id; });
  return found == objects.end() ? nullptr : *found;
}

const Object* Document::find(ObjectId id) const {
  return find_shared(id).get();
}

bool operator==(const Document& a, const Document& b) {
  const auto same = [](const auto& x, const auto& y) { return x == y || *x == *y; };
  return a.unit == b.unit && a.next_object_id == b.next_object_id && a.kept == b.kept &&
         a.dimensions == b.dimensions && a.groups == b.groups && a.making == b.making &&
         a.saved_views == b.saved_views &&
         (a.paper == b.paper || (a.paper && b.paper && *a.paper == *b.paper)) &&
         std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(), same);
}

Result<Document> document_from_mesh(PolygonMesh mesh, std::string name) {
  if (const auto checked = check_name(name); !checked) return checked.error();
  Result<PolyhedronSource> source = PolyhedronSource::from_mesh(std::move(mesh));
  if (!source) return source.error();
  Document document;
  document.objects.push_back(std::make_shared<const Object>(
      Object{document.next_object_id, std::move(name), true, false, {}, {}, *std::move(source), {}}));
  ++document.next_object_id.value;
  return document;
}

Result<Done> check_name(std::string_view name) {
  if (name.find_first_not_of(" \t") == std::string_view::npos)
    return make_error(e_name_empty, "The name is empty.", "Type a name with at least one letter.");
  if (name.size() > Object::max_name_length)
    return make_error(e_name_invalid, "The name is too long.",
                      "Use at most " + std::to_string(Object::max_name_length) + " bytes.");
  if (sanitized_utf8(name) != name)
    return make_error(e_name_invalid, "The name has characters that cannot be shown.",
                      "Remove line breaks, tabs and other control characters.");
  return Done{};
}

}  // namespace hariko
