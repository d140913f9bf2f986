#pragma once

// MakingSettings: how a part is going to be made, which the maps of making check it against. A choice of the
// designer, hence part of the document.

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/document/display.hpp"

namespace hariko {

inline constexpr Code e_making_invalid{"E_MAKING_INVALID"};

/// Limits of a way of making, and what is compared. Invariants (checked by `set_making` and the file reader):
/// `pull` is finite and 1e-100 .. 1e100 long, `draft` is 0 .. max_draft, lengths are min_length ..
/// max_length.
struct MakingSettings {
  /// Direction in which the part leaves its mould, in the document's space; of any length.
  Vector3 pull = Vector3::UnitZ();
  double draft = 3;      ///< least angle between walls and pull, degrees
  double radius = 3;     ///< the tool's, millimetres: less than that it cannot follow
  double thickness = 2;  ///< least thickness of walls, millimetres
  /// Object that the others deviate from; it need not exist. The default is none.
  ObjectId reference;

  static constexpr double max_draft = 89, min_length = 1e-9, max_length = 1e9;
  friend bool operator==(const MakingSettings&, const MakingSettings&) = default;
};

/// Checks the invariants. Errors: E_MAKING_INVALID.
Result<Done> check_making(const MakingSettings& making);

/// Whether a map is one of making: draft, smallest radius, wall thickness, deviation. Their values are those
/// of the document's space, whatever an object's scale, and depend on more than the surface.
bool is_of_making(SurfaceMap map);
/// Whether a map has a limit: values below it are faults.
bool has_limit(SurfaceMap map);
/// Limit of a map, degrees or a length in the unit that is so many millimetres long; 0 for maps without one.
double limit_of(const MakingSettings& making, SurfaceMap map, double millimetres_per_unit);

}  // namespace hariko
