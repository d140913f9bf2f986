#pragma once

// GPU copies of display meshes and polyhedra. Internal to render/.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "render/display_mesh.hpp"
#include "render/display_polyhedron.hpp"
#include "render/gl_object.hpp"
#include "render/surface_lines.hpp"

namespace hariko::gl {

/// Buffer with a buffer texture, so that vertex shaders can read any element.
struct TexturedBuffer {
  Buffer buffer;
  Texture texture;
  std::size_t bytes = 0;
  /// Allocates and fills the buffer; `data` may be null.
  void allocate(std::size_t size, const void* data, GLenum format, GLenum usage);
  /// Binds the buffer texture to a texture unit.
  void bind_texture(int unit) const;
};

/// Element of a value buffer. An undefined value has defined = 0 and the mean of its defined neighbours as
/// value, so that shaders can draw the grey spot of an undefined corner at a fixed size on the screen instead
/// of whole triangles.
struct MapPoint {
  float value = 0, defined = 0;
};

/// Sets up the bound vertex array for line instances: points from `segments`, values from `values` unless it
/// is 0.
void set_up_line_instances(GLuint segments, GLuint values);

/// Line segments, drawn as instances.
class LineInstances {
 public:
  /// Uploads segments, and two values for each unless there are none. Leaves no vertex array bound.
  void upload(std::span<const CurveSegment> segments, std::span<const MapPoint> values,
              std::size_t& uploaded);
  GLuint array() const { return array_.name(); }
  GLsizei count() const { return count_; }

 private:
  VertexArray array_;
  Buffer segments_, values_;
  GLsizei count_ = 0;
};

/// Triangle indices of patch blocks on one grid; shared by meshes of the same pattern.
struct PatchIndices {
  Buffer buffer;
  GLsizei count = 0;
  TexturedBuffer places;  ///< positions of a patch's grid points, in intervals: two floats each
};

/// Cache of index buffers by pattern and number of patches.
class IndexCache {
 public:
  /// Indices for this many patches on a grid; uploaded where they are not in use already.
  std::shared_ptr<const PatchIndices> get(const GridPattern& pattern, Index patch_count,
                                          std::size_t& uploaded);

 private:
  std::map<std::tuple<Domain, int, Index>, std::weak_ptr<const PatchIndices>> entries_;
};

/// GPU copy of a display mesh. Refreshed versions upload only the chunks that differ.
class MeshBuffers {
 public:
  MeshBuffers(const DisplayMesh& mesh, IndexCache& indices, std::size_t& uploaded);
  /// Updates the copy to `mesh`, which must have the same adjacency and pattern.
  void update(const DisplayMesh& mesh, std::size_t& uploaded);
  /// Sets the colours of the patches, with highlights in alpha; uploads only when they changed.
  void set_patch_colors(std::vector<std::uint8_t> rgba, std::size_t& uploaded);

  void bind_vertex_array() const { glBindVertexArray(vertex_array_.name()); }
  GLsizei index_count() const { return indices_->count; }
  const TexturedBuffer& grid_places() const { return indices_->places; }
  const TexturedBuffer& vertices() const { return vertices_; }
  const TexturedBuffer& patch_colors() const { return patch_colors_; }
  /// Instanced vertex array over the segments of one kind of curves.
  GLuint curve_array(CurveKind kind) const { return curves_[std::size_t(kind)].array(); }
  /// Number of segments of one kind of curves.
  GLsizei curve_count(CurveKind kind) const { return curves_[std::size_t(kind)].count(); }
  bool has_curve_values() const { return has_curve_values_; }

 private:
  void upload_run(const DisplayMesh& mesh, std::size_t begin, std::size_t end, std::size_t& uploaded);
  void upload_curves(const DisplayMesh& mesh, std::size_t& uploaded);

  VertexArray vertex_array_;
  TexturedBuffer vertices_, patch_colors_;
  Buffer values_;
  std::vector<std::vector<int>> neighbours_;  // neighbours of each grid point, to fill in undefined values
  std::shared_ptr<const PatchIndices> indices_;
  /// Uploaded chunks, kept so that addresses stay unique.
  std::vector<std::shared_ptr<const DisplayMesh::Chunk>> chunks_;
  std::vector<std::uint8_t> color_bytes_;
  std::array<LineInstances, curve_kind_count> curves_;
  std::shared_ptr<const std::vector<float>> seam_values_;
  bool has_curve_values_ = false;
};

/// GPU copy of a polyhedron: positions, and edges sorted by kind.
class PolyhedronBuffers {
 public:
  PolyhedronBuffers(const DisplayPolyhedron& polyhedron, std::size_t& uploaded);
  const TexturedBuffer& positions() const { return positions_; }
  GLuint edge_array(EdgeKind kind) const { return edges_[std::size_t(kind)].array(); }
  GLsizei edge_count(EdgeKind kind) const { return edges_[std::size_t(kind)].count(); }
  GLsizei point_count() const { return point_count_; }
  /// Whether any edge, or any vertex, has a tension other than the default: edge arrays then carry
  /// `tension_fraction`, and `point_colors` the vertices' colours with alpha 0 for the default.
  bool has_edge_tensions() const { return has_edge_tensions_; }
  bool has_point_tensions() const { return has_point_tensions_; }
  const TexturedBuffer& point_colors() const { return point_colors_; }

 private:
  void upload_point_colors(const DisplayPolyhedron& polyhedron, std::size_t& uploaded);

  TexturedBuffer positions_, point_colors_;
  bool has_edge_tensions_ = false, has_point_tensions_ = false;
  std::array<LineInstances, edge_kind_count> edges_;
  GLsizei point_count_ = 0;
};

/// GPU copy of continuity marks; coordinates are those of the mesh.
class MarkBuffers {
 public:
  MarkBuffers(const EdgeMarks& marks, std::size_t& uploaded);
  GLuint array(std::size_t mark) const { return lines_[mark].array(); }
  GLsizei count(std::size_t mark) const { return lines_[mark].count(); }

 private:
  std::array<LineInstances, 3> lines_;
};

/// GPU copy of curvature combs: the foot of tooth k is point 2 k, its tip point 2 k + 1.
class CombBuffers {
 public:
  CombBuffers(const CombLines& combs, std::size_t& uploaded);
  const TexturedBuffer& teeth() const { return teeth_; }
  const LineInstances& tooth_lines() const { return tooth_lines_; }
  const LineInstances& envelope() const { return envelope_; }

 private:
  TexturedBuffer teeth_;
  LineInstances tooth_lines_, envelope_;
};

/// GPU copy of the edges of triangles.
class FacetLineBuffers {
 public:
  FacetLineBuffers(const FacetLines& lines, std::size_t& uploaded);
  const TexturedBuffer& points() const { return points_; }
  const LineInstances& lines() const { return lines_; }

 private:
  TexturedBuffer points_;
  LineInstances lines_;
};

/// GPU copy of the intersection of a mesh with a plane.
class SectionBuffers {
 public:
  SectionBuffers(const DisplayMesh& mesh, const LocalPlane& plane, std::size_t& uploaded);
  const TexturedBuffer& points() const { return points_; }
  const LineInstances& lines() const { return lines_; }

 private:
  TexturedBuffer points_;
  LineInstances lines_;
};

}  // namespace hariko::gl
