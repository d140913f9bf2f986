#pragma once

// Writer of control meshes of subdivision surfaces, as OBJ files with crease tags.

#include <span>
#include <string>

#include "core/subdivision/control_mesh.hpp"

namespace hariko {

/// Control mesh with its name; borrows the mesh.
struct NamedControlMesh {
  std::string name;
  const ControlMesh* mesh = nullptr;
};

/// OBJ with one `o` for each mesh, positions exact. Creases and corners are written as the tags of
/// OpenSubdiv's files (`t crease 2/1/0 a b sharpness`, `t corner 1/1/0 v sharpness`, vertices counted from 0
/// over all objects); programs that do not know them ignore them. O(size).
std::string write_control_obj(std::span<const NamedControlMesh> meshes);

}  // namespace hariko
