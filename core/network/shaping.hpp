#pragma once

// Shaping: the designer's settings on elements of a polyhedron that shape its surface. Sparse, keyed by
// stable ids.

#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Treatment of a vertex on a border or crease (kuriyama.md section 2.1). `automatic`: a border vertex with
/// two edges is a corner, one with more is smooth; an inner vertex with two creases is smooth, one with three
/// or more is a corner.
enum class VertexTag { automatic, corner, smooth };

/// Constraint on a vertex's tangent plane. `tangents`: fixes the vertex's basis vectors themselves (Ts, Tc of
/// kuriyama.md section 2.1; as many as the vertex has), in length units. `normal`: fixes the plane only, by a
/// normal vector of any length.
struct Pin {
  enum class Kind { tangents, normal };
  Kind kind = Kind::normal;
  std::vector<Vector3> vectors;  ///< the basis vectors, or the one normal
  friend bool operator==(const Pin&, const Pin&) = default;
};

/// Record of a refinement at a vertex that keeps the surface: the difference between its tangents and those
/// that metric frames give it (kuriyama.md section 12.7). The numbers are relative to the edges: moving,
/// rotating and scaling the polyhedron leaves them unchanged.
struct KeptForm {
  struct Edge {
    VertexId to;         ///< the edge's other end
    double turn = 0;     ///< added to its direction in the fan, radians, counter-clockwise
    double stretch = 0;  ///< natural logarithm of the factor of its length in the fan
    /// Added to the image of its unit vector, in components along the edge, to its left and outward.
    Vector3 offset = Vector3::Zero();
    /// Turn of the split vector beside a corner of nearly a half turn, counter-clockwise, as a share of the
    /// corner's angle. Both edges of the corner have the same value.
    double lean = 0;
    /// Position of a corner of nearly a half turn on a side of its face's chart: this edge's part of the side
    /// between the corners before and behind, in the same unit for both edges of the corner; 0 elsewhere.
    double side = 0;
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  std::vector<Edge> edges;  ///< ascending by `to`
  friend bool operator==(const KeptForm&, const KeptForm&) = default;

  /// Entry of the edge to a vertex, null where there is none.
  const Edge* find(VertexId to) const {
    for (const Edge& edge : edges)
      if (edge.to == to) return &edge;
    return nullptr;
  }
};

/// Shaping settings of a polyhedron. Elements without an entry have the defaults.
struct Shaping {
  FlatMap<VertexId, double> alpha;  ///< vertex tension, 0 .. 1000, default 0
  /// Edge tension, 0.001 .. 1000 (0 allowed where the system stays regular), default 1.
  FlatMap<EdgeId, double> beta;
  FlatMap<EdgeId, bool> crease;  ///< sharp edges (the value is always true)
  FlatMap<VertexId, VertexTag> tag;
  FlatMap<VertexId, Pin> pin;
  FlatMap<VertexId, KeptForm> form;
  /// Record of a refinement at faces: factor of the face's area in mode FAIR with metric frames, default 1
  /// (kuriyama.md section 12.7).
  FlatMap<FaceId, double> kept_area;
  friend bool operator==(const Shaping&, const Shaping&) = default;
};

/// Construction of the surface over the network (kuriyama.md, introduction). `fair` is the default for
/// designers; `g2` has continuous curvature (g2.md).
enum class Mode { paper, target, fair, g2 };

/// Layout of vertices and faces in the plane. `equal`: equal angles and unit lengths at every vertex, regular
/// faces, as in the paper. `metric`: by the polyhedron's angles and lengths (kuriyama.md section 12). Mode
/// PAPER always uses equal frames.
enum class Frames { equal, metric };

/// Frames of a surface of this mode.
inline Frames frames_in(Mode mode, Frames frames) {
  return mode == Mode::paper ? Frames::equal : frames;
}

}  // namespace hariko
