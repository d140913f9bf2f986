#pragma once

// Vertices and curves of a field's cage that the designer pulls: under which names settings keep them, and
// what they do. Contours have no vertices of their own that would stay while solids move, so a name is a
// place in the frame of the nearest solid, and belongs to the vertex that is nearest to it
// (docs/envelope.md).

#include <optional>
#include <span>
#include <vector>

#include "core/envelope/cage_surface.hpp"
#include "core/envelope/envelope_handles.hpp"

namespace hariko {

/// Of a vertex of a field's cage, not of a network.
bool is_field_name(const NetworkVertexKey& key);

struct FieldNamesInput {
  std::span<const Solid> solids;             ///< images of solids after them, under the same ids
  std::span<const SolidDistance> distances;  ///< one a solid; relative to the same origin as `positions`
  std::span<const Vector3> positions;        ///< of the vertices, before anything is pulled
  std::span<const double> cell;              ///< one a vertex
  const CageMirror* mirror = nullptr;        ///< where the cage is its own image
};

/// One entry a vertex.
struct FieldNames {
  std::vector<NetworkVertexKey> name;
  std::vector<Index> owner;   ///< whose offset moves it: itself or its image
  std::vector<Matrix3> axes;  ///< columns: those of the offset, a rotation
};

/// Names that the settings have go to the vertices nearest to their places, one each, where one is nearer
/// than 0.75 cells. All others are named by their own places; only a vertex and its image share a name.
/// O(vertices (solids + names of the settings)).
FieldNames field_names(const FieldNamesInput& input, const EnvelopeSettings& settings);

/// What was pulled. Both empty where nothing was.
struct FieldPulls {
  std::vector<Vector3> moves;          ///< one a name, or none
  std::vector<CageFullness> fullness;  ///< of edges of the cage
  bool empty() const { return moves.empty() && fullness.empty(); }
};

FieldPulls field_pulls(const FieldNames& names, const HalfEdgeMesh& cage, const EnvelopeSettings& settings,
                       const CageMirror* mirror);

/// Handles of the vertices that have a name, and of the curves between them; the surface's cage may have
/// more. Curves go about the way that is told.
void add_field_handles(const FieldNames& names, const CageSurface& surface, const EnvelopeSettings& settings,
                       const CageMirror* mirror, EnvelopeHandles& out);

}  // namespace hariko
