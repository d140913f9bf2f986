#pragma once

// Primitives: the starting polyhedra of a design.

#include <array>

#include "core/base/result.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

inline constexpr Code e_primitive_size{"E_PRIMITIVE_SIZE"};
inline constexpr Code e_primitive_count{"E_PRIMITIVE_COUNT"};

/// `centred`: the bounding box, or where that is more natural the centre of symmetry, is centred at the
/// origin. `on_ground`: the same in x and y, and the lowest vertex at z = 0.
enum class Placement { centred, on_ground };

enum class PlatonicSolid { tetrahedron, cube, octahedron, dodecahedron, icosahedron };

/// Bounds of all lengths below, in the document's unit.
inline constexpr double min_primitive_length = 1e-9, max_primitive_length = 1e9;
/// Largest number of sides that mode FAIR accepts in a face (see `largest_fair_side_count`).
inline constexpr int max_primitive_sides = 128;
inline constexpr int max_box_segments = 64;
inline constexpr int max_grid_segments = 512;
inline constexpr int max_sphere_segments = 64;
inline constexpr int max_icosphere_level = 6;

// Every shape is symmetric bit for bit where it is symmetric (always across x = 0), so that mirrors and
// measurements find equal numbers. Faces are counter-clockwise seen from outside, those of the plane seen
// from above.

struct BoxShape {
  Vector3 size = Vector3::Constant(2);
  std::array<int, 3> segments{1, 1, 1};  ///< quads along x, y, z, 1 .. max_box_segments
  Placement placement = Placement::centred;
};

struct PrismShape {
  int sides = 6;  ///< 3 .. max_primitive_sides
  double radius = 1, height = 2;
  Placement placement = Placement::centred;
};

/// Pyramid: a regular polygon at the foot and an apex above its centre.
struct PyramidShape {
  int sides = 4;  ///< 3 .. max_primitive_sides
  double radius = 1, height = 2;
  Placement placement = Placement::centred;
};

/// Platonic solid with its vertices on the sphere of `radius`. On the ground it rests on a face.
struct PlatonicShape {
  PlatonicSolid solid = PlatonicSolid::icosahedron;
  double radius = 1;
  Placement placement = Placement::centred;
};

/// Torus about the z axis. `ring_radius`, from the axis to the centre of the tube, is larger than
/// `tube_radius`.
struct TorusShape {
  double ring_radius = 1, tube_radius = 0.5;
  int segments = 8;  ///< round the axis, 3 .. max_grid_segments
  int sides = 4;     ///< round the tube, 3 .. max_grid_segments
  Placement placement = Placement::centred;
};

/// Open sheet in the plane z = 0.
struct PlaneShape {
  double width = 2, depth = 2;  ///< along x, along y
  int columns = 2, rows = 2;    ///< quads along x, along y, 1 .. max_grid_segments
};

/// Control cage of a sphere: a cube whose faces have segments^2 quads, projected onto the sphere of `radius`;
/// nearly equal quads, valence 4 except at eight vertices. From two segments on its surface is close to a
/// sphere.
struct SphereCageShape {
  double radius = 1;
  int segments = 2;  ///< 1 .. max_sphere_segments
  Placement placement = Placement::centred;
};

/// Icosahedron whose triangles are subdivided into four `level` times, vertices on the sphere of `radius`.
struct IcosphereShape {
  double radius = 1;
  int level = 1;  ///< 0 .. max_icosphere_level
  Placement placement = Placement::centred;
};

// Errors of all functions: E_PRIMITIVE_SIZE (a length that is not finite, not positive or out of range, a
// tube that would close the torus's hole), E_PRIMITIVE_COUNT (a number of sides, segments or levels out of
// range).
Result<PolygonMesh> make_primitive(const BoxShape& shape);
Result<PolygonMesh> make_primitive(const PrismShape& shape);
Result<PolygonMesh> make_primitive(const PyramidShape& shape);
Result<PolygonMesh> make_primitive(const PlatonicShape& shape);
Result<PolygonMesh> make_primitive(const TorusShape& shape);
Result<PolygonMesh> make_primitive(const PlaneShape& shape);
Result<PolygonMesh> make_primitive(const SphereCageShape& shape);
Result<PolygonMesh> make_primitive(const IcosphereShape& shape);

}  // namespace hariko
