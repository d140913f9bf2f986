#pragma once

// Files of the kinds that other programs write, as they came.

#include "core/exchange/mesh_file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko::test {

/// `name` in tests/cases.
inline std::filesystem::path case_file(const std::string& name) {
  return std::filesystem::path(source_folder()) / "tests/cases" / name;
}

/// Least and greatest coordinates of the vertices.
inline Eigen::AlignedBox3d box_of(const PolygonMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& p : mesh.positions) box.extend(p);
  return box;
}

}  // namespace hariko::test
