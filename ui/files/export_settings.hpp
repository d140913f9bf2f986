#pragma once

// Settings by which surfaces become the triangles or faces of an exported file, and what is known of them
// before it is written.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/text/enum_words.hpp"
#include "core/document/format/cad_choices.hpp"
#include "core/document/format/file_choices.hpp"
#include "core/offset/offset_surface.hpp"

namespace hariko {

struct ExportSettings {
  enum class By { tolerance, density };
  By by = By::tolerance;
  double distance = 0;    ///< largest between surface and triangles, in the document's space; above 0
  double angle = 0;       ///< largest between the normals of both, radians; 0: any
  bool optimise = false;  ///< as few triangles as can be found, which takes long
  int density = 16;       ///< intervals a patch side
  FileChoices choices = {};
  bool only_selected = false;
  Wall wall = {};  ///< distance and thickness of surfaces, in the document's space

  friend bool operator==(const ExportSettings&, const ExportSettings&) = default;
  /// True when both give the same triangles, however their numbers are written.
  bool same_triangles(ExportSettings other) const {
    other.choices = choices;
    return *this == other;
  }
  /// True when also the errors of the numbers are the same in a format that rounds them.
  bool same_digits(ExportSettings other) const {
    other.choices.ascii = choices.ascii;
    return *this == other;
  }
};

template <>
inline constexpr auto enum_words<ExportSettings::By> = all_words<ExportSettings::By>(
    {{ExportSettings::By::tolerance, "tolerance"}, {ExportSettings::By::density, "density"}});

/// Likewise for CAD.
struct CadSettings {
  CadChoices choices;
  bool only_selected = false;
  Wall wall = {};

  friend bool operator==(const CadSettings&, const CadSettings&) = default;
  /// True when both give the same faces, however their numbers are written.
  bool same_faces(const CadSettings& other) const {
    return choices.tolerance == other.choices.tolerance && choices.angle == other.choices.angle &&
           choices.exact == other.choices.exact && choices.whole_faces == other.choices.whole_faces &&
           choices.scale == other.choices.scale && only_selected == other.only_selected && wall == other.wall;
  }
};

/// Totals of an exported file, all objects together.
struct ExportReport {
  std::size_t triangles = 0;
  Vector3 moved = Vector3::Zero();  ///< the point of the file's space that was brought to zero
  std::vector<Message> warnings;
  Vector3 size = Vector3::Zero();  ///< along the axes of the document, in its unit times the scale chosen
  std::uintmax_t bytes = 0;
};

/// Totals found before a file is exported, all objects together.
struct ExportCount {
  std::size_t triangles = 0;
  /// By tolerance only. `certain`: no point is farther off; else samples showed it.
  double distance = 0, angle = 0;
  bool certain = false, reached = true;
  double rounding = 0;  ///< farthest that the file's digits move a vertex, which the distance includes
};

}  // namespace hariko
