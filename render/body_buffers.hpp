#pragma once

// BodyBuffers: GPU copy of the faces of solid bodies, with normals. Internal to render/.

#include <span>
#include <utility>
#include <vector>

#include "render/display_polyhedron.hpp"
#include "render/gl_object.hpp"

namespace hariko::gl {

/// Triangle corners, face by face. Normals are smoothed over edges with a small angle, so that round bodies
/// look round.
class BodyBuffers {
 public:
  BodyBuffers(const DisplayPolyhedron& bodies, std::size_t& uploaded);
  GLuint array() const { return array_.name(); }
  /// First corner and number of corners of the faces from `first` to `last`.
  std::pair<GLint, GLsizei> corners_of(Index first, Index last) const {
    return {first_corner_[first], first_corner_[last + 1] - first_corner_[first]};
  }
  Index face_count() const { return static_cast<Index>(first_corner_.size() - 1); }

 private:
  VertexArray array_;
  Buffer corners_;
  std::vector<GLint> first_corner_;  ///< by face, and the end
};

/// Unit normals at the corners of all faces, in the order of `face_vertices`: the mean over those faces at
/// the vertex whose normals differ by less than 25 degrees from the corner's own.
std::vector<Vector3> corner_normals(const DisplayPolyhedron& bodies);

}  // namespace hariko::gl
