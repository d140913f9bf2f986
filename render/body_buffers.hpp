#pragma once

// BodyBuffers: the faces of solid bodies with their normals, on the GPU. Internal to render/.

#include <span>
#include <utility>
#include <vector>

#include "render/display_polyhedron.hpp"
#include "render/gl_object.hpp"

namespace hariko::gl {

/// Corners of triangles, face by face. Normals run smoothly over edges between faces that turn a little, so
/// that round bodies look round.
class BodyBuffers {
 public:
  BodyBuffers(const DisplayPolyhedron& bodies, std::size_t& uploaded);
  GLuint array() const { return array_.name(); }
  /// Of the faces from `first` to `last`: the first corner, and the number of corners.
  std::pair<GLint, GLsizei> corners_of(Index first, Index last) const {
    return {first_corner_[first], first_corner_[last + 1] - first_corner_[first]};
  }
  Index face_count() const { return static_cast<Index>(first_corner_.size() - 1); }

 private:
  VertexArray array_;
  Buffer corners_;
  std::vector<GLint> first_corner_;  ///< one a face, and the end
};

/// Unit normals at the corners of all faces, in the order of `face_vertices`: the mean of the normals of the
/// faces at the vertex that turn by less than 25 degrees from the corner's own.
std::vector<Vector3> corner_normals(const DisplayPolyhedron& bodies);

}  // namespace hariko::gl
