#include "core/document/making.hpp"

namespace hariko {

Result<Done> check_making(const MakingSettings& making) {
  // Within these bounds directions are computed without overflow.
  const double length = making.pull.cwiseAbs().maxCoeff();
  if (!making.pull.allFinite() || !(length > 1e-100 && length < 1e100))
    return make_error(e_making_invalid, "The pull has no direction.",
                      "Choose an axis or the direction of the view.");
  if (!(making.draft >= 0 && making.draft <= MakingSettings::max_draft))
    return make_error(e_making_invalid, "The least draft is out of range.", "Use 0 to 89 degrees.");
  for (const double least : {making.radius, making.thickness})
    if (!(least >= MakingSettings::min_length && least <= MakingSettings::max_length))
      return make_error(e_making_invalid, "The least radius or thickness is out of range.",
                        "Use a length above 0.");
  return Done{};
}

bool is_of_making(SurfaceMap map) {
  return has_limit(map) || map == SurfaceMap::deviation;
}

bool has_limit(SurfaceMap map) {
  return map == SurfaceMap::draft || map == SurfaceMap::radius || map == SurfaceMap::thickness;
}

double limit_of(const MakingSettings& making, SurfaceMap map, double millimetres_per_unit) {
  switch (map) {
    case SurfaceMap::draft:
      return making.draft;
    case SurfaceMap::radius:
      return making.radius / millimetres_per_unit;
    case SurfaceMap::thickness:
      return making.thickness / millimetres_per_unit;
    default:
      return 0;
  }
}

}  // namespace hariko
