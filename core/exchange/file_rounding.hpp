#pragma once

// The rounding of a mesh by the numbers of a file: some formats hold fewer digits than a double has.

#include <Eigen/Geometry>
#include <cstddef>
#include <string_view>

#include "core/base/message.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// A promised distance or angle is broken, or facets are ruined, by the digits of a format.
inline constexpr Code e_file_digits{"E_FILE_DIGITS"};
/// Coordinates that are rounded coarsely, or facets too small for the format, which are left out.
inline constexpr Code w_file_digits{"W_FILE_DIGITS"};

/// How a format holds coordinates.
struct FileNumbers {
  enum class Kind {
    exact,         ///< as doubles, or text that reads back as the same: OBJ, OFF, PLY, 3MF
    floats,        ///< absolute floats: STL, as text too
    local_floats,  ///< floats about a point of each mesh, which is a double: glTF
  };
  Kind kind = Kind::exact;
  double scale = 1;  ///< the file's number of a length 1

  double rounded(double value) const {
    return kind == Kind::exact ? value : static_cast<double>(static_cast<float>(scale * value)) / scale;
  }
};

struct FileRounding {
  double distance = 0;        ///< farthest that a vertex moves, in the unit of the mesh
  double turn = 0;            ///< largest angle that a facet turns by, radians; collapsed ones apart
  std::size_t collapsed = 0;  ///< facets with an area that have none any more
  std::size_t left_out = 0;   ///< those of them that two corners of become the same, which are not written
  double size = 0;            ///< diagonal of the mesh's box
};

/// Takes all vertices that facets have. O(size).
FileRounding rounding_of(const TriangleMesh& mesh, const FileNumbers& numbers);
FileRounding rounding_of(const PolygonMesh& mesh, const FileNumbers& numbers);

/// The mesh without facets two corners of which the numbers make the same although they are not: neighbours
/// meet where they were, so what is closed stays closed. O(size).
TriangleMesh without_collapsed(const TriangleMesh& mesh, const FileNumbers& numbers);

/// The farthest that any point of the box can move; for local floats any point of a mesh that is as large.
double largest_rounding(const Eigen::AlignedBox3d& box, const FileNumbers& numbers);

/// The format's digits are too few: the distance is above `allowed`, or above 1e-4 of the size where nothing
/// is, or facets collapse although the vertices are not just smaller than what floats tell apart (1e-6 of the
/// size). `name`: of the mesh.
bool ruins(const FileRounding& rounding, const double* allowed);
Message digits_error(const FileRounding& rounding, std::string_view name);
/// The format's digits turn facets by more than a promised angle leaves.
Message turn_error(const FileRounding& rounding, std::string_view name);
/// W_FILE_DIGITS where facets collapse or, with `allowed` not given, vertices move by more than 1e-6 of the
/// size; nothing else.
bool coarse(const FileRounding& rounding, const double* allowed);
Message digits_warning(const FileRounding& rounding, std::string_view name);

}  // namespace hariko
