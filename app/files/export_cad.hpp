#pragma once

// Export of a document's surfaces as STEP or IGES.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/cad/cad_totals.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/document/format/cad_choices.hpp"
#include "core/offset/offset_surface.hpp"

namespace hariko {

inline constexpr Code w_cad_tolerance{"W_CAD_TOLERANCE"};
inline constexpr Code w_cad_angle{"W_CAD_ANGLE"};
inline constexpr Code w_cad_invalid{"W_CAD_INVALID"};
inline constexpr Code w_cad_names{"W_CAD_NAMES"};

/// Report on one exported object; lengths are the document's, after `scale`.
struct CadObjectReport {
  std::string name;
  std::size_t faces = 0, exact = 0, edges = 0, control_points = 0;
  std::string_view not_exact;  ///< reason why some faces are not exact, where exact ones were requested
  bool closed = false;
  double distance = 0;     ///< largest measured distance between the surface and its faces
  double tolerance = 0;    ///< requested tolerance
  double angle = 0;        ///< requested angle, radians
  double normal_jump = 0;  ///< largest across smooth edges, radians
  bool curvature = false;  ///< the model is meant to have continuous curvature
  /// Largest across the same edges, relative to the curvature there; only with `curvature`.
  double curvature_jump = 0;
  std::size_t unreached = 0;           ///< faces that do not keep the tolerance
  std::vector<Message> warnings = {};  ///< messages of the wall
};

/// Report on an export.
struct CadExportReport {
  std::vector<CadObjectReport> objects;
  CadFileReport file;  ///< lengths in millimetres
  std::uintmax_t bytes = 0;
  Vector3 moved = Vector3::Zero();  ///< point of the file's space that `to_zero` moved to zero
};

/// Writes the surfaces of all visible objects, at quality `final`, atomically. `time` goes into the file's
/// header; `wall` is in the document's space. Errors: those of rebuilding and of `wall_surface` (with the
/// object's name) and of writing, E_NO_SURFACE, E_FILE_DIGITS, E_NO_CAD_KERNEL, E_CAD_KERNEL,
/// E_FORMAT_UNKNOWN, E_CANCELLED; the file is then unchanged.
Result<CadExportReport> export_cad(const Document& document, const std::filesystem::path& path,
                                   const CadChoices& settings, const std::string& time,
                                   const CancelToken& cancel = {}, const Progress& progress = {},
                                   const Wall& wall = {});

/// Totals over all objects; lengths are the document's, after `scale`.
CadTotals totals(std::span<const CadObjectReport> objects);

/// Totals of what `export_cad` would write, without OpenCASCADE. Takes nearly as long. Errors: those of
/// rebuilding, E_NO_SURFACE, E_CANCELLED.
Result<CadTotals> count_cad(const Document& document, const CadChoices& choices,
                            const CancelToken& cancel = {}, const Wall& wall = {});

/// Warnings of an export: those of the wall; W_CAD_TOLERANCE and W_CAD_ANGLE for objects with faces that do
/// not keep the tolerance or the angle; W_CAD_INVALID where the kernel finds faults; W_CAD_NAMES where names
/// lost letters.
std::vector<Message> warnings_of(const CadExportReport& report);

/// Local time in the form of file headers: 2026-11-22T12:00:00.
std::string header_time();

}  // namespace hariko
