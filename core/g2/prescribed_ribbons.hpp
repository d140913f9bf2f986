#pragma once

// Boundary conditions on border sides with prescribed ribbons: a polyhedron's surface joined to patches in
// mode G2 (g2.md section 11).

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/g2/degrees_of_freedom.hpp"
#include "core/g2/faces/face_chart.hpp"

namespace hariko {

/// Prescribed part of a border side's ribbon R(t, s) = r0(t) + s r1(t) + s^2/2 r2(t).
enum class PrescribedRibbon : std::uint8_t {
  none,
  curve,                  ///< r0 is a cubic
  curve_and_cubic_cross,  ///< r0 is a cubic, r1 any cubic
  cross                   ///< r0 and r1 are given cubics
};

/// Prescribed side, from its half-edge's origin (t = 0) to its target. Values and first derivatives at its
/// ends are those of the network.
struct GivenSide {
  Index half_edge = no_index;
  Vector3 second_origin, second_target;  ///< r0'' at its ends
  bool has_cross = false;
  Vector3 cross_origin = Vector3::Zero(), cross_target = Vector3::Zero();  ///< r1' at its ends
  /// Second tangent g2 of straight corners at its ends; those of neighbouring sides agree.
  std::optional<Vector3> tangent_origin, tangent_target;
};

/// Prescribed sides with their consequences: unknowns with known values, and departures.
struct GivenSides {
  struct Side {
    GivenSide given;
    /// Departures, indexed by `SideDeparture`. Zero where the corner's quadratic has the prescribed values.
    /// Two sides that prescribe different second derivatives at one corner get their mean there, and depart
    /// from it.
    std::array<Vector3, side_departure_count> departure;
  };
  std::vector<Side> sides;                          ///< ascending by half-edge
  std::vector<std::pair<Index, Vector3>> unknowns;  ///< ascending

  /// Entry of a side; null where nothing is prescribed.
  const Side* find(Index half_edge) const;
};

/// Flags of the unknowns that the sides determine, whatever their values. `ribbons`: per half-edge, or empty.
std::vector<bool> given_unknowns(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                                 const G2Unknowns& unknowns, const std::vector<PrescribedRibbon>& ribbons);

/// Determines the unknowns and departures of prescribed sides.
GivenSides resolve_given_sides(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                               const G2Unknowns& unknowns, std::vector<GivenSide> sides);

}  // namespace hariko
