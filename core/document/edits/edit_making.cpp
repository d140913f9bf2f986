#include "core/document/edits/edit_making.hpp"

namespace hariko {

Result<Document> set_making(const Document& document, const MakingSettings& making) {
  if (const auto checked = check_making(making); !checked) return checked.error();
  Document changed = document;
  changed.making = making;
  return changed;
}

double limit_of(const Document& document, SurfaceMap map) {
  return limit_of(document.making, map, millimetres_per(document.unit));
}

}  // namespace hariko
