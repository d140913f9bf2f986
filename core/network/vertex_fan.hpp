#pragma once

// Fans: the edges and corners around a vertex, and their division into sectors with basis vectors of their
// own (kuriyama.md section 2.1). Internal to vertex frames.

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/message.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {

/// Edge of a fan: the half-edge that carries it and which of its ends lies at the vertex.
struct FanEdge {
  Index half_edge;
  bool at_origin;
};

/// Edges around a vertex, counter-clockwise; corner k lies between edges k and k + 1.
struct Fan {
  std::vector<FanEdge> edges;
  std::vector<Index> corners;
  bool closed;
};

/// The fan of a vertex that has edges. O(edges).
Fan fan_of(const HalfEdgeMesh& mesh, Index v);

/// Sector: the corners between two sharp edges, or all corners around a vertex that has at most one sharp
/// edge, and the map from plane vectors to tangents there.
struct Sector {
  enum class Image : std::uint8_t { smooth, straight, line, corner };
  Image image = Image::smooth;
  std::size_t first = 0, corners = 0;  ///< its first edge in the fan, and the number of corners that follow
  double opening = 0;
  /// Basis vectors by image. Smooth: Ts, Tc. Straight: Tc. Line: Ts (none with one corner), Tc. Corner: X of
  /// the first and of the last edge.
  std::array<Index, 2> basis{no_index, no_index};
  double sign = 1;  ///< sign of Tc in a line
};

/// Divides the fans of all vertices, one after the other, and allocates their basis vectors.
class FanDivider {
 public:
  /// `sharp`: per edge. All must outlive the divider.
  FanDivider(const Polyhedron& polyhedron, const Shaping& shaping, const std::vector<bool>& sharp)
      : polyhedron_(polyhedron), shaping_(shaping), sharp_(sharp) {}

  struct Division {
    FrameKind kind = FrameKind::isolated;
    std::vector<Sector> sectors;
  };
  /// Sectors of the vertex with this fan. `request`: on the frame of a border vertex, or null. Error:
  /// E_CORNER_NEEDS_CREASE.
  Result<Division> divide(Index v, const Fan& fan, const FrameRequest* request);
  /// Number of basis vectors so far.
  Index basis_count() const { return next_basis_; }

 private:
  Index take_basis(Index count);
  Division smooth(const Fan& fan);
  Division line(const Fan& fan, const std::vector<std::size_t>& sharp);
  Division corner(const Fan& fan, const std::vector<std::size_t>& sharp, std::optional<double> given = {});

  const Polyhedron& polyhedron_;
  const Shaping& shaping_;
  const std::vector<bool>& sharp_;
  Index next_basis_ = 0;
};

}  // namespace hariko
