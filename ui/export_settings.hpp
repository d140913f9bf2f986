#pragma once

// How surfaces become the triangles of an exported file, and what is known of them before it is written.

#include <cstddef>

namespace hariko {

struct ExportSettings {
  enum class By { tolerance, density };
  By by = By::tolerance;
  double distance = 0;    ///< largest between surface and triangles, in the document's space; above 0
  double angle = 0;       ///< largest between the normals of both, radians; 0: any
  bool optimise = false;  ///< as few triangles as can be found, which takes long
  int density = 16;       ///< intervals a patch side

  friend bool operator==(const ExportSettings&, const ExportSettings&) = default;
};

/// Of all objects together.
struct ExportCount {
  std::size_t triangles = 0;
  /// By tolerance only. `certain`: no point is farther off; else samples showed it.
  double distance = 0, angle = 0;
  bool certain = false, reached = true;
};

}  // namespace hariko
