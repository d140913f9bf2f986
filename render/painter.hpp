#pragma once

// Painter: drawing commands of a frame. Knows programs and uniforms, but no caches. Internal to render/.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/body_buffers.hpp"
#include "render/mesh_buffers.hpp"
#include "render/program.hpp"
#include "render/renderer.hpp"
#include "render/style.hpp"
#include "render/surface_looks.hpp"

namespace hariko::gl {

/// Constants of a frame.
struct Frame {
  Camera camera;
  PixelSize size;
  ClipRange clip;
  Matrix4 view, projection;
  double pixel_scale = 1;
  /// Half-space that the section plane keeps, in camera axes: dot(section, (x, 1)) >= 0; (0, 0, 0, 1) keeps
  /// all.
  glm::vec4 section{0, 0, 0, 1};
  bool has_section = false;
  bool colour_blind_safe = false;
  /// Depth shift towards the eye by one pixel: a fraction of the distance (perspective) or a length
  /// (orthographic).
  double pixel_bias = 0;

  Frame(const Scene& scene, const Camera& camera, PixelSize size, const Box3& box);
};

/// Part of a line or point that is drawn: visible, hidden, or all of it.
enum class Depth { visible, hidden, any };

/// Special looks of lines: map colours, dashes, depth offset, combs.
struct LineLook {
  struct Values {
    ColorScale scale = ColorScale::diverging;
    ValueRange range;
    Color undefined;  ///< alpha 0 omits undefined parts
  };
  std::optional<Values> values;     ///< map colours from the instances' values
  double dash = 0, dash_share = 1;  ///< length of a dash with its gap in object units, 0: solid
  double depth = 0;                 ///< object length that lines may lie behind the surface under them
  std::optional<double> amplitude;  ///< for combs: object length of a tooth of curvature 1
};

/// Drawing commands with their GL programs and streaming buffers.
class Painter {
 public:
  /// Compiles the usual programs. Errors: E_SHADER_SOURCE, E_GL_SHADER.
  static Result<Painter> create();

  /// Draws the background.
  void background(const Style& style, Background background);
  /// Draws the ground grid or, for an orthographic camera that looks along an axis, a grid in the plane
  /// perpendicular to it, as a backdrop to be drawn first.
  void grid(const Frame& frame, const GridSettings& grid, const Style& style);
  /// Turns clipping by the section plane on or off for what follows.
  void cut(const Frame& frame, bool on);
  /// Draws the surface of an object. Errors: E_GL_SHADER; programs for rare looks are compiled on first use.
  Result<Done> surface(const Frame& frame, const SceneObject& object, const MeshBuffers& mesh,
                       const Scene& scene, const Style& style);

  /// Line instances: a vertex array made by set_up_line_instances over a coordinate texture.
  struct Lines {
    const TexturedBuffer* coordinates = nullptr;
    int stride = 3;
    GLuint array = 0;
    GLsizei count = 0;
  };
  /// Draws line instances.
  void lines(const Frame& frame, const Matrix4& model, const Lines& lines, const LineStyle& style,
             Depth depth, float opacity, const LineLook& look = {});
  /// Draws some edges of a polyhedron.
  void some_edges(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
                  const PolyhedronBuffers& buffers, std::span<const Index> edges, const LineStyle& style,
                  Depth depth, float opacity);
  /// Draws curve segments over any coordinates.
  void segments(const Frame& frame, const Matrix4& model, const TexturedBuffer& coordinates, int stride,
                std::span<const CurveSegment> segments, const LineStyle& style, Depth depth, float opacity);
  /// Draws all points of a polyhedron. `tensions`: in the colours of their tensions.
  void points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
              const PointStyle& style, Depth depth, float opacity, bool tensions = false);
  /// Draws some points of a polyhedron.
  void some_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                   std::span<const Index> vertices, const PointStyle& style, Depth depth, float opacity);
  /// Draws some faces of a polyhedron in one colour, as fans round their centres.
  void faces(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
             std::span<const Index> faces, const Color& paint);
  /// Draws some faces of bodies, given by ascending numbers: those that face the eye, without a depth test.
  void bodies(const Frame& frame, const Matrix4& model, const BodyBuffers& buffers,
              std::span<const Index> faces, const BodyStyle& style, float opacity);
  /// Draws free lines over the scene.
  void overlay(const Frame& frame, std::span<const OverlayLine> lines);
  /// Draws the area that a mesh covers in one colour, nearest first, into a mask.
  void silhouette(const Frame& frame, const Matrix4& model, const MeshBuffers& mesh, const Color& paint);
  /// Draws lines round the areas of a silhouette mask.
  void silhouette_lines(const Frame& frame, GLuint mask, const Style& style);

  /// Sets the statistics that the following calls add to.
  void reset(FrameStatistics* statistics) { statistics_ = statistics; }

 private:
  struct Programs {
    Program background, grid, line, dashed_line, comb_line, point, colored_point, fill, body, silhouette;
    /// Programs of surfaces by their defines: software drivers execute every branch of a shader, so each look
    /// has a program of its own.
    std::map<std::string, Program> surface;
  };
  explicit Painter(Programs programs);
  Result<const Program*> surface_program(const SceneObject& object, const Scene& scene);
  void bind_table(ColorScale scale) const;
  void upload_stream(std::size_t bytes, const void* data);
  void set_frame(const Program& program, const Frame& frame, const Matrix4& model, double bias_pixels,
                 double bias_length = 0) const;
  void draw_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                   const PointStyle& style, Depth depth, float opacity, GLsizei count, bool numbered,
                   bool tensions);
  void count(std::size_t triangles = 0);

  Programs programs_;
  std::array<Texture, color_scale_count> tables_;
  VertexArray empty_, stream_lines_, stream_points_, stream_triangles_;
  Buffer stream_;
  TexturedBuffer overlay_points_;
  EnvironmentTexture environment_;
  bool cutting_ = false;
  FrameStatistics* statistics_ = nullptr;
};

/// Model matrix for coordinates relative to an origin.
Matrix4 at_origin(const Matrix4& transform, const Vector3& origin);

}  // namespace hariko::gl
