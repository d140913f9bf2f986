#pragma once

// Rounding of a mesh by file formats that hold fewer digits than a double.

#include <Eigen/Geometry>
#include <cstddef>
#include <string_view>

#include "core/base/message.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// Rounding that breaks a promised distance or angle, or ruins facets.
inline constexpr Code e_file_digits{"E_FILE_DIGITS"};
/// Coarsely rounded coordinates, or facets too small for the format, which are left out.
inline constexpr Code w_file_digits{"W_FILE_DIGITS"};

/// Precision of coordinates in a format.
struct FileNumbers {
  enum class Kind {
    exact,         ///< doubles, or text that reads back as the same doubles: OBJ, OFF, PLY, 3MF
    floats,        ///< absolute floats: STL, also as text
    local_floats,  ///< floats relative to a point of each mesh that is stored in double precision: glTF
  };
  Kind kind = Kind::exact;
  double scale = 1;  ///< number in the file for a length of 1

  /// Value after it was written and read back.
  double rounded(double value) const {
    return kind == Kind::exact ? value : static_cast<double>(static_cast<float>(scale * value)) / scale;
  }
};

/// Effect of rounding on a mesh.
struct FileRounding {
  double distance = 0;        ///< largest displacement of a vertex, in the unit of the mesh
  double turn = 0;            ///< largest rotation of a facet, radians; collapsed facets not counted
  std::size_t collapsed = 0;  ///< facets with an area that lose it
  std::size_t left_out = 0;   ///< collapsed facets with two corners that become equal; these are not written
  double size = 0;            ///< diagonal of the mesh's box
};

/// Effect of a format's rounding on all vertices and facets of a mesh. O(size).
FileRounding rounding_of(const TriangleMesh& mesh, const FileNumbers& numbers);
FileRounding rounding_of(const PolygonMesh& mesh, const FileNumbers& numbers);

/// Mesh without the facets two different corners of which the rounding makes equal. Their neighbours stay
/// joined, so a closed mesh stays closed. O(size).
TriangleMesh without_collapsed(const TriangleMesh& mesh, const FileNumbers& numbers);

/// Largest displacement of any point of the box; for local floats, of any point of a mesh of that size.
double largest_rounding(const Eigen::AlignedBox3d& box, const FileNumbers& numbers);

/// Whether rounding ruins a mesh: the displacement exceeds `allowed` (null: 1e-4 of the size), or facets
/// collapse and the displacement exceeds 1e-6 of the size, so that it is not merely facets below float
/// resolution that do.
bool ruins(const FileRounding& rounding, const double* allowed);
/// E_FILE_DIGITS for a mesh, called `name`, that `ruins` rejects.
Message digits_error(const FileRounding& rounding, std::string_view name);
/// E_FILE_DIGITS where rounding rotates facets by more than a promised angle leaves.
Message turn_error(const FileRounding& rounding, std::string_view name);
/// Whether rounding deserves a warning: facets collapse or, where `allowed` is null, vertices move by more
/// than 1e-6 of the size.
bool coarse(const FileRounding& rounding, const double* allowed);
/// W_FILE_DIGITS for a mesh that `coarse` notices.
Message digits_warning(const FileRounding& rounding, std::string_view name);

}  // namespace hariko
