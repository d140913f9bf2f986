#pragma once

// Border sides whose ribbons are given: a polyhedron's surface joined to patches in mode G2 (g2.md section
// 11).

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/g2/face_chart.hpp"
#include "core/g2/unknowns.hpp"

namespace hariko {

/// What is given of a border side's ribbon R(t, s) = r0(t) + s r1(t) + s^2/2 r2(t).
enum class GivenRibbon : std::uint8_t {
  none,
  curve,                  ///< r0 is a cubic
  curve_and_cubic_cross,  ///< r0 is a cubic, r1 some cubic
  cross                   ///< r0 and r1 are given cubics
};

/// A side from its half-edge's origin (t = 0) to its target. Values and first derivatives at its ends are
/// those of the network.
struct GivenSide {
  Index half_edge = no_index;
  Vector3 second_origin, second_target;  ///< r0''
  bool has_cross = false;
  Vector3 cross_origin = Vector3::Zero(), cross_target = Vector3::Zero();  ///< r1'
  /// g2 of straight corners at its ends; those of neighbouring sides agree.
  std::optional<Vector3> tangent_origin, tangent_target;
};

/// The same with what follows: unknowns that are no unknowns any more, and departures.
struct GivenSides {
  struct Side {
    GivenSide given;
    /// By `SideDeparture`. Zero where the corner's quadratic has what is given. Two sides that ask for
    /// different second derivatives in one corner get their mean there, and depart from it.
    std::array<Vector3, side_departure_count> departure;
  };
  std::vector<Side> sides;                          ///< ascending by half-edge
  std::vector<std::pair<Index, Vector3>> unknowns;  ///< ascending

  /// Null where nothing is given.
  const Side* find(Index half_edge) const;
};

/// Flags: unknowns that the sides give, whatever their values. `ribbons`: per half-edge, or empty.
std::vector<bool> given_unknowns(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                                 const G2Unknowns& unknowns, const std::vector<GivenRibbon>& ribbons);

GivenSides resolve_given_sides(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                               const G2Unknowns& unknowns, std::vector<GivenSide> sides);

}  // namespace hariko
