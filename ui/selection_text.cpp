#include "ui/selection_text.hpp"

namespace hariko {

std::string describe_in(const Object* object, const ElementSelection& selection, const Language& tr) {
  const std::size_t count = selection.vertices.size();
  if (!object || !object->solids() || count == 0) return describe(selection, tr);
  return count == 1 ? std::string(tr("1 solid")) : fill(tr("{0} solids"), {std::to_string(count)});
}

}  // namespace hariko
