#include "core/document/edits/edit_skin.hpp"

#include "core/document/edits/edit_support.hpp"

namespace hariko {

Result<Document> set_skin(const Document& document, ObjectId object, const Skin& skin) {
  return detail::change_object(document, object, true, [&](Object& changed) -> Result<Done> {
    auto* source = std::get_if<SkinSource>(&changed.source);
    if (!source)
      return make_error(e_not_a_skin, "The object is no skin.", "Select a skin.", element_of(object));
    if (!(*source->skin == skin)) source->skin = skin;
    return Done{};
  });
}

}  // namespace hariko
