#pragma once

// Painter: the drawing commands of a frame. Knows programs and uniforms, not what is cached. Internal to
// render/.

#include <span>
#include <vector>

#include "render/mesh_buffers.hpp"
#include "render/program.hpp"
#include "render/renderer.hpp"
#include "render/style.hpp"

namespace hariko::gl {

/// What stays the same during a frame.
struct Frame {
  Camera camera;
  PixelSize size;
  ClipRange clip;
  Matrix4 view, projection;
  double pixel_scale = 1;
  /// Shift towards the eye by one pixel: a share of the distance (perspective) or a length (orthographic).
  double pixel_bias = 0;

  Frame(const Scene& scene, const Camera& camera, PixelSize size, const Box3& box);
};

/// Which part of a line or point is drawn: what the eye sees, what is hidden, or all.
enum class Depth { visible, hidden, any };

class Painter {
 public:
  static Result<Painter> create();

  void background(const Style& style, Background background);
  void grid(const Frame& frame, const GridSettings& grid, const Style& style);
  void surface(const Frame& frame, const SceneObject& object, const MeshBuffers& mesh,
               const ZebraSettings& zebra, const Style& style);

  /// Line instances of a vertex array made by set_up_line_instances over a coordinate texture.
  struct Lines {
    const TexturedBuffer* coordinates = nullptr;
    int stride = 3;
    GLuint array = 0;
    GLsizei count = 0;
    bool by_value = false;
  };
  void lines(const Frame& frame, const Matrix4& model, const Lines& lines, const LineStyle& style,
             Depth depth, float opacity, const SceneObject* values_of = nullptr);
  /// Some edges of a polyhedron.
  void some_edges(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
                  const PolyhedronBuffers& buffers, std::span<const Index> edges, const LineStyle& style,
                  Depth depth, float opacity);
  /// All points of a polyhedron, or some.
  void points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
              const PointStyle& style, Depth depth, float opacity);
  void some_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                   std::span<const Index> vertices, const PointStyle& style, Depth depth, float opacity);
  void faces(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
             std::span<const Index> faces, const Color& paint);
  void overlay(const Frame& frame, std::span<const OverlayLine> lines);

  void reset(FrameStatistics* statistics) { statistics_ = statistics; }

 private:
  static constexpr std::size_t surface_mode_count = 5;
  struct Programs {
    Program background, grid, line, point, fill;
    /// By mode and whether patches are highlighted: software drivers execute every branch of a shader, so
    /// each mode has a program of its own.
    std::array<Program, 2 * surface_mode_count> surface;
  };
  explicit Painter(Programs programs);
  void upload_stream(std::size_t bytes, const void* data);
  void set_frame(const Program& program, const Frame& frame, const Matrix4& model, double bias_pixels) const;
  void draw_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                   const PointStyle& style, Depth depth, float opacity, GLsizei count, bool numbered);
  void count(std::size_t triangles = 0);

  Programs programs_;
  Texture diverging_, sequential_;
  VertexArray empty_, stream_lines_, stream_points_, stream_triangles_;
  Buffer stream_;
  TexturedBuffer overlay_points_;
  FrameStatistics* statistics_ = nullptr;
};

/// Model matrix of coordinates relative to an origin.
Matrix4 at_origin(const Matrix4& transform, const Vector3& origin);

}  // namespace hariko::gl
