#pragma once

// Rings round the bars of a field's cage, by which their waists are drawn in or widened.

#include <optional>
#include <span>
#include <vector>

#include "core/envelope/envelope_handles.hpp"
#include "core/envelope/field_cage.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// A point of the surface on an edge of its cage, or at a vertex.
struct RingPoint {
  Index vertex = no_index;
  Index edge = no_index;  ///< where it is no vertex
  Vector3 position = Vector3::Zero();
  Vector3 outward = Vector3::UnitZ();  ///< unit, normal of the surface
};

/// Where the surface is crossed by the plane through the middle of a bar, at right angles to it.
struct BarRing {
  SolidPair solids;
  Vector3 centre = Vector3::Zero();  ///< mean of the points
  std::vector<RingPoint> points;     ///< in order
};

/// At most one a bar: none where the crossing runs through a face more than once, or is not that of a bar.
/// Vertices near the plane are points of the ring. No two rings have a face in common; the earlier bar's
/// stays. `surface`: the fair one over `cage`, one patch a half-edge; positions relative to the same origin.
/// O(bars * faces).
std::vector<BarRing> bar_rings(std::span<const FieldBar> bars, const Polyhedron& cage,
                               const Surface& surface);

struct RingedCage {
  PolygonMesh mesh;          ///< vertices of the cage keep their numbers
  std::vector<double> cell;  ///< one a vertex
};

/// The cage with the rings as vertices and edges, each scaled from its centre by its factor. `cell`: one a
/// vertex of the cage.
RingedCage ringed_cage(const Polyhedron& cage, std::span<const double> cell, std::span<const BarRing> rings,
                       std::span<const double> factors);

/// How thick a bar, or wide a fillet, is to be, where 1 is what the solids suggest: the waist over the usual
/// one, and the factor of the pair. [0.25, 2].
double wanted_thickness(const EnvelopeSettings& settings, const SolidPair& solids);

/// What `wanted_thickness` grows by while the pair's factor grows by one.
double thickness_growth(const EnvelopeSettings& settings);

/// A handle at each point.
std::vector<EnvelopeBridge> bridges_of(std::span<const BarRing> rings, const EnvelopeSettings& settings);

}  // namespace hariko
