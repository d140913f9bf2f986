#pragma once

// Shares of vertices: how the points of a polyhedron's surface follow its vertices.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// Shares of the vertices at and round a face in the points of its patches: a point moves by the sum of the
/// displacements of the vertices times their shares.
struct FaceShares {
  std::vector<Index> vertices;  ///< ascending
  /// share[p * vertices.size() + j]: of vertex j, in point p = side * parameters + parameter, where `side`
  /// counts the face's half-edges, to which its patches belong.
  std::vector<double> share;

  std::span<const double> of_point(std::size_t p) const {
    return std::span(share).subspan(p * vertices.size(), vertices.size());
  }
};

/// Computes the shares at parameters of all patches, per face. The construction is linear in the positions
/// where the frames stay, so they are solutions for positions of 1 at a vertex and 0 at the others; vertices
/// that are at least four edges and diagonals of faces apart are solved at once. Shares of vertices that are
/// more than one edge or diagonal from the face, some hundredths, are left out, and the others scaled to a
/// sum of 1. Pinned planes and joins do not count, and mode G2 has the shares of mode FAIR. Errors: those of
/// `NetworkSystem::assemble`, E_CANCELLED. O(faces) per solution, some ten of them unless vertices or faces
/// have many sides.
Result<std::vector<FaceShares>> vertex_shares(const PolyhedronSurfaceInput& input,
                                              std::span<const Vector2> parameters,
                                              const CancelToken& cancel = {});

}  // namespace hariko
