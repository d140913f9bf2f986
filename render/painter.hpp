#pragma once

// Painter: the drawing commands of a frame. Knows programs and uniforms, not what is cached. Internal to
// render/.

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

namespace hariko::gl {

/// What stays the same during a frame.
struct Frame {
  Camera camera;
  PixelSize size;
  ClipRange clip;
  Matrix4 view, projection;
  double pixel_scale = 1;
  /// What section plane keeps, in camera axes: dot(section, (x, 1)) >= 0; (0, 0, 0, 1) keeps all.
  glm::vec4 section{0, 0, 0, 1};
  bool has_section = false;
  bool colour_blind_safe = false;
  /// Shift towards the eye by one pixel: a share of the distance (perspective) or a length (orthographic).
  double pixel_bias = 0;

  Frame(const Scene& scene, const Camera& camera, PixelSize size, const Box3& box);
};

/// Which part of a line or point is drawn: what the eye sees, what is hidden, or all.
enum class Depth { visible, hidden, any };

/// How lines differ from plain ones.
struct LineLook {
  struct Values {
    ColorScale scale = ColorScale::diverging;
    ValueRange range;
    Color undefined;  ///< alpha 0 leaves undefined parts out
  };
  std::optional<Values> values;     ///< colours, from the instances' values
  double dash = 0, dash_share = 1;  ///< length of a dash with its gap in object units, 0: solid
  double depth = 0;  ///< object length by which the lines may lie behind what they are drawn over
  std::optional<double> amplitude;  ///< of combs: object length of a tooth of curvature 1
};

class Painter {
 public:
  static Result<Painter> create();

  void background(const Style& style, Background background);
  /// The ground; or, where a camera in parallel projection looks along an axis, the plane across it, as a
  /// backdrop that is to be drawn before everything else.
  void grid(const Frame& frame, const GridSettings& grid, const Style& style);
  /// Whether what follows is cut by the section plane.
  void cut(const Frame& frame, bool on);
  /// Errors: E_GL_SHADER; programs of rare looks are compiled when they are first needed.
  Result<Done> surface(const Frame& frame, const SceneObject& object, const MeshBuffers& mesh,
                       const ZebraSettings& zebra, const Style& style);

  /// Line instances of a vertex array made by set_up_line_instances over a coordinate texture.
  struct Lines {
    const TexturedBuffer* coordinates = nullptr;
    int stride = 3;
    GLuint array = 0;
    GLsizei count = 0;
  };
  void lines(const Frame& frame, const Matrix4& model, const Lines& lines, const LineStyle& style,
             Depth depth, float opacity, const LineLook& look = {});
  /// Some edges of a polyhedron.
  void some_edges(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
                  const PolyhedronBuffers& buffers, std::span<const Index> edges, const LineStyle& style,
                  Depth depth, float opacity);
  /// Pieces of curves over any coordinates.
  void segments(const Frame& frame, const Matrix4& model, const TexturedBuffer& coordinates, int stride,
                std::span<const CurveSegment> segments, const LineStyle& style, Depth depth, float opacity);
  /// All points of a polyhedron, or some. `tensions`: in the colours of their tensions.
  void points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
              const PointStyle& style, Depth depth, float opacity, bool tensions = false);
  void some_points(const Frame& frame, const Matrix4& model, const PolyhedronBuffers& buffers,
                   std::span<const Index> vertices, const PointStyle& style, Depth depth, float opacity);
  void faces(const Frame& frame, const Matrix4& model, const DisplayPolyhedron& polyhedron,
             std::span<const Index> faces, const Color& paint);
  /// Some faces of bodies, by their numbers ascending: what looks at the eye, whatever lies before it.
  void bodies(const Frame& frame, const Matrix4& model, const BodyBuffers& buffers,
              std::span<const Index> faces, const BodyStyle& style, float opacity);
  void overlay(const Frame& frame, std::span<const OverlayLine> lines);
  /// The area that a mesh covers in one colour, nearest first, into a mask.
  void silhouette(const Frame& frame, const Matrix4& model, const MeshBuffers& mesh, const Color& paint);
  /// Lines round the areas of such a mask.
  void silhouette_lines(const Frame& frame, GLuint mask, const Style& style);

  void reset(FrameStatistics* statistics) { statistics_ = statistics; }

 private:
  struct Programs {
    Program background, grid, line, dashed_line, comb_line, point, colored_point, fill, body, silhouette;
    /// By what is defined: software drivers execute every branch of a shader, so each look has a program of
    /// its own.
    std::map<std::string, Program> surface;
  };
  explicit Painter(Programs programs);
  Result<const Program*> surface_program(const SceneObject& object);
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
  bool cutting_ = false;
  FrameStatistics* statistics_ = nullptr;
};

/// Model matrix of coordinates relative to an origin.
Matrix4 at_origin(const Matrix4& transform, const Vector3& origin);

}  // namespace hariko::gl
