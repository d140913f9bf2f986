#pragma once

// Sewing of faces that lie edge to edge in a file but do not share their edges. Private to this folder.

#include <TopoDS_Shape.hxx>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hariko {

using CadColour = std::optional<std::array<std::uint8_t, 3>>;

/// Shape of a file in its place, with name and colour.
struct CadLeaf {
  TopoDS_Shape shape;
  std::string name;
  CadColour colour;
  bool visible = true;
};

/// Largest gap between sewn borders, relative to the diagonal of the shape: a tenth of the tolerance of
/// triangles.
inline constexpr double sewing_tolerance = 5e-5;

/// Leaves with faces and shells that lie edge to edge sewn along them; closed shells become solids that look
/// outward. `loose`: also sews faces that are leaves of their own, as in IGES: sewn faces become a leaf
/// for each body, with their common name up to a number, and all faces that remain single become another. A
/// leaf has the colour of the first of its own faces that has one. Visible and hidden faces are not sewn
/// together. Leaves keep their order.
std::vector<CadLeaf> sewn(std::vector<CadLeaf> leaves, bool loose);

}  // namespace hariko
