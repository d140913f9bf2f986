#pragma once

// Contents of STEP and IGES files, read by OpenCASCADE where the program was built with it.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/bezier_patch.hpp"

namespace hariko {

inline constexpr Code e_cad_read{"E_CAD_READ"};
inline constexpr Code w_cad_patches{"W_CAD_PATCHES"};
inline constexpr Code w_cad_faces{"W_CAD_FACES"};
inline constexpr Code w_cad_mixed{"W_CAD_MIXED"};
inline constexpr Code w_cad_mark{"W_CAD_MARK"};          ///< a byte order mark before the file
inline constexpr Code w_cad_behind{"W_CAD_BEHIND"};      ///< text behind the file's end
inline constexpr Code w_cad_counts{"W_CAD_COUNTS"};      ///< wrong counts of lines in the last line of IGES
inline constexpr Code w_cad_letters{"W_CAD_LETTERS"};    ///< letters in an unknown encoding
inline constexpr Code w_cad_unit{"W_CAD_UNIT"};          ///< lengths without a unit
inline constexpr Code w_cad_placed{"W_CAD_PLACED"};      ///< a scale or mirroring that is not applied
inline constexpr Code w_cad_left_out{"W_CAD_LEFT_OUT"};  ///< curves and points
inline constexpr Code w_cad_tessellated{"W_CAD_TESSELLATED"};  ///< bodies of triangles in STEP

/// Tolerances of the triangles, and the choice of patches.
struct CadReadOptions {
  double tolerance = 0;  ///< chordal deviation from a face, mm; 0: `usual_cad_mesh_tolerance` of its part
  double angle = 0.2;   ///< angular deviation of the triangles' chords from the curves that they cut, radians
  bool patches = true;  ///< false: all faces become triangles
  std::optional<CadFormat> format = {};  ///< nothing: that of the file's ending
};
inline constexpr double usual_cad_mesh_tolerance = 5e-4;  ///< relative to the part's diagonal
/// Limits of a CAD file, above which reading gives E_LIMIT.
inline constexpr std::uint64_t max_cad_file_bytes = std::uint64_t{1} << 29;
inline constexpr std::size_t max_cad_parts = 10'000;
/// Limit of the patches of a file, the same as of one object; above it everything becomes triangles.
inline constexpr std::size_t max_cad_patches = 100'000;
inline constexpr std::size_t max_cad_triangles = 20'000'000;

/// Part of a CAD file. Every face is in `patches` or in `mesh`; positions in millimetres, absolute.
struct CadPart {
  std::string name;                                   ///< printable; empty where the file gives none
  std::optional<std::array<std::uint8_t, 3>> colour;  ///< sRGB
  std::vector<BezierPatch> patches;                   ///< exact patches of faces that are whole splines
  PolygonMesh mesh;                                   ///< triangles of all other faces, joined at their edges
  /// Patches of spline faces that are triangulated in `mesh`: they share edges with faces of other kinds, and
  /// a body that is closed in the file stays one closed mesh.
  std::vector<BezierPatch> also_exact = {};
  bool visible = true;  ///< false where the file hides the part
};

/// Parts and warnings of a CAD file.
struct CadScene {
  std::vector<CadPart> parts;  ///< at least one, none of them empty
  std::vector<Message> warnings;
};

/// Reads a CAD file; without a given format its ending (asserted to be one) gives it. Parts of assemblies are
/// placed. A face becomes patches where its surface is a spline of a degree that patches have and its border
/// runs along the sides of a parameter rectangle. Where it is connected to faces of other kinds it becomes
/// triangles with them, and `also_exact` has its patches (W_CAD_MIXED counts such faces). Errors: those of
/// `read_file`, E_NO_CAD_KERNEL, E_CAD_READ (no such file, truncated, or the kernel's message), E_LIMIT,
/// E_CANCELLED. Warnings: W_CAD_FACES for faces that could not be triangulated, W_CAD_PATCHES for too many
/// patches, W_CAD_LEFT_OUT and W_CAD_TESSELLATED (which count what is not read), W_CAD_UNIT, W_CAD_PLACED,
/// and those of `step_text_of`. Calls are serialised, together with those of make_cad_file.
Result<CadScene> read_cad_file(const std::filesystem::path& path, const CadReadOptions& options = {},
                               const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko
