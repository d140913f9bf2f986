#pragma once

// Faces that lie edge to edge in a file but do not share their edges. Only for this folder.

#include <TopoDS_Shape.hxx>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hariko {

using CadColour = std::optional<std::array<std::uint8_t, 3>>;

/// A shape of a file in its place.
struct CadLeaf {
  TopoDS_Shape shape;
  std::string name;
  CadColour colour;
};

/// Between borders that are sewn, of the diagonal of what is sewn: a tenth of the tolerance of triangles.
inline constexpr double sewing_tolerance = 5e-5;

/// Faces and shells of one leaf that lie edge to edge share their edges, and closed shells become solids that
/// look outward. `loose`: also faces that are leaves of their own, as IGES has them: what can be sewn
/// together becomes one leaf, with the name that its faces have in common but for a number, and all faces
/// that stay alone become one. Leaves keep their order.
std::vector<CadLeaf> sewn(std::vector<CadLeaf> leaves, bool loose);

}  // namespace hariko
