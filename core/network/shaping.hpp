#pragma once

// Shaping: what a designer sets on the elements of a polyhedron to shape its surface. Sparse, keyed by stable
// ids.

#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// How the surface treats a vertex on a border or crease (kuriyama.md section 2.1). `automatic`: a border
/// vertex with two edges is a corner, one with more is smooth; an inner vertex with two creases is smooth,
/// with three or more a corner.
enum class VertexTag { automatic, corner, smooth };

/// A pin fixes a vertex's tangent plane. `tangents`: the vertex's basis vectors themselves (Ts, Tc of
/// kuriyama.md 2.1; as many as the vertex has), length units. `normal`: only the plane, by a normal vector of
/// any length.
struct Pin {
  enum class Kind { tangents, normal };
  Kind kind = Kind::normal;
  std::vector<Vector3> vectors;  ///< the basis vectors, or the one normal
  friend bool operator==(const Pin&, const Pin&) = default;
};

/// Memory of a refinement at a vertex so that the surface stays: how its tangents differ from those that
/// frames by measure give it (kuriyama.md section 12.7). The numbers follow the edges: moving, turning and
/// scaling the polyhedron leaves them as they are.
struct KeptForm {
  struct Edge {
    VertexId to;         ///< the edge's other end
    double turn = 0;     ///< added to its direction in the fan, radians, counter-clockwise
    double stretch = 0;  ///< natural logarithm of the factor of its length in the fan
    /// Added to the image of its unit vector: along the edge, to the left of it and outward.
    Vector3 offset = Vector3::Zero();
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  std::vector<Edge> edges;  ///< ascending by `to`
  friend bool operator==(const KeptForm&, const KeptForm&) = default;

  const Edge* find(VertexId to) const {
    for (const Edge& edge : edges)
      if (edge.to == to) return &edge;
    return nullptr;
  }
};

struct Shaping {
  FlatMap<VertexId, double> alpha;  ///< vertex tension, 0 .. 1000, default 0
  FlatMap<EdgeId, double>
      beta;  ///< edge tension, 0.001 .. 1000 (0 allowed where the system stays regular), default 1
  FlatMap<EdgeId, bool> crease;  ///< sharp edges (value always true)
  FlatMap<VertexId, VertexTag> tag;
  FlatMap<VertexId, Pin> pin;
  FlatMap<VertexId, KeptForm> form;
  /// Memory of a refinement at faces: factor of the area with which mode FAIR counts a face in frames by
  /// measure, default 1 (kuriyama.md section 12.7).
  FlatMap<FaceId, double> kept_area;
  friend bool operator==(const Shaping&, const Shaping&) = default;
};

/// The construction of the surface over the network (kuriyama.md, head). `fair` is the default for designers.
/// `g2` has continuous curvature (g2.md).
enum class Mode { paper, target, fair, g2 };

/// How vertices and faces are laid out in the plane. `equal`: equal angles and unit lengths at every vertex,
/// regular faces, as in the paper. `metric`: as the polyhedron's angles and lengths are (kuriyama.md section
/// 12). Mode PAPER takes the first always.
enum class Frames { equal, metric };

/// The frames that a surface of this mode has.
inline Frames frames_in(Mode mode, Frames frames) {
  return mode == Mode::paper ? Frames::equal : frames;
}

}  // namespace hariko
