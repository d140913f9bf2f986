#pragma once

// What the designer pulled by hand on the vertices of a network: under which names settings keep it, and how
// it moves them.

#include <span>

#include "core/envelope/network_cage.hpp"

namespace hariko {

/// The name that settings have for a vertex: that of what it is an image of. Of two images in a valley both
/// have the lesser name.
NetworkVertexKey settings_name(const NetworkCage& cage, Index vertex, std::span<const PlacedSolid> solids);

/// Of a vertex and its image across the plane of symmetry the one whose offset moves both.
Index offset_owner(const NetworkCage& cage, Index vertex, std::span<const PlacedSolid> solids,
                   const FlatMap<NetworkVertexKey, Vector3>& offsets);

/// Columns are the axes of a vertex's offset: those of its solid, or of the scene in valleys.
Matrix3 offset_axes(const CageVertex& vertex, std::span<const PlacedSolid> solids);

/// Moves the vertices from number `first` on, with new frames, by their offsets; those before it are the
/// hull's, which has moved them. False where none of them has an offset. A cage that is its own image may not
/// be so to the last bit afterwards.
bool pull_vertices(NetworkCage& cage, Index first, std::span<const PlacedSolid> solids,
                   const FlatMap<NetworkVertexKey, Vector3>& offsets);

}  // namespace hariko
