#pragma once

// LiveCopies: one source at many places. The arrays that describe the places are values of the document, not
// copies of geometry; `core/document/edits/edit_copies.hpp` makes them and turns them into objects.

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/similarity.hpp"

namespace hariko {

struct Object;

inline constexpr Code e_copies_invalid{"E_COPIES_INVALID"};

/// Least and largest number of places of an array, and largest number of places of an object, its own
/// included.
inline constexpr int least_places = 2, most_places = 10000;

/// Row: place k is k steps from the first.
struct RowOfCopies {
  int count = least_places;  ///< number of places, the first included
  Vector3 step = Vector3::UnitX();
  friend bool operator==(const RowOfCopies&, const RowOfCopies&) = default;
};

/// Ring: places are turned about an axis by equal angles, right-handed. A full turn (`degrees` 360 or -360)
/// spaces all of them evenly round; of a smaller angle the first and the last stand at both ends.
struct RingOfCopies {
  int count = least_places;
  Vector3 point = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();  ///< any length but zero
  double degrees = 360;
  friend bool operator==(const RingOfCopies&, const RingOfCopies&) = default;
};

/// Mirror: what stands there, and its mirror image on the other side of a plane.
struct MirrorOfCopies {
  Vector3 point = Vector3::Zero();    ///< a point of the plane
  Vector3 normal = Vector3::UnitX();  ///< any length but zero
  friend bool operator==(const MirrorOfCopies&, const MirrorOfCopies&) = default;
};

/// Places behind the first, each by its own motion, such as those along a curve.
struct ListOfCopies {
  std::vector<Similarity> places;  ///< scale 1
  friend bool operator==(const ListOfCopies&, const ListOfCopies&) = default;
};

using CopyArray = std::variant<RowOfCopies, RingOfCopies, ListOfCopies, MirrorOfCopies>;
/// Arrays of an object, the inner ones first: each repeats what those before it give, so that a row of a row
/// is a grid. Empty: the object stands at its own place alone.
using LiveCopies = std::vector<CopyArray>;

/// Checks arrays. E_COPIES_INVALID: a count out of its range, a step, axis, normal or angle that is zero or
/// not finite, an angle beyond a full turn, a place that is scaled, or more than most_places places.
Result<Done> check_copies(const LiveCopies& copies);

/// Number of places of an object, its own included. O(arrays).
std::size_t place_count(const Object& object);
/// Transforms of all places, the object's own first; those of mirror images have a negative scale
/// (`Similarity::mirrors`). O(places).
std::vector<Similarity> places_of(const Object& object);
/// Name of what a file holds of one place: "Cup", "Cup (2)", "Cup (3)".
std::string name_of_place(const Object& object, std::size_t place);

/// The same array in the space of an object that stands at `place`.
CopyArray in_space_of(const CopyArray& array, const Similarity& place);
/// Arrays of an object whose source is changed by a linear map of its own space, which takes their places
/// along. A map that turns or reflects is followed exactly. Of one that stretches, rows are followed exactly;
/// rings stay rings round the mapped axis, mirrors stay mirrors in the mapped plane, and the turns of lists
/// stay turns.
LiveCopies mapped(const LiveCopies& copies, const Matrix3& linear);

}  // namespace hariko
