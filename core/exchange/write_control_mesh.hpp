#pragma once

// Control meshes of subdivision surfaces as OBJ files with creases.

#include <span>
#include <string>

#include "core/skinning/control_mesh.hpp"

namespace hariko {

/// A control mesh and what to call it; borrows the mesh.
struct NamedControlMesh {
  std::string name;
  const ControlMesh* mesh = nullptr;
};

/// OBJ with one `o` for each mesh, positions exact. Creases and corners are the tags that OpenSubdiv's own
/// files use (`t crease 2/1/0 a b sharpness`, `t corner 1/1/0 v sharpness`, vertices counted from 0 over all
/// objects); programs that do not know them leave them out. O(size).
std::string write_control_obj(std::span<const NamedControlMesh> meshes);

}  // namespace hariko
