#pragma once

// Helpers of the exchange tests.

#include <gtest/gtest.h>

#include <string>

#include "core/exchange/imported_mesh.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko::test {

/// Code and line of what a reader answered: "E_PARSE 3", "E_EMPTY 0" without a line, or "ok".
inline std::string outcome(const Result<ImportedMesh>& result) {
  if (result.ok()) return "ok";
  const Message& error = result.error();
  EXPECT_FALSE(error.text.empty());
  EXPECT_FALSE(error.remedy.empty());
  EXPECT_EQ(error.severity, Severity::error);
  const bool has_line = error.element.kind == Element::Kind::line;
  if (has_line) {
    EXPECT_TRUE(error.text.starts_with("Line " + std::to_string(error.element.id))) << error.text;
  }
  return std::string(error.code.name) + " " + std::to_string(has_line ? error.element.id : 0);
}

/// Expects what every reader promises about a mesh it returns.
inline void expect_sound(const PolygonMesh& mesh) {
  ASSERT_FALSE(mesh.face_offsets.empty());
  EXPECT_EQ(mesh.face_offsets.front(), 0U);
  EXPECT_EQ(mesh.face_offsets.back(), mesh.face_vertices.size());
  EXPECT_GT(mesh.face_count(), 0U);
  for (const Index v : mesh.face_vertices) ASSERT_LT(v, mesh.positions.size());
  for (const Vector3& p : mesh.positions) ASSERT_TRUE(p.allFinite());
}

/// Any polygons: 3 to 9 corners, also 300, over random positions of very different sizes.
inline PolygonMesh random_polygons(std::mt19937_64& rng, bool long_face = false) {
  PolygonMesh mesh;
  const double scale = std::pow(10.0, uniform(rng, -9, 9));
  const int vertex_count = uniform_int(rng, 9, 60);
  for (int i = 0; i < vertex_count; ++i) mesh.positions.push_back(random_vector(rng, scale));
  const int face_count = uniform_int(rng, 1, 60);
  for (int f = 0; f < face_count; ++f) {
    std::vector<Index> corners(static_cast<std::size_t>(long_face && f == 0 ? 300 : uniform_int(rng, 3, 9)));
    for (Index& corner : corners) corner = static_cast<Index>(uniform_int(rng, 0, vertex_count - 1));
    mesh.add_face(corners);
  }
  return mesh;
}

inline void expect_same(const PolygonMesh& a, const PolygonMesh& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.face_offsets, b.face_offsets);
  EXPECT_EQ(a.face_vertices, b.face_vertices);
}

/// The text with one part of it exchanged for another.
inline std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

}  // namespace hariko::test
