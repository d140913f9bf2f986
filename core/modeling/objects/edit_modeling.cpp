#include "core/modeling/objects/edit_modeling.hpp"

#include <utility>

#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_support.hpp"

namespace hariko {

Result<ModeledDocument> edit_polyhedron(
    const Document& document, ObjectId id,
    const std::function<Result<EditResult>(const PolyhedronSource&)>& operation) {
  ElementSet selection;
  Result<Document> changed = detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    const PolyhedronSource* source = object.polyhedron();
    if (!source)
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" is not a polyhedron.",
                        "Select a polyhedron.", element_of(id));
    Result<EditResult> modeled = operation(*source);
    if (!modeled) return modeled.error();
    EditResult result = std::move(modeled).value();
    selection = std::move(result.selection);
    object.source = std::move(result.source);
    return Done{};
  });
  if (!changed) return changed.error();
  return ModeledDocument{std::move(changed).value(), std::move(selection)};
}

}  // namespace hariko
