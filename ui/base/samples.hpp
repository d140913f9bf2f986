#pragma once

// Samples: models that come with the program, by the ways in which they were made.

#include <imgui.h>

#include <array>
#include <filesystem>
#include <string>

namespace hariko {

/// Ways to begin a model; samples stand under these headings, in this order.
enum class Beginning { polyhedron, solids, sections, outline, other };
inline constexpr std::array beginnings{Beginning::polyhedron, Beginning::solids, Beginning::sections,
                                       Beginning::outline, Beginning::other};

/// A texture, or the upper left part of one.
struct Picture {
  unsigned texture = 0;  ///< name of OpenGL; 0 until it is there
  ImVec2 used{1, 1};     ///< texture coordinates of the part's lower right corner
  float aspect = 1.5F;   ///< width by height
};

struct Sample {
  std::filesystem::path path;
  std::string title, description;  ///< English
  Beginning beginning = Beginning::other;
  bool wanted = false;  ///< its picture was asked for
  Picture picture;
};

}  // namespace hariko
