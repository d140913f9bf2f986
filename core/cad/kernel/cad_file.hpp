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

enum class CadFormat { step_ap214, step_ap242, iges };
/// Of .step, .stp, .iges and .igs, whatever their case; STEP is AP214.
std::optional<CadFormat> cad_format_of(const std::filesystem::path& path);
/// The endings, as they stand in sentences.
inline constexpr std::string_view cad_endings = ".step, .stp, .iges or .igs";

/// E_NO_CAD_KERNEL where the program was built without OpenCASCADE; nothing where files can be written.
std::optional<Message> why_no_cad_files();

enum class CadUnit { millimetre, centimetre, metre, inch };

struct CadObject {
  std::string name;                                   ///< UTF-8
  const CadModel* model = nullptr;                    ///< in millimetres
  std::array<std::uint8_t, 3> colour{185, 180, 172};  ///< sRGB
};

struct CadFileOptions {
  CadFormat format = CadFormat::step_ap214;
  CadUnit unit = CadUnit::millimetre;  ///< that the file is written in
  /// When the file was made, as 2026-11-22T12:00:00: a part of the header, so that the same input and time
  /// give the same bytes.
  std::string time = "1970-01-01T00:00:00";
};

/// What the kernel says of what it was given.
struct CadFileReport {
  std::size_t solids = 0, open_shells = 0, faces = 0;
  bool valid = false;         ///< BRepCheck_Analyzer finds nothing wrong
  double edge_tolerance = 0;  ///< the largest, millimetres
  /// Objects whose names lost letters: IGES has those of ASCII only.
  std::size_t changed_names = 0;
};

struct CadFile {
  std::string bytes;
  CadFileReport report;
};

/// Each object becomes a part with its name and colour: solids of its closed shells, and its open shells.
/// Errors: E_NO_CAD_KERNEL, E_CAD_KERNEL (with what the kernel says), E_CANCELLED. Calls wait for each other:
/// the kernel keeps its settings for the whole process.
Result<CadFile> make_cad_file(std::span<const CadObject> objects, const CadFileOptions& options,
                              const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko
