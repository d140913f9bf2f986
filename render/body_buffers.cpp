#include "render/body_buffers.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/geometry/polygon.hpp"

namespace hariko::gl {

namespace {

Vector3 area_of(const DisplayPolyhedron& bodies, Index f) {
  const auto corners = bodies.face(f);
  return newell_normal(corners.size(), [&](std::size_t i) { return bodies.position(corners[i]); });
}

}  // namespace

std::vector<Vector3> corner_normals(const DisplayPolyhedron& bodies) {
  const double least_cosine = std::cos(25 * std::numbers::pi / 180);
  std::vector<Vector3> areas, units;
  std::vector<std::vector<Index>> faces_at(bodies.positions.size());
  for (Index f = 0; f < bodies.face_count(); ++f) {
    areas.push_back(area_of(bodies, f));
    units.push_back(areas.back().stableNormalized());
    for (const Index v : bodies.face(f)) faces_at[v].push_back(f);
  }
  std::vector<Vector3> out;
  out.reserve(bodies.face_vertices.size());
  for (Index f = 0; f < bodies.face_count(); ++f)
    for (const Index v : bodies.face(f)) {
      Vector3 sum = Vector3::Zero();
      for (const Index other : faces_at[v])
        if (units[other].dot(units[f]) >= least_cosine) sum += areas[other];
      out.push_back(sum.stableNormalized());
    }
  return out;
}

BodyBuffers::BodyBuffers(const DisplayPolyhedron& bodies, std::size_t& uploaded) {
  using Corner = std::array<float, 6>;
  std::vector<Corner> corners;
  const std::vector<Vector3> normals = corner_normals(bodies);
  const auto corner = [&](std::size_t at) -> Corner {
    const auto& p = bodies.positions[bodies.face_vertices[at]];
    const Vector3& n = normals[at];
    return {
        p[0], p[1], p[2], static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())};
  };
  first_corner_.push_back(0);
  for (std::size_t f = 0; f < bodies.face_count(); ++f) {
    const std::size_t from = bodies.face_offsets[f], to = bodies.face_offsets[f + 1];
    for (std::size_t i = from + 1; i + 1 < to; ++i)
      for (const std::size_t at : {from, i, i + 1}) corners.push_back(corner(at));
    first_corner_.push_back(static_cast<GLint>(corners.size()));
  }
  array_ = VertexArray::make();
  corners_ = Buffer::make();
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  const std::size_t bytes = corners.size() * sizeof(Corner);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), corners.data(), GL_STATIC_DRAW);
  for (GLuint attribute = 0; attribute < 2; ++attribute) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Corner),
                          byte_offset(attribute * 3 * sizeof(float)));
  }
  glBindVertexArray(0);
  uploaded += bytes;
}

}  // namespace hariko::gl
