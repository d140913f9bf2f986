#pragma once

// STEP and IGES files, written by OpenCASCADE where the program was built with it.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/cad/cad_model.hpp"

namespace hariko {

inline constexpr Code e_no_cad_kernel{"E_NO_CAD_KERNEL"};
inline constexpr Code e_cad_kernel{"E_CAD_KERNEL"};

/// Formats of CAD files.
enum class CadFormat { step_ap214, step_ap242, iges };
/// Format by the ending .step, .stp, .iges or .igs in any case; STEP is AP214. Nothing for other endings.
std::optional<CadFormat> cad_format_of(const std::filesystem::path& path);
/// Endings of CAD files as they appear in sentences.
inline constexpr std::string_view cad_endings = ".step, .stp, .iges or .igs";

/// E_NO_CAD_KERNEL where the program was built without OpenCASCADE; nothing where files can be written.
std::optional<Message> why_no_cad_files();

/// Units of length of CAD files.
enum class CadUnit { millimetre, centimetre, metre, inch };

/// Named and coloured object to be written.
struct CadObject {
  std::string name;                                   ///< UTF-8
  const CadModel* model = nullptr;                    ///< in millimetres
  std::array<std::uint8_t, 3> colour{185, 180, 172};  ///< sRGB
};

/// Format, unit and time stamp of a file.
struct CadFileOptions {
  CadFormat format = CadFormat::step_ap214;
  CadUnit unit = CadUnit::millimetre;  ///< unit of the file; models are in millimetres
  /// Time stamp of the header, as 2026-11-22T12:00:00; a parameter, so that the same input and time give the
  /// same bytes.
  std::string time = "1970-01-01T00:00:00";
};

/// Statistics and verdict of the kernel on a model.
struct CadFileReport {
  std::size_t solids = 0, open_shells = 0, faces = 0;
  std::size_t voids = 0;      ///< hollow spaces in the solids
  bool valid = false;         ///< BRepCheck_Analyzer finds no fault
  double edge_tolerance = 0;  ///< largest tolerance of an edge, millimetres
  /// Objects whose names lost letters, as IGES has ASCII only.
  std::size_t changed_names = 0;
};

/// Bytes of a CAD file with its report.
struct CadFile {
  std::string bytes;
  CadFileReport report;
};

/// STEP or IGES file of objects. Each object becomes a part with its name and colour: one solid for each
/// closed shell that is no void of another (`cad_shells`), with its voids, and its open shells. Errors:
/// E_NO_CAD_KERNEL, E_CAD_KERNEL (with the object's name and the kernel's own message), E_CANCELLED. Calls
/// are serialised, as the kernel keeps its settings for the whole process.
Result<CadFile> make_cad_file(std::span<const CadObject> objects, const CadFileOptions& options,
                              const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko
